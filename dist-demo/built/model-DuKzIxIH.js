
var e=({map:e,emissiveMap:t,metalRoughMap:n,normalMap:r})=>[e,t,n,r].flatMap(e=>e??[]),t=class extends Error{name=`ModelError`;code;constructor(e,t,n){super(t,n),this.code=e}};export{e as n,t};