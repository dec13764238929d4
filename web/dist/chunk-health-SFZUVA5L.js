import{e as t,f as e}from"./chunk-chunk-Q6UE53WT.js";import"./chunk-chunk-XRK2MBP4.js";function a(){return t("h1",{class:"page-title",children:e("health")})}export{a as HealthPage};
