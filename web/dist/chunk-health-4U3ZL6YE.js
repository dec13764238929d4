import{s as t,t as e}from"./chunk-chunk-A4BJ7L6L.js";function a(){return e("h1",{class:"page-title",children:t("health")})}export{a as HealthPage};
