import{e,f as t}from"./chunk-chunk-Q6UE53WT.js";import"./chunk-chunk-XRK2MBP4.js";function l(){return e("h1",{class:"page-title",children:t("replay")})}export{l as ReplayPage};
