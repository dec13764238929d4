import{e as o,f as t}from"./chunk-chunk-Q6UE53WT.js";import"./chunk-chunk-XRK2MBP4.js";function n(){return o("h1",{class:"page-title",children:t("configuration")})}export{n as ConfigurationPage};
