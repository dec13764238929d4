import{p as e,q as t}from"./chunk-chunk-XRCMVGIZ.js";function l(){return t("h1",{class:"page-title",children:e("replay")})}export{l as ReplayPage};
