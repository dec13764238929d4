import{p as o,q as t}from"./chunk-chunk-XRCMVGIZ.js";function n(){return t("h1",{class:"page-title",children:o("configuration")})}export{n as ConfigurationPage};
