import{p as t,q as e}from"./chunk-chunk-XRCMVGIZ.js";function a(){return e("h1",{class:"page-title",children:t("health")})}export{a as HealthPage};
