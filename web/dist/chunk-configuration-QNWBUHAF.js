import{s as o,t}from"./chunk-chunk-A4BJ7L6L.js";function n(){return t("h1",{class:"page-title",children:o("configuration")})}export{n as ConfigurationPage};
