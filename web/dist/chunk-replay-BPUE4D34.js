import{s as e,t}from"./chunk-chunk-A4BJ7L6L.js";function l(){return t("h1",{class:"page-title",children:e("replay")})}export{l as ReplayPage};
