import{p as o,q as r}from"./chunk-chunk-XRCMVGIZ.js";function t(){return r("h1",{class:"page-title",children:o("recordings")})}export{t as RecordingsPage};
