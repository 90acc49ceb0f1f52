const __vite__mapDeps=(i,m=__vite__mapDeps,d=(m.f||(m.f=["./diagnose-CiGEBe8o.js","./field-CXlt62Yf.js","./description-C1KtsLjY.js","./angle-CS1XfWio.js","./light-layout-DryugaYw.js","./file-name-D6GoQUku.js","./solids-wsoucnVU.js","./three.core-ADDfBTJJ.js","./vector-BSkN5mpv.js","./teapot-DYLMVShE.js","./model-content-QpVRDcEv.js","./rolldown-runtime-DWK5is8u.js","./model-DuKzIxIH.js","./shade-at-CFth73sH.js","./color-Cq5HoIL4.js","./panel-BLZleFSd.js","./light-state-BZRv3YOF.js"])))=>i.map(i=>d[i]);
/*!
 * @lit/reactive-element 2.1.2: Copyright (c) 2017 Google LLC, BSD-3-Clause
 * three 0.187.0: Copyright © 2010-2026 three.js authors, MIT
 * Licences: THIRD-PARTY-LICENSES.txt
 */
import{a as e,i as t,o as n,r,t as i}from"./light-state-BZRv3YOF.js";import{a,c as o,d as s,f as c,h as l,l as u,n as d,o as f,p,r as m,s as h,t as g}from"./field-CXlt62Yf.js";import{C as _,D as v,E as y,O as b,T as x,_ as S,a as C,b as w,c as T,d as E,f as D,g as O,h as k,i as A,l as j,m as ee,n as M,o as te,p as N,r as P,t as ne,u as re,v as ie,w as ae,x as F,y as oe}from"./description-C1KtsLjY.js";import{i as I,n as se,r as L,t as ce}from"./angle-CS1XfWio.js";import{a as le,i as ue,n as R,o as z,s as de,t as fe}from"./light-layout-DryugaYw.js";import{t as pe}from"./file-name-D6GoQUku.js";import{n as me,t as he}from"./color-Cq5HoIL4.js";import{a as ge,c as _e,r as ve,s as B,t as ye}from"./vector-BSkN5mpv.js";import{$ as V,$n as be,A as xe,An as H,C as U,Cn as W,E as G,Gn as Se,In as Ce,Jn as K,Kn as we,Ln as Te,M as Ee,Mn as De,N as Oe,Nt as ke,O as Ae,P as je,Pt as Me,Q as Ne,Qn as Pe,Rn as Fe,S as Ie,Sn as Le,T as Re,Tn as ze,Un as Be,Vn as Ve,W as He,Wn as Ue,X as We,Y as Ge,Yn as Ke,Z as qe,Zn as Je,_n as Ye,a as Xe,ar as Ze,at as Qe,b as $e,bt as et,c as tt,cr as nt,ct as rt,d as q,dn as it,dr as at,er as ot,f as J,fn as st,fr as Y,ft as ct,g as lt,gn as ut,h as dt,hn as ft,ht as pt,ir as mt,it as X,j as ht,k as gt,kt as _t,lr as vt,lt as yt,m as bt,mt as xt,nr as St,nt as Ct,o as wt,or as Tt,ot as Et,pr as Dt,pt as Ot,qn as kt,r as At,rr as Z,s as jt,sr as Mt,tr as Nt,u as Pt,un as Ft,ur as It,v as Lt,vt as Rt,wn as zt,x as Bt,xt as Vt,y as Ht,yt as Ut,zn as Wt}from"./three.core-ADDfBTJJ.js";import{t as Gt}from"./model-DuKzIxIH.js";var Kt=new WeakMap;function qt(e){let t=Kt.get(e);if(t!==void 0)return t;let n=new Xt(e);return Kt.set(e,n),n}function Jt(e){for(let t=e;t!==void 0;t=Yt(t)?.host){let e=t.closest(`phong-viewer`);if(e!==null)return t.closest(`phong-viewer > [slot]:not([slot=""])`)?.parentElement===e?null:qt(e)}return null}function Yt(e){let t=e.getRootNode();return t.nodeType===Node.DOCUMENT_FRAGMENT_NODE&&`host`in t?t:null}var Xt=class{#e;#t=new Set;#n=null;#r=null;constructor(e){this.#e=e}listen(e){this.#r=e;for(let t of this.inOrder)e.added(t)}add(e){this.#n=null,this.#t.has(e)?this.#r?.moved():(this.#t.add(e),this.#r?.added(e))}delete(e){this.#t.delete(e)&&(this.#n=null,this.#r?.removed(e))}get inOrder(){return this.#n??=Zt(this.#t,this.#e),this.#n}};function Zt(e,t){let n=[],r=Qt(e,t),i=t=>{let a=document.createTreeWalker(t,NodeFilter.SHOW_ELEMENT);for(;a.nextNode()!==null;){let t=a.currentNode;e.has(t)&&n.push(t);let o=r.get(t);o!==void 0&&i(o)}},a=r.get(t);return a!==void 0&&i(a),i(t),n}function Qt(e,t){let n=new Map,r=t.getRootNode();for(let t of e){let e=Yt(t);for(;e!==null&&e!==r&&!n.has(e.host);)n.set(e.host,e),e=Yt(e.host)}return n}var $t=class{surface=en(`div`,{part:`surface`});panel=en(`div`,{class:`panel`,part:`panel`});#e=en(`img`,{class:`poster`,part:`poster`,alt:``});#t=en(`div`,{class:`message`,role:`alert`});#n=en(`p`,{class:`notice`,part:`notice`});constructor(e,t){this.surface.append(t);let n=en(`slot`,{name:`error`});n.append(this.#n),this.#t.append(n);for(let t of[this.surface,this.panel,en(`slot`,{})])e.appendChild(t)}update({poster:e,fixed:t,notice:n}){tn(this.surface,`class`,t?`surface fixed`:`surface`),tn(this.#e,`src`,e===``?null:e),e===``?this.#e.remove():this.#e.parentNode===null&&this.surface.after(this.#e);let r=n??``;this.#n.textContent!==r&&(this.#n.textContent=r),n===null?this.#t.remove():this.#t.parentNode===null&&this.panel.before(this.#t)}};function en(e,t){let n=document.createElement(e);for(let[e,r]of Object.entries(t))n.setAttribute(e,r);return n}function tn(e,t,n){e.getAttribute(t)!==n&&(n===null?e.removeAttribute(t):e.setAttribute(t,n))}var nn=[`aria-label`,`aria-labelledby`,`role`];function rn(e,t,n){let r=t.getAttribute(`aria-label`)||t.alt,i=t.ariaLabelledByElements??null,a=on(t,`ArrowLeft ArrowRight ArrowUp ArrowDown`,`Plus - PageUp PageDown`,`Home`),o=a===``&&r===``&&i===null&&cn(t);return tn(e,`tabindex`,a===``?null:`0`),tn(e,`role`,a===``?`img`:`application`),tn(e,`aria-hidden`,o?`true`:null),tn(e,`aria-label`,r||T(n,`3D scene`)),tn(e,`aria-keyshortcuts`,a||null),(i!==null||e.hasAttribute(`aria-labelledby`))&&(e.ariaLabelledByElements=i),!o}var an=(e,t)=>on(e,T(t,`Arrow keys rotate.`),T(t,`Plus and minus zoom.`),T(t,`Home resets the camera.`)),on=({orbit:e,zoom:t},n,r,i)=>[e?n:``,t?r:``,e||t?i:``].filter(e=>e!==``).join(` `),sn=e=>cn(e)||e.matches(`[aria-label],[aria-labelledby]`)||e.closest(`[aria-hidden=true]`)!==null,cn=e=>F(e).store.given(`alt`)||e.matches(`[role=none],[role=presentation]`),ln=(function(){let e=typeof document<`u`&&document.createElement(`link`).relList;return e&&e.supports&&e.supports(`modulepreload`)?`modulepreload`:`preload`})(),un=function(e,t){return new URL(e,t).href},dn={},fn=function(e){return e.pathname.endsWith(`.css`)},pn=function(e,t,n){if(t in e)return e[t];let r=n();if(!r){e[t]=void 0;return}let i=r.then(()=>{e[t]=void 0},n=>{throw e[t]=void 0,n});return e[t]=i,i},mn=function(e,t,n){let r=Promise.resolve();if(t&&t.length>0){let e,i=document.querySelector(`meta[property=csp-nonce]`),a=i?.nonce||i?.getAttribute(`nonce`);function o(e){return Promise.all(e.map(e=>Promise.resolve(e).then(e=>({status:`fulfilled`,value:e}),e=>({status:`rejected`,reason:e}))))}function s(e){return import.meta.resolve?new URL(import.meta.resolve(e)):new URL(e,import.meta.url)}r=o(t.map(t=>{t=un(t,n);let r=s(t),i=fn(r);return pn(dn,r.href,()=>{if(e===void 0){e={all:new Set,styles:new Set};let t=document.getElementsByTagName(`link`);for(let n=t.length-1;n>=0;n--){let r=t[n];e.all.add(r.href),r.rel===`stylesheet`&&e.styles.add(r.href)}}if((i?e.styles:e.all).has(r.href))return;let t=document.createElement(`link`);if(t.rel=i?`stylesheet`:ln,i||(t.as=`script`),t.crossOrigin=``,t.href=r.href,a&&t.setAttribute(`nonce`,a),document.head.appendChild(t),i)return new Promise((e,n)=>{let i=a=>{t.removeEventListener(`load`,i),t.removeEventListener(`error`,i),a.type===`error`?n(Error(`Unable to preload CSS for ${r}`)):e(a)};t.addEventListener(`load`,i),t.addEventListener(`error`,i)})})}).filter(e=>e!==void 0))}function i(e){let t=new Event(`vite:preloadError`,{cancelable:!0});if(t.payload=e,window.dispatchEvent(t),!t.defaultPrevented)throw e}return r.then(t=>{for(let e of t||[])e.status===`rejected`&&i(e.reason);return e().catch(i)})},hn=new Set,gn=new WeakSet;function _n(e){gn.has(e)||(gn.add(e),hn.add(e),hn.size>1||(document.readyState===`loading`?document.addEventListener(`DOMContentLoaded`,xn,{once:!0}):xn()))}function vn(e){e.querySelector(`:not(:defined)`)!==null&&(gn.delete(e),_n(e))}function yn(e){let{observedAttributes:t}=e.constructor;return e.getAttributeNames().filter(e=>!t.includes(e)&&!bn.test(e))}var bn=/^(class|id|style|slot|hidden|title|lang|dir|role|tabindex)$|^(on|_)|[^\p{L}\d]/u;function xn(){setTimeout(()=>{let e=[...hn].filter(Sn);hn.clear(),e.length!==0&&mn(async()=>{let{diagnose:e}=await import(`./diagnose-CiGEBe8o.js`);return{diagnose:e}},__vite__mapDeps([0,1,2,3,4,5]),import.meta.url).then(({diagnose:t})=>t(e)).catch(()=>void 0)})}function Sn(e){return e.isConnected?yn(e).length>0?!0:e.localName===`phong-viewer`?!sn(e)||e.querySelector(`:not(phong-light, phong-mesh, :scope > [slot], :scope > [slot] *)`)!==null||Array.from(e.childNodes).some(e=>e.nodeType===Node.TEXT_NODE&&e.nodeValue?.trim()!==``):Jt(e)===null:!gn.delete(e)}var Cn=typeof HTMLElement>`u`?class{}:HTMLElement,wn,Tn=class extends Cn{static{wn=e=>{#t in e&&e.#n()}}#e;#t=null;constructor(e,t){super(),this.#e=new ae(this,e,t)}connectedCallback(){this.#n(),_n(this)}disconnectedCallback(){this.#n()}connectedMoveCallback(){this.#n()}attributeChangedCallback(e,t,n){this.#e.attributeChanged(e,n)}#n(){this.#e.upgrade();let e=Jt(this);e!==this.#t&&this.#t?.delete(this),this.#t=e,e?.add(this)}},En=class e extends Tn{static observedAttributes=x(i);constructor(){super(new t)}get name(){let{name:t}=F(this).store.values;if(t!==``)return t;let n=Jt(this)?.inOrder.filter(t=>t instanceof e)??[];return Dn(Math.max(n.indexOf(this),0))}set name(e){F(this).set(`name`,e)}},Dn=e=>`light ${String(e+1)}`;y(En.prototype,i);var On={min:0,max:r.color},kn={ka:m([200,200,200],On),kd:m([200,200,200],On),ks:m([128,128,128],On),shininess:a(32,{min:0,max:r.exponent})},An=()=>({data:new Float32Array(64),rows:R.rows,active:0,sent:0,counts:{directional:0,point:0,spot:0},features:new Uint32Array(8)});function jn(e,t,n){let r=[0,0,0];n.rows=R.rows,n.sent=0,n.active=0;for(let t of e)t.active&&Mn[S(t)].push(t);for(let e of j){let i=n.sent;for(let i of Mn[e]){n.active+=1;let a=e===`directional`&&O(i)?Ln(i):1;a!==0&&(e!==`spot`&&In(r,i.ambient,a,t.linear),Nn(i,e)&&Pn(i,e,a,t,n))}n.counts[e]=n.sent-i,Mn[e].length=0}let{directional:i,point:a,spot:o}=n.counts;Hn(n.data,R.counts*4,i,a,o,0),Hn(n.data,R.ambient*4,r[0],r[1],r[2],0)}var Mn={directional:[],point:[],spot:[]};function Nn({position:e,diffuse:t,specular:n,ambient:r},i){let a=!(N(t)&&N(n));return i===`spot`?a||!N(r):i===`directional`&&e[0]===0&&e[1]===0&&e[2]===0?!1:a}function Pn(e,t,n,r,i){let{linear:a}=r,{rows:o}=z[t];Gn(i,i.rows+o,i.sent+1);let{data:s}=i,c=i.rows*4,l=e.space===`camera`?r.cameraToShading:r.worldToShading,{position:u,attenuation:d}=e;t===`directional`?(zn(l,s,c+z.directional.direction*4,u,0),Vn(s,c+z.directional.diffuse*4,e.diffuse,n,a,0),Vn(s,c+z.directional.specular*4,e.specular,n,a,0)):(Bn(l,s,c+z.point.position*4,u[0],u[1],u[2],1,d[0]),Vn(s,c+z.point.diffuse*4,e.diffuse,1,a,d[1]),Vn(s,c+z.point.specular*4,e.specular,1,a,d[2])),t===`spot`&&(zn(l,s,c+z.spot.axis*4,e.axis,e.cutoff),Vn(s,c+z.spot.ambient*4,e.ambient,1,a,oe(e.aperture))),i.features[i.sent]=D(e,t),i.rows+=o,i.sent+=1}var Fn=(e,t)=>t?me(e/255):e/255;function In(e,t,n,r){N(t)||(e[0]+=Fn(t[0],r)*n,e[1]+=Fn(t[1],r)*n,e[2]+=Fn(t[2],r)*n)}function Ln(e){let t=_e([e.position[0],e.position[1],e.position[2]]);if(ve(t,t)===0)return 1;let n=_e(e.axis),r=Rn(t,n),i=Rn(t,B(n)),a=4*2**-52,o=re(e.aperture);return(o<0?Math.sqrt(i)>=Math.sqrt(-o)-a:Math.sqrt(r)<=Math.sqrt(o)+a)?e.cutoff<1e-6?1:i**e.cutoff:0}function Rn(e,t){let n=ye(e,t);return ve(n,n)/4}function zn(e,t,n,r,i){let a=Math.max(Math.abs(r[0]),Math.abs(r[1]),Math.abs(r[2])),o=r[0]/a,s=r[1]/a,c=r[2]/a,l=1/Math.sqrt(o*o+s*s+c*c);Bn(e,t,n,o*l,s*l,c*l,0,i)}function Bn(e,t,n,r,i,a,o,s){t[n]=e[0]*r+e[4]*i+e[8]*a+e[12]*o,t[n+1]=e[1]*r+e[5]*i+e[9]*a+e[13]*o,t[n+2]=e[2]*r+e[6]*i+e[10]*a+e[14]*o,t[n+3]=s}function Vn(e,t,n,r,i,a){e[t]=Fn(n[0],i)*r,e[t+1]=Fn(n[1],i)*r,e[t+2]=Fn(n[2],i)*r,e[t+3]=a}function Hn(e,t,n,r,i,a){e[t]=n,e[t+1]=r,e[t+2]=i,e[t+3]=a}function Un(e,t){let n=R.rows,r=0;for(let i of j)for(let a=0;a<e.counts[i];a++,n+=z[i].rows)t(r++,i,n)}function Wn(e,t,n){Gn(n,e.rows,e.sent),n.data.set(e.data.subarray(0,R.rows*4)),n.active=e.active,n.sent=0,n.rows=R.rows;for(let e of j)n.counts[e]=0;Un(e,(r,i,a)=>{if(t[r]!==1)return;let{rows:o}=z[i];n.data.set(e.data.subarray(a*4,(a+o)*4),n.rows*4),n.features[n.sent]=e.features[r],n.rows+=o,n.sent+=1,n.counts[i]+=1});let{directional:r,point:i,spot:a}=n.counts;Hn(n.data,R.counts*4,r,i,a,0)}function Gn(e,t,n){if(n>e.features.length){let t=new Uint32Array(Math.max(n,e.features.length*2));t.set(e.features),e.features=t}if(t*4<=e.data.length)return;let r=new Float32Array(Math.max(t*4,e.data.length*2));r.set(e.data),e.data=r}var Kn=`float attenuation(vec3 k,float d,float squared,int features){float sum=(features&FEATURE_LINEAR)!=0?k.x + d*(k.y + d*k.z):k.x + squared*k.z;return 1.0/((features&FEATURE_CLAMPED)!=0?max(sum,1.0):sum);}
`,qn=`struct PixelView{vec3 V;vec3 dxSum;vec3 dySum;vec3 dxN;vec3 dyN;vec3 dxP;vec3 dyP;};PixelView pixelView(vec3 p,vec3 N,vec3 V,float n){return PixelView(V,dFdx(V),dFdy(V),dFdx(N),dFdy(N),dFdx(p),dFdy(p));}PixelView pixelViewNear(PixelView view,vec3 L,float d,float n){view.dxSum -=turning(L,view.dxP,d*d);view.dySum -=turning(L,view.dyP,d*d);return view;}float specularLobe(vec3 N,vec3 L,PixelView view,float n){vec3 sum=refined(L)+ refined(view.V);float squared=dot(sum,sum);vec3 H=sum*inversesqrt(max(squared,LEAST_SUM));vec3 e=N - H;vec3 dx=view.dxN - turning(H,view.dxSum,squared);vec3 dy=view.dyN - turning(H,view.dySum,squared);float average=averagedLobe(e,1.0 - 0.5*dot(e,e),n,footprintOf(dx,dy,n));return squared>=LEAST_SUM?average:0.0;}
`,Jn=`struct PixelView{vec3 W;vec3 dxW;vec3 dyW;vec3 dxP;vec3 dyP;Footprint pixel;};PixelView pixelView(vec3 p,vec3 N,vec3 V,float n){vec3 W=specularView(N,V);vec3 dxW=dFdx(W);vec3 dyW=dFdy(W);return PixelView(W,dxW,dyW,dFdx(p),dFdy(p),footprintOf(dxW,dyW,n));}PixelView pixelViewNear(PixelView view,vec3 L,float d,float n){vec3 dx=view.dxW + turning(L,view.dxP,d*d);vec3 dy=view.dyW + turning(L,view.dyP,d*d);view.pixel=footprintOf(dx,dy,n);return view;}float specularLobe(vec3 N,vec3 L,PixelView view,float n){float average=averagedLobe(L - view.W,dot(L,view.W),n,view.pixel);return dot(view.W,view.W)>0.5?average:0.0;}
`,Yn=`float diffuseLobe(float NoL){return clamp(NoL,0.0,1.0);}
`,Xn=`float exponentOfRoughness(float roughness){float alpha=max(roughness,LEAST_ROUGHNESS);alpha*=alpha;return 0.5/(alpha*alpha)- 0.5;}float lobeScale(float n){return min((n + 2.0)/FULL_LOBE,1.0);}vec3 mappedNormal(vec3 normal,vec4 tangent,vec3 texel,float scale){vec3 N=unitInRange(normal);vec3 B=cross(N,tangent.xyz)*tangent.w;vec3 t=texel*2.0 - 1.0;return scale*(t.x*tangent.xyz + t.y*B)+ t.z*N;}
`,Zn=`struct Footprint{vec3 first;vec3 second;vec2 pull;vec2 turn;vec2 share;float peak;};Footprint footprintOf(vec3 dx,vec3 dy,float n){const float DEVIATION=0.28867513459481287;vec3 jx=dx*DEVIATION;vec3 jy=dy*DEVIATION;float d=0.5*dot(jx + jy,jx - jy);float b=dot(jx,jy);float tangent=(d<0.0?-b:b)/(abs(d)+ sqrt(max(d*d + b*b,1e-32)));float cosine=inversesqrt(1.0 + tangent*tangent);vec2 turn=vec2(cosine,tangent*cosine);vec3 first=turn.x*jx + turn.y*jy;vec3 second=turn.x*jy - turn.y*jx;vec2 squares=vec2(dot(first,first),dot(second,second));vec2 grown=1.0 + n*squares;vec2 pull=vec2(n/grown.x,n/grown.y);vec2 shares=pull*squares;vec2 turned=turn*turn;vec2 share=vec2(dot(turned,shares),dot(turned,shares.yx));return Footprint(first,second,pull,turn,share,inversesqrt(grown.x*grown.y));}float averagedLobe(vec3 e,float x,float n,Footprint pixel){vec2 along=vec2(dot(e,pixel.first),dot(e,pixel.second));vec2 t=pixel.pull*along;float nearer=0.5*dot(along,t);x=min(x + nearer,1.0);
#if defined(INTEGER_SHININESS)
float lobe=powInteger(max(x,0.0),INTEGER_SHININESS);
#elif defined(SHININESS_TO_64)
float lobe=powTo64(x,n);
#else
float lobe=powNearOne(x,max(0.5*dot(e,e)- nearer,0.0),n);
#endif
vec2 s=vec2(pixel.turn.x*t.x - pixel.turn.y*t.y,pixel.turn.y*t.x + pixel.turn.x*t.y);vec2 s2=s*s;vec2 q=pixel.share;vec2 flatness=s2*(s2 - 6.0*q)+ 3.0*q*q;return clamp(lobe*pixel.peak*(1.0 - 0.05*(flatness.x + flatness.y)),0.0,1.0);}vec3 turning(vec3 along,vec3 move,float squared){vec3 across=move - along*dot(along,move);return across*inversesqrt(max(squared + dot(across,across),NEAREST_SQUARED));}
`,Qn=`vec3 refined(vec3 unit){return unit*(1.5 - 0.5*dot(unit,unit));}vec3 unitInRange(vec3 v){float squared=dot(v,v);return squared>=NEAREST_SQUARED?v*inversesqrt(max(squared,NEAREST_SQUARED)):vec3(0.0);}vec3 unitOrZero(vec3 v){float squared=dot(v,v);if(!(squared>=1e-20&&squared<=1e30)){vec3 a=abs(v);float largest=max(a.x,max(a.y,a.z));v*=largest>1.0?1.3552527156068805e-20:1.2379400392853803e27;squared=dot(v,v);if(!(squared>=TINY))return vec3(0.0);}return v*inversesqrt(squared);}
`,$n=`struct CellSpots{int first;int count;};CellSpots cellSpots(vec3 p){int grid=int(lightRow(HEADER_COUNTS).w);vec4 low=lightRow(grid + GRID_LOW);vec4 scale=lightRow(grid + GRID_SCALE);vec3 size=lightRow(grid + GRID_SIZE).xyz;vec3 cell=clamp(floor((p - low.xyz)*scale.xyz),vec3(0.0),size - 1.0);vec2 range=lightRow(int(low.w)+ int(cell.x + size.x*(cell.y + size.y*cell.z))).xy;return CellSpots(int(range.x),int(range.y));}int unlistedSpots(){int grid=int(lightRow(HEADER_COUNTS).w);return int(lightRow(grid + GRID_SIZE).w);}int listedRow(int index){int grid=int(lightRow(HEADER_COUNTS).w);vec4 four=lightRow(int(lightRow(grid + GRID_SCALE).w)+(index>>2));return int(four[index&3]);}
`,er=`struct LightSums{vec3 ambient;vec3 diffuse;vec3 specular;float greyDiffuse;float greySpecular;};const int DECLARED_FEATURES=0
#ifdef HAS_AMBIENT
+ FEATURE_AMBIENT
#endif
#ifdef HAS_DIFFUSE
+ FEATURE_DIFFUSE + FEATURE_TINTED_DIFFUSE
#endif
#ifdef HAS_SPECULAR
+ FEATURE_SPECULAR + FEATURE_TINTED_SPECULAR
#endif
#ifdef HAS_ATTENUATION
+ FEATURE_ATTENUATED + FEATURE_CLAMPED + FEATURE_LINEAR
#endif
#ifdef HAS_CONE
+ FEATURE_NARROW + FEATURE_WIDE
#endif
#ifdef HAS_DECAY
+ FEATURE_DECAY
#endif
#if defined(HAS_CONE) || defined(HAS_DECAY)
+ FEATURE_CHORDS
#endif
;
#ifdef FILTER_HIGHLIGHTS
#define LOBE_VIEW PixelView
#else
#define LOBE_VIEW vec3
#endif
bool has(int features,int bit){return(features&bit)!=0;}void addColor(inout vec3 sum,inout float grey,vec3 color,float amount,bool tinted){if(tinted)sum +=color*amount;else grey +=color.r*amount;}void addLobes(inout LightSums sums,vec3 N,LOBE_VIEW view,vec3 L,float n,vec3 diffuse,vec3 specular,float factor,int features){float NoL=dot(N,L);if(has(features,FEATURE_DIFFUSE)){float amount=factor*diffuseLobe(NoL);addColor(sums.diffuse,sums.greyDiffuse,diffuse,amount,has(features,FEATURE_TINTED_DIFFUSE));}if(has(features,FEATURE_SPECULAR)){float amount=NoL>0.0?factor*specularLobe(N,L,view,n):0.0;addColor(sums.specular,sums.greySpecular,specular,amount,has(features,FEATURE_TINTED_SPECULAR));}}vec3 towardLight(vec3 position,vec3 p,out float d,out float squared){vec3 v=position - p;squared=dot(v,v);float inverse=squared<NEAREST_SQUARED?0.0:inversesqrt(max(squared,NEAREST_SQUARED));d=squared*inverse;return v*inverse;}void addDirectional(inout LightSums sums,int row,vec3 p,vec3 N,LOBE_VIEW view,float n,int features){vec3 L=lightRow(row + DIRECTIONAL_DIRECTION).xyz;addLobes(sums,N,view,L,n,lightRow(row + DIRECTIONAL_DIFFUSE).rgb,lightRow(row + DIRECTIONAL_SPECULAR).rgb,1.0,features);}void addAttenuated(inout LightSums sums,int row,vec3 L,float d,float squared,vec3 N,LOBE_VIEW view,float n,float factor,int features){vec4 diffuse=lightRow(row + POINT_DIFFUSE);vec4 specular=lightRow(row + POINT_SPECULAR);if(has(features,FEATURE_ATTENUATED)){vec3 k=vec3(lightRow(row + POINT_POSITION).w,diffuse.w,specular.w);factor*=attenuation(k,d,squared,features);}
#ifdef FILTER_HIGHLIGHTS
view=pixelViewNear(view,L,d,n);
#endif
addLobes(sums,N,view,L,n,diffuse.rgb,specular.rgb,factor,features);}void addPoint(inout LightSums sums,int row,vec3 p,vec3 N,LOBE_VIEW view,float n,int features){float d,squared;vec3 L=towardLight(lightRow(row + POINT_POSITION).xyz,p,d,squared);addAttenuated(sums,row,L,d,squared,N,view,n,1.0,features);}void addSpot(inout LightSums sums,int row,vec3 p,vec3 N,LOBE_VIEW view,float n,int features){float d,squared;vec3 L=towardLight(lightRow(row + SPOT_POSITION).xyz,p,d,squared);vec4 axis=lightRow(row + SPOT_AXIS);vec4 ambient=lightRow(row + SPOT_AMBIENT);bool chords=has(features,FEATURE_CHORDS);float cosHalfSquared=chords?quarterLengthSquared(L - axis.xyz):0.5 - 0.5*dot(L,axis.xyz);float sinHalfSquared=quarterLengthSquared(L + axis.xyz);sinHalfSquared=d>0.0?sinHalfSquared:0.0;cosHalfSquared=d>0.0?cosHalfSquared:1.0;bool inside=insideCone(sinHalfSquared,cosHalfSquared,ambient.w,features);float factor=inside?spotDecay(sinHalfSquared,cosHalfSquared,axis.w,features):0.0;if(has(features,FEATURE_AMBIENT))sums.ambient +=ambient.rgb*factor;addAttenuated(sums,row,L,d,squared,N,view,n,factor,features);}LightSums lightSums(vec3 p,vec3 N,vec3 V,float n){LightSums sums=LightSums(vec3(0.0),vec3(0.0),vec3(0.0),0.0,0.0);
#ifdef HAS_AMBIENT
sums.ambient=lightRow(HEADER_AMBIENT).rgb;
#endif
#ifdef FILTER_HIGHLIGHTS
LOBE_VIEW view=pixelView(p,N,V,n);
#else
LOBE_VIEW view=specularView(N,V);
#endif
#ifdef LIGHT_STATEMENTS
LIGHT_STATEMENTS
#else
ivec3 counts=ivec3(lightRow(HEADER_COUNTS).xyz);int row=HEADER_ROWS;
#ifdef HAS_DIRECTIONAL
for(int i=0;i<counts.x;i++,row +=DIRECTIONAL_ROWS)addDirectional(sums,row,p,N,view,n,DECLARED_FEATURES);
#endif
#ifdef HAS_POINT
for(int i=0;i<counts.y;i++,row +=POINT_ROWS)addPoint(sums,row,p,N,view,n,DECLARED_FEATURES);
#endif
#ifdef HAS_SPOT
for(int i=0;i<counts.z;i++,row +=SPOT_ROWS)addSpot(sums,row,p,N,view,n,DECLARED_FEATURES);
#endif
#endif
sums.diffuse +=sums.greyDiffuse;sums.specular +=sums.greySpecular;return sums;}
`,tr=`#if LIGHT_STORAGE == STORAGE_UNIFORMS
uniform highp vec4 uLightRows[LIGHT_ROWS];vec4 lightRow(int i){return uLightRows[i];}
#elif LIGHT_STORAGE == STORAGE_BLOCK
layout(std140)uniform LightRows{highp vec4 uLightRows[BLOCK_ROWS];};vec4 lightRow(int i){return uLightRows[i];}
#elif LIGHT_STORAGE == STORAGE_TEXTURE
uniform highp sampler2D uLightTexture;uniform highp vec2 uLightTextureScale;vec4 lightRow(int i){vec2 texel=vec2(float(i&((1<<TEXTURE_ROWS_LOG2)- 1)),float(i>>TEXTURE_ROWS_LOG2))+ 0.5;return texture(uLightTexture,texel*uLightTextureScale);}
#elif LIGHT_STORAGE == STORAGE_INLINED
const vec4 INLINED_ROWS[]=LIGHT_ROW_LITERALS;
#define lightRow(i) INLINED_ROWS[i]
#endif
`,nr=`vec3 nearestCode(vec3 color){return floor(clamp(color,0.0,1.0)*255.0 + 0.5)/255.0;}
`,rr=`uniform float uOpacity;
#ifdef HAS_MAP
uniform sampler2D uMap;in vec2 vMapUv;
#endif
#ifdef HAS_VERTEX_COLOR
in vec4 vColor;
#endif
#ifdef HAS_ALPHA_MASK
uniform float uAlphaCutoff;
#endif
#ifdef HAS_EMISSIVE
uniform vec3 uEmissive;
#endif
#ifdef HAS_EMISSIVE_MAP
uniform sampler2D uEmissiveMap;in vec2 vEmissiveMapUv;
#endif
#ifdef HAS_METAL_ROUGH_MAP
uniform sampler2D uMetalRoughMap;in vec2 vMetalRoughMapUv;
#endif
#if defined(HAS_METALNESS) || defined(IS_UNLIT)
uniform vec3 uBaseColor;
#endif
#ifdef HAS_METALNESS
uniform float uMetalness;uniform float uLobeScale;
#endif
#ifdef HAS_ROUGHNESS
uniform float uRoughness;
#endif
#ifdef HAS_NORMAL_MAP
uniform sampler2D uNormalMap;uniform float uNormalScale;in vec2 vNormalMapUv;in vec4 vTangent;
#endif
#ifdef IS_UNLIT
#elif defined(SHADING_GOURAUD)
in vec3 vFrontAmbient;in vec3 vFrontDiffuse;in vec3 vFrontSpecular;in vec3 vBackAmbient;in vec3 vBackDiffuse;in vec3 vBackSpecular;
#else
uniform vec3 uEye;uniform vec3 uKa;uniform vec3 uKd;uniform vec3 uKs;uniform float uShininess;in vec3 vPosition;in vec3 vNormal;
#endif
layout(location=0)out highp vec4 outColor;vec4 decodeBase(vec4 color){
#ifdef IS_LINEAR
color.rgb=srgbDecode(color.rgb);
#endif
return color;}vec4 baseColor(){vec4 color=vec4(1.0,1.0,1.0,uOpacity);
#ifdef HAS_MAP
color*=decodeBase(texture(uMap,vMapUv));
#endif
#ifdef HAS_VERTEX_COLOR
color*=decodeBase(vColor);
#endif
return color;}void main(){vec4 base=baseColor();
#ifdef HAS_ALPHA_MASK
#ifdef FILTER_HIGHLIGHTS
bool masked=base.a<uAlphaCutoff;
#else
if(base.a<uAlphaCutoff)discard;
#endif
#endif
#ifndef IS_BLENDED
base.a=1.0;
#endif
#ifdef IS_UNLIT
vec3 color=base.rgb*uBaseColor;
#else
vec3 kd=base.rgb;vec3 ks=vec3(1.0);
#ifdef HAS_METAL_ROUGH_MAP
vec3 metalRough=texture(uMetalRoughMap,vMetalRoughMapUv).rgb;
#endif
#ifdef HAS_ROUGHNESS
float n=exponentOfRoughness(uRoughness*metalRough.g);float scale=lobeScale(n);ks*=scale;
#endif
#ifdef HAS_METALNESS
float m=uMetalness;
#ifdef HAS_METAL_ROUGH_MAP
m*=metalRough.b;
#endif
#ifndef HAS_ROUGHNESS
float scale=uLobeScale;
#endif
kd*=1.0 - m;ks=mix(vec3(scale),base.rgb*uBaseColor,m);
#endif
#ifdef SHADING_GOURAUD
vec3 color=gl_FrontFacing?base.rgb*vFrontAmbient + kd*vFrontDiffuse + ks*vFrontSpecular:base.rgb*vBackAmbient + kd*vBackDiffuse + ks*vBackSpecular;
#else
#ifndef HAS_ROUGHNESS
float n=uShininess;
#endif
#ifdef HAS_NORMAL_MAP
vec3 normal=mappedNormal(vNormal,vTangent,texture(uNormalMap,vNormalMapUv).xyz,uNormalScale);
#else
vec3 normal=vNormal;
#endif
normal=gl_FrontFacing?normal:-normal;
#ifdef FILTER_HIGHLIGHTS
vec3 color=surfaceColor(vPosition,normal,uEye,base.rgb*uKa,kd*uKd,ks*uKs,n);
#else
vec3 color=unitSurfaceColor(vPosition,unitInRange(normal),uEye,base.rgb*uKa,kd*uKd,ks*uKs,n);
#endif
#endif
#ifdef HAS_EMISSIVE
vec3 emissive=uEmissive;
#ifdef HAS_EMISSIVE_MAP
emissive*=decodeBase(texture(uEmissiveMap,vEmissiveMapUv)).rgb;
#endif
color +=emissive;
#endif
#endif
#ifdef IS_LINEAR
color=srgbEncode(color);
#endif
#ifdef FILTER_HIGHLIGHTS
#ifdef HAS_ALPHA_MASK
if(masked)discard;
#endif
#endif
outColor=vec4(nearestCode(color)*base.a,base.a);}
`,ir=`in vec3 position;in vec3 normal;uniform mat4 uModelToShading;uniform mat4 uShadingToClip;uniform mat3 uNormalToShading;
#ifdef HAS_UV
in vec2 uv;
#endif
#ifdef HAS_UV1
in vec2 uv1;
#endif
#ifdef HAS_UV2
in vec2 uv2;
#endif
#ifdef HAS_UV3
in vec2 uv3;
#endif
#ifdef HAS_MAP
uniform mat3 uMapTransform;out vec2 vMapUv;
#endif
#ifdef HAS_EMISSIVE_MAP
uniform mat3 uEmissiveMapTransform;out vec2 vEmissiveMapUv;
#endif
#ifdef HAS_METAL_ROUGH_MAP
uniform mat3 uMetalRoughMapTransform;out vec2 vMetalRoughMapUv;
#endif
#ifdef HAS_NORMAL_MAP
uniform mat3 uNormalMapTransform;uniform float uMirrored;out vec2 vNormalMapUv;in vec4 tangent;out vec4 vTangent;
#endif
#ifdef HAS_VERTEX_COLOR
in vec4 color;out vec4 vColor;
#endif
#ifdef IS_UNLIT
#elif defined(SHADING_GOURAUD)
uniform vec3 uEye;uniform float uShininess;out vec3 vFrontAmbient;out vec3 vFrontDiffuse;out vec3 vFrontSpecular;out vec3 vBackAmbient;out vec3 vBackDiffuse;out vec3 vBackSpecular;uniform vec3 uKa;uniform vec3 uKd;uniform vec3 uKs;void shadeFace(vec3 p,vec3 N,vec3 V,out vec3 ambient,out vec3 diffuse,out vec3 specular){LightSums sums=lightSums(p,N,V,uShininess);ambient=uKa*sums.ambient;diffuse=uKd*sums.diffuse;specular=uKs*sums.specular;}
#else
out vec3 vPosition;out vec3 vNormal;
#endif
void main(){vec3 p=(uModelToShading*vec4(position,1.0)).xyz;
#ifdef HAS_MAP
vMapUv=(uMapTransform*vec3(MAP_UV,1.0)).xy;
#endif
#ifdef HAS_EMISSIVE_MAP
vEmissiveMapUv=(uEmissiveMapTransform*vec3(EMISSIVE_MAP_UV,1.0)).xy;
#endif
#ifdef HAS_METAL_ROUGH_MAP
vMetalRoughMapUv=(uMetalRoughMapTransform*vec3(METAL_ROUGH_MAP_UV,1.0)).xy;
#endif
#ifdef HAS_NORMAL_MAP
vNormalMapUv=(uNormalMapTransform*vec3(NORMAL_MAP_UV,1.0)).xy;vTangent=vec4(unitOrZero(mat3(uModelToShading)*tangent.xyz),tangent.w*uMirrored);
#endif
#ifdef HAS_VERTEX_COLOR
vColor=color;
#endif
#ifndef IS_UNLIT
vec3 N=unitOrZero(uNormalToShading*normal);
#ifdef SHADING_GOURAUD
vec3 V=unitOrZero(uEye - p);shadeFace(p,N,V,vFrontAmbient,vFrontDiffuse,vFrontSpecular);shadeFace(p,-N,V,vBackAmbient,vBackDiffuse,vBackSpecular);
#else
vPosition=p;vNormal=N;
#endif
#endif
gl_Position=uShadingToClip*vec4(p,1.0);}
`,ar=`const float LOG2_E=1.4426950408889634;float powNearOne(float x,float y,float k){if(k<LEAST_EXPONENT)return 1.0;if(!(x>=TINY))return 0.0;float z=y/(2.0 - y);float z2=z*z;float series=-2.0*LOG2_E*z*(1.0 + z2*(1.0/3.0 + z2*(1.0/5.0 + z2*(1.0/7.0))));float log2x=y<0.25?series:log2(x);return exp2(k*log2x);}float powTo64(float x,float k){float power=exp2(k*log2(max(x,TINY)));return x>=TINY||k<LEAST_EXPONENT?power:0.0;}float powFrom1(float x,float k){return exp2(k*log2(max(x,TINY)));}float powInteger(float x,int k){float result=(k&1)!=0?x:1.0;float square=x*x;if((k&2)!=0)result*=square;square*=square;if((k&4)!=0)result*=square;square*=square;if((k&8)!=0)result*=square;square*=square;if((k&16)!=0)result*=square;square*=square;if((k&32)!=0)result*=square;square*=square;return(k&64)!=0?result*square:result;}
`,or=`const float LEAST_SUM=1e-12;vec3 specularView(vec3 N,vec3 V){return V;}
#ifndef FILTER_HIGHLIGHTS
float specularLobe(vec3 N,vec3 L,vec3 V,float n){vec3 sum=refined(L)+ refined(V);float squared=dot(sum,sum);
#if defined(INTEGER_SHININESS)
float NoH=dot(N,sum)*inversesqrt(max(squared,LEAST_SUM));return squared>=LEAST_SUM?powInteger(clamp(NoH,0.0,1.0),INTEGER_SHININESS):0.0;
#else
vec3 H=squared>=LEAST_SUM?sum*inversesqrt(squared):vec3(0.0);
#if defined(SHININESS_TO_64)
return powTo64(dot(N,H),n);
#else
vec3 d=N - H;return powNearOne(dot(N,H),0.5*dot(d,d),n);
#endif
#endif
}
#endif
`,sr=`vec3 specularView(vec3 N,vec3 V){return 2.0*dot(N,V)*N - V;}
#ifndef FILTER_HIGHLIGHTS
float specularLobe(vec3 N,vec3 L,vec3 W,float n){float RoV=dot(L,W);
#if defined(INTEGER_SHININESS)
return powInteger(clamp(RoV,0.0,1.0),INTEGER_SHININESS);
#elif defined(SHININESS_TO_64)
return powTo64(RoV,n);
#else
vec3 d=L - W;return powNearOne(RoV,0.5*dot(d,d),n);
#endif
}
#endif
`,cr=`float quarterLengthSquared(vec3 v){return 0.25*dot(v,v);}bool insideCone(float sinHalfSquared,float cosHalfSquared,float limit,int features){bool narrow=(features&FEATURE_NARROW)!=0;bool wide=(features&FEATURE_WIDE)!=0;if(narrow&&wide)return limit<0.0?cosHalfSquared>=-limit:sinHalfSquared<=limit;if(narrow)return sinHalfSquared<=limit;if(wide)return cosHalfSquared>=-limit;return true;}float spotDecay(float sinHalfSquared,float cosHalfSquared,float cutoff,int features){int integer=features>>FEATURE_POWER_SHIFT;bool chords=(features&FEATURE_CHORDS)!=0;if(integer>0)return powInteger(chords?1.0 - sinHalfSquared:cosHalfSquared,integer);if((features&FEATURE_DECAY)!=0&&!chords)return powFrom1(cosHalfSquared,cutoff);if((features&FEATURE_DECAY_TO64)!=0)return powTo64(cosHalfSquared,cutoff);if((features&FEATURE_DECAY)!=0)return powNearOne(cosHalfSquared,sinHalfSquared,cutoff);return 1.0;}
`,lr=`vec3 srgbDecode(vec3 encoded){vec3 e=max(encoded,0.0);vec3 line=e/SRGB_SLOPE;vec3 curve=pow((e + SRGB_OFFSET)/(1.0 + SRGB_OFFSET),vec3(SRGB_EXPONENT));return mix(curve,line,lessThanEqual(e,vec3(SRGB_ENCODED_KNEE)));}vec3 srgbEncode(vec3 linear){vec3 l=max(linear,0.0);vec3 line=l*SRGB_SLOPE;vec3 curve=(1.0 + SRGB_OFFSET)*pow(max(l,SRGB_LINEAR_KNEE),vec3(1.0/SRGB_EXPONENT))- SRGB_OFFSET;return mix(curve,line,lessThanEqual(l,vec3(SRGB_LINEAR_KNEE)));}
`,ur=`#ifdef FILTER_HIGHLIGHTS
const float FARTHEST=1e18;
#endif
vec3 unitSurfaceColor(vec3 p,vec3 N,vec3 eye,vec3 ka,vec3 kd,vec3 ks,float n){LightSums sums=lightSums(p,N,unitInRange(eye - p),n);return ka*sums.ambient + kd*sums.diffuse + ks*sums.specular;}vec3 surfaceColor(vec3 p,vec3 normal,vec3 eye,vec3 ka,vec3 kd,vec3 ks,float n){
#ifdef FILTER_HIGHLIGHTS
p=clamp(p,-FARTHEST,FARTHEST);normal=clamp(normal,-FARTHEST,FARTHEST);
#endif
return unitSurfaceColor(p,unitOrZero(normal),eye,ka,kd,ks,n);}
`,dr={unlit:!1,emissive:[0,0,0],emissiveMap:null,metalness:0,roughness:null,metalRoughMap:null,normalMap:null,normalScale:1},fr=.045;function pr(e){let t=Math.max(e,fr)**2;return .5/(t*t)-.5}var mr=e=>Math.min((e+2)/34,1),hr=e=>e.toExponential(),gr=`${de()}
#define STORAGE_UNIFORMS 0
#define STORAGE_BLOCK 1
#define STORAGE_TEXTURE 2
#define STORAGE_INLINED 3
#define STORAGE_OWN 4
#define SRGB_ENCODED_KNEE ${hr(he.encodedKnee)}
#define SRGB_LINEAR_KNEE ${hr(he.linearKnee)}
#define SRGB_SLOPE ${hr(he.slope)}
#define SRGB_OFFSET ${hr(he.offset)}
#define SRGB_EXPONENT ${hr(he.exponent)}
`,_r=[`#ifdef FILTER_HIGHLIGHTS`,Zn,`#ifdef REFLECTION_BLINN_PHONG`,qn,`#else`,Jn,`#endif`,`#endif`].join(`
`),vr=`#define LEAST_ROUGHNESS ${hr(fr)}
#define FULL_LOBE ${hr(34)}
${Xn}`,yr=(...e)=>[gr,Qn,ar,Kn,cr,Yn,`#ifdef REFLECTION_BLINN_PHONG`,or,`#else`,sr,`#endif`,tr,...e,er,ur].join(`
`),br=yr(_r,$n),xr=[lr,nr].join(`
`),Sr=`precision highp float;
precision highp int;`,Cr=new Map;function wr(e){let t=`SHADING_GOURAUD`in e,n=`FILTER_HIGHLIGHTS`in e,r=`HAS_LIGHT_GRID`in e,i=`IS_UNLIT`in e,a=`HAS_METAL_ROUGH_MAP`in e||`HAS_NORMAL_MAP`in e,o=[t,n,r,i,a].join(),s=Cr.get(o);if(s===void 0){let e=yr(...n?[_r]:[],...r?[$n]:[]),c=`${gr}\n${Qn}`;s={vertexShader:[Sr,t&&!i?e:c,ir].join(`
`),fragmentShader:[Sr,t||i?c:e,xr,...a?[vr]:[],rr].join(`
`)},Cr.set(o,s)}return s}var Tr=[`phong`,`gouraud`,`flat`],Er=[`phong`,`blinn-phong`],Dr=[`edges`,`highlights`],Or=[`ambient`,`diffuse`,`specular`],kr={map:`MAP`,emissiveMap:`EMISSIVE_MAP`,metalRoughMap:`METAL_ROUGH_MAP`,normalMap:`NORMAL_MAP`};function Ar(e,t,n){let{shading:r,reflection:i,terms:a,antialias:o,alphaMode:s,unlit:c}=e,l=c?ie():{...t};for(let e of Or)l[e]&&=a.includes(e);let u={SHADING_GOURAUD:r===`gouraud`,REFLECTION_BLINN_PHONG:i===`blinn-phong`,FILTER_HIGHLIGHTS:o===`highlights`&&l.specular&&r!==`gouraud`,SHININESS_TO_64:e.shininessTo64,IS_LINEAR:e.linear,IS_UNLIT:c,HAS_EMISSIVE:e.emissive,HAS_METALNESS:e.metalness,HAS_ROUGHNESS:e.roughness,HAS_VERTEX_COLOR:e.vertexColors,HAS_ALPHA_MASK:s===`mask`,IS_BLENDED:s===`blend`};for(let[e,t]of Object.entries(l))u[`HAS_${e.toUpperCase()}`]=t;let d=jr(n);for(let[e,t]of Object.entries(u))t&&(d[e]=``);for(let[t,n]of Object.entries(e.maps)){let e=kr[t],r=n===0?`uv`:`uv${String(n)}`;Object.assign(d,{[`HAS_${e}`]:``,[`${e}_UV`]:r,[`HAS_${r.toUpperCase()}`]:``})}return Mr(d)}var jr=e=>e>0?{LIGHT_STORAGE:`STORAGE_UNIFORMS`,LIGHT_ROWS:String(e)}:{LIGHT_STORAGE:`STORAGE_TEXTURE`};function Mr(e){let t=Object.entries(e).sort(([e],[t])=>e<t?-1:1),n=Object.fromEntries(t);return{defines:n,key:t.map(e=>e.join(`=`)).join(` `),...wr(n)}}function Nr({defines:e},{terms:t,integerShininess:n},r,i){let a={...e};return t.includes(`ambient`)||delete a.HAS_AMBIENT,n!==null&&(a.INTEGER_SHININESS=String(n)),r===`grid`&&(Object.assign(a,{...jr(0),HAS_LIGHT_GRID:``}),delete a.LIGHT_ROWS),r===`inlined`&&(a.LIGHT_STORAGE=`STORAGE_INLINED`,a.LIGHT_ROW_LITERALS=Br(i),delete a.LIGHT_ROWS),a.LIGHT_STATEMENTS=Ir[r](i,zr(t)),Mr(a)}var Pr=(e,t,n)=>`add${e.charAt(0).toUpperCase()}${e.slice(1)}(sums,${t},p,N,view,n,${String(n)});`,Fr=32,Ir={counted(e,t){let n=Rr(e,t),r=``;return Lr(e,(e,t,i)=>{for(let a=0;a<i;a+=Fr){let o=Math.min(i-a,Fr),s=t+a*z[e].rows,c=Pr(e,`${String(s)}+i*${String(z[e].rows)}`,n[e]);r+=`for(int i=0;i<${String(o)};i++)${c}`}}),r},inlined(e,t){let n=``;return Un(e,(r,i,a)=>{n+=Pr(i,String(a),e.features[r]&t)}),n},grid(e,t){let{directional:n,point:r,spot:i}=Rr(e,t),a=(e,t,n)=>`for(int i=0;i<${t};i++,row+=${String(z[e].rows)})${Pr(e,`row`,n)}`;return[`ivec3 counts=ivec3(lightRow(HEADER_COUNTS).xyz);int row=HEADER_ROWS;`,a(`directional`,`counts.x`,n),a(`point`,`counts.y`,r),a(`spot`,`unlistedSpots()`,i),`CellSpots cell=cellSpots(p);`,`for(int i=0;i<cell.count;i++)${Pr(`spot`,`listedRow(cell.first+i)`,i)}`].join(``)}};function Lr({counts:e},t){let n=R.rows;for(let r of j)e[r]>0&&t(r,n,e[r]),n+=e[r]*z[r].rows}function Rr(e,t){let n={directional:-1,point:-1,spot:-1};Un(e,(r,i)=>{let a=e.features[r]&t;n[i]=n[i]===-1?a:w(n[i],a)});for(let e of j)n[e]===-1&&(n[e]=0);return n}function zr(e){let t=0;return e.includes(`ambient`)||(t|=ue.ambient),e.includes(`diffuse`)||(t|=ue.diffuse|ue.tintedDiffuse),e.includes(`specular`)||(t|=ue.specular|ue.tintedSpecular),~t}function Br({data:e,rows:t}){let n=t=>`vec4(${Array.from(e.subarray(t*4,t*4+4),e=>e.toExponential(8)).join()})`;return`vec4[](${Array.from({length:t},(e,t)=>n(t)).join()})`}function Vr(){let e=null,t=!1,n=null,r=null;function i(t,a){r=e.requestAnimationFrame(i),n(t,a)}return{start:function(){t!==!0&&n!==null&&e!==null&&(r=e.requestAnimationFrame(i),t=!0)},stop:function(){e!==null&&e.cancelAnimationFrame(r),t=!1},setAnimationLoop:function(e){n=e},setContext:function(t){e=t}}}function Hr(e){let t=new WeakMap;function n(t,n){let r=t.array,i=t.usage,a=r.byteLength,o=e.createBuffer();e.bindBuffer(n,o),e.bufferData(n,r,i),t.onUploadCallback();let s;if(r instanceof Float32Array)s=e.FLOAT;else if(typeof Float16Array<`u`&&r instanceof Float16Array)s=e.HALF_FLOAT;else if(r instanceof Uint16Array)s=t.isFloat16BufferAttribute?e.HALF_FLOAT:e.UNSIGNED_SHORT;else if(r instanceof Int16Array)s=e.SHORT;else if(r instanceof Uint32Array)s=e.UNSIGNED_INT;else if(r instanceof Int32Array)s=e.INT;else if(r instanceof Int8Array)s=e.BYTE;else if(r instanceof Uint8Array)s=e.UNSIGNED_BYTE;else if(r instanceof Uint8ClampedArray)s=e.UNSIGNED_BYTE;else throw Error(`THREE.WebGLAttributes: Unsupported buffer data format: `+r);return{buffer:o,type:s,bytesPerElement:r.BYTES_PER_ELEMENT,version:t.version,size:a}}function r(t,n,r){let i=n.array,a=n.updateRanges;if(e.bindBuffer(r,t),a.length===0)e.bufferSubData(r,0,i);else{a.sort((e,t)=>e.start-t.start);let t=0;for(let e=1;e<a.length;e++){let n=a[t],r=a[e];r.start<=n.start+n.count+1?n.count=Math.max(n.count,r.start+r.count-n.start):(++t,a[t]=r)}a.length=t+1;for(let t=0,n=a.length;t<n;t++){let n=a[t];e.bufferSubData(r,n.start*i.BYTES_PER_ELEMENT,i,n.start,n.count)}n.clearUpdateRanges()}n.onUploadCallback()}function i(e){return e.isInterleavedBufferAttribute&&(e=e.data),t.get(e)}function a(n){n.isInterleavedBufferAttribute&&(n=n.data);let r=t.get(n);r&&(e.deleteBuffer(r.buffer),t.delete(n))}function o(e,i){if(e.isInterleavedBufferAttribute&&(e=e.data),e.isGLBufferAttribute){let n=t.get(e);(!n||n.version<e.version)&&t.set(e,{buffer:e.buffer,type:e.type,bytesPerElement:e.elementSize,version:e.version});return}let a=t.get(e);if(a===void 0)t.set(e,n(e,i));else if(a.version<e.version){if(a.size!==e.array.byteLength)throw Error(`THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.`);r(a.buffer,e,i),a.version=e.version}}return{get:i,remove:a,update:o}}var Q={alphahash_fragment:`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,alphahash_pars_fragment:`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,alphamap_fragment:`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,alphamap_pars_fragment:`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,alphatest_fragment:`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,alphatest_pars_fragment:`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,aomap_fragment:`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,aomap_pars_fragment:`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,batching_pars_vertex:`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,batching_vertex:`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,begin_vertex:`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,beginnormal_vertex:`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,bsdfs:`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,iridescence_fragment:`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,bumpmap_pars_fragment:`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,clipping_planes_fragment:`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,clipping_planes_pars_fragment:`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,clipping_planes_pars_vertex:`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,clipping_planes_vertex:`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,color_fragment:`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,color_pars_fragment:`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,color_pars_vertex:`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,color_vertex:`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,common:`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,defaultnormal_vertex:`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,displacementmap_pars_vertex:`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,displacementmap_vertex:`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,emissivemap_fragment:`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,emissivemap_pars_fragment:`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,colorspace_fragment:`gl_FragColor = linearToOutputTexel( gl_FragColor );`,colorspace_pars_fragment:`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,envmap_fragment:`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,envmap_common_pars_fragment:`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,envmap_pars_fragment:`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,envmap_pars_vertex:`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,envmap_physical_pars_fragment:`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,envmap_vertex:`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,fog_vertex:`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,fog_pars_vertex:`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,fog_fragment:`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,fog_pars_fragment:`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,gradientmap_pars_fragment:`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,lightmap_pars_fragment:`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,lights_lambert_fragment:`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,lights_lambert_pars_fragment:`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,lights_pars_begin:`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,lights_toon_fragment:`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,lights_toon_pars_fragment:`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,lights_phong_fragment:`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,lights_phong_pars_fragment:`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,lights_physical_fragment:`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,lights_physical_pars_fragment:`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,lights_fragment_begin:`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,lights_fragment_maps:`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,lights_fragment_end:`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,lightprobes_pars_fragment:`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,logdepthbuf_fragment:`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,logdepthbuf_pars_fragment:`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,logdepthbuf_pars_vertex:`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,logdepthbuf_vertex:`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,map_fragment:`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,map_pars_fragment:`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,map_particle_fragment:`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,map_particle_pars_fragment:`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,metalnessmap_fragment:`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,metalnessmap_pars_fragment:`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,morphinstance_vertex:`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,morphcolor_vertex:`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,morphnormal_vertex:`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,morphtarget_pars_vertex:`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,morphtarget_vertex:`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,normal_fragment_begin:`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,normal_fragment_maps:`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,normal_pars_fragment:`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,normal_pars_vertex:`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,normal_vertex:`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,normalmap_pars_fragment:`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,clearcoat_normal_fragment_begin:`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,clearcoat_normal_fragment_maps:`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,clearcoat_pars_fragment:`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,iridescence_pars_fragment:`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,opaque_fragment:`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,packing:`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,premultiplied_alpha_fragment:`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,project_vertex:`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,dithering_fragment:`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,dithering_pars_fragment:`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,roughnessmap_fragment:`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,roughnessmap_pars_fragment:`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,shadowmap_pars_fragment:`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,shadowmap_pars_vertex:`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,shadowmap_vertex:`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,shadowmask_pars_fragment:`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,skinbase_vertex:`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,skinning_pars_vertex:`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,skinning_vertex:`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,skinnormal_vertex:`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,specularmap_fragment:`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,specularmap_pars_fragment:`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,tonemapping_fragment:`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,tonemapping_pars_fragment:`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,transmission_fragment:`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,transmission_pars_fragment:`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,uv_pars_fragment:`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,uv_pars_vertex:`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,uv_vertex:`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,worldpos_vertex:`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,background_vert:`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,background_frag:`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,backgroundCube_vert:`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,backgroundCube_frag:`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,cube_vert:`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,cube_frag:`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,depth_vert:`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,depth_frag:`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,distance_vert:`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,distance_frag:`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,equirect_vert:`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,equirect_frag:`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,linedashed_vert:`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,linedashed_frag:`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,meshbasic_vert:`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,meshbasic_frag:`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,meshlambert_vert:`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,meshlambert_frag:`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,meshmatcap_vert:`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,meshmatcap_frag:`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,meshnormal_vert:`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,meshnormal_frag:`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,meshphong_vert:`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,meshphong_frag:`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,meshphysical_vert:`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,meshphysical_frag:`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,meshtoon_vert:`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,meshtoon_frag:`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,points_vert:`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,points_frag:`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,shadow_vert:`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,shadow_frag:`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,sprite_vert:`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,sprite_frag:`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`},$={common:{diffuse:{value:new q(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new X},alphaMap:{value:null},alphaMapTransform:{value:new X},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new X}},envmap:{envMap:{value:null},envMapRotation:{value:new X},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new X}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new X}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new X},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new X},normalScale:{value:new kt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new X},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new X}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new X}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new X}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new q(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new q(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new X},alphaTest:{value:0},uvTransform:{value:new X}},sprite:{diffuse:{value:new q(16777215)},opacity:{value:1},center:{value:new kt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new X},alphaMap:{value:null},alphaMapTransform:{value:new X},alphaTest:{value:0}}},Ur={basic:{uniforms:vt([$.common,$.specularmap,$.envmap,$.aomap,$.lightmap,$.fog]),vertexShader:Q.meshbasic_vert,fragmentShader:Q.meshbasic_frag},lambert:{uniforms:vt([$.common,$.specularmap,$.envmap,$.aomap,$.lightmap,$.emissivemap,$.bumpmap,$.normalmap,$.displacementmap,$.fog,$.lights,{emissive:{value:new q(0)},envMapIntensity:{value:1}}]),vertexShader:Q.meshlambert_vert,fragmentShader:Q.meshlambert_frag},phong:{uniforms:vt([$.common,$.specularmap,$.envmap,$.aomap,$.lightmap,$.emissivemap,$.bumpmap,$.normalmap,$.displacementmap,$.fog,$.lights,{emissive:{value:new q(0)},specular:{value:new q(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Q.meshphong_vert,fragmentShader:Q.meshphong_frag},standard:{uniforms:vt([$.common,$.envmap,$.aomap,$.lightmap,$.emissivemap,$.bumpmap,$.normalmap,$.displacementmap,$.roughnessmap,$.metalnessmap,$.fog,$.lights,{emissive:{value:new q(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Q.meshphysical_vert,fragmentShader:Q.meshphysical_frag},toon:{uniforms:vt([$.common,$.aomap,$.lightmap,$.emissivemap,$.bumpmap,$.normalmap,$.displacementmap,$.gradientmap,$.fog,$.lights,{emissive:{value:new q(0)}}]),vertexShader:Q.meshtoon_vert,fragmentShader:Q.meshtoon_frag},matcap:{uniforms:vt([$.common,$.bumpmap,$.normalmap,$.displacementmap,$.fog,{matcap:{value:null}}]),vertexShader:Q.meshmatcap_vert,fragmentShader:Q.meshmatcap_frag},points:{uniforms:vt([$.points,$.fog]),vertexShader:Q.points_vert,fragmentShader:Q.points_frag},dashed:{uniforms:vt([$.common,$.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Q.linedashed_vert,fragmentShader:Q.linedashed_frag},depth:{uniforms:vt([$.common,$.displacementmap]),vertexShader:Q.depth_vert,fragmentShader:Q.depth_frag},normal:{uniforms:vt([$.common,$.bumpmap,$.normalmap,$.displacementmap,{opacity:{value:1}}]),vertexShader:Q.meshnormal_vert,fragmentShader:Q.meshnormal_frag},sprite:{uniforms:vt([$.sprite,$.fog]),vertexShader:Q.sprite_vert,fragmentShader:Q.sprite_frag},background:{uniforms:{uvTransform:{value:new X},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Q.background_vert,fragmentShader:Q.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new X}},vertexShader:Q.backgroundCube_vert,fragmentShader:Q.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Q.cube_vert,fragmentShader:Q.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Q.equirect_vert,fragmentShader:Q.equirect_frag},distance:{uniforms:vt([$.common,$.displacementmap,{referencePosition:{value:new K},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Q.distance_vert,fragmentShader:Q.distance_frag},shadow:{uniforms:vt([$.lights,$.fog,{color:{value:new q(0)},opacity:{value:1}}]),vertexShader:Q.shadow_vert,fragmentShader:Q.shadow_frag}};Ur.physical={uniforms:vt([Ur.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new X},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new X},clearcoatNormalScale:{value:new kt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new X},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new X},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new X},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new X},sheen:{value:0},sheenColor:{value:new q(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new X},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new X},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new X},transmissionSamplerSize:{value:new kt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new X},attenuationDistance:{value:0},attenuationColor:{value:new q(0)},specularColor:{value:new q(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new X},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new X},anisotropyVector:{value:new kt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new X}}]),vertexShader:Q.meshphysical_vert,fragmentShader:Q.meshphysical_frag};var Wr={r:0,b:0,g:0},Gr=new Qe,Kr=new X;Kr.set(-1,0,0,0,1,0,0,0,1);function qr(e,t,n,r,i,a){let o=new q(0),s=i===!0?0:1,c,l,u=null,d=0,f=null;function p(e){let n=e.isScene===!0?e.background:null;if(n&&n.isTexture){let r=e.backgroundBlurriness>0;n=t.get(n,r)}return n}function m(t){let r=!1,i=p(t);i===null?g(o,s):i&&i.isColor&&(g(i,1),r=!0);let c=e.xr.getEnvironmentBlendMode();c===`additive`?n.buffers.color.setClear(0,0,0,1,a):c===`alpha-blend`&&n.buffers.color.setClear(0,0,0,0,a),(e.autoClear||r)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),e.clear(e.autoClearColor,e.autoClearDepth,e.autoClearStencil))}function h(t,n){let i=p(n);i&&i.isCubeTexture?(l===void 0&&(l=new Et(new wt(1,1,1),new ze({name:`BackgroundCubeMaterial`,uniforms:ot(Ur.backgroundCube.uniforms),vertexShader:Ur.backgroundCube.vertexShader,fragmentShader:Ur.backgroundCube.fragmentShader,side:1,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute(`normal`),l.geometry.deleteAttribute(`uv`),l.onBeforeRender=function(e,t,n){this.matrixWorld.copyPosition(n.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),r.update(l)),l.material.uniforms.envMap.value=i,l.material.uniforms.backgroundBlurriness.value=n.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=n.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(Gr.makeRotationFromEuler(n.backgroundRotation)).transpose(),i.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Kr),l.material.toneMapped=J.getTransfer(i.colorSpace)!==W,(u!==i||d!==i.version||f!==e.toneMapping)&&(l.material.needsUpdate=!0,u=i,d=i.version,f=e.toneMapping),l.layers.enableAll(),t.unshift(l,l.geometry,l.material,0,0,null)):i&&i.isTexture&&(c===void 0&&(c=new Et(new Vt(2,2),new ze({name:`BackgroundMaterial`,uniforms:ot(Ur.background.uniforms),vertexShader:Ur.background.vertexShader,fragmentShader:Ur.background.fragmentShader,side:0,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute(`normal`),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),r.update(c)),c.material.uniforms.t2D.value=i,c.material.uniforms.backgroundIntensity.value=n.backgroundIntensity,c.material.toneMapped=J.getTransfer(i.colorSpace)!==W,i.matrixAutoUpdate===!0&&i.updateMatrix(),c.material.uniforms.uvTransform.value.copy(i.matrix),(u!==i||d!==i.version||f!==e.toneMapping)&&(c.material.needsUpdate=!0,u=i,d=i.version,f=e.toneMapping),c.layers.enableAll(),t.unshift(c,c.geometry,c.material,0,0,null))}function g(t,r){t.getRGB(Wr,Mt(e)),n.buffers.color.setClear(Wr.r,Wr.g,Wr.b,r,a)}function _(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(e,t=1){o.set(e),s=t,g(o,s)},getClearAlpha:function(){return s},setClearAlpha:function(e){s=e,g(o,s)},render:m,addToRenderList:h,dispose:_}}function Jr(e,t){let n=e.getParameter(e.MAX_VERTEX_ATTRIBS),r={},i=f(null),a=i,o=!1;function s(n,r,i,s,c){let u=!1,f=d(n,s,i,r);a!==f&&(a=f,l(a.object)),u=p(n,s,i,c),u&&m(n,s,i,c),c!==null&&t.update(c,e.ELEMENT_ARRAY_BUFFER),(u||o)&&(o=!1,b(n,r,i,s),c!==null&&e.bindBuffer(e.ELEMENT_ARRAY_BUFFER,t.get(c).buffer))}function c(){return e.createVertexArray()}function l(t){return e.bindVertexArray(t)}function u(t){return e.deleteVertexArray(t)}function d(e,t,n,i){let a=i.wireframe===!0,o=r[t.id];o===void 0&&(o={},r[t.id]=o);let s=e.isInstancedMesh===!0?e.id:0,l=o[s];l===void 0&&(l={},o[s]=l);let u=l[n.id];u===void 0&&(u={},l[n.id]=u);let d=u[a];return d===void 0&&(d=f(c()),u[a]=d),d}function f(e){let t=[],r=[],i=[];for(let e=0;e<n;e++)t[e]=0,r[e]=0,i[e]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:t,enabledAttributes:r,attributeDivisors:i,object:e,attributes:{},index:null}}function p(e,t,n,r){let i=a.attributes,o=t.attributes,s=0,c=n.getAttributes();for(let t in c)if(c[t].location>=0){let n=i[t],r=o[t];if(r===void 0&&(t===`instanceMatrix`&&e.instanceMatrix&&(r=e.instanceMatrix),t===`instanceColor`&&e.instanceColor&&(r=e.instanceColor)),n===void 0||n.attribute!==r||r&&n.data!==r.data)return!0;s++}return a.attributesNum!==s||a.index!==r}function m(e,t,n,r){let i={},o=t.attributes,s=0,c=n.getAttributes();for(let t in c)if(c[t].location>=0){let n=o[t];n===void 0&&(t===`instanceMatrix`&&e.instanceMatrix&&(n=e.instanceMatrix),t===`instanceColor`&&e.instanceColor&&(n=e.instanceColor));let r={};r.attribute=n,n&&n.data&&(r.data=n.data),i[t]=r,s++}a.attributes=i,a.attributesNum=s,a.index=r}function h(){let e=a.newAttributes;for(let t=0,n=e.length;t<n;t++)e[t]=0}function g(e){_(e,0)}function _(t,n){let r=a.newAttributes,i=a.enabledAttributes,o=a.attributeDivisors;r[t]=1,i[t]===0&&(e.enableVertexAttribArray(t),i[t]=1),o[t]!==n&&(e.vertexAttribDivisor(t,n),o[t]=n)}function v(){let t=a.newAttributes,n=a.enabledAttributes;for(let r=0,i=n.length;r<i;r++)n[r]!==t[r]&&(e.disableVertexAttribArray(r),n[r]=0)}function y(t,n,r,i,a,o,s){s===!0?e.vertexAttribIPointer(t,n,r,a,o):e.vertexAttribPointer(t,n,r,i,a,o)}function b(n,r,i,a){h();let o=a.attributes,s=i.getAttributes(),c=r.defaultAttributeValues;for(let r in s){let i=s[r];if(i.location>=0){let s=o[r];if(s===void 0&&(r===`instanceMatrix`&&n.instanceMatrix&&(s=n.instanceMatrix),r===`instanceColor`&&n.instanceColor&&(s=n.instanceColor)),s!==void 0){let r=s.normalized,o=s.itemSize,c=t.get(s);if(c===void 0)continue;let l=c.buffer,u=c.type,d=c.bytesPerElement,f=u===e.INT||u===e.UNSIGNED_INT||s.gpuType===1013;if(s.isInterleavedBufferAttribute){let t=s.data,c=t.isInterleavedBuffer===!0?t.stride:t.itemSize,p=s.offset;if(t.isInstancedInterleavedBuffer||t.isInstancedBufferAttribute){for(let e=0;e<i.locationSize;e++)_(i.location+e,t.meshPerAttribute);n.isInstancedMesh!==!0&&a._maxInstanceCount===void 0&&(a._maxInstanceCount=t.meshPerAttribute*t.count)}else for(let e=0;e<i.locationSize;e++)g(i.location+e);e.bindBuffer(e.ARRAY_BUFFER,l);for(let e=0;e<i.locationSize;e++)y(i.location+e,o/i.locationSize,u,r,c*d,(p+o/i.locationSize*e)*d,f)}else{if(s.isInstancedBufferAttribute){for(let e=0;e<i.locationSize;e++)_(i.location+e,s.meshPerAttribute);n.isInstancedMesh!==!0&&a._maxInstanceCount===void 0&&(a._maxInstanceCount=s.meshPerAttribute*s.count)}else for(let e=0;e<i.locationSize;e++)g(i.location+e);e.bindBuffer(e.ARRAY_BUFFER,l);for(let e=0;e<i.locationSize;e++)y(i.location+e,o/i.locationSize,u,r,o*d,o/i.locationSize*e*d,f)}}else if(c!==void 0){let t=c[r];if(t!==void 0)switch(t.length){case 2:e.vertexAttrib2fv(i.location,t);break;case 3:e.vertexAttrib3fv(i.location,t);break;case 4:e.vertexAttrib4fv(i.location,t);break;default:e.vertexAttrib1fv(i.location,t)}}}}v()}function x(){T();for(let e in r){let t=r[e];for(let e in t){let n=t[e];for(let e in n){let t=n[e];for(let e in t)u(t[e].object),delete t[e];delete n[e]}}delete r[e]}}function S(e){if(r[e.id]===void 0)return;let t=r[e.id];for(let e in t){let n=t[e];for(let e in n){let t=n[e];for(let e in t)u(t[e].object),delete t[e];delete n[e]}}delete r[e.id]}function C(e){for(let t in r){let n=r[t];for(let t in n){let r=n[t];if(r[e.id]===void 0)continue;let i=r[e.id];for(let e in i)u(i[e].object),delete i[e];delete r[e.id]}}}function w(e){for(let t in r){let n=r[t],i=e.isInstancedMesh===!0?e.id:0,a=n[i];if(a!==void 0){for(let e in a){let t=a[e];for(let e in t)u(t[e].object),delete t[e];delete a[e]}delete n[i],Object.keys(n).length===0&&delete r[t]}}}function T(){E(),o=!0,a!==i&&(a=i,l(a.object))}function E(){i.geometry=null,i.program=null,i.wireframe=!1}return{setup:s,reset:T,resetDefaultState:E,dispose:x,releaseStatesOfGeometry:S,releaseStatesOfObject:w,releaseStatesOfProgram:C,initAttributes:h,enableAttribute:g,disableUnusedAttributes:v}}function Yr(e,t,n){let r;function i(e){r=e}function a(t,i){e.drawArrays(r,t,i),n.update(i,r,1)}function o(t,i,a){a!==0&&(e.drawArraysInstanced(r,t,i,a),n.update(i,r,a))}function s(e,i,a){if(a===0)return;t.get(`WEBGL_multi_draw`).multiDrawArraysWEBGL(r,e,0,i,0,a);let o=0;for(let e=0;e<a;e++)o+=i[e];n.update(o,r,1)}this.setMode=i,this.render=a,this.renderInstances=o,this.renderMultiDraw=s}function Xr(e,t,n,r){let i;function a(){if(i!==void 0)return i;if(t.has(`EXT_texture_filter_anisotropic`)===!0){let n=t.get(`EXT_texture_filter_anisotropic`);i=e.getParameter(n.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else i=0;return i}function o(t){return t===1023||r.convert(t)===e.getParameter(e.IMPLEMENTATION_COLOR_READ_FORMAT)}function s(n){let i=n===1016&&(t.has(`EXT_color_buffer_half_float`)||t.has(`EXT_color_buffer_float`));return!(n!==1009&&n!==1015&&!i&&r.convert(n)!==e.getParameter(e.IMPLEMENTATION_COLOR_READ_TYPE))}function c(t){if(t===`highp`){if(e.getShaderPrecisionFormat(e.VERTEX_SHADER,e.HIGH_FLOAT).precision>0&&e.getShaderPrecisionFormat(e.FRAGMENT_SHADER,e.HIGH_FLOAT).precision>0)return`highp`;t=`mediump`}return t===`mediump`&&e.getShaderPrecisionFormat(e.VERTEX_SHADER,e.MEDIUM_FLOAT).precision>0&&e.getShaderPrecisionFormat(e.FRAGMENT_SHADER,e.MEDIUM_FLOAT).precision>0?`mediump`:`lowp`}let l=n.precision===void 0?`highp`:n.precision,u=c(l);u!==l&&(Y(`WebGLRenderer:`,l,`not supported, using`,u,`instead.`),l=u);let d=n.reversedDepthBuffer===!0&&t.has(`EXT_clip_control`),f=n.logarithmicDepthBuffer===!0&&d===!1;n.reversedDepthBuffer===!0&&d===!1&&Y(`WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer.`),n.logarithmicDepthBuffer===!0&&d===!0&&Y(`WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.`);let p=e.getParameter(e.MAX_TEXTURE_IMAGE_UNITS),m=e.getParameter(e.MAX_VERTEX_TEXTURE_IMAGE_UNITS),h=e.getParameter(e.MAX_TEXTURE_SIZE),g=e.getParameter(e.MAX_CUBE_MAP_TEXTURE_SIZE),_=e.getParameter(e.MAX_VERTEX_ATTRIBS),v=e.getParameter(e.MAX_VERTEX_UNIFORM_VECTORS),y=e.getParameter(e.MAX_VARYING_VECTORS),b=e.getParameter(e.MAX_FRAGMENT_UNIFORM_VECTORS),x=e.getParameter(e.MAX_SAMPLES),S=e.getParameter(e.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:a,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:s,precision:l,logarithmicDepthBuffer:f,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:m,maxTextureSize:h,maxCubemapSize:g,maxAttributes:_,maxVertexUniforms:v,maxVaryings:y,maxFragmentUniforms:b,maxSamples:x,samples:S}}function Zr(e){let t=this,n=null,r=0,i=!1,a=!1,o=new et,s=new X,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(e,t){let n=e.length!==0||t||r!==0||i;return i=t,r=e.length,n},this.beginShadows=function(){a=!0,u(null)},this.endShadows=function(){a=!1},this.setGlobalState=function(e,t){n=u(e,t,0)},this.setState=function(t,o,s){let d=t.clippingPlanes,f=t.clipIntersection,p=t.clipShadows,m=e.get(t);if(!i||d===null||d.length===0||a&&!p)a?u(null):l();else{let e=a?0:r,t=e*4,i=m.clippingState||null;c.value=i,i=u(d,o,t,s);for(let e=0;e!==t;++e)i[e]=n[e];m.clippingState=i,this.numIntersection=f?this.numPlanes:0,this.numPlanes+=e}};function l(){c.value!==n&&(c.value=n,c.needsUpdate=r>0),t.numPlanes=r,t.numIntersection=0}function u(e,n,r,i){let a=e===null?0:e.length,l=null;if(a!==0){if(l=c.value,i!==!0||l===null){let t=r+a*4,i=n.matrixWorldInverse;s.getNormalMatrix(i),(l===null||l.length<t)&&(l=new Float32Array(t));for(let t=0,n=r;t!==a;++t,n+=4)o.copy(e[t]).applyMatrix4(i,s),o.normal.toArray(l,n),l[n+3]=o.constant}c.value=l,c.needsUpdate=!0}return t.numPlanes=a,t.numIntersection=0,l}}var Qr=class extends Pe{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},r=[n,n,n,n,n,n];this.texture=new lt(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},r=new wt(5,5,5),i=new ze({name:`CubemapFromEquirect`,uniforms:ot(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:1,blending:0});i.uniforms.tEquirect.value=t;let a=new Et(r,i),o=t.minFilter;return t.minFilter===1008&&(t.minFilter=Ge),new bt(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,r=!0){let i=e.getRenderTarget();for(let i=0;i<6;i++)e.setRenderTarget(this,i),e.clear(t,n,r);e.setRenderTarget(i)}},$r=256,ei=3,ti=20,ni=256,ri=16,ii=3,ai=new K,oi=new q,si=class e{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new bt(1,10,null),this._boxMesh=new Et(new wt(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,r=100,i={}){let{size:a=256,position:o=ai}=i,s=this._renderer;this._setSize(a);let c=this._allocateTarget(),l=this._getSourceTarget(!0);t>0&&(l.texture.mipmapsAutoUpdate=!1);let u=s.autoClear,d=s.autoClearColor,f=s.autoClearDepth,p=s.autoClearStencil,m=e.background;s.autoClear=!0,s.autoClearColor=!0,s.autoClearDepth=!0,s.autoClearStencil=!0,m===null&&(e.background=s.getClearColor(oi));let h=new bt(n,r,l);return h.position.copy(o),h.update(s,e),s.autoClear=u,s.autoClearColor=d,s.autoClearDepth=f,s.autoClearStencil=p,e.background=m,t>0&&(l.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=mi(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=pi(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max($r,mt(e))}_fromTexture(e,t){e.mapping===301||e.mapping===302?this._setSize(e.image.length===0?$r:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=ci(e,!1,!1),n=Math.log2(e)-ei;for(let r=0;r<=n;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name=`PMREM`,t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=ci(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let r=this._boxMesh,i=this._cubeCamera;r.material=n,i.renderTarget=e,i.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),i.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===301||e.mapping===302?(this._cubemapMaterial===null&&(this._cubemapMaterial=mi()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=pi()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=ui(),this._integrationMaterial=di());let n=this._cubeSize,r=t.texture.mipmaps.length-1,i=this._ggxMaterial.uniforms;i.envMap.value=this._sourceTarget.texture;let a=this._integrationMaterial.uniforms;a.envMap.value=this._sourceTarget.texture,a.sourceLod.value=Math.log2(n/ri);for(let o=0;o<=r;o++){let s=e.lodToRoughness(o,r);if(o>r-ii)a.roughness.value=s,this._renderCube(t,o,this._integrationMaterial);else{let e=s>0?Math.log2(n)+.5*Math.log2(6/(ni*s**4))+.5:0;i.roughness.value=s,i.lodBias.value=e,this._renderCube(t,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=fi());let n=this._blurMaterial,r=n.uniforms,i=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=i.texture,this._renderCube(e,0,n),r.envMap.value=e.texture,this._renderCube(i,0,n)}};function ci(e,t,n){return new Qr(e,{minFilter:We,generateMipmaps:t,type:je,colorSpace:Ne,depthBuffer:n})}function li(e,t,n){return new ze({name:e,uniforms:t,vertexShader:Q.cube_vert,fragmentShader:n,side:1,blending:0,depthTest:!1,depthWrite:!1})}function ui(){return li(`PMREMGGXConvolution`,{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${ni}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function di(){return li(`PMREMGGXIntegration`,{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:ri}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function fi(){return li(`PMREMSphericalGaussianBlur`,{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${ti}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function pi(){return li(`PMREMEquirectangularToCubemap`,{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function mi(){return li(`PMREMCubemapToCubemap`,{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function hi(e){let t=new WeakMap,n=new WeakMap,r=null;function i(e,t=!1){return e==null?null:t?o(e):a(e)}function a(n){if(n&&n.isTexture){let r=n.mapping;if(r===303||r===304){if(t.has(n)){let e=t.get(n).texture;return s(e,n.mapping)}{let r=n.image;if(r&&r.height>0){let i=new Qr(r.height);return i.fromEquirectangularTexture(e,n),t.set(n,i),n.addEventListener(`dispose`,l),s(i.texture,n.mapping)}return null}}}return n}function o(t){if(t&&t.isTexture&&t.isPMREMTexture!==!0){let i=t.mapping,a=i===303||i===304,o=i===301||i===302;if(a||o){let i=n.get(t),s=i===void 0?0:i.texture.pmremVersion;if(t.isRenderTargetTexture&&t.pmremVersion!==s)return r===null&&(r=new si(e)),i=a?r.fromEquirectangular(t,i):r.fromCubemap(t,i),i.texture.pmremVersion=t.pmremVersion,n.set(t,i),i.texture;if(i!==void 0)return i.texture;{let s=t.image;return a&&s&&s.height>0||o&&s&&c(s)?(r===null&&(r=new si(e)),i=a?r.fromEquirectangular(t):r.fromCubemap(t),i.texture.pmremVersion=t.pmremVersion,n.set(t,i),t.addEventListener(`dispose`,u),i.texture):null}}}return t}function s(e,t){return t===303?e.mapping=301:t===304&&(e.mapping=302),e}function c(e){let t=0;for(let n=0;n<6;n++)e[n]!==void 0&&t++;return t===6}function l(e){let n=e.target;n.removeEventListener(`dispose`,l);let r=t.get(n);r!==void 0&&(t.delete(n),r.dispose())}function u(e){let t=e.target;t.removeEventListener(`dispose`,u);let r=n.get(t);r!==void 0&&(n.delete(t),r.dispose())}function d(){t=new WeakMap,n=new WeakMap,r!==null&&(r.dispose(),r=null)}return{get:i,dispose:d}}function gi(e){let t={};function n(n){if(t[n]!==void 0)return t[n];let r=e.getExtension(n);return t[n]=r,r}return{has:function(e){return n(e)!==null},init:function(){n(`EXT_color_buffer_float`),n(`WEBGL_clip_cull_distance`),n(`OES_texture_float_linear`),n(`EXT_color_buffer_half_float`),n(`WEBGL_multisampled_render_to_texture`),n(`WEBGL_render_shared_exponent`)},get:function(e){let t=n(e);return t===null&&Dt(`WebGLRenderer: `+e+` extension not supported.`),t}}}function _i(e,t,n,r){let i={},a=new WeakMap,o=new FinalizationRegistry(e=>delete i[e]);function s(e){c(e.target)}function c(e){e.index!==null&&t.remove(e.index);for(let n in e.attributes)t.remove(e.attributes[n]);e.removeEventListener(`dispose`,s),delete i[e.id],o.unregister(e);let c=a.get(e);c&&(t.remove(c),a.delete(e)),r.releaseStatesOfGeometry(e),e.isInstancedBufferGeometry===!0&&delete e._maxInstanceCount,n.memory.geometries--}function l(e,t){return i[t.id]===void 0&&(t.addEventListener(`dispose`,s),i[t.id]=new WeakRef(t),o.register(t,t.id,t),n.memory.geometries++),t}function u(n){let r=n.attributes;for(let n in r)t.update(r[n],e.ARRAY_BUFFER)}function d(e){let n=e.index,r=e.attributes.position,i=0;if(r===void 0)return;let o=n===null?r.array.length/3-1:n.array.length,s=new(r.count>=65535?Te:Ce)(Math.ceil(o/3)*6,1),c=s.array;if(n!==null){let e=n.array;i=n.version;for(let t=0,n=0;t<o;t+=3){let r=e[t+0],i=e[t+1],a=e[t+2];c[n++]=r,c[n++]=i,c[n++]=i,c[n++]=a,c[n++]=a,c[n++]=r}}else{i=r.version;for(let e=0,t=0;e<o;e+=3){let n=e+0,r=e+1,i=e+2;c[t++]=n,c[t++]=r,c[t++]=r,c[t++]=i,c[t++]=i,c[t++]=n}}s.version=i;let l=a.get(e);l&&t.remove(l),a.set(e,s)}function f(e){let t=a.get(e);if(t){let n=e.index;n!==null&&t.version<n.version&&d(e)}else d(e);return a.get(e)}function p(){for(let e in i){let t=i[e].deref();t!==void 0&&c(t)}}return{get:l,update:u,getWireframeAttribute:f,dispose:p}}function vi(e,t,n){let r;function i(e){r=e}let a,o;function s(e){a=e.type,o=e.bytesPerElement}function c(t,i){e.drawElements(r,i,a,t*o),n.update(i,r,1)}function l(t,i,s){s!==0&&(e.drawElementsInstanced(r,i,a,t*o,s),n.update(i,r,s))}function u(e,i,o){if(o===0)return;t.get(`WEBGL_multi_draw`).multiDrawElementsWEBGL(r,i,0,a,e,0,o);let s=0;for(let e=0;e<o;e++)s+=i[e];n.update(s,r,1)}this.setMode=i,this.setIndex=s,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function yi(e){let t={geometries:0,textures:0},n={frame:0,calls:0,triangles:0,points:0,lines:0};function r(t,r,i){switch(n.calls++,r){case e.TRIANGLES:n.triangles+=t/3*i;break;case e.LINES:n.lines+=t/2*i;break;case e.LINE_STRIP:n.lines+=i*(t-1);break;case e.LINE_LOOP:n.lines+=i*t;break;case e.POINTS:n.points+=i*t;break;default:Z(`WebGLInfo: Unknown draw mode:`,r)}}function i(){n.calls=0,n.triangles=0,n.points=0,n.lines=0}return{memory:t,render:n,programs:null,autoReset:!0,reset:i,update:r}}function bi(e,t,n){let r=new WeakMap,i=new Ke;function a(a,o,s){let c=a.morphTargetInfluences,l=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,u=l===void 0?0:l.length,d=r.get(o);if(d===void 0||d.count!==u){d!==void 0&&d.texture.dispose();let e=o.morphAttributes.position!==void 0,n=o.morphAttributes.normal!==void 0,a=o.morphAttributes.color!==void 0,s=o.morphAttributes.position||[],c=o.morphAttributes.normal||[],l=o.morphAttributes.color||[],f=0;e===!0&&(f=1),n===!0&&(f=2),a===!0&&(f=3);let p=o.attributes.position.count*f,m=1;p>t.maxTextureSize&&(m=Math.ceil(p/t.maxTextureSize),p=t.maxTextureSize);let h=new Float32Array(p*m*4*u),g=new Ht(h,p,m,u);g.type=gt,g.needsUpdate=!0;let _=f*4;for(let t=0;t<u;t++){let r=s[t],o=c[t],u=l[t],d=p*m*4*t;for(let t=0;t<r.count;t++){let s=t*_;e===!0&&(i.fromBufferAttribute(r,t),h[d+s+0]=i.x,h[d+s+1]=i.y,h[d+s+2]=i.z,h[d+s+3]=0),n===!0&&(i.fromBufferAttribute(o,t),h[d+s+4]=i.x,h[d+s+5]=i.y,h[d+s+6]=i.z,h[d+s+7]=0),a===!0&&(i.fromBufferAttribute(u,t),h[d+s+8]=i.x,h[d+s+9]=i.y,h[d+s+10]=i.z,h[d+s+11]=u.itemSize===4?i.w:1)}}d={count:u,texture:g,size:new kt(p,m)},r.set(o,d);function v(){g.dispose(),r.delete(o),o.removeEventListener(`dispose`,v)}o.addEventListener(`dispose`,v)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)s.getUniforms().setValue(e,`morphTexture`,a.morphTexture,n);else{let t=0;for(let e=0;e<c.length;e++)t+=c[e];let n=o.morphTargetsRelative?1:1-t;s.getUniforms().setValue(e,`morphTargetBaseInfluence`,n),s.getUniforms().setValue(e,`morphTargetInfluences`,c)}s.getUniforms().setValue(e,`morphTargetsTexture`,d.texture,n),s.getUniforms().setValue(e,`morphTargetsTextureSize`,d.size)}return{update:a}}function xi(e,t,n,r,i){let a=new WeakMap;function o(r){let o=i.render.frame,s=r.geometry,l=t.get(r,s);if(a.get(l)!==o&&(t.update(l),a.set(l,o)),r.isInstancedMesh&&(r.hasEventListener(`dispose`,c)===!1&&r.addEventListener(`dispose`,c),a.get(r)!==o&&(n.update(r.instanceMatrix,e.ARRAY_BUFFER),r.instanceColor!==null&&n.update(r.instanceColor,e.ARRAY_BUFFER),a.set(r,o))),r.isSkinnedMesh){let e=r.skeleton;a.get(e)!==o&&(e.update(),a.set(e,o))}return l}function s(){a=new WeakMap}function c(e){let t=e.target;t.removeEventListener(`dispose`,c),r.releaseStatesOfObject(t),n.remove(t.instanceMatrix),t.instanceColor!==null&&n.remove(t.instanceColor)}return{update:o,dispose:s}}var Si={1:`LINEAR_TONE_MAPPING`,2:`REINHARD_TONE_MAPPING`,3:`CINEON_TONE_MAPPING`,4:`ACES_FILMIC_TONE_MAPPING`,6:`AGX_TONE_MAPPING`,7:`NEUTRAL_TONE_MAPPING`,5:`CUSTOM_TONE_MAPPING`};function Ci(e,t,n,r,i,a){let o=new Pe(t,n,{type:e,depthBuffer:i,stencilBuffer:a,samples:r?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),s=null,c=null,l=null,u=new tt;u.setAttribute(`position`,new Ae([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute(`uv`,new Ae([0,2,0,0,2,0],2));let d=new st({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new Et(u,d),p=new Rt(-1,1,1,-1,0,1),m=null,h=null,g=!1,_,v=null,y=[],b=!1;this.setSize=function(e,t){o.setSize(e,t),s!==null&&s.setSize(e,t),c!==null&&c.setSize(e,t);for(let n=0;n<y.length;n++){let r=y[n];r.setSize&&r.setSize(e,t)}},this.setEffects=function(e){y=e,b=y.length>0&&y[0].isRenderPass===!0;let t=o.width,n=o.height;y.length>0&&s===null&&(s=new Pe(t,n,{type:je,depthBuffer:!1,stencilBuffer:!1}),c=new Pe(t,n,{type:je,depthBuffer:!1,stencilBuffer:!1}));let r=i===!0&&y.some(e=>e.needsDepthTexture===!0);r!==(o.depthTexture!==null)&&(r===!0&&l===null&&(l=new U(t,n),a===!0&&(l.format=Ie,l.type=Ve)),o.dispose(),o.depthTexture=r?l:null,o.resolveDepthBuffer=r,o.storeMultisampledDepthBuffer=r);for(let e=0;e<y.length;e++){let i=y[e];i.setSize&&i.setSize(t,n),r&&i.needsDepthTexture===!0&&i.setDepthTexture&&i.setDepthTexture(l)}},this.begin=function(e,t){if(g||e.toneMapping===0&&y.length===0)return!1;if(v=t,t!==null){let e=t.width,n=t.height;(o.width!==e||o.height!==n)&&this.setSize(e,n)}return b===!1&&e.setRenderTarget(o),_=e.toneMapping,e.toneMapping=0,!0},this.hasRenderPass=function(){return b},this.end=function(e,t){e.toneMapping=_,g=!0;let n=o,r=s;for(let i=0;i<y.length;i++){let a=y[i];a.enabled!==!1&&(a.render(e,r,n,t),a.needsSwap!==!1&&(n=r,r=r===s?c:s))}if(m!==e.outputColorSpace||h!==e.toneMapping){m=e.outputColorSpace,h=e.toneMapping,d.defines={},J.getTransfer(m)===`srgb`&&(d.defines.SRGB_TRANSFER=``);let t=Si[h];t&&(d.defines[t]=``),d.needsUpdate=!0}d.uniforms.tDiffuse.value=n.texture,e.setRenderTarget(v),e.render(f,p),v=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),s!==null&&s.dispose(),c!==null&&c.dispose(),u.dispose(),d.dispose()}}var wi=new De,Ti=new U(1,1),Ei=new dt(1),Di=new Ht,Oi=new Lt,ki=new lt,Ai=[],ji=[],Mi=new Float32Array(16),Ni=new Float32Array(9),Pi=new Float32Array(4);function Fi(e,t,n){let r=e[0];if(r<=0||r>0)return e;let i=t*n,a=Ai[i];if(a===void 0&&(a=new Float32Array(i),Ai[i]=a),t!==0){r.toArray(a,0);for(let r=1,i=0;r!==t;++r)i+=n,e[r].toArray(a,i)}return a}function Ii(e,t){if(e.length!==t.length)return!1;for(let n=0,r=e.length;n<r;n++)if(e[n]!==t[n])return!1;return!0}function Li(e,t){for(let n=0,r=t.length;n<r;n++)e[n]=t[n]}function Ri(e,t){let n=ji[t];n===void 0&&(n=new Int32Array(t),ji[t]=n);for(let r=0;r!==t;++r)n[r]=e.allocateTextureUnit();return n}function zi(e,t){let n=this.cache;n[0]!==t&&(e.uniform1f(this.addr,t),n[0]=t)}function Bi(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2f(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(Ii(n,t))return;e.uniform2fv(this.addr,t),Li(n,t)}}function Vi(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3f(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else if(t.r!==void 0)(n[0]!==t.r||n[1]!==t.g||n[2]!==t.b)&&(e.uniform3f(this.addr,t.r,t.g,t.b),n[0]=t.r,n[1]=t.g,n[2]=t.b);else{if(Ii(n,t))return;e.uniform3fv(this.addr,t),Li(n,t)}}function Hi(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4f(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(Ii(n,t))return;e.uniform4fv(this.addr,t),Li(n,t)}}function Ui(e,t){let n=this.cache,r=t.elements;if(r===void 0){if(Ii(n,t))return;e.uniformMatrix2fv(this.addr,!1,t),Li(n,t)}else{if(Ii(n,r))return;Pi.set(r),e.uniformMatrix2fv(this.addr,!1,Pi),Li(n,r)}}function Wi(e,t){let n=this.cache,r=t.elements;if(r===void 0){if(Ii(n,t))return;e.uniformMatrix3fv(this.addr,!1,t),Li(n,t)}else{if(Ii(n,r))return;Ni.set(r),e.uniformMatrix3fv(this.addr,!1,Ni),Li(n,r)}}function Gi(e,t){let n=this.cache,r=t.elements;if(r===void 0){if(Ii(n,t))return;e.uniformMatrix4fv(this.addr,!1,t),Li(n,t)}else{if(Ii(n,r))return;Mi.set(r),e.uniformMatrix4fv(this.addr,!1,Mi),Li(n,r)}}function Ki(e,t){let n=this.cache;n[0]!==t&&(e.uniform1i(this.addr,t),n[0]=t)}function qi(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2i(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(Ii(n,t))return;e.uniform2iv(this.addr,t),Li(n,t)}}function Ji(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3i(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else{if(Ii(n,t))return;e.uniform3iv(this.addr,t),Li(n,t)}}function Yi(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4i(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(Ii(n,t))return;e.uniform4iv(this.addr,t),Li(n,t)}}function Xi(e,t){let n=this.cache;n[0]!==t&&(e.uniform1ui(this.addr,t),n[0]=t)}function Zi(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2ui(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(Ii(n,t))return;e.uniform2uiv(this.addr,t),Li(n,t)}}function Qi(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3ui(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else{if(Ii(n,t))return;e.uniform3uiv(this.addr,t),Li(n,t)}}function $i(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4ui(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(Ii(n,t))return;e.uniform4uiv(this.addr,t),Li(n,t)}}function ea(e){return e.version===0&&(e.compareFunction=519,e.needsUpdate=!0),e}function ta(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i);let a;a=this.type===e.SAMPLER_2D_SHADOW?ea(Ti):wi,n.setTexture2D(t||a,i)}function na(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i),n.setTexture3D(t||Oi,i)}function ra(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i);let a;a=this.type===e.SAMPLER_CUBE_SHADOW?ea(Ei):ki,n.setTextureCube(t||a,i)}function ia(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i),n.setTexture2DArray(t||Di,i)}function aa(e){switch(e){case 5126:return zi;case 35664:return Bi;case 35665:return Vi;case 35666:return Hi;case 35674:return Ui;case 35675:return Wi;case 35676:return Gi;case 5124:case 35670:return Ki;case 35667:case 35671:return qi;case 35668:case 35672:return Ji;case 35669:case 35673:return Yi;case 5125:return Xi;case 36294:return Zi;case 36295:return Qi;case 36296:return $i;case 35678:case 36198:case 36298:case 36306:case 35682:return ta;case 35679:case 36299:case 36307:return na;case 35680:case 36300:case 36308:case 36293:return ra;case 36289:case 36303:case 36311:case 36292:return ia}}function oa(e,t){e.uniform1fv(this.addr,t)}function sa(e,t){let n=Fi(t,this.size,2);e.uniform2fv(this.addr,n)}function ca(e,t){let n=Fi(t,this.size,3);e.uniform3fv(this.addr,n)}function la(e,t){let n=Fi(t,this.size,4);e.uniform4fv(this.addr,n)}function ua(e,t){let n=Fi(t,this.size,4);e.uniformMatrix2fv(this.addr,!1,n)}function da(e,t){let n=Fi(t,this.size,9);e.uniformMatrix3fv(this.addr,!1,n)}function fa(e,t){let n=Fi(t,this.size,16);e.uniformMatrix4fv(this.addr,!1,n)}function pa(e,t){e.uniform1iv(this.addr,t)}function ma(e,t){e.uniform2iv(this.addr,t)}function ha(e,t){e.uniform3iv(this.addr,t)}function ga(e,t){e.uniform4iv(this.addr,t)}function _a(e,t){e.uniform1uiv(this.addr,t)}function va(e,t){e.uniform2uiv(this.addr,t)}function ya(e,t){e.uniform3uiv(this.addr,t)}function ba(e,t){e.uniform4uiv(this.addr,t)}function xa(e,t,n){let r=this.cache,i=t.length,a=Ri(n,i);Ii(r,a)||(e.uniform1iv(this.addr,a),Li(r,a));let o;o=this.type===e.SAMPLER_2D_SHADOW?ea(Ti):wi;for(let e=0;e!==i;++e)n.setTexture2D(t[e]||o,a[e])}function Sa(e,t,n){let r=this.cache,i=t.length,a=Ri(n,i);Ii(r,a)||(e.uniform1iv(this.addr,a),Li(r,a));for(let e=0;e!==i;++e)n.setTexture3D(t[e]||Oi,a[e])}function Ca(e,t,n){let r=this.cache,i=t.length,a=Ri(n,i);Ii(r,a)||(e.uniform1iv(this.addr,a),Li(r,a));let o;o=this.type===e.SAMPLER_CUBE_SHADOW?ea(Ei):ki;for(let e=0;e!==i;++e)n.setTextureCube(t[e]||o,a[e])}function wa(e,t,n){let r=this.cache,i=t.length,a=Ri(n,i);Ii(r,a)||(e.uniform1iv(this.addr,a),Li(r,a));for(let e=0;e!==i;++e)n.setTexture2DArray(t[e]||Di,a[e])}function Ta(e){switch(e){case 5126:return oa;case 35664:return sa;case 35665:return ca;case 35666:return la;case 35674:return ua;case 35675:return da;case 35676:return fa;case 5124:case 35670:return pa;case 35667:case 35671:return ma;case 35668:case 35672:return ha;case 35669:case 35673:return ga;case 5125:return _a;case 36294:return va;case 36295:return ya;case 36296:return ba;case 35678:case 36198:case 36298:case 36306:case 35682:return xa;case 35679:case 36299:case 36307:return Sa;case 35680:case 36300:case 36308:case 36293:return Ca;case 36289:case 36303:case 36311:case 36292:return wa}}var Ea=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=aa(t.type)}},Da=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Ta(t.type)}},Oa=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let r=this.seq;for(let i=0,a=r.length;i!==a;++i){let a=r[i];a.setValue(e,t[a.id],n)}}},ka=/(\w+)(\])?(\[|\.)?/g;function Aa(e,t){e.seq.push(t),e.map[t.id]=t}function ja(e,t,n){let r=e.name,i=r.length;for(ka.lastIndex=0;;){let a=ka.exec(r),o=ka.lastIndex,s=a[1],c=a[2]===`]`,l=a[3];if(c&&(s|=0),l===void 0||l===`[`&&o+2===i){Aa(n,l===void 0?new Ea(s,e,t):new Da(s,e,t));break}{let e=n.map[s];e===void 0&&(e=new Oa(s),Aa(n,e)),n=e}}}var Ma=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let r=0;r<n;++r){let n=e.getActiveUniform(t,r);ja(n,e.getUniformLocation(t,n.name),this)}let r=[],i=[];for(let t of this.seq)t.type===e.SAMPLER_2D_SHADOW||t.type===e.SAMPLER_CUBE_SHADOW||t.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(t):i.push(t);r.length>0&&(this.seq=r.concat(i))}setValue(e,t,n,r){let i=this.map[t];i!==void 0&&i.setValue(e,n,r)}setOptional(e,t,n){let r=t[n];r!==void 0&&this.setValue(e,n,r)}static upload(e,t,n,r){for(let i=0,a=t.length;i!==a;++i){let a=t[i],o=n[a.id];o.needsUpdate!==!1&&a.setValue(e,o.value,r)}}static seqWithValue(e,t){let n=[];for(let r=0,i=e.length;r!==i;++r){let i=e[r];i.id in t&&n.push(i)}return n}};function Na(e,t,n){let r=e.createShader(t);return e.shaderSource(r,n),e.compileShader(r),r}var Pa=37297,Fa=0;function Ia(e,t){let n=e.split(`
`),r=[],i=Math.max(t-6,0),a=Math.min(t+6,n.length);for(let e=i;e<a;e++){let i=e+1;r.push(`${i===t?`>`:` `} ${i}: ${n[e]}`)}return r.join(`
`)}var La=new X;function Ra(e){J._getMatrix(La,J.workingColorSpace,e);let t=`mat3( ${La.elements.map(e=>e.toFixed(4))} )`;switch(J.getTransfer(e)){case V:return[t,`LinearTransferOETF`];case W:return[t,`sRGBTransferOETF`];default:return Y(`WebGLProgram: Unsupported color space: `,e),[t,`LinearTransferOETF`]}}function za(e,t,n){let r=e.getShaderParameter(t,e.COMPILE_STATUS),i=(e.getShaderInfoLog(t)||``).trim();if(r&&i===``)return``;let a=/ERROR: 0:(\d+)/.exec(i);if(a){let r=parseInt(a[1]);return n.toUpperCase()+`

`+i+`

`+Ia(e.getShaderSource(t),r)}return i}function Ba(e,t){let n=Ra(t);return[`vec4 ${e}( vec4 value ) {`,`	return ${n[1]}( vec4( ${n[0]} * value.rgb, value.a ) );`,`}`].join(`
`)}var Va={1:`Linear`,2:`Reinhard`,3:`Cineon`,4:`ACESFilmic`,6:`AgX`,7:`Neutral`,5:`Custom`};function Ha(e,t){let n=Va[t];return n===void 0?(Y(`WebGLProgram: Unsupported toneMapping:`,t),`vec3 `+e+`( vec3 color ) { return LinearToneMapping( color ); }`):`vec3 `+e+`( vec3 color ) { return `+n+`ToneMapping( color ); }`}var Ua=new K;function Wa(){return J.getLuminanceCoefficients(Ua),[`float luminance( const in vec3 rgb ) {`,`	const vec3 weights = vec3( ${Ua.x.toFixed(4)}, ${Ua.y.toFixed(4)}, ${Ua.z.toFixed(4)} );`,`	return dot( weights, rgb );`,`}`].join(`
`)}function Ga(e){return[e.extensionClipCullDistance?`#extension GL_ANGLE_clip_cull_distance : require`:``,e.extensionMultiDraw?`#extension GL_ANGLE_multi_draw : require`:``].filter(Ja).join(`
`)}function Ka(e){let t=[];for(let n in e){let r=e[n];r!==!1&&t.push(`#define `+n+` `+r)}return t.join(`
`)}function qa(e,t){let n={},r=e.getProgramParameter(t,e.ACTIVE_ATTRIBUTES);for(let i=0;i<r;i++){let r=e.getActiveAttrib(t,i),a=r.name,o=1;r.type===e.FLOAT_MAT2&&(o=2),r.type===e.FLOAT_MAT3&&(o=3),r.type===e.FLOAT_MAT4&&(o=4),n[a]={type:r.type,location:e.getAttribLocation(t,a),locationSize:o}}return n}function Ja(e){return e!==``}function Ya(e,t){let n=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return e.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,n).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Xa(e,t){return e.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Za=/^[ \t]*#include +<([\w\d./]+)>/gm;function Qa(e){return e.replace(Za,$a)}function $a(e,t){let n=Q[t];if(n===void 0)throw Error(`THREE.WebGLProgram: Can not resolve #include <`+t+`>`);return Qa(n)}var eo=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function to(e){return e.replace(eo,no)}function no(e,t,n,r){let i=``;for(let e=parseInt(t);e<parseInt(n);e++)i+=r.replace(/\[\s*i\s*\]/g,`[ `+e+` ]`).replace(/UNROLLED_LOOP_INDEX/g,e);return i}function ro(e){let t=`precision ${e.precision} float;
	precision ${e.precision} int;
	precision ${e.precision} sampler2D;
	precision ${e.precision} samplerCube;
	precision ${e.precision} sampler3D;
	precision ${e.precision} sampler2DArray;
	precision ${e.precision} sampler2DShadow;
	precision ${e.precision} samplerCubeShadow;
	precision ${e.precision} sampler2DArrayShadow;
	precision ${e.precision} isampler2D;
	precision ${e.precision} isampler3D;
	precision ${e.precision} isamplerCube;
	precision ${e.precision} isampler2DArray;
	precision ${e.precision} usampler2D;
	precision ${e.precision} usampler3D;
	precision ${e.precision} usamplerCube;
	precision ${e.precision} usampler2DArray;
	`;return e.precision===`highp`?t+=`
#define HIGH_PRECISION`:e.precision===`mediump`?t+=`
#define MEDIUM_PRECISION`:e.precision===`lowp`&&(t+=`
#define LOW_PRECISION`),t}var io={1:`SHADOWMAP_TYPE_PCF`,3:`SHADOWMAP_TYPE_VSM`};function ao(e){return io[e.shadowMapType]||`SHADOWMAP_TYPE_BASIC`}var oo={302:`ENVMAP_MODE_REFRACTION`};function so(e){return e.envMap===!1?`ENVMAP_MODE_REFLECTION`:oo[e.envMapMode]||`ENVMAP_MODE_REFLECTION`}var co={0:`ENVMAP_BLENDING_MULTIPLY`,1:`ENVMAP_BLENDING_MIX`,2:`ENVMAP_BLENDING_ADD`};function lo(e){return e.envMap===!1?`ENVMAP_BLENDING_NONE`:co[e.combine]||`ENVMAP_BLENDING_NONE`}function uo(e,t,n,r){let i=e.getContext(),a=n.defines,o=n.vertexShader,s=n.fragmentShader,c=ao(n),l=n.envMapPMREM===!0?`ENVMAP_TYPE_PMREM`:`ENVMAP_TYPE_CUBE`,u=so(n),d=lo(n),f=Ga(n),p=Ka(a),m=i.createProgram(),h,g,_=n.glslVersion?`#version `+n.glslVersion+`
`:``;n.isRawShaderMaterial?(h=[`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p].filter(Ja).join(`
`),h.length>0&&(h+=`
`),g=[`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p].filter(Ja).join(`
`),g.length>0&&(g+=`
`)):(h=[ro(n),`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p,n.extensionClipCullDistance?`#define USE_CLIP_DISTANCE`:``,n.batching?`#define USE_BATCHING`:``,n.batchingColor?`#define USE_BATCHING_COLOR`:``,n.instancing?`#define USE_INSTANCING`:``,n.instancingColor?`#define USE_INSTANCING_COLOR`:``,n.instancingMorph?`#define USE_INSTANCING_MORPH`:``,n.useFog&&n.fog?`#define USE_FOG`:``,n.useFog&&n.fogExp2?`#define FOG_EXP2`:``,n.map?`#define USE_MAP`:``,n.envMap?`#define USE_ENVMAP`:``,n.envMap?`#define `+u:``,n.lightMap?`#define USE_LIGHTMAP`:``,n.aoMap?`#define USE_AOMAP`:``,n.bumpMap?`#define USE_BUMPMAP`:``,n.normalMap?`#define USE_NORMALMAP`:``,n.normalMapObjectSpace?`#define USE_NORMALMAP_OBJECTSPACE`:``,n.normalMapTangentSpace?`#define USE_NORMALMAP_TANGENTSPACE`:``,n.displacementMap?`#define USE_DISPLACEMENTMAP`:``,n.emissiveMap?`#define USE_EMISSIVEMAP`:``,n.anisotropy?`#define USE_ANISOTROPY`:``,n.anisotropyMap?`#define USE_ANISOTROPYMAP`:``,n.clearcoatMap?`#define USE_CLEARCOATMAP`:``,n.clearcoatRoughnessMap?`#define USE_CLEARCOAT_ROUGHNESSMAP`:``,n.clearcoatNormalMap?`#define USE_CLEARCOAT_NORMALMAP`:``,n.diffuseRoughnessMap?`#define USE_DIFFUSE_ROUGHNESSMAP`:``,n.iridescenceMap?`#define USE_IRIDESCENCEMAP`:``,n.iridescenceThicknessMap?`#define USE_IRIDESCENCE_THICKNESSMAP`:``,n.specularMap?`#define USE_SPECULARMAP`:``,n.specularColorMap?`#define USE_SPECULAR_COLORMAP`:``,n.specularIntensityMap?`#define USE_SPECULAR_INTENSITYMAP`:``,n.roughnessMap?`#define USE_ROUGHNESSMAP`:``,n.metalnessMap?`#define USE_METALNESSMAP`:``,n.alphaMap?`#define USE_ALPHAMAP`:``,n.alphaHash?`#define USE_ALPHAHASH`:``,n.transmission?`#define USE_TRANSMISSION`:``,n.transmissionMap?`#define USE_TRANSMISSIONMAP`:``,n.thicknessMap?`#define USE_THICKNESSMAP`:``,n.sheenColorMap?`#define USE_SHEEN_COLORMAP`:``,n.sheenRoughnessMap?`#define USE_SHEEN_ROUGHNESSMAP`:``,n.mapUv?`#define MAP_UV `+n.mapUv:``,n.alphaMapUv?`#define ALPHAMAP_UV `+n.alphaMapUv:``,n.lightMapUv?`#define LIGHTMAP_UV `+n.lightMapUv:``,n.aoMapUv?`#define AOMAP_UV `+n.aoMapUv:``,n.emissiveMapUv?`#define EMISSIVEMAP_UV `+n.emissiveMapUv:``,n.bumpMapUv?`#define BUMPMAP_UV `+n.bumpMapUv:``,n.normalMapUv?`#define NORMALMAP_UV `+n.normalMapUv:``,n.displacementMapUv?`#define DISPLACEMENTMAP_UV `+n.displacementMapUv:``,n.metalnessMapUv?`#define METALNESSMAP_UV `+n.metalnessMapUv:``,n.roughnessMapUv?`#define ROUGHNESSMAP_UV `+n.roughnessMapUv:``,n.anisotropyMapUv?`#define ANISOTROPYMAP_UV `+n.anisotropyMapUv:``,n.clearcoatMapUv?`#define CLEARCOATMAP_UV `+n.clearcoatMapUv:``,n.clearcoatNormalMapUv?`#define CLEARCOAT_NORMALMAP_UV `+n.clearcoatNormalMapUv:``,n.clearcoatRoughnessMapUv?`#define CLEARCOAT_ROUGHNESSMAP_UV `+n.clearcoatRoughnessMapUv:``,n.diffuseRoughnessMapUv?`#define DIFFUSE_ROUGHNESSMAP_UV `+n.diffuseRoughnessMapUv:``,n.iridescenceMapUv?`#define IRIDESCENCEMAP_UV `+n.iridescenceMapUv:``,n.iridescenceThicknessMapUv?`#define IRIDESCENCE_THICKNESSMAP_UV `+n.iridescenceThicknessMapUv:``,n.sheenColorMapUv?`#define SHEEN_COLORMAP_UV `+n.sheenColorMapUv:``,n.sheenRoughnessMapUv?`#define SHEEN_ROUGHNESSMAP_UV `+n.sheenRoughnessMapUv:``,n.specularMapUv?`#define SPECULARMAP_UV `+n.specularMapUv:``,n.specularColorMapUv?`#define SPECULAR_COLORMAP_UV `+n.specularColorMapUv:``,n.specularIntensityMapUv?`#define SPECULAR_INTENSITYMAP_UV `+n.specularIntensityMapUv:``,n.transmissionMapUv?`#define TRANSMISSIONMAP_UV `+n.transmissionMapUv:``,n.thicknessMapUv?`#define THICKNESSMAP_UV `+n.thicknessMapUv:``,n.vertexTangents&&n.flatShading===!1?`#define USE_TANGENT`:``,n.vertexNormals?`#define HAS_NORMAL`:``,n.vertexColors?`#define USE_COLOR`:``,n.vertexAlphas?`#define USE_COLOR_ALPHA`:``,n.vertexUv1s?`#define USE_UV1`:``,n.vertexUv2s?`#define USE_UV2`:``,n.vertexUv3s?`#define USE_UV3`:``,n.pointsUvs?`#define USE_POINTS_UV`:``,n.flatShading?`#define FLAT_SHADED`:``,n.skinning?`#define USE_SKINNING`:``,n.morphTargets?`#define USE_MORPHTARGETS`:``,n.morphNormals&&n.flatShading===!1?`#define USE_MORPHNORMALS`:``,n.morphColors?`#define USE_MORPHCOLORS`:``,n.morphTargetsCount>0?`#define MORPHTARGETS_TEXTURE_STRIDE `+n.morphTextureStride:``,n.morphTargetsCount>0?`#define MORPHTARGETS_COUNT `+n.morphTargetsCount:``,n.doubleSided?`#define DOUBLE_SIDED`:``,n.flipSided?`#define FLIP_SIDED`:``,n.shadowMapEnabled?`#define USE_SHADOWMAP`:``,n.shadowMapEnabled?`#define `+c:``,n.sizeAttenuation?`#define USE_SIZEATTENUATION`:``,n.numLightProbes>0?`#define USE_LIGHT_PROBES`:``,n.logarithmicDepthBuffer?`#define USE_LOGARITHMIC_DEPTH_BUFFER`:``,n.reversedDepthBuffer?`#define USE_REVERSED_DEPTH_BUFFER`:``,`uniform mat4 modelMatrix;`,`uniform mat4 modelViewMatrix;`,`uniform mat4 projectionMatrix;`,`uniform mat4 viewMatrix;`,`uniform mat3 normalMatrix;`,`uniform vec3 cameraPosition;`,`uniform bool isOrthographic;`,`#ifdef USE_INSTANCING`,`	attribute mat4 instanceMatrix;`,`#endif`,`#ifdef USE_INSTANCING_COLOR`,`	attribute vec3 instanceColor;`,`#endif`,`#ifdef USE_INSTANCING_MORPH`,`	uniform sampler2D morphTexture;`,`#endif`,`attribute vec3 position;`,`attribute vec3 normal;`,`attribute vec2 uv;`,`#ifdef USE_UV1`,`	attribute vec2 uv1;`,`#endif`,`#ifdef USE_UV2`,`	attribute vec2 uv2;`,`#endif`,`#ifdef USE_UV3`,`	attribute vec2 uv3;`,`#endif`,`#ifdef USE_TANGENT`,`	attribute vec4 tangent;`,`#endif`,`#if defined( USE_COLOR_ALPHA )`,`	attribute vec4 color;`,`#elif defined( USE_COLOR )`,`	attribute vec3 color;`,`#endif`,`#ifdef USE_SKINNING`,`	attribute vec4 skinIndex;`,`	attribute vec4 skinWeight;`,`#endif`,`
`].filter(Ja).join(`
`),g=[ro(n),`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p,n.useFog&&n.fog?`#define USE_FOG`:``,n.useFog&&n.fogExp2?`#define FOG_EXP2`:``,n.alphaToCoverage?`#define ALPHA_TO_COVERAGE`:``,n.map?`#define USE_MAP`:``,n.matcap?`#define USE_MATCAP`:``,n.envMap?`#define USE_ENVMAP`:``,n.envMap?`#define `+l:``,n.envMap?`#define `+u:``,n.envMap?`#define `+d:``,n.envMapPMREM?`#define ENVMAP_MAX_LOD `+n.envMapMaxLod+`.0`:``,n.envMapPMREM?`#define ENVMAP_SIZE `+n.envMapSize+`.0`:``,n.lightMap?`#define USE_LIGHTMAP`:``,n.aoMap?`#define USE_AOMAP`:``,n.bumpMap?`#define USE_BUMPMAP`:``,n.normalMap?`#define USE_NORMALMAP`:``,n.normalMapObjectSpace?`#define USE_NORMALMAP_OBJECTSPACE`:``,n.normalMapTangentSpace?`#define USE_NORMALMAP_TANGENTSPACE`:``,n.packedNormalMap?`#define USE_PACKED_NORMALMAP`:``,n.emissiveMap?`#define USE_EMISSIVEMAP`:``,n.anisotropy?`#define USE_ANISOTROPY`:``,n.anisotropyMap?`#define USE_ANISOTROPYMAP`:``,n.clearcoat?`#define USE_CLEARCOAT`:``,n.clearcoatMap?`#define USE_CLEARCOATMAP`:``,n.clearcoatRoughnessMap?`#define USE_CLEARCOAT_ROUGHNESSMAP`:``,n.clearcoatNormalMap?`#define USE_CLEARCOAT_NORMALMAP`:``,n.diffuseRoughness?`#define USE_DIFFUSE_ROUGHNESS`:``,n.diffuseRoughnessMap?`#define USE_DIFFUSE_ROUGHNESSMAP`:``,n.dispersion?`#define USE_DISPERSION`:``,n.retroreflection?`#define USE_RETROREFLECTION`:``,n.iridescence?`#define USE_IRIDESCENCE`:``,n.iridescenceMap?`#define USE_IRIDESCENCEMAP`:``,n.iridescenceThicknessMap?`#define USE_IRIDESCENCE_THICKNESSMAP`:``,n.specularMap?`#define USE_SPECULARMAP`:``,n.specularColorMap?`#define USE_SPECULAR_COLORMAP`:``,n.specularIntensityMap?`#define USE_SPECULAR_INTENSITYMAP`:``,n.roughnessMap?`#define USE_ROUGHNESSMAP`:``,n.metalnessMap?`#define USE_METALNESSMAP`:``,n.alphaMap?`#define USE_ALPHAMAP`:``,n.alphaTest?`#define USE_ALPHATEST`:``,n.alphaHash?`#define USE_ALPHAHASH`:``,n.sheen?`#define USE_SHEEN`:``,n.sheenColorMap?`#define USE_SHEEN_COLORMAP`:``,n.sheenRoughnessMap?`#define USE_SHEEN_ROUGHNESSMAP`:``,n.transmission?`#define USE_TRANSMISSION`:``,n.transmissionMap?`#define USE_TRANSMISSIONMAP`:``,n.thicknessMap?`#define USE_THICKNESSMAP`:``,n.vertexTangents&&n.flatShading===!1?`#define USE_TANGENT`:``,n.vertexColors||n.instancingColor?`#define USE_COLOR`:``,n.vertexAlphas||n.batchingColor?`#define USE_COLOR_ALPHA`:``,n.vertexUv1s?`#define USE_UV1`:``,n.vertexUv2s?`#define USE_UV2`:``,n.vertexUv3s?`#define USE_UV3`:``,n.pointsUvs?`#define USE_POINTS_UV`:``,n.gradientMap?`#define USE_GRADIENTMAP`:``,n.flatShading?`#define FLAT_SHADED`:``,n.doubleSided?`#define DOUBLE_SIDED`:``,n.flipSided?`#define FLIP_SIDED`:``,n.shadowMapEnabled?`#define USE_SHADOWMAP`:``,n.shadowMapEnabled?`#define `+c:``,n.premultipliedAlpha?`#define PREMULTIPLIED_ALPHA`:``,n.numLightProbes>0?`#define USE_LIGHT_PROBES`:``,n.decodeVideoTexture?`#define DECODE_VIDEO_TEXTURE`:``,n.decodeVideoTextureEmissive?`#define DECODE_VIDEO_TEXTURE_EMISSIVE`:``,n.logarithmicDepthBuffer?`#define USE_LOGARITHMIC_DEPTH_BUFFER`:``,n.reversedDepthBuffer?`#define USE_REVERSED_DEPTH_BUFFER`:``,`uniform mat4 viewMatrix;`,`uniform vec3 cameraPosition;`,`uniform bool isOrthographic;`,n.toneMapping===0?``:`#define TONE_MAPPING`,n.toneMapping===0?``:Q.tonemapping_pars_fragment,n.toneMapping===0?``:Ha(`toneMapping`,n.toneMapping),n.dithering?`#define DITHERING`:``,n.opaque?`#define OPAQUE`:``,Q.colorspace_pars_fragment,Ba(`linearToOutputTexel`,n.outputColorSpace),Wa(),n.useDepthPacking?`#define DEPTH_PACKING `+n.depthPacking:``,`
`].filter(Ja).join(`
`)),o=Qa(o),o=Ya(o,n),o=Xa(o,n),s=Qa(s),s=Ya(s,n),s=Xa(s,n),o=to(o),s=to(s),n.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,h=[f,`#define attribute in`,`#define varying out`,`#define texture2D texture`].join(`
`)+`
`+h,g=[`#define varying in`,n.glslVersion===`300 es`?``:`layout(location = 0) out highp vec4 pc_fragColor;`,n.glslVersion===`300 es`?``:`#define gl_FragColor pc_fragColor`,`#define gl_FragDepthEXT gl_FragDepth`,`#define texture2D texture`,`#define textureCube texture`,`#define texture2DProj textureProj`,`#define texture2DLodEXT textureLod`,`#define texture2DProjLodEXT textureProjLod`,`#define textureCubeLodEXT textureLod`,`#define texture2DGradEXT textureGrad`,`#define texture2DProjGradEXT textureProjGrad`,`#define textureCubeGradEXT textureGrad`].join(`
`)+`
`+g);let v=_+h+o,y=_+g+s,b=Na(i,i.VERTEX_SHADER,v),x=Na(i,i.FRAGMENT_SHADER,y);i.attachShader(m,b),i.attachShader(m,x),n.index0AttributeName===void 0?n.hasPositionAttribute===!0&&i.bindAttribLocation(m,0,`position`):i.bindAttribLocation(m,0,n.index0AttributeName),i.linkProgram(m);function S(t){if(e.debug.checkShaderErrors){let n=i.getProgramInfoLog(m)||``,r=i.getShaderInfoLog(b)||``,a=i.getShaderInfoLog(x)||``,o=n.trim(),s=r.trim(),c=a.trim(),l=!0,u=!0;if(i.getProgramParameter(m,i.LINK_STATUS)===!1){if(l=!1,typeof e.debug.onShaderError==`function`)e.debug.onShaderError(i,m,b,x);else{let e=za(i,b,`vertex`),n=za(i,x,`fragment`);Z(`WebGLProgram: Shader Error `+i.getError()+` - VALIDATE_STATUS `+i.getProgramParameter(m,i.VALIDATE_STATUS)+`

Material Name: `+t.name+`
Material Type: `+t.type+`

Program Info Log: `+o+`
`+e+`
`+n)}}else o===``?(s===``||c===``)&&(u=!1):Y(`WebGLProgram: Program Info Log:`,o);u&&(t.diagnostics={runnable:l,programLog:o,vertexShader:{log:s,prefix:h},fragmentShader:{log:c,prefix:g}})}i.deleteShader(b),i.deleteShader(x),C=new Ma(i,m),w=qa(i,m)}let C;this.getUniforms=function(){return C===void 0&&S(this),C};let w;this.getAttributes=function(){return w===void 0&&S(this),w};let T=n.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return T===!1&&(T=i.getProgramParameter(m,Pa)),T},this.destroy=function(){r.releaseStatesOfProgram(this),i.deleteProgram(m),this.program=void 0},this.type=n.shaderType,this.name=n.shaderName,this.id=Fa++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=b,this.fragmentShader=x,this}var fo=0,po=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let e of t)e.usedTimes--,e.usedTimes===0&&this.shaderCache.delete(e.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new mo(e),t.set(e,n)),n}},mo=class{constructor(e){this.id=fo++,this.code=e,this.usedTimes=0}};function ho(e){return e===1030||e===37490||e===36285}function go(e,t,n,r,i,a){let o=new He,s=new po,c=new Set,l=[],u=new Map,d=r.logarithmicDepthBuffer,f={MeshDepthMaterial:`depth`,MeshDistanceMaterial:`distance`,MeshNormalMaterial:`normal`,MeshBasicMaterial:`basic`,MeshLambertMaterial:`lambert`,MeshPhongMaterial:`phong`,MeshToonMaterial:`toon`,MeshStandardMaterial:`physical`,MeshPhysicalMaterial:`physical`,MeshMatcapMaterial:`matcap`,LineBasicMaterial:`basic`,LineDashedMaterial:`dashed`,PointsMaterial:`points`,ShadowMaterial:`shadow`,SpriteMaterial:`sprite`};function p(e){return c.add(e),e===0?`uv`:`uv${e}`}function m(i,o,l,u,m,h){let g=u.fog,_=m.geometry,v=i.isMeshStandardMaterial||i.isMeshLambertMaterial||i.isMeshPhongMaterial?u.environment:null,y=i.isMeshStandardMaterial||i.isMeshLambertMaterial&&!i.envMap||i.isMeshPhongMaterial&&!i.envMap,b=t.get(i.envMap||v,y),x=f[i.type],S=r.precision;i.precision!==null&&(S=r.getMaxPrecision(i.precision),S!==i.precision&&Y(`WebGLProgram.getParameters:`,i.precision,`not supported, using`,S,`instead.`));let C=_.morphAttributes.position||_.morphAttributes.normal||_.morphAttributes.color,w=C===void 0?0:C.length,T=0;_.morphAttributes.position!==void 0&&(T=1),_.morphAttributes.normal!==void 0&&(T=2),_.morphAttributes.color!==void 0&&(T=3);let E,D,O,k;if(x){let e=Ur[x];E=e.vertexShader,D=e.fragmentShader}else{E=i.vertexShader,D=i.fragmentShader;let e=s.getVertexShaderStage(i),t=s.getFragmentShaderStage(i);s.update(i,e,t),O=e.id,k=t.id}let A=e.getRenderTarget(),j=e.state.buffers.depth.getReversed(),ee=m.isInstancedMesh===!0,M=m.isBatchedMesh===!0,te=!!i.map,N=!!i.matcap,P=!!b,ne=P&&b.isPMREMTexture===!0,re=!!i.aoMap,ie=!!i.lightMap,ae=!!i.bumpMap&&i.wireframe===!1,F=!!i.normalMap,oe=!!i.displacementMap,I=!!i.emissiveMap,se=!!i.metalnessMap,L=!!i.roughnessMap,ce=i.anisotropy>0,le=i.clearcoat>0,ue=i.diffuseRoughness>0,R=i.dispersion>0,z=i.retroreflectivity>0,de=i.iridescence>0,fe=i.sheen>0,pe=i.transmission>0,me=ce&&!!i.anisotropyMap,he=le&&!!i.clearcoatMap,ge=le&&!!i.clearcoatNormalMap,_e=le&&!!i.clearcoatRoughnessMap,ve=ue&&!!i.diffuseRoughnessMap,B=de&&!!i.iridescenceMap,ye=de&&!!i.iridescenceThicknessMap,V=fe&&!!i.sheenColorMap,be=fe&&!!i.sheenRoughnessMap,xe=!!i.specularMap,H=!!i.specularColorMap,U=!!i.specularIntensityMap,W=pe&&!!i.transmissionMap,G=pe&&!!i.thicknessMap,Se=!!i.gradientMap,Ce=!!i.alphaMap,K=i.alphaTest>0,we=!!i.alphaHash,Te=!!i.extensions,Ee=0;i.toneMapped&&(A===null||A.isXRRenderTarget===!0)&&(Ee=e.toneMapping);let De=ne?b.isCompressedCubeTexture?b.image[0].mipmaps:b.mipmaps:null,Oe={shaderID:x,shaderType:i.type,shaderName:i.name,vertexShader:E,fragmentShader:D,defines:i.defines,customVertexShaderID:O,customFragmentShaderID:k,isRawShaderMaterial:i.isRawShaderMaterial===!0,glslVersion:i.glslVersion,precision:S,batching:M,batchingColor:M&&m._colorsTexture!==null,instancing:ee,instancingColor:ee&&m.instanceColor!==null,instancingMorph:ee&&m.morphTexture!==null,outputColorSpace:A===null?e.outputColorSpace:A.isXRRenderTarget===!0?A.texture.colorSpace:J.workingColorSpace,alphaToCoverage:!!i.alphaToCoverage,map:te,matcap:N,envMap:P,envMapMode:P&&b.mapping,envMapPMREM:ne,envMapMaxLod:ne?De.length-1:null,envMapSize:ne?De[0].width:null,aoMap:re,lightMap:ie,bumpMap:ae,normalMap:F,displacementMap:oe,emissiveMap:I,normalMapObjectSpace:F&&i.normalMapType===1,normalMapTangentSpace:F&&i.normalMapType===0,packedNormalMap:F&&i.normalMapType===0&&ho(i.normalMap.format),metalnessMap:se,roughnessMap:L,anisotropy:ce,anisotropyMap:me,clearcoat:le,clearcoatMap:he,clearcoatNormalMap:ge,clearcoatRoughnessMap:_e,diffuseRoughness:ue,diffuseRoughnessMap:ve,dispersion:R,retroreflection:z,iridescence:de,iridescenceMap:B,iridescenceThicknessMap:ye,sheen:fe,sheenColorMap:V,sheenRoughnessMap:be,specularMap:xe,specularColorMap:H,specularIntensityMap:U,transmission:pe,transmissionMap:W,thicknessMap:G,gradientMap:Se,opaque:i.transparent===!1&&i.blending===1&&i.alphaToCoverage===!1,alphaMap:Ce,alphaTest:K,alphaHash:we,combine:i.combine,mapUv:te&&p(i.map.channel),aoMapUv:re&&p(i.aoMap.channel),lightMapUv:ie&&p(i.lightMap.channel),bumpMapUv:ae&&p(i.bumpMap.channel),normalMapUv:F&&p(i.normalMap.channel),displacementMapUv:oe&&p(i.displacementMap.channel),emissiveMapUv:I&&p(i.emissiveMap.channel),metalnessMapUv:se&&p(i.metalnessMap.channel),roughnessMapUv:L&&p(i.roughnessMap.channel),anisotropyMapUv:me&&p(i.anisotropyMap.channel),clearcoatMapUv:he&&p(i.clearcoatMap.channel),clearcoatNormalMapUv:ge&&p(i.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:_e&&p(i.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ve&&p(i.diffuseRoughnessMap.channel),iridescenceMapUv:B&&p(i.iridescenceMap.channel),iridescenceThicknessMapUv:ye&&p(i.iridescenceThicknessMap.channel),sheenColorMapUv:V&&p(i.sheenColorMap.channel),sheenRoughnessMapUv:be&&p(i.sheenRoughnessMap.channel),specularMapUv:xe&&p(i.specularMap.channel),specularColorMapUv:H&&p(i.specularColorMap.channel),specularIntensityMapUv:U&&p(i.specularIntensityMap.channel),transmissionMapUv:W&&p(i.transmissionMap.channel),thicknessMapUv:G&&p(i.thicknessMap.channel),alphaMapUv:Ce&&p(i.alphaMap.channel),vertexTangents:!!_.attributes.tangent&&(F||ce),vertexNormals:!!_.attributes.normal,vertexColors:i.vertexColors,vertexAlphas:i.vertexColors===!0&&!!_.attributes.color&&_.attributes.color.itemSize===4,pointsUvs:m.isPoints===!0&&!!_.attributes.uv&&(te||Ce),fog:!!g,useFog:i.fog===!0,fogExp2:!!g&&g.isFogExp2,flatShading:i.wireframe===!1&&(i.flatShading===!0||_.attributes.normal===void 0&&F===!1&&(i.isMeshLambertMaterial||i.isMeshPhongMaterial||i.isMeshStandardMaterial||i.isMeshPhysicalMaterial)),sizeAttenuation:i.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:j,skinning:m.isSkinnedMesh===!0,hasPositionAttribute:_.attributes.position!==void 0,morphTargets:_.morphAttributes.position!==void 0,morphNormals:_.morphAttributes.normal!==void 0,morphColors:_.morphAttributes.color!==void 0,morphTargetsCount:w,morphTextureStride:T,numSunLights:o.sun.length,numDirLights:o.directional.length,numPointLights:o.point.length,numSpotLights:o.spot.length,numSpotLightMaps:o.spotLightMap.length,numRectAreaLights:o.rectArea.length,numHemiLights:o.hemi.length,numSunLightShadows:o.sunShadowMap.length,numDirLightShadows:o.directionalShadowMap.length,numPointLightShadows:o.pointShadowMap.length,numSpotLightShadows:o.spotShadowMap.length,numSpotLightShadowsWithMaps:o.numSpotLightShadowsWithMaps,numLightProbes:o.numLightProbes,numLightProbeGrids:h.filter(e=>e.texture!==null).length,numClippingPlanes:a.numPlanes,numClipIntersection:a.numIntersection,dithering:i.dithering,shadowMapEnabled:e.shadowMap.enabled&&l.length>0,shadowMapType:e.shadowMap.type,toneMapping:Ee,decodeVideoTexture:te&&i.map.isVideoTexture===!0&&J.getTransfer(i.map.colorSpace)===`srgb`,decodeVideoTextureEmissive:I&&i.emissiveMap.isVideoTexture===!0&&J.getTransfer(i.emissiveMap.colorSpace)===`srgb`,premultipliedAlpha:i.premultipliedAlpha,doubleSided:i.side===2,flipSided:i.side===1,useDepthPacking:i.depthPacking>=0,depthPacking:i.depthPacking||0,index0AttributeName:i.index0AttributeName,extensionClipCullDistance:Te&&i.extensions.clipCullDistance===!0&&n.has(`WEBGL_clip_cull_distance`),extensionMultiDraw:(Te&&i.extensions.multiDraw===!0||M)&&n.has(`WEBGL_multi_draw`),rendererExtensionParallelShaderCompile:n.has(`KHR_parallel_shader_compile`),customProgramCacheKey:i.customProgramCacheKey()};return Oe.vertexUv1s=c.has(1),Oe.vertexUv2s=c.has(2),Oe.vertexUv3s=c.has(3),c.clear(),Oe}function h(t){let n=[];if(t.shaderID?n.push(t.shaderID):(n.push(t.customVertexShaderID),n.push(t.customFragmentShaderID)),t.defines!==void 0)for(let e in t.defines)n.push(e),n.push(t.defines[e]);return t.isRawShaderMaterial===!1&&(g(n,t),_(n,t),n.push(e.outputColorSpace)),n.push(t.customProgramCacheKey),n.join()}function g(e,t){e.push(t.precision),e.push(t.outputColorSpace),e.push(t.envMapMode),e.push(t.envMapPMREM),e.push(t.envMapMaxLod),e.push(t.envMapSize),e.push(t.mapUv),e.push(t.alphaMapUv),e.push(t.lightMapUv),e.push(t.aoMapUv),e.push(t.bumpMapUv),e.push(t.normalMapUv),e.push(t.displacementMapUv),e.push(t.emissiveMapUv),e.push(t.metalnessMapUv),e.push(t.roughnessMapUv),e.push(t.anisotropyMapUv),e.push(t.clearcoatMapUv),e.push(t.clearcoatNormalMapUv),e.push(t.clearcoatRoughnessMapUv),e.push(t.diffuseRoughnessMapUv),e.push(t.iridescenceMapUv),e.push(t.iridescenceThicknessMapUv),e.push(t.sheenColorMapUv),e.push(t.sheenRoughnessMapUv),e.push(t.specularMapUv),e.push(t.specularColorMapUv),e.push(t.specularIntensityMapUv),e.push(t.transmissionMapUv),e.push(t.thicknessMapUv),e.push(t.combine),e.push(t.fogExp2),e.push(t.sizeAttenuation),e.push(t.morphTargetsCount),e.push(t.numSunLights),e.push(t.numDirLights),e.push(t.numPointLights),e.push(t.numSpotLights),e.push(t.numSpotLightMaps),e.push(t.numHemiLights),e.push(t.numRectAreaLights),e.push(t.numSunLightShadows),e.push(t.numDirLightShadows),e.push(t.numPointLightShadows),e.push(t.numSpotLightShadows),e.push(t.numSpotLightShadowsWithMaps),e.push(t.numLightProbes),e.push(t.numLightProbeGrids),e.push(t.shadowMapType),e.push(t.toneMapping),e.push(t.numClippingPlanes),e.push(t.numClipIntersection),e.push(t.depthPacking)}function _(e,t){o.disableAll(),t.instancing&&o.enable(0),t.instancingColor&&o.enable(1),t.instancingMorph&&o.enable(2),t.matcap&&o.enable(3),t.envMap&&o.enable(4),t.normalMapObjectSpace&&o.enable(5),t.normalMapTangentSpace&&o.enable(6),t.clearcoat&&o.enable(7),t.iridescence&&o.enable(8),t.alphaTest&&o.enable(9),t.vertexColors&&o.enable(10),t.vertexAlphas&&o.enable(11),t.vertexUv1s&&o.enable(12),t.vertexUv2s&&o.enable(13),t.vertexUv3s&&o.enable(14),t.vertexTangents&&o.enable(15),t.anisotropy&&o.enable(16),t.alphaHash&&o.enable(17),t.batching&&o.enable(18),t.dispersion&&o.enable(19),t.retroreflection&&o.enable(24),t.diffuseRoughness&&o.enable(25),t.batchingColor&&o.enable(20),t.gradientMap&&o.enable(21),t.packedNormalMap&&o.enable(22),t.vertexNormals&&o.enable(23),e.push(o.mask),o.disableAll(),t.fog&&o.enable(0),t.useFog&&o.enable(1),t.flatShading&&o.enable(2),t.logarithmicDepthBuffer&&o.enable(3),t.reversedDepthBuffer&&o.enable(4),t.skinning&&o.enable(5),t.morphTargets&&o.enable(6),t.morphNormals&&o.enable(7),t.morphColors&&o.enable(8),t.premultipliedAlpha&&o.enable(9),t.shadowMapEnabled&&o.enable(10),t.doubleSided&&o.enable(11),t.flipSided&&o.enable(12),t.useDepthPacking&&o.enable(13),t.dithering&&o.enable(14),t.transmission&&o.enable(15),t.sheen&&o.enable(16),t.opaque&&o.enable(17),t.pointsUvs&&o.enable(18),t.decodeVideoTexture&&o.enable(19),t.decodeVideoTextureEmissive&&o.enable(20),t.alphaToCoverage&&o.enable(21),t.numLightProbeGrids>0&&o.enable(22),t.hasPositionAttribute&&o.enable(23),e.push(o.mask)}function v(e){let t=f[e.type],n;if(t){let e=Ur[t];n=Fe.clone(e.uniforms)}else n=e.uniforms;return n}function y(t,n){let r=u.get(n);return r===void 0?(r=new uo(e,n,t,i),l.push(r),u.set(n,r)):++r.usedTimes,r}function b(e){if(--e.usedTimes===0){let t=l.indexOf(e);l[t]=l[l.length-1],l.pop(),u.delete(e.cacheKey),e.destroy()}}function x(e){s.remove(e)}function S(){s.dispose()}return{getParameters:m,getProgramCacheKey:h,getUniforms:v,acquireProgram:y,releaseProgram:b,releaseShaderCache:x,programs:l,dispose:S}}function _o(){let e=new WeakMap;function t(t){return e.has(t)}function n(t){let n=e.get(t);return n===void 0&&(n={},e.set(t,n)),n}function r(t){e.delete(t)}function i(t,n,r){e.get(t)[n]=r}function a(){e=new WeakMap}return{has:t,get:n,remove:r,update:i,dispose:a}}function vo(e,t){return e.groupOrder===t.groupOrder?e.renderOrder===t.renderOrder?e.material.id===t.material.id?e.materialVariant===t.materialVariant?e.z===t.z?e.id-t.id:e.z-t.z:e.materialVariant-t.materialVariant:e.material.id-t.material.id:e.renderOrder-t.renderOrder:e.groupOrder-t.groupOrder}function yo(e,t){return e.groupOrder===t.groupOrder?e.renderOrder===t.renderOrder?e.z===t.z?e.id-t.id:t.z-e.z:e.renderOrder-t.renderOrder:e.groupOrder-t.groupOrder}function bo(){let e=[],t=0,n=[],r=[],i=[];function a(){t=0,n.length=0,r.length=0,i.length=0}function o(e){let t=0;return e.isInstancedMesh&&(t+=2),e.isSkinnedMesh&&(t+=1),t}function s(n,r,i,a,s,c){let l=e[t];return l===void 0?(l={id:n.id,object:n,geometry:r,material:i,materialVariant:o(n),groupOrder:a,renderOrder:n.renderOrder,z:s,group:c},e[t]=l):(l.id=n.id,l.object=n,l.geometry=r,l.material=i,l.materialVariant=o(n),l.groupOrder=a,l.renderOrder=n.renderOrder,l.z=s,l.group=c),t++,l}function c(e,t,a,o,c,l,u){u.reversedDepth===!0&&(c=-c);let d=s(e,t,a,o,c,l);a.transmission>0?r.push(d):a.transparent===!0?i.push(d):n.push(d)}function l(e,t,a,o,c,l){let u=s(e,t,a,o,c,l);a.transmission>0?r.unshift(u):a.transparent===!0?i.unshift(u):n.unshift(u)}function u(e,t){n.length>1&&n.sort(e||vo),r.length>1&&r.sort(t||yo),i.length>1&&i.sort(t||yo)}function d(){for(let n=t,r=e.length;n<r;n++){let t=e[n];if(t.id===null)break;t.id=null,t.object=null,t.geometry=null,t.material=null,t.group=null}}return{opaque:n,transmissive:r,transparent:i,init:a,push:c,unshift:l,finish:d,sort:u}}function xo(){let e=new WeakMap;function t(t,n){let r=e.get(t),i;return r===void 0?(i=new bo,e.set(t,[i])):n>=r.length?(i=new bo,r.push(i)):i=r[n],i}function n(){e=new WeakMap}return{get:t,dispose:n}}function So(){let e={};return{get:function(t){if(e[t.id]!==void 0)return e[t.id];let n;switch(t.type){case`SunLight`:case`DirectionalLight`:n={direction:new K,color:new q};break;case`SpotLight`:n={position:new K,direction:new K,color:new q,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case`PointLight`:n={position:new K,color:new q,distance:0,decay:0};break;case`HemisphereLight`:n={direction:new K,skyColor:new q,groundColor:new q};break;case`RectAreaLight`:n={color:new q,position:new K,halfWidth:new K,halfHeight:new K}}return e[t.id]=n,n}}}function Co(){let e={};return{get:function(t){if(e[t.id]!==void 0)return e[t.id];let n;switch(t.type){case`SunLight`:case`DirectionalLight`:n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new kt};break;case`SpotLight`:n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new kt};break;case`PointLight`:n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new kt,shadowCameraNear:1,shadowCameraFar:1e3}}return e[t.id]=n,n}}}var wo=0;function To(e,t){return(t.castShadow?2:0)-(e.castShadow?2:0)+ +!!t.map-!!e.map}function Eo(e){let t=new So,n=Co(),r={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let e=0;e<9;e++)r.probe.push(new K);let i=new K,a=new Qe,o=new Qe;function s(i){let a=0,o=0,s=0;for(let e=0;e<9;e++)r.probe[e].set(0,0,0);let c=0,l=0,u=0,d=0,f=0,p=0,m=0,h=0,g=0,_=0,v=0,y=0,b=0,x=0;i.sort(To);for(let e=0,S=i.length;e<S;e++){let S=i[e],C=S.color,w=S.intensity,T=S.distance,E=null;if(S.shadow&&S.shadow.map&&(E=S.shadow.map.texture.format===1030?S.shadow.map.texture:S.shadow.map.depthTexture||S.shadow.map.texture),S.isAmbientLight)a+=C.r*w,o+=C.g*w,s+=C.b*w;else if(S.isLightProbe){for(let e=0;e<9;e++)r.probe[e].addScaledVector(S.sh.coefficients[e],w);x++}else if(S.isSunLight){let e=t.get(S);if(e.color.copy(S.color).multiplyScalar(S.intensity),S.castShadow){let e=S.shadow,t=n.get(S);t.shadowIntensity=e.intensity,t.shadowBias=e.bias,t.shadowNormalBias=e.normalBias,t.shadowRadius=e.radius,t.shadowMapSize.copy(e.mapSize).multiply(e.getFrameExtents()),r.sunShadow[l]=t,r.sunShadowMap[l]=E;let i=e.getViewportCount();for(let t=0;t<i;t++)r.sunShadowMatrix[u+t]=e.getMatrix(t),r.sunShadowCascade[u+t]=e._cascadeData[t];u+=i,l++}r.sun[c]=e,c++}else if(S.isDirectionalLight){let e=t.get(S);if(e.color.copy(S.color).multiplyScalar(S.intensity),S.castShadow){let e=S.shadow,t=n.get(S);t.shadowIntensity=e.intensity,t.shadowBias=e.bias,t.shadowNormalBias=e.normalBias,t.shadowRadius=e.radius,t.shadowMapSize=e.mapSize,r.directionalShadow[d]=t,r.directionalShadowMap[d]=E,r.directionalShadowMatrix[d]=S.shadow.matrix,g++}r.directional[d]=e,d++}else if(S.isSpotLight){let e=t.get(S);e.position.setFromMatrixPosition(S.matrixWorld),e.color.copy(C).multiplyScalar(w),e.distance=T,e.coneCos=Math.cos(S.angle),e.penumbraCos=Math.cos(S.angle*(1-S.penumbra)),e.decay=S.decay,r.spot[p]=e;let i=S.shadow;if(S.map&&(r.spotLightMap[y]=S.map,y++,i.updateMatrices(S),S.castShadow&&b++),r.spotLightMatrix[p]=i.matrix,S.castShadow){let e=n.get(S);e.shadowIntensity=i.intensity,e.shadowBias=i.bias,e.shadowNormalBias=i.normalBias,e.shadowRadius=i.radius,e.shadowMapSize=i.mapSize,r.spotShadow[p]=e,r.spotShadowMap[p]=E,v++}p++}else if(S.isRectAreaLight){let e=t.get(S);e.color.copy(C).multiplyScalar(w),e.halfWidth.set(S.width*.5,0,0),e.halfHeight.set(0,S.height*.5,0),r.rectArea[m]=e,m++}else if(S.isPointLight){let e=t.get(S);if(e.color.copy(S.color).multiplyScalar(S.intensity),e.distance=S.distance,e.decay=S.decay,S.castShadow){let e=S.shadow,t=n.get(S);t.shadowIntensity=e.intensity,t.shadowBias=e.bias,t.shadowNormalBias=e.normalBias,t.shadowRadius=e.radius,t.shadowMapSize=e.mapSize,t.shadowCameraNear=e.camera.near,t.shadowCameraFar=e.camera.far,r.pointShadow[f]=t,r.pointShadowMap[f]=E,r.pointShadowMatrix[f]=S.shadow.matrix,_++}r.point[f]=e,f++}else if(S.isHemisphereLight){let e=t.get(S);e.skyColor.copy(S.color).multiplyScalar(w),e.groundColor.copy(S.groundColor).multiplyScalar(w),r.hemi[h]=e,h++}}m>0&&(e.has(`OES_texture_float_linear`)===!0?(r.rectAreaLTC1=$.LTC_FLOAT_1,r.rectAreaLTC2=$.LTC_FLOAT_2):(r.rectAreaLTC1=$.LTC_HALF_1,r.rectAreaLTC2=$.LTC_HALF_2)),r.ambient[0]=a,r.ambient[1]=o,r.ambient[2]=s;let S=r.hash;(S.sunLength!==c||S.directionalLength!==d||S.pointLength!==f||S.spotLength!==p||S.rectAreaLength!==m||S.hemiLength!==h||S.numSunShadows!==l||S.numDirectionalShadows!==g||S.numPointShadows!==_||S.numSpotShadows!==v||S.numSpotMaps!==y||S.numLightProbes!==x)&&(r.sun.length=c,r.directional.length=d,r.spot.length=p,r.rectArea.length=m,r.point.length=f,r.hemi.length=h,r.sunShadow.length=l,r.sunShadowMap.length=l,r.sunShadowMatrix.length=u,r.sunShadowCascade.length=u,r.directionalShadow.length=g,r.directionalShadowMap.length=g,r.directionalShadowMatrix.length=g,r.pointShadow.length=_,r.pointShadowMap.length=_,r.pointShadowMatrix.length=_,r.spotShadow.length=v,r.spotShadowMap.length=v,r.spotLightMatrix.length=v+y-b,r.spotLightMap.length=y,r.numSpotLightShadowsWithMaps=b,r.numLightProbes=x,S.sunLength=c,S.directionalLength=d,S.pointLength=f,S.spotLength=p,S.rectAreaLength=m,S.hemiLength=h,S.numSunShadows=l,S.numDirectionalShadows=g,S.numPointShadows=_,S.numSpotShadows=v,S.numSpotMaps=y,S.numLightProbes=x,r.version=wo++)}function c(e,t){let n=0,s=0,c=0,l=0,u=0,d=0,f=t.matrixWorldInverse;for(let t=0,p=e.length;t<p;t++){let p=e[t];if(p.isSunLight){let e=r.sun[n];e.direction.setFromMatrixPosition(p.matrixWorld),e.direction.transformDirection(f),n++}else if(p.isDirectionalLight){let e=r.directional[s];e.direction.setFromMatrixPosition(p.matrixWorld),i.setFromMatrixPosition(p.target.matrixWorld),e.direction.sub(i),e.direction.transformDirection(f),s++}else if(p.isSpotLight){let e=r.spot[l];e.position.setFromMatrixPosition(p.matrixWorld),e.position.applyMatrix4(f),e.direction.setFromMatrixPosition(p.matrixWorld),i.setFromMatrixPosition(p.target.matrixWorld),e.direction.sub(i),e.direction.transformDirection(f),l++}else if(p.isRectAreaLight){let e=r.rectArea[u];e.position.setFromMatrixPosition(p.matrixWorld),e.position.applyMatrix4(f),o.identity(),a.copy(p.matrixWorld),a.premultiply(f),o.extractRotation(a),e.halfWidth.set(p.width*.5,0,0),e.halfHeight.set(0,p.height*.5,0),e.halfWidth.applyMatrix4(o),e.halfHeight.applyMatrix4(o),u++}else if(p.isPointLight){let e=r.point[c];e.position.setFromMatrixPosition(p.matrixWorld),e.position.applyMatrix4(f),c++}else if(p.isHemisphereLight){let e=r.hemi[d];e.direction.setFromMatrixPosition(p.matrixWorld),e.direction.transformDirection(f),d++}}}return{setup:s,setupView:c,state:r}}function Do(e){let t=new Eo(e),n=[],r=[],i=[];function a(e){u.camera=e,n.length=0,r.length=0,i.length=0}function o(e){e.isLightProbeGrid?i.push(e):n.push(e)}function s(e){r.push(e)}function c(){t.setup(n),i.sort((e,t)=>e.priority-t.priority||e.id-t.id)}function l(e){t.setupView(n,e)}let u={lightsArray:n,shadowsArray:r,lightProbeGridArray:i,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:a,state:u,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:s}}function Oo(e){let t=new WeakMap;function n(n,r=0){let i=t.get(n),a;return i===void 0?(a=new Do(e),t.set(n,[a])):r>=i.length?(a=new Do(e),i.push(a)):a=i[r],a}function r(){t=new WeakMap}return{get:n,dispose:r}}var ko=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Ao=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,jo=[new K(1,0,0),new K(-1,0,0),new K(0,1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1)],Mo=[new K(0,-1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1),new K(0,-1,0),new K(0,-1,0)],No=new Qe,Po=new K,Fo=new K;function Io(e,t,n){let r=new xe,i=new kt,a=new kt,o=new Ke,s=new rt,c=new yt,l={},u=n.maxTextureSize,d={0:1,1:0,2:2},f=new ze({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new kt},radius:{value:4}},vertexShader:ko,fragmentShader:Ao}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let m=new tt;m.setAttribute(`position`,new jt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let h=new Et(m,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=1;let _=this.type;this.render=function(t,n,s){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||t.length===0)return;this.type===2&&(Y(`WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead.`),this.type=1);let c=e.getRenderTarget(),l=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),f=e.state;f.setBlending(0),f.buffers.depth.getReversed()===!0?f.buffers.color.setClear(0,0,0,0):f.buffers.color.setClear(1,1,1,1),f.buffers.depth.setTest(!0),f.setScissorTest(!1);let p=_!==this.type;p&&n.traverse(function(e){e.material&&(Array.isArray(e.material)?e.material.forEach(e=>e.needsUpdate=!0):e.material.needsUpdate=!0)});for(let c=0,l=t.length;c<l;c++){let l=t[c],d=l.shadow;if(d===void 0){Y(`WebGLShadowMap:`,l,`has no shadow.`);continue}if(d.autoUpdate===!1&&d.needsUpdate===!1)continue;i.copy(d.mapSize);let m=d.getFrameExtents();i.multiply(m),a.copy(d.mapSize),(i.x>u||i.y>u)&&(i.x>u&&(a.x=Math.floor(u/m.x),i.x=a.x*m.x,d.mapSize.x=a.x),i.y>u&&(a.y=Math.floor(u/m.y),i.y=a.y*m.y,d.mapSize.y=a.y));let h=e.state.buffers.depth.getReversed();if(d.camera._reversedDepth=h,d.map===null||p===!0){if(d.map!==null&&(d.map.depthTexture!==null&&(d.map.depthTexture.dispose(),d.map.depthTexture=null),d.map.dispose()),this.type===3){if(l.isPointLight){Y(`WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.`);continue}d.map=new Pe(i.x,i.y,{format:Ft,type:je,minFilter:Ge,magFilter:Ge,generateMipmaps:!1}),d.map.texture.name=l.name+`.shadowMap`,d.map.depthTexture=new U(i.x,i.y,gt),d.map.depthTexture.name=l.name+`.shadowMapDepth`,d.map.depthTexture.format=Bt,d.map.depthTexture.compareFunction=null,d.map.depthTexture.minFilter=Ot,d.map.depthTexture.magFilter=Ot}else l.isPointLight?(d.map=new Qr(i.x),d.map.depthTexture=new dt(i.x,Be)):(d.map=new Pe(i.x,i.y),d.map.depthTexture=new U(i.x,i.y,Be)),d.map.depthTexture.name=l.name+`.shadowMap`,d.map.depthTexture.format=Bt,this.type===1?(d.map.depthTexture.compareFunction=h?518:515,d.map.depthTexture.minFilter=Ge,d.map.depthTexture.magFilter=Ge):(d.map.depthTexture.compareFunction=null,d.map.depthTexture.minFilter=Ot,d.map.depthTexture.magFilter=Ot);d.camera.updateProjectionMatrix()}d.map.isWebGLCubeRenderTarget!==!0&&(d.map.width!==i.x||d.map.height!==i.y)&&d.map.setSize(i.x,i.y);let g=d.map.isWebGLCubeRenderTarget?6:d.getViewportCount();l.isPointLight!==!0&&d.updateMatrices(l,s);let _=d.camera.layers.mask&4294967294?d.camera.layers:s.layers;for(let t=0;t<g;t++){let i=d.getCamera(t);if(l.isPointLight){let e=d.camera,n=d.matrix,r=l.distance||e.far;r!==e.far&&(e.far=r,e.updateProjectionMatrix()),Po.setFromMatrixPosition(l.matrixWorld),e.position.copy(Po),Fo.copy(e.position),Fo.add(jo[t]),e.up.copy(Mo[t]),e.lookAt(Fo),e.updateMatrixWorld(),n.makeTranslation(-Po.x,-Po.y,-Po.z),No.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),d._frustum.setFromProjectionMatrix(No,e.coordinateSystem,e.reversedDepth)}if(d.map.isWebGLCubeRenderTarget)e.setRenderTarget(d.map,t),e.clear();else{t===0&&(e.setRenderTarget(d.map),e.clear());let n=d.getViewport(t);o.set(a.x*n.x,a.y*n.y,a.x*n.z,a.y*n.w),f.viewport(o)}r=d.getFrustum(t),b(n,s,i,l,_,this.type)}d.isPointLightShadow!==!0&&this.type===3&&v(d,s),d.needsUpdate=!1}_=this.type,g.needsUpdate=!1,e.setRenderTarget(c,l,d)};function v(n,r){let a=t.update(h);f.defines.VSM_SAMPLES!==n.blurSamples&&(f.defines.VSM_SAMPLES=n.blurSamples,p.defines.VSM_SAMPLES=n.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),n.mapPass===null?n.mapPass=new Pe(i.x,i.y,{format:Ft,type:je}):(n.mapPass.width!==n.map.width||n.mapPass.height!==n.map.height)&&n.mapPass.setSize(n.map.width,n.map.height),f.uniforms.shadow_pass.value=n.map.depthTexture,f.uniforms.resolution.value.set(n.map.width,n.map.height),f.uniforms.radius.value=n.radius,e.setRenderTarget(n.mapPass),e.clear(),e.renderBufferDirect(r,null,a,f,h,null),p.uniforms.shadow_pass.value=n.mapPass.texture,p.uniforms.resolution.value.set(n.map.width,n.map.height),p.uniforms.radius.value=n.radius,e.setRenderTarget(n.map),e.clear(),e.renderBufferDirect(r,null,a,p,h,null)}function y(t,n,r,i){let a=null,o=r.isPointLight===!0?t.customDistanceMaterial:t.customDepthMaterial;if(o!==void 0)a=o;else if(a=r.isPointLight===!0?c:s,e.localClippingEnabled&&n.clipShadows===!0&&Array.isArray(n.clippingPlanes)&&n.clippingPlanes.length!==0||n.displacementMap&&n.displacementScale!==0||n.alphaMap&&n.alphaTest>0||n.map&&n.alphaTest>0||n.alphaToCoverage===!0){let e=a.uuid,t=n.uuid,r=l[e];r===void 0&&(r={},l[e]=r);let i=r[t];i===void 0&&(i=a.clone(),r[t]=i,n.addEventListener(`dispose`,x)),a=i}if(a.visible=n.visible,a.wireframe=n.wireframe,i===3?a.side=n.shadowSide===null?n.side:n.shadowSide:a.side=n.shadowSide===null?d[n.side]:n.shadowSide,a.alphaMap=n.alphaMap,a.alphaTest=n.alphaToCoverage===!0?.5:n.alphaTest,a.map=n.map,a.clipShadows=n.clipShadows,a.clippingPlanes=n.clippingPlanes,a.clipIntersection=n.clipIntersection,a.displacementMap=n.displacementMap,a.displacementScale=n.displacementScale,a.displacementBias=n.displacementBias,a.wireframeLinewidth=n.wireframeLinewidth,a.linewidth=n.linewidth,r.isPointLight===!0&&a.isMeshDistanceMaterial===!0){let t=e.properties.get(a);t.light=r}return a}function b(n,i,a,o,s,c){if(n.visible===!1)return;if(n.layers.test(s)&&(n.isMesh||n.isLine||n.isPoints)&&(n.castShadow||n.receiveShadow&&c===3)&&(!n.frustumCulled||n.intersectsFrustum(r))){n.modelViewMatrix.multiplyMatrices(a.matrixWorldInverse,n.matrixWorld);let r=t.update(n),s=n.material;if(Array.isArray(s)){let t=r.groups;for(let l=0,u=t.length;l<u;l++){let u=t[l],d=s[u.materialIndex];if(d&&d.visible){let t=y(n,d,o,c);n.onBeforeShadow(e,n,i,a,r,t,u),e.renderBufferDirect(a,null,r,t,n,u),n.onAfterShadow(e,n,i,a,r,t,u)}}}else if(s.visible){let t=y(n,s,o,c);n.onBeforeShadow(e,n,i,a,r,t,null),e.renderBufferDirect(a,null,r,t,n,null),n.onAfterShadow(e,n,i,a,r,t,null)}}let l=n.children;for(let e=0,t=l.length;e<t;e++)b(l[e],i,a,o,s,c)}function x(e){e.target.removeEventListener(`dispose`,x);for(let t in l){let n=l[t],r=e.target.uuid;r in n&&(n[r].dispose(),delete n[r])}}}function Lo(e,t){function n(){let t=!1,n=new Ke,r=null,i=new Ke(0,0,0,0);return{setMask:function(n){r!==n&&!t&&(e.colorMask(n,n,n,n),r=n)},setLocked:function(e){t=e},setClear:function(t,r,a,o,s){s===!0&&(t*=o,r*=o,a*=o),n.set(t,r,a,o),i.equals(n)===!1&&(e.clearColor(t,r,a,o),i.copy(n))},reset:function(){t=!1,r=null,i.set(-1,0,0,0)}}}function r(){let n=!1,r=!1,i=null,a=null,o=null;return{setReversed:function(e){if(r!==e){let n=t.get(`EXT_clip_control`);e?n.clipControlEXT(n.LOWER_LEFT_EXT,n.ZERO_TO_ONE_EXT):n.clipControlEXT(n.LOWER_LEFT_EXT,n.NEGATIVE_ONE_TO_ONE_EXT),r=e;let i=o;o=null,this.setClear(i)}},getReversed:function(){return r},setTest:function(t){t?se(e.DEPTH_TEST):L(e.DEPTH_TEST)},setMask:function(t){i!==t&&!n&&(e.depthMask(t),i=t)},setFunc:function(t){if(r&&(t=Ye[t]),a!==t){switch(t){case 0:e.depthFunc(e.NEVER);break;case 1:e.depthFunc(e.ALWAYS);break;case 2:e.depthFunc(e.LESS);break;case 3:e.depthFunc(e.LEQUAL);break;case 4:e.depthFunc(e.EQUAL);break;case 5:e.depthFunc(e.GEQUAL);break;case 6:e.depthFunc(e.GREATER);break;case 7:e.depthFunc(e.NOTEQUAL);break;default:e.depthFunc(e.LEQUAL)}a=t}},setLocked:function(e){n=e},setClear:function(t){o!==t&&(o=t,r&&(t=1-t),e.clearDepth(t))},reset:function(){n=!1,i=null,a=null,o=null,r=!1}}}function i(){let t=!1,n=null,r=null,i=null,a=null,o=null,s=null,c=null,l=null;return{setTest:function(n){t||(n?se(e.STENCIL_TEST):L(e.STENCIL_TEST))},setMask:function(r){n!==r&&!t&&(e.stencilMask(r),n=r)},setFunc:function(t,n,o){(r!==t||i!==n||a!==o)&&(e.stencilFunc(t,n,o),r=t,i=n,a=o)},setOp:function(t,n,r){(o!==t||s!==n||c!==r)&&(e.stencilOp(t,n,r),o=t,s=n,c=r)},setLocked:function(e){t=e},setClear:function(t){l!==t&&(e.clearStencil(t),l=t)},reset:function(){t=!1,n=null,r=null,i=null,a=null,o=null,s=null,c=null,l=null}}}let a=new n,o=new r,s=new i,c={},l=new WeakMap,u={},d={},f={},p=new WeakMap,m=[],h=null,g=!1,_=null,v=null,y=null,b=null,x=null,S=null,C=null,w=new q(0,0,0),T=0,E=!1,D=null,O=null,k=null,A=null,j=null,ee=e.getParameter(e.MAX_COMBINED_TEXTURE_IMAGE_UNITS),M=!1,te=0,N=e.getParameter(e.VERSION);N.indexOf(`WebGL`)===-1?N.indexOf(`OpenGL ES`)!==-1&&(te=parseFloat(/^OpenGL ES (\d)/.exec(N)[1]),M=te>=2):(te=parseFloat(/^WebGL (\d)/.exec(N)[1]),M=te>=1);let P=null,ne={},re=e.getParameter(e.SCISSOR_BOX),ie=e.getParameter(e.VIEWPORT),ae=new Ke().fromArray(re),F=new Ke().fromArray(ie);function oe(t,n,r,i){let a=new Uint8Array(4),o=e.createTexture();e.bindTexture(t,o),e.texParameteri(t,e.TEXTURE_MIN_FILTER,e.NEAREST),e.texParameteri(t,e.TEXTURE_MAG_FILTER,e.NEAREST);for(let o=0;o<r;o++)t===e.TEXTURE_3D||t===e.TEXTURE_2D_ARRAY?e.texImage3D(n,0,e.RGBA,1,1,i,0,e.RGBA,e.UNSIGNED_BYTE,a):e.texImage2D(n+o,0,e.RGBA,1,1,0,e.RGBA,e.UNSIGNED_BYTE,a);return o}let I={};I[e.TEXTURE_2D]=oe(e.TEXTURE_2D,e.TEXTURE_2D,1),I[e.TEXTURE_CUBE_MAP]=oe(e.TEXTURE_CUBE_MAP,e.TEXTURE_CUBE_MAP_POSITIVE_X,6),I[e.TEXTURE_2D_ARRAY]=oe(e.TEXTURE_2D_ARRAY,e.TEXTURE_2D_ARRAY,1,1),I[e.TEXTURE_3D]=oe(e.TEXTURE_3D,e.TEXTURE_3D,1,1),a.setClear(0,0,0,1),o.setClear(1),s.setClear(0),se(e.DEPTH_TEST),o.setFunc(3),pe(!1),me(1),se(e.CULL_FACE),de(0);function se(t){u[t]!==!0&&(e.enable(t),u[t]=!0)}function L(t){u[t]!==!1&&(e.disable(t),u[t]=!1)}function ce(t,n){return f[t]!==n&&(e.bindFramebuffer(t,n),f[t]=n,t===e.DRAW_FRAMEBUFFER&&(f[e.FRAMEBUFFER]=n),t===e.FRAMEBUFFER&&(f[e.DRAW_FRAMEBUFFER]=n),!0)}function le(t,n){let r=m,i=!1;if(t){r=p.get(n),r===void 0&&(r=[],p.set(n,r));let a=t.textures;if(r.length!==a.length||r[0]!==e.COLOR_ATTACHMENT0){for(let t=0,n=a.length;t<n;t++)r[t]=e.COLOR_ATTACHMENT0+t;r.length=a.length,i=!0}}else r[0]!==e.BACK&&(r[0]=e.BACK,i=!0);i&&e.drawBuffers(r)}function ue(t){return h!==t&&(e.useProgram(t),h=t,!0)}let R={100:e.FUNC_ADD,101:e.FUNC_SUBTRACT,102:e.FUNC_REVERSE_SUBTRACT};R[103]=e.MIN,R[104]=e.MAX;let z={200:e.ZERO,201:e.ONE,202:e.SRC_COLOR,204:e.SRC_ALPHA,210:e.SRC_ALPHA_SATURATE,208:e.DST_COLOR,206:e.DST_ALPHA,203:e.ONE_MINUS_SRC_COLOR,205:e.ONE_MINUS_SRC_ALPHA,209:e.ONE_MINUS_DST_COLOR,207:e.ONE_MINUS_DST_ALPHA,211:e.CONSTANT_COLOR,212:e.ONE_MINUS_CONSTANT_COLOR,213:e.CONSTANT_ALPHA,214:e.ONE_MINUS_CONSTANT_ALPHA};function de(t,n,r,i,a,o,s,c,l,u){if(t===0)g===!0&&(L(e.BLEND),g=!1);else if(g===!1&&(se(e.BLEND),g=!0),t!==5){if(t!==_||u!==E){if((v!==100||x!==100)&&(e.blendEquation(e.FUNC_ADD),v=100,x=100),u)switch(t){case 1:e.blendFuncSeparate(e.ONE,e.ONE_MINUS_SRC_ALPHA,e.ONE,e.ONE_MINUS_SRC_ALPHA);break;case 2:e.blendFunc(e.ONE,e.ONE);break;case 3:e.blendFuncSeparate(e.ZERO,e.ONE_MINUS_SRC_COLOR,e.ZERO,e.ONE);break;case 4:e.blendFuncSeparate(e.DST_COLOR,e.ONE_MINUS_SRC_ALPHA,e.ZERO,e.ONE);break;default:Z(`WebGLState: Invalid blending: `,t)}else switch(t){case 1:e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,e.ONE,e.ONE_MINUS_SRC_ALPHA);break;case 2:e.blendFuncSeparate(e.SRC_ALPHA,e.ONE,e.ONE,e.ONE);break;case 3:Z(`WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true`);break;case 4:Z(`WebGLState: MultiplyBlending requires material.premultipliedAlpha = true`);break;default:Z(`WebGLState: Invalid blending: `,t)}y=null,b=null,S=null,C=null,w.set(0,0,0),T=0,_=t,E=u}}else a||=n,o||=r,s||=i,(n!==v||a!==x)&&(e.blendEquationSeparate(R[n],R[a]),v=n,x=a),(r!==y||i!==b||o!==S||s!==C)&&(e.blendFuncSeparate(z[r],z[i],z[o],z[s]),y=r,b=i,S=o,C=s),(c.equals(w)===!1||l!==T)&&(e.blendColor(c.r,c.g,c.b,l),w.copy(c),T=l),_=t,E=!1}function fe(t,n){t.side===2?L(e.CULL_FACE):se(e.CULL_FACE);let r=t.side===1;n&&(r=!r),pe(r),t.blending===1&&t.transparent===!1?de(0):de(t.blending,t.blendEquation,t.blendSrc,t.blendDst,t.blendEquationAlpha,t.blendSrcAlpha,t.blendDstAlpha,t.blendColor,t.blendAlpha,t.premultipliedAlpha),o.setFunc(t.depthFunc),o.setTest(t.depthTest),o.setMask(t.depthWrite),a.setMask(t.colorWrite);let i=t.stencilWrite;s.setTest(i),i&&(s.setMask(t.stencilWriteMask),s.setFunc(t.stencilFunc,t.stencilRef,t.stencilFuncMask),s.setOp(t.stencilFail,t.stencilZFail,t.stencilZPass)),ge(t.polygonOffset,t.polygonOffsetFactor,t.polygonOffsetUnits),t.alphaToCoverage===!0?se(e.SAMPLE_ALPHA_TO_COVERAGE):L(e.SAMPLE_ALPHA_TO_COVERAGE)}function pe(t){D!==t&&(t?e.frontFace(e.CW):e.frontFace(e.CCW),D=t)}function me(t){t===0?L(e.CULL_FACE):(se(e.CULL_FACE),t!==O&&(t===1?e.cullFace(e.BACK):t===2?e.cullFace(e.FRONT):e.cullFace(e.FRONT_AND_BACK))),O=t}function he(t){t!==k&&(M&&e.lineWidth(t),k=t)}function ge(t,n,r){t?(se(e.POLYGON_OFFSET_FILL),(A!==n||j!==r)&&(A=n,j=r,o.getReversed()&&(n=-n,r=-r),e.polygonOffset(n,r))):L(e.POLYGON_OFFSET_FILL)}function _e(t){t?se(e.SCISSOR_TEST):L(e.SCISSOR_TEST)}function ve(t){t===void 0&&(t=e.TEXTURE0+ee-1),P!==t&&(e.activeTexture(t),P=t)}function B(t,n,r){r===void 0&&(r=P===null?e.TEXTURE0+ee-1:P);let i=ne[r];i===void 0&&(i={type:void 0,texture:void 0},ne[r]=i),(i.type!==t||i.texture!==n)&&(P!==r&&(e.activeTexture(r),P=r),e.bindTexture(t,n||I[t]),i.type=t,i.texture=n)}function ye(){let t=ne[P];t!==void 0&&t.type!==void 0&&(e.bindTexture(t.type,null),t.type=void 0,t.texture=void 0)}function V(){try{e.compressedTexImage2D(...arguments)}catch(e){Z(`WebGLState:`,e)}}function be(){try{e.compressedTexImage3D(...arguments)}catch(e){Z(`WebGLState:`,e)}}function xe(){try{e.texSubImage2D(...arguments)}catch(e){Z(`WebGLState:`,e)}}function H(){try{e.texSubImage3D(...arguments)}catch(e){Z(`WebGLState:`,e)}}function U(){try{e.compressedTexSubImage2D(...arguments)}catch(e){Z(`WebGLState:`,e)}}function W(){try{e.compressedTexSubImage3D(...arguments)}catch(e){Z(`WebGLState:`,e)}}function G(){try{e.texStorage2D(...arguments)}catch(e){Z(`WebGLState:`,e)}}function Se(){try{e.texStorage3D(...arguments)}catch(e){Z(`WebGLState:`,e)}}function Ce(){try{e.texImage2D(...arguments)}catch(e){Z(`WebGLState:`,e)}}function K(){try{e.texImage3D(...arguments)}catch(e){Z(`WebGLState:`,e)}}function we(t){return d[t]===void 0?e.getParameter(t):d[t]}function Te(t,n){d[t]!==n&&(e.pixelStorei(t,n),d[t]=n)}function Ee(t){ae.equals(t)===!1&&(e.scissor(t.x,t.y,t.z,t.w),ae.copy(t))}function De(t){F.equals(t)===!1&&(e.viewport(t.x,t.y,t.z,t.w),F.copy(t))}function Oe(t,n){let r=l.get(n);r===void 0&&(r=new WeakMap,l.set(n,r));let i=r.get(t);i===void 0&&(i=e.getUniformBlockIndex(n,t.name),e.uniformBlockBinding(n,i,i),r.set(t,i))}function ke(t,n,r){let i=l.get(n).get(t);c[i]!==r&&(e.bindBufferBase(e.UNIFORM_BUFFER,i,r),c[i]=r)}function Ae(){e.disable(e.BLEND),e.disable(e.CULL_FACE),e.disable(e.DEPTH_TEST),e.disable(e.POLYGON_OFFSET_FILL),e.disable(e.SCISSOR_TEST),e.disable(e.STENCIL_TEST),e.disable(e.SAMPLE_ALPHA_TO_COVERAGE),e.blendEquation(e.FUNC_ADD),e.blendFunc(e.ONE,e.ZERO),e.blendFuncSeparate(e.ONE,e.ZERO,e.ONE,e.ZERO),e.blendColor(0,0,0,0),e.colorMask(!0,!0,!0,!0),e.clearColor(0,0,0,0),e.depthMask(!0),e.depthFunc(e.LESS),o.setReversed(!1),e.clearDepth(1),e.stencilMask(4294967295),e.stencilFunc(e.ALWAYS,0,4294967295),e.stencilOp(e.KEEP,e.KEEP,e.KEEP),e.clearStencil(0),e.cullFace(e.BACK),e.frontFace(e.CCW),e.polygonOffset(0,0),e.activeTexture(e.TEXTURE0),e.bindFramebuffer(e.FRAMEBUFFER,null),e.bindFramebuffer(e.DRAW_FRAMEBUFFER,null),e.bindFramebuffer(e.READ_FRAMEBUFFER,null),e.useProgram(null),e.lineWidth(1),e.scissor(0,0,e.canvas.width,e.canvas.height),e.viewport(0,0,e.canvas.width,e.canvas.height),e.pixelStorei(e.PACK_ALIGNMENT,4),e.pixelStorei(e.UNPACK_ALIGNMENT,4),e.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,!1),e.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),e.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,e.BROWSER_DEFAULT_WEBGL),e.pixelStorei(e.PACK_ROW_LENGTH,0),e.pixelStorei(e.PACK_SKIP_PIXELS,0),e.pixelStorei(e.PACK_SKIP_ROWS,0),e.pixelStorei(e.UNPACK_ROW_LENGTH,0),e.pixelStorei(e.UNPACK_IMAGE_HEIGHT,0),e.pixelStorei(e.UNPACK_SKIP_PIXELS,0),e.pixelStorei(e.UNPACK_SKIP_ROWS,0),e.pixelStorei(e.UNPACK_SKIP_IMAGES,0),u={},d={},P=null,ne={},f={},c={},p=new WeakMap,m=[],h=null,g=!1,_=null,v=null,y=null,b=null,x=null,S=null,C=null,w=new q(0,0,0),T=0,E=!1,D=null,O=null,k=null,A=null,j=null,ae.set(0,0,e.canvas.width,e.canvas.height),F.set(0,0,e.canvas.width,e.canvas.height),a.reset(),o.reset(),s.reset()}return{buffers:{color:a,depth:o,stencil:s},enable:se,disable:L,bindFramebuffer:ce,drawBuffers:le,useProgram:ue,setBlending:de,setMaterial:fe,setFlipSided:pe,setCullFace:me,setLineWidth:he,setPolygonOffset:ge,setScissorTest:_e,activeTexture:ve,bindTexture:B,unbindTexture:ye,compressedTexImage2D:V,compressedTexImage3D:be,texImage2D:Ce,texImage3D:K,pixelStorei:Te,getParameter:we,updateUBOMapping:Oe,uniformBlockBinding:ke,texStorage2D:G,texStorage3D:Se,texSubImage2D:xe,texSubImage3D:H,compressedTexSubImage2D:U,compressedTexSubImage3D:W,scissor:Ee,viewport:De,reset:Ae}}function Ro(e,t,n,r,i,a,o){let s=t.has(`WEBGL_multisampled_render_to_texture`)?t.get(`WEBGL_multisampled_render_to_texture`):null,c=typeof navigator>`u`?!1:/OculusBrowser/g.test(navigator.userAgent),l=new kt,u=new WeakMap,d=new Set,f,p=new WeakMap,m=new Set,h=new FinalizationRegistry(e=>m.delete(e)),g=!1;try{g=typeof OffscreenCanvas<`u`&&new OffscreenCanvas(1,1).getContext(`2d`)!==null}catch{}function _(e,t){return g?new OffscreenCanvas(e,t):St(`canvas`)}function v(e,t,n){let r=1,i=Se(e);if((i.width>n||i.height>n)&&(r=n/Math.max(i.width,i.height)),r<1){if(typeof HTMLImageElement<`u`&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<`u`&&e instanceof HTMLCanvasElement||typeof ImageBitmap<`u`&&e instanceof ImageBitmap||typeof VideoFrame<`u`&&e instanceof VideoFrame){let n=Math.floor(r*i.width),a=Math.floor(r*i.height);f===void 0&&(f=_(n,a));let o=t?_(n,a):f;return o.width=n,o.height=a,o.getContext(`2d`).drawImage(e,0,0,n,a),Y(`WebGLRenderer: Texture has been resized from (`+i.width+`x`+i.height+`) to (`+n+`x`+a+`).`),o}return`data`in e&&Y(`WebGLRenderer: Image in DataTexture is too big (`+i.width+`x`+i.height+`).`),e}return e}function y(e){return e.generateMipmaps}function b(t){e.generateMipmap(t)}function x(t){return t.isWebGLCubeRenderTarget?e.TEXTURE_CUBE_MAP:t.isWebGL3DRenderTarget?e.TEXTURE_3D:t.isWebGLArrayRenderTarget||t.isCompressedArrayTexture?e.TEXTURE_2D_ARRAY:e.TEXTURE_2D}function S(n,r,i,a,o,s=!1){if(n!==null){if(e[n]!==void 0)return e[n];Y(`WebGLRenderer: Attempt to use non-existing WebGL internal format '`+n+`'`)}let c;a&&(c=t.get(`EXT_texture_norm16`),c||Y(`WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension`));let l=r;if(r===e.RED&&(i===e.FLOAT&&(l=e.R32F),i===e.HALF_FLOAT&&(l=e.R16F),i===e.UNSIGNED_BYTE&&(l=e.R8),i===e.UNSIGNED_SHORT&&c&&(l=c.R16_EXT),i===e.SHORT&&c&&(l=c.R16_SNORM_EXT)),r===e.RED_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.R8UI),i===e.UNSIGNED_SHORT&&(l=e.R16UI),i===e.UNSIGNED_INT&&(l=e.R32UI),i===e.BYTE&&(l=e.R8I),i===e.SHORT&&(l=e.R16I),i===e.INT&&(l=e.R32I)),r===e.RG&&(i===e.FLOAT&&(l=e.RG32F),i===e.HALF_FLOAT&&(l=e.RG16F),i===e.UNSIGNED_BYTE&&(l=e.RG8),i===e.UNSIGNED_SHORT&&c&&(l=c.RG16_EXT),i===e.SHORT&&c&&(l=c.RG16_SNORM_EXT)),r===e.RG_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.RG8UI),i===e.UNSIGNED_SHORT&&(l=e.RG16UI),i===e.UNSIGNED_INT&&(l=e.RG32UI),i===e.BYTE&&(l=e.RG8I),i===e.SHORT&&(l=e.RG16I),i===e.INT&&(l=e.RG32I)),r===e.RGB_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.RGB8UI),i===e.UNSIGNED_SHORT&&(l=e.RGB16UI),i===e.UNSIGNED_INT&&(l=e.RGB32UI),i===e.BYTE&&(l=e.RGB8I),i===e.SHORT&&(l=e.RGB16I),i===e.INT&&(l=e.RGB32I)),r===e.RGBA_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.RGBA8UI),i===e.UNSIGNED_SHORT&&(l=e.RGBA16UI),i===e.UNSIGNED_INT&&(l=e.RGBA32UI),i===e.BYTE&&(l=e.RGBA8I),i===e.SHORT&&(l=e.RGBA16I),i===e.INT&&(l=e.RGBA32I)),r===e.RGB&&(i===e.UNSIGNED_SHORT&&c&&(l=c.RGB16_EXT),i===e.SHORT&&c&&(l=c.RGB16_SNORM_EXT),i===e.UNSIGNED_INT_5_9_9_9_REV&&(l=e.RGB9_E5),i===e.UNSIGNED_INT_10F_11F_11F_REV&&(l=e.R11F_G11F_B10F)),r===e.RGBA){let t=s?V:J.getTransfer(o);i===e.FLOAT&&(l=e.RGBA32F),i===e.HALF_FLOAT&&(l=e.RGBA16F),i===e.UNSIGNED_BYTE&&(l=t===`srgb`?e.SRGB8_ALPHA8:e.RGBA8),i===e.UNSIGNED_SHORT&&c&&(l=c.RGBA16_EXT),i===e.SHORT&&c&&(l=c.RGBA16_SNORM_EXT),i===e.UNSIGNED_SHORT_4_4_4_4&&(l=e.RGBA4),i===e.UNSIGNED_SHORT_5_5_5_1&&(l=e.RGB5_A1)}return(l===e.R16F||l===e.R32F||l===e.RG16F||l===e.RG32F||l===e.RGBA16F||l===e.RGBA32F)&&t.get(`EXT_color_buffer_float`),l}function C(t,n){let r;return t?n===null||n===1014||n===1020?r=e.DEPTH24_STENCIL8:n===1015?r=e.DEPTH32F_STENCIL8:n===1012&&(r=e.DEPTH24_STENCIL8,Y(`DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.`)):n===null||n===1014||n===1020?r=e.DEPTH_COMPONENT24:n===1015?r=e.DEPTH_COMPONENT32F:n===1012&&(r=e.DEPTH_COMPONENT16),r}function w(e,t){return y(e)===!0||e.isFramebufferTexture&&e.minFilter!==1003&&e.minFilter!==1006?Math.log2(Math.max(t.width,t.height))+1:e.mipmaps.length>0?e.mipmaps.length:e.isCompressedTexture&&Array.isArray(e.image)?t.mipmaps.length:1}function T(e){let t=new WeakRef(e);r.get(e).__ref=t,m.add(t),h.register(e,t,t)}function E(e){let t=r.get(e).__ref;t!==void 0&&(m.delete(t),h.unregister(t))}function D(e){k(e.target)}function O(e){A(e.target)}function k(e){e.removeEventListener(`dispose`,D),E(e),ee(e),e.isVideoTexture&&u.delete(e),e.isHTMLTexture&&d.delete(e)}function A(e){e.removeEventListener(`dispose`,O),E(e),te(e)}function j(){for(let e of m){let t=e.deref();t!==void 0&&(t.isRenderTarget===!0?A(t):k(t))}m.clear(),d.clear()}function ee(e){let t=r.get(e);if(t.__webglInit===void 0)return;let n=e.source,i=p.get(n);if(i){let r=i[t.__cacheKey];r.usedTimes--,r.usedTimes===0&&M(e),Object.keys(i).length===0&&p.delete(n)}r.remove(e)}function M(t){let n=r.get(t);e.deleteTexture(n.__webglTexture);let i=t.source,a=p.get(i);delete a[n.__cacheKey],o.memory.textures--}function te(t){let n=r.get(t);n.__depthDisposeCallback&&n.__depthDisposeCallback();let i=t.depthTexture;if(i&&i.renderTarget===t&&k(i),t.isWebGLCubeRenderTarget)for(let t=0;t<6;t++){if(Array.isArray(n.__webglFramebuffer[t]))for(let r=0;r<n.__webglFramebuffer[t].length;r++)e.deleteFramebuffer(n.__webglFramebuffer[t][r]);else e.deleteFramebuffer(n.__webglFramebuffer[t]);n.__webglDepthbuffer&&e.deleteRenderbuffer(n.__webglDepthbuffer[t])}else{if(Array.isArray(n.__webglFramebuffer))for(let t=0;t<n.__webglFramebuffer.length;t++)e.deleteFramebuffer(n.__webglFramebuffer[t]);else e.deleteFramebuffer(n.__webglFramebuffer);if(n.__webglDepthbuffer&&e.deleteRenderbuffer(n.__webglDepthbuffer),n.__webglMultisampledFramebuffer&&e.deleteFramebuffer(n.__webglMultisampledFramebuffer),n.__webglColorRenderbuffer)for(let t=0;t<n.__webglColorRenderbuffer.length;t++)n.__webglColorRenderbuffer[t]&&e.deleteRenderbuffer(n.__webglColorRenderbuffer[t]);n.__webglDepthRenderbuffer&&e.deleteRenderbuffer(n.__webglDepthRenderbuffer)}let a=t.textures;for(let t=0,n=a.length;t<n;t++){let n=r.get(a[t]);n.__webglTexture&&(e.deleteTexture(n.__webglTexture),o.memory.textures--),r.remove(a[t])}r.remove(t)}let N=0;function P(){N=0}function ne(){return N}function re(e){N=e}function ie(){let e=N;return e>=i.maxTextures&&Y(`WebGLTextures: Trying to use `+(e+1)+` texture units while this GPU supports only `+i.maxTextures),N+=1,e}function ae(e){let t=[];return t.push(e.wrapS),t.push(e.wrapT),t.push(e.wrapR||0),t.push(e.magFilter),t.push(e.minFilter),t.push(e.anisotropy),t.push(e.internalFormat),t.push(e.format),t.push(e.type),t.push(e.generateMipmaps),t.push(e.mipmapsAutoUpdate),t.push(e.premultiplyAlpha),t.push(e.flipY),t.push(e.unpackAlignment),t.push(e.colorSpace),t.join()}function F(t,i){let a=r.get(t);if(t.isVideoTexture&&W(t),t.isRenderTargetTexture===!1&&t.isExternalTexture!==!0&&t.version>0&&a.__version!==t.version){let e=t.image;if(e===null)Y(`WebGLRenderer: Texture marked for update but no image data found.`);else if(e.complete===!1)Y(`WebGLRenderer: Texture marked for update but image is incomplete`);else{fe(a,t,i);return}}else t.isExternalTexture&&(a.__webglTexture=t.sourceTexture?t.sourceTexture:null);n.bindTexture(e.TEXTURE_2D,a.__webglTexture,e.TEXTURE0+i)}function oe(t,i){let a=r.get(t);t.isRenderTargetTexture===!1&&t.version>0&&a.__version!==t.version?fe(a,t,i):(t.isExternalTexture&&(a.__webglTexture=t.sourceTexture?t.sourceTexture:null),n.bindTexture(e.TEXTURE_2D_ARRAY,a.__webglTexture,e.TEXTURE0+i))}function I(t,i){let a=r.get(t);t.isRenderTargetTexture===!1&&t.version>0&&a.__version!==t.version?fe(a,t,i):n.bindTexture(e.TEXTURE_3D,a.__webglTexture,e.TEXTURE0+i)}function se(t,i){let a=r.get(t);t.version>0&&a.__version!==t.version?pe(a,t,i):n.bindTexture(e.TEXTURE_CUBE_MAP,a.__webglTexture,e.TEXTURE0+i)}let L={[ut]:e.REPEAT,[Pt]:e.CLAMP_TO_EDGE,[ct]:e.MIRRORED_REPEAT},ce={[Ot]:e.NEAREST,[pt]:e.NEAREST_MIPMAP_NEAREST,[xt]:e.NEAREST_MIPMAP_LINEAR,[Ge]:e.LINEAR,[qe]:e.LINEAR_MIPMAP_NEAREST,[We]:e.LINEAR_MIPMAP_LINEAR},le={512:e.NEVER,519:e.ALWAYS,513:e.LESS,515:e.LEQUAL,514:e.EQUAL,518:e.GEQUAL,516:e.GREATER,517:e.NOTEQUAL};function ue(n,a){if(a.type===1015&&t.has(`OES_texture_float_linear`)===!1&&(a.magFilter===1006||a.magFilter===1007||a.magFilter===1005||a.magFilter===1008||a.minFilter===1006||a.minFilter===1007||a.minFilter===1005||a.minFilter===1008)&&Y(`WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device.`),e.texParameteri(n,e.TEXTURE_WRAP_S,L[a.wrapS]),e.texParameteri(n,e.TEXTURE_WRAP_T,L[a.wrapT]),(n===e.TEXTURE_3D||n===e.TEXTURE_2D_ARRAY)&&e.texParameteri(n,e.TEXTURE_WRAP_R,L[a.wrapR]),e.texParameteri(n,e.TEXTURE_MAG_FILTER,ce[a.magFilter]),e.texParameteri(n,e.TEXTURE_MIN_FILTER,ce[a.minFilter]),a.compareFunction&&(e.texParameteri(n,e.TEXTURE_COMPARE_MODE,e.COMPARE_REF_TO_TEXTURE),e.texParameteri(n,e.TEXTURE_COMPARE_FUNC,le[a.compareFunction])),t.has(`EXT_texture_filter_anisotropic`)===!0){if(a.magFilter===1003||a.minFilter!==1005&&a.minFilter!==1008||a.type===1015&&t.has(`OES_texture_float_linear`)===!1)return;if(a.anisotropy>1||r.get(a).__currentAnisotropy){let o=t.get(`EXT_texture_filter_anisotropic`);e.texParameterf(n,o.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(a.anisotropy,i.getMaxAnisotropy())),r.get(a).__currentAnisotropy=a.anisotropy}}}function R(t,n){let r=!1;t.__webglInit===void 0&&(t.__webglInit=!0,n.addEventListener(`dispose`,D),T(n));let i=n.source,a=p.get(i);a===void 0&&(a={},p.set(i,a));let s=ae(n);if(s!==t.__cacheKey){a[s]===void 0&&(a[s]={texture:e.createTexture(),usedTimes:0},o.memory.textures++,r=!0),a[s].usedTimes++;let i=a[t.__cacheKey];i!==void 0&&(a[t.__cacheKey].usedTimes--,i.usedTimes===0&&M(n)),t.__cacheKey=s,t.__webglTexture=a[s].texture}return r}function z(e,t,n){return Math.floor(Math.floor(e/n)/t)}function de(t,r,i,a){let o=t.updateRanges;if(o.length===0)n.texSubImage2D(e.TEXTURE_2D,0,0,0,r.width,r.height,i,a,r.data);else{o.sort((e,t)=>e.start-t.start);let s=0;for(let e=1;e<o.length;e++){let t=o[s],n=o[e],i=t.start+t.count,a=z(n.start,r.width,4),c=z(t.start,r.width,4);n.start<=i+1&&a===c&&z(n.start+n.count-1,r.width,4)===a?t.count=Math.max(t.count,n.start+n.count-t.start):(++s,o[s]=n)}o.length=s+1;let c=n.getParameter(e.UNPACK_ROW_LENGTH),l=n.getParameter(e.UNPACK_SKIP_PIXELS),u=n.getParameter(e.UNPACK_SKIP_ROWS);n.pixelStorei(e.UNPACK_ROW_LENGTH,r.width);for(let t=0,s=o.length;t<s;t++){let s=o[t],c=Math.floor(s.start/4),l=Math.ceil(s.count/4),u=c%r.width,d=Math.floor(c/r.width),f=l;n.pixelStorei(e.UNPACK_SKIP_PIXELS,u),n.pixelStorei(e.UNPACK_SKIP_ROWS,d),n.texSubImage2D(e.TEXTURE_2D,0,u,d,f,1,i,a,r.data)}t.clearUpdateRanges(),n.pixelStorei(e.UNPACK_ROW_LENGTH,c),n.pixelStorei(e.UNPACK_SKIP_PIXELS,l),n.pixelStorei(e.UNPACK_SKIP_ROWS,u)}}function fe(t,o,s){let c=e.TEXTURE_2D;(o.isDataArrayTexture||o.isCompressedArrayTexture)&&(c=e.TEXTURE_2D_ARRAY),o.isData3DTexture&&(c=e.TEXTURE_3D);let l=R(t,o),u=o.source;n.bindTexture(c,t.__webglTexture,e.TEXTURE0+s);let f=r.get(u);if(u.version!==f.__version||l===!0){if(n.activeTexture(e.TEXTURE0+s),!(typeof ImageBitmap<`u`&&o.image instanceof ImageBitmap)){let t=J.getPrimaries(J.workingColorSpace),r=o.colorSpace===``?null:J.getPrimaries(o.colorSpace),i=o.colorSpace===``||t===r?e.NONE:e.BROWSER_DEFAULT_WEBGL;n.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,o.flipY),n.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,o.premultiplyAlpha),n.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,i)}n.pixelStorei(e.UNPACK_ALIGNMENT,o.unpackAlignment);let t=v(o.image,!1,i.maxTextureSize);t=G(o,t);let r=a.convert(o.format,o.colorSpace),p=a.convert(o.type),m=S(o.internalFormat,r,p,o.normalized,o.colorSpace,o.isVideoTexture);ue(c,o);let h,g=o.mipmaps,_=o.isVideoTexture!==!0,x=f.__version===void 0||l===!0,T=u.dataReady,E=w(o,t);if(o.isDepthTexture)m=C(o.format===Ie,o.type),x&&(_?n.texStorage2D(e.TEXTURE_2D,1,m,t.width,t.height):n.texImage2D(e.TEXTURE_2D,0,m,t.width,t.height,0,r,p,null));else if(o.isDataTexture){if(g.length>0){_&&x&&n.texStorage2D(e.TEXTURE_2D,E,m,g[0].width,g[0].height);for(let t=0,i=g.length;t<i;t++)h=g[t],_?T&&n.texSubImage2D(e.TEXTURE_2D,t,0,0,h.width,h.height,r,p,h.data):n.texImage2D(e.TEXTURE_2D,t,m,h.width,h.height,0,r,p,h.data);o.generateMipmaps=!1}else _?(x&&n.texStorage2D(e.TEXTURE_2D,E,m,t.width,t.height),T&&de(o,t,r,p)):n.texImage2D(e.TEXTURE_2D,0,m,t.width,t.height,0,r,p,t.data)}else if(o.isCompressedTexture){if(o.isCompressedArrayTexture){_&&x&&n.texStorage3D(e.TEXTURE_2D_ARRAY,E,m,g[0].width,g[0].height,t.depth);for(let i=0,a=g.length;i<a;i++)if(h=g[i],o.format!==1023){if(r!==null){if(_){if(T){if(o.layerUpdates.size>0){let t=Ze(h.width,h.height,o.format,o.type);for(let a of o.layerUpdates){let o=h.data.subarray(a*t/h.data.BYTES_PER_ELEMENT,(a+1)*t/h.data.BYTES_PER_ELEMENT);n.compressedTexSubImage3D(e.TEXTURE_2D_ARRAY,i,0,0,a,h.width,h.height,1,r,o)}}else n.compressedTexSubImage3D(e.TEXTURE_2D_ARRAY,i,0,0,0,h.width,h.height,t.depth,r,h.data)}}else n.compressedTexImage3D(e.TEXTURE_2D_ARRAY,i,m,h.width,h.height,t.depth,0,h.data,0,0)}else Y(`WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()`)}else _?T&&n.texSubImage3D(e.TEXTURE_2D_ARRAY,i,0,0,0,h.width,h.height,t.depth,r,p,h.data):n.texImage3D(e.TEXTURE_2D_ARRAY,i,m,h.width,h.height,t.depth,0,r,p,h.data);o.layerUpdates.size>0&&o.clearLayerUpdates()}else{_&&x&&n.texStorage2D(e.TEXTURE_2D,E,m,g[0].width,g[0].height);for(let t=0,i=g.length;t<i;t++)h=g[t],o.format===1023?_?T&&n.texSubImage2D(e.TEXTURE_2D,t,0,0,h.width,h.height,r,p,h.data):n.texImage2D(e.TEXTURE_2D,t,m,h.width,h.height,0,r,p,h.data):r===null?Y(`WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()`):_?T&&n.compressedTexSubImage2D(e.TEXTURE_2D,t,0,0,h.width,h.height,r,h.data):n.compressedTexImage2D(e.TEXTURE_2D,t,m,h.width,h.height,0,h.data)}}else if(o.isDataArrayTexture){if(_){if(x&&n.texStorage3D(e.TEXTURE_2D_ARRAY,E,m,t.width,t.height,t.depth),T){if(o.layerUpdates.size>0){let i=Ze(t.width,t.height,o.format,o.type);for(let a of o.layerUpdates){let o=t.data.subarray(a*i/t.data.BYTES_PER_ELEMENT,(a+1)*i/t.data.BYTES_PER_ELEMENT);n.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,a,t.width,t.height,1,r,p,o)}o.clearLayerUpdates()}else n.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,0,t.width,t.height,t.depth,r,p,t.data)}}else n.texImage3D(e.TEXTURE_2D_ARRAY,0,m,t.width,t.height,t.depth,0,r,p,t.data)}else if(o.isData3DTexture)_?(x&&n.texStorage3D(e.TEXTURE_3D,E,m,t.width,t.height,t.depth),T&&n.texSubImage3D(e.TEXTURE_3D,0,0,0,0,t.width,t.height,t.depth,r,p,t.data)):n.texImage3D(e.TEXTURE_3D,0,m,t.width,t.height,t.depth,0,r,p,t.data);else if(o.isFramebufferTexture){if(x){if(_)n.texStorage2D(e.TEXTURE_2D,E,m,t.width,t.height);else{let i=t.width,a=t.height;for(let t=0;t<E;t++)n.texImage2D(e.TEXTURE_2D,t,m,i,a,0,r,p,null),i>>=1,a>>=1}}}else if(o.isHTMLTexture){if(`texElementImage2D`in e){let n=e.canvas;if(n.hasAttribute(`layoutsubtree`)||n.setAttribute(`layoutsubtree`,`true`),t.parentNode!==n){n.appendChild(t),d.add(o),n.onpaint=e=>{let t=e.changedElements;for(let e of d)t.includes(e.image)&&(e.needsUpdate=!0)},n.requestPaint();return}if(e.texElementImage2D.length===3)e.texElementImage2D(e.TEXTURE_2D,e.RGBA8,t);else{let n=e.RGBA,r=e.RGBA,i=e.UNSIGNED_BYTE;e.texElementImage2D(e.TEXTURE_2D,0,n,r,i,t)}e.texParameteri(e.TEXTURE_2D,e.TEXTURE_MIN_FILTER,e.LINEAR),e.texParameteri(e.TEXTURE_2D,e.TEXTURE_WRAP_S,e.CLAMP_TO_EDGE),e.texParameteri(e.TEXTURE_2D,e.TEXTURE_WRAP_T,e.CLAMP_TO_EDGE)}}else if(g.length>0){if(_&&x){let t=Se(g[0]);n.texStorage2D(e.TEXTURE_2D,E,m,t.width,t.height)}for(let t=0,i=g.length;t<i;t++)h=g[t],_?T&&n.texSubImage2D(e.TEXTURE_2D,t,0,0,r,p,h):n.texImage2D(e.TEXTURE_2D,t,m,r,p,h);o.generateMipmaps=!1}else if(_){if(x){let r=Se(t);n.texStorage2D(e.TEXTURE_2D,E,m,r.width,r.height)}T&&n.texSubImage2D(e.TEXTURE_2D,0,0,0,r,p,t)}else n.texImage2D(e.TEXTURE_2D,0,m,r,p,t);y(o)&&o.mipmapsAutoUpdate===!0&&b(c),f.__version=u.version,o.onUpdate&&o.onUpdate(o)}t.__version=o.version}function pe(t,o,s){if(o.image.length!==6)return;let c=R(t,o),l=o.source;n.bindTexture(e.TEXTURE_CUBE_MAP,t.__webglTexture,e.TEXTURE0+s);let u=r.get(l);if(l.version!==u.__version||c===!0){n.activeTexture(e.TEXTURE0+s);let t=J.getPrimaries(J.workingColorSpace),r=o.colorSpace===``?null:J.getPrimaries(o.colorSpace),d=o.colorSpace===``||t===r?e.NONE:e.BROWSER_DEFAULT_WEBGL;n.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,o.flipY),n.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,o.premultiplyAlpha),n.pixelStorei(e.UNPACK_ALIGNMENT,o.unpackAlignment),n.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,d);let f=o.isCompressedTexture||o.image[0].isCompressedTexture,p=o.image[0]&&o.image[0].isDataTexture,m=[];for(let e=0;e<6;e++)!f&&!p?m[e]=v(o.image[e],!0,i.maxCubemapSize):m[e]=p?o.image[e].image:o.image[e],m[e]=G(o,m[e]);let h=m[0],g=a.convert(o.format,o.colorSpace),_=a.convert(o.type),x=S(o.internalFormat,g,_,o.normalized,o.colorSpace),T=o.isVideoTexture!==!0,E=u.__version===void 0||c===!0,D=l.dataReady,O=w(o,h);ue(e.TEXTURE_CUBE_MAP,o);let k;if(o.isDepthTexture){if(x=C(o.format===Ie,o.type),E){if(T)n.texStorage2D(e.TEXTURE_CUBE_MAP,1,x,h.width,h.height);else for(let t=0;t<6;t++)n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,x,h.width,h.height,0,g,_,null)}}else if(f){T&&E&&n.texStorage2D(e.TEXTURE_CUBE_MAP,O,x,h.width,h.height);for(let t=0;t<6;t++){k=m[t].mipmaps;for(let r=0;r<k.length;r++){let i=k[r];o.format===1023?T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,0,0,i.width,i.height,g,_,i.data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,x,i.width,i.height,0,g,_,i.data):g===null?Y(`WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()`):T?D&&n.compressedTexSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,0,0,i.width,i.height,g,i.data):n.compressedTexImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,x,i.width,i.height,0,i.data)}}}else{if(k=o.mipmaps,T&&E){k.length>0&&O++;let t=Se(m[0]);n.texStorage2D(e.TEXTURE_CUBE_MAP,O,x,t.width,t.height)}for(let t=0;t<6;t++)if(p){T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,0,0,m[t].width,m[t].height,g,_,m[t].data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,x,m[t].width,m[t].height,0,g,_,m[t].data);for(let r=0;r<k.length;r++){let i=k[r].image[t].image;T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,0,0,i.width,i.height,g,_,i.data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,x,i.width,i.height,0,g,_,i.data)}}else{T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,0,0,g,_,m[t]):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,x,g,_,m[t]);for(let r=0;r<k.length;r++){let i=k[r];T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,0,0,g,_,i.image[t]):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,x,g,_,i.image[t])}}}y(o)&&o.mipmapsAutoUpdate===!0&&b(e.TEXTURE_CUBE_MAP),u.__version=l.version,o.onUpdate&&o.onUpdate(o)}t.__version=o.version}function me(t,i,o,c,l,u){let d=a.convert(o.format,o.colorSpace),f=a.convert(o.type),p=S(o.internalFormat,d,f,o.normalized,o.colorSpace),m=r.get(i),h=r.get(o);if(h.__renderTarget=i,!m.__hasExternalTextures){let t=Math.max(1,i.width>>u),r=Math.max(1,i.height>>u);l===e.TEXTURE_3D||l===e.TEXTURE_2D_ARRAY?n.texImage3D(l,u,p,t,r,i.depth,0,d,f,null):n.texImage2D(l,u,p,t,r,0,d,f,null)}n.bindFramebuffer(e.FRAMEBUFFER,t),U(i)?s.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,c,l,h.__webglTexture,0,H(i)):(l===e.TEXTURE_2D||l>=e.TEXTURE_CUBE_MAP_POSITIVE_X&&l<=e.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&e.framebufferTexture2D(e.FRAMEBUFFER,c,l,h.__webglTexture,u),n.bindFramebuffer(e.FRAMEBUFFER,null)}function he(t,n,r){if(e.bindRenderbuffer(e.RENDERBUFFER,t),n.depthBuffer){let i=n.depthTexture,a=i&&i.isDepthTexture?i.type:null,o=C(n.stencilBuffer,a),c=n.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;U(n)?s.renderbufferStorageMultisampleEXT(e.RENDERBUFFER,H(n),o,n.width,n.height):r?e.renderbufferStorageMultisample(e.RENDERBUFFER,H(n),o,n.width,n.height):e.renderbufferStorage(e.RENDERBUFFER,o,n.width,n.height),e.framebufferRenderbuffer(e.FRAMEBUFFER,c,e.RENDERBUFFER,t)}else{let t=n.textures;for(let i=0;i<t.length;i++){let o=t[i],c=a.convert(o.format,o.colorSpace),l=a.convert(o.type),u=S(o.internalFormat,c,l,o.normalized,o.colorSpace);U(n)?s.renderbufferStorageMultisampleEXT(e.RENDERBUFFER,H(n),u,n.width,n.height):r?e.renderbufferStorageMultisample(e.RENDERBUFFER,H(n),u,n.width,n.height):e.renderbufferStorage(e.RENDERBUFFER,u,n.width,n.height)}}e.bindRenderbuffer(e.RENDERBUFFER,null)}function ge(t,i,a){let o=i.isWebGLCubeRenderTarget===!0;if(n.bindFramebuffer(e.FRAMEBUFFER,t),!(i.depthTexture&&i.depthTexture.isDepthTexture))throw Error(`THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.`);let c=r.get(i.depthTexture);c.__renderTarget=i;let l=o?i.depthTexture.image[0]:i.depthTexture.image;c.__webglTexture&&l.width===i.width&&l.height===i.height||(l.width=i.width,l.height=i.height,i.depthTexture.needsUpdate=!0),o?se(i.depthTexture,0):F(i.depthTexture,0);let u=c.__webglTexture,d=H(i),f=o?e.TEXTURE_CUBE_MAP_POSITIVE_X+a:e.TEXTURE_2D,p=i.depthTexture.format===1027?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;if(i.depthTexture.format===1026)U(i)?s.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,p,f,u,0,d):e.framebufferTexture2D(e.FRAMEBUFFER,p,f,u,0);else if(i.depthTexture.format===1027)U(i)?s.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,p,f,u,0,d):e.framebufferTexture2D(e.FRAMEBUFFER,p,f,u,0);else throw Error(`THREE.WebGLTextures: Unknown depthTexture format.`)}function _e(t){let i=r.get(t),a=t.isWebGLCubeRenderTarget===!0;if(i.__boundDepthTexture!==t.depthTexture){let e=t.depthTexture;if(i.__depthDisposeCallback&&i.__depthDisposeCallback(),e){let t=()=>{delete i.__boundDepthTexture,delete i.__depthDisposeCallback,e.removeEventListener(`dispose`,t)};e.addEventListener(`dispose`,t),i.__depthDisposeCallback=t}i.__boundDepthTexture=e}if(t.depthTexture&&!i.__autoAllocateDepthBuffer){if(a)for(let e=0;e<6;e++)ge(i.__webglFramebuffer[e],t,e);else t.texture.mipmaps.length>0?ge(i.__webglFramebuffer[0],t,0):ge(i.__webglFramebuffer,t,0)}else if(a){i.__webglDepthbuffer=[];for(let r=0;r<6;r++)if(n.bindFramebuffer(e.FRAMEBUFFER,i.__webglFramebuffer[r]),i.__webglDepthbuffer[r]===void 0)i.__webglDepthbuffer[r]=e.createRenderbuffer(),he(i.__webglDepthbuffer[r],t,!1);else{let n=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,a=i.__webglDepthbuffer[r];e.bindRenderbuffer(e.RENDERBUFFER,a),e.framebufferRenderbuffer(e.FRAMEBUFFER,n,e.RENDERBUFFER,a)}}else if(t.texture.mipmaps.length>0?n.bindFramebuffer(e.FRAMEBUFFER,i.__webglFramebuffer[0]):n.bindFramebuffer(e.FRAMEBUFFER,i.__webglFramebuffer),i.__webglDepthbuffer===void 0)i.__webglDepthbuffer=e.createRenderbuffer(),he(i.__webglDepthbuffer,t,!1);else{let n=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,r=i.__webglDepthbuffer;e.bindRenderbuffer(e.RENDERBUFFER,r),e.framebufferRenderbuffer(e.FRAMEBUFFER,n,e.RENDERBUFFER,r)}n.bindFramebuffer(e.FRAMEBUFFER,null)}function ve(t,n,i){let a=r.get(t);n!==void 0&&me(a.__webglFramebuffer,t,t.texture,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,0),i!==void 0&&_e(t)}function B(t){let i=t.texture,s=r.get(t),c=r.get(i);t.addEventListener(`dispose`,O),T(t);let l=t.textures,u=t.isWebGLCubeRenderTarget===!0,d=l.length>1;if(d||(c.__webglTexture===void 0&&(c.__webglTexture=e.createTexture()),c.__version=i.version,o.memory.textures++),u){s.__webglFramebuffer=[];for(let t=0;t<6;t++)if(i.mipmaps.length>0){s.__webglFramebuffer[t]=[];for(let n=0;n<i.mipmaps.length;n++)s.__webglFramebuffer[t][n]=e.createFramebuffer()}else s.__webglFramebuffer[t]=e.createFramebuffer()}else{if(i.mipmaps.length>0){s.__webglFramebuffer=[];for(let t=0;t<i.mipmaps.length;t++)s.__webglFramebuffer[t]=e.createFramebuffer()}else s.__webglFramebuffer=e.createFramebuffer();if(d)for(let t=0,n=l.length;t<n;t++){let n=r.get(l[t]);n.__webglTexture===void 0&&(n.__webglTexture=e.createTexture(),o.memory.textures++)}if(t.samples>0&&U(t)===!1){s.__webglMultisampledFramebuffer=e.createFramebuffer(),s.__webglColorRenderbuffer=[],n.bindFramebuffer(e.FRAMEBUFFER,s.__webglMultisampledFramebuffer);for(let n=0;n<l.length;n++){let r=l[n];s.__webglColorRenderbuffer[n]=e.createRenderbuffer(),e.bindRenderbuffer(e.RENDERBUFFER,s.__webglColorRenderbuffer[n]);let i=a.convert(r.format,r.colorSpace),o=a.convert(r.type),c=S(r.internalFormat,i,o,r.normalized,r.colorSpace,t.isXRRenderTarget===!0),u=H(t);e.renderbufferStorageMultisample(e.RENDERBUFFER,u,c,t.width,t.height),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+n,e.RENDERBUFFER,s.__webglColorRenderbuffer[n])}e.bindRenderbuffer(e.RENDERBUFFER,null),t.depthBuffer&&(s.__webglDepthRenderbuffer=e.createRenderbuffer(),he(s.__webglDepthRenderbuffer,t,!0)),n.bindFramebuffer(e.FRAMEBUFFER,null)}}if(u){n.bindTexture(e.TEXTURE_CUBE_MAP,c.__webglTexture),ue(e.TEXTURE_CUBE_MAP,i);for(let n=0;n<6;n++)if(i.mipmaps.length>0)for(let r=0;r<i.mipmaps.length;r++)me(s.__webglFramebuffer[n][r],t,i,e.COLOR_ATTACHMENT0,e.TEXTURE_CUBE_MAP_POSITIVE_X+n,r);else me(s.__webglFramebuffer[n],t,i,e.COLOR_ATTACHMENT0,e.TEXTURE_CUBE_MAP_POSITIVE_X+n,0);y(i)?b(e.TEXTURE_CUBE_MAP):i.mipmaps.length>0&&e.texParameteri(e.TEXTURE_CUBE_MAP,e.TEXTURE_MAX_LEVEL,i.mipmaps.length-1),n.unbindTexture()}else if(d){for(let i=0,a=l.length;i<a;i++){let a=l[i],o=r.get(a),c=e.TEXTURE_2D;(t.isWebGL3DRenderTarget||t.isWebGLArrayRenderTarget)&&(c=t.isWebGL3DRenderTarget?e.TEXTURE_3D:e.TEXTURE_2D_ARRAY),n.bindTexture(c,o.__webglTexture),ue(c,a),me(s.__webglFramebuffer,t,a,e.COLOR_ATTACHMENT0+i,c,0),y(a)&&b(c)}n.unbindTexture()}else{let r=e.TEXTURE_2D;if((t.isWebGL3DRenderTarget||t.isWebGLArrayRenderTarget)&&(r=t.isWebGL3DRenderTarget?e.TEXTURE_3D:e.TEXTURE_2D_ARRAY),n.bindTexture(r,c.__webglTexture),ue(r,i),i.mipmaps.length>0)for(let n=0;n<i.mipmaps.length;n++)me(s.__webglFramebuffer[n],t,i,e.COLOR_ATTACHMENT0,r,n);else me(s.__webglFramebuffer,t,i,e.COLOR_ATTACHMENT0,r,0);y(i)?b(r):i.mipmaps.length>0&&e.texParameteri(r,e.TEXTURE_MAX_LEVEL,i.mipmaps.length-1),n.unbindTexture()}t.depthBuffer&&_e(t)}function ye(e){let t=e.textures;for(let i=0,a=t.length;i<a;i++){let a=t[i];if(y(a)&&a.mipmapsAutoUpdate===!0){let t=x(e),i=r.get(a).__webglTexture;n.bindTexture(t,i),b(t),n.unbindTexture()}}}let be=[];function xe(t){if(t.samples>0){if(U(t)===!1){let i=t.textures,a=t.width,o=t.height,s=e.COLOR_BUFFER_BIT,l=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,u=r.get(t),d=i.length>1;if(d)for(let t=0;t<i.length;t++)n.bindFramebuffer(e.FRAMEBUFFER,u.__webglMultisampledFramebuffer),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.RENDERBUFFER,null),n.bindFramebuffer(e.FRAMEBUFFER,u.__webglFramebuffer),e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.TEXTURE_2D,null,0);n.bindFramebuffer(e.READ_FRAMEBUFFER,u.__webglMultisampledFramebuffer),t.texture.mipmaps.length>0?n.bindFramebuffer(e.DRAW_FRAMEBUFFER,u.__webglFramebuffer[0]):n.bindFramebuffer(e.DRAW_FRAMEBUFFER,u.__webglFramebuffer);for(let n=0;n<i.length;n++){if(t.resolveDepthBuffer&&(t.depthBuffer&&(s|=e.DEPTH_BUFFER_BIT),t.stencilBuffer&&t.resolveStencilBuffer&&(s|=e.STENCIL_BUFFER_BIT)),d){e.framebufferRenderbuffer(e.READ_FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.RENDERBUFFER,u.__webglColorRenderbuffer[n]);let t=r.get(i[n]).__webglTexture;e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,t,0)}e.blitFramebuffer(0,0,a,o,0,0,a,o,s,e.NEAREST),c===!0&&(be.length=0,be.push(e.COLOR_ATTACHMENT0+n),t.depthBuffer&&t.storeMultisampledDepthBuffer===!1&&be.push(l),e.invalidateFramebuffer(e.READ_FRAMEBUFFER,be))}if(n.bindFramebuffer(e.READ_FRAMEBUFFER,null),n.bindFramebuffer(e.DRAW_FRAMEBUFFER,null),d)for(let t=0;t<i.length;t++){n.bindFramebuffer(e.FRAMEBUFFER,u.__webglMultisampledFramebuffer),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.RENDERBUFFER,u.__webglColorRenderbuffer[t]);let a=r.get(i[t]).__webglTexture;n.bindFramebuffer(e.FRAMEBUFFER,u.__webglFramebuffer),e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.TEXTURE_2D,a,0)}n.bindFramebuffer(e.DRAW_FRAMEBUFFER,u.__webglMultisampledFramebuffer)}else if(t.depthBuffer&&t.storeMultisampledDepthBuffer===!1&&c){let n=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;e.invalidateFramebuffer(e.DRAW_FRAMEBUFFER,[n])}}}function H(e){return Math.min(i.maxSamples,e.samples)}function U(e){let n=r.get(e);return e.samples>0&&t.has(`WEBGL_multisampled_render_to_texture`)===!0&&n.__useRenderToTexture!==!1}function W(e){let t=o.render.frame;u.get(e)!==t&&(u.set(e,t),e.update())}function G(e,t){let n=e.colorSpace,r=e.format,i=e.type;return e.isCompressedTexture===!0||e.isVideoTexture===!0||n!==`srgb-linear`&&n!==``&&(J.getTransfer(n)===`srgb`?(r!==1023||i!==1009)&&Y(`WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType.`):Z(`WebGLTextures: Unsupported texture color space:`,n)),t}function Se(e){return typeof HTMLImageElement<`u`&&e instanceof HTMLImageElement?(l.width=e.naturalWidth||e.width,l.height=e.naturalHeight||e.height):typeof VideoFrame<`u`&&e instanceof VideoFrame?(l.width=e.displayWidth,l.height=e.displayHeight):(l.width=e.width,l.height=e.height),l}this.allocateTextureUnit=ie,this.resetTextureUnits=P,this.getTextureUnits=ne,this.setTextureUnits=re,this.setTexture2D=F,this.setTexture2DArray=oe,this.setTexture3D=I,this.setTextureCube=se,this.rebindTextures=ve,this.setupRenderTarget=B,this.updateRenderTargetMipmap=ye,this.updateMultisampleRenderTarget=xe,this.setupDepthRenderbuffer=_e,this.setupFrameBufferTexture=me,this.useMultisampledRTT=U,this.dispose=j}function zo(e,t){function n(n,r=``){let i,a=J.getTransfer(r);if(n===1009)return e.UNSIGNED_BYTE;if(n===1017)return e.UNSIGNED_SHORT_4_4_4_4;if(n===1018)return e.UNSIGNED_SHORT_5_5_5_1;if(n===35902)return e.UNSIGNED_INT_5_9_9_9_REV;if(n===35899)return e.UNSIGNED_INT_10F_11F_11F_REV;if(n===1010)return e.BYTE;if(n===1011)return e.SHORT;if(n===1012)return e.UNSIGNED_SHORT;if(n===1013)return e.INT;if(n===1014)return e.UNSIGNED_INT;if(n===1015)return e.FLOAT;if(n===1016)return e.HALF_FLOAT;if(n===1021)return e.ALPHA;if(n===1022)return e.RGB;if(n===1023)return e.RGBA;if(n===1026)return e.DEPTH_COMPONENT;if(n===1027)return e.DEPTH_STENCIL;if(n===1028)return e.RED;if(n===1029)return e.RED_INTEGER;if(n===1030)return e.RG;if(n===1031)return e.RG_INTEGER;if(n===1033)return e.RGBA_INTEGER;if(n===33776||n===33777||n===33778||n===33779){if(a===`srgb`){if(i=t.get(`WEBGL_compressed_texture_s3tc_srgb`),i!==null){if(n===33776)return i.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===33777)return i.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===33778)return i.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===33779)return i.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null}else if(i=t.get(`WEBGL_compressed_texture_s3tc`),i!==null){if(n===33776)return i.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===33777)return i.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===33778)return i.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===33779)return i.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null}if(n===35840||n===35841||n===35842||n===35843){if(i=t.get(`WEBGL_compressed_texture_pvrtc`),i!==null){if(n===35840)return i.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===35841)return i.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===35842)return i.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===35843)return i.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null}if(n===36196||n===37492||n===37496||n===37488||n===37489||n===37490||n===37491){if(i=t.get(`WEBGL_compressed_texture_etc`),i!==null){if(n===36196||n===37492)return a===`srgb`?i.COMPRESSED_SRGB8_ETC2:i.COMPRESSED_RGB8_ETC2;if(n===37496)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:i.COMPRESSED_RGBA8_ETC2_EAC;if(n===37488)return i.COMPRESSED_R11_EAC;if(n===37489)return i.COMPRESSED_SIGNED_R11_EAC;if(n===37490)return i.COMPRESSED_RG11_EAC;if(n===37491)return i.COMPRESSED_SIGNED_RG11_EAC}else return null}if(n===37808||n===37809||n===37810||n===37811||n===37812||n===37813||n===37814||n===37815||n===37816||n===37817||n===37818||n===37819||n===37820||n===37821){if(i=t.get(`WEBGL_compressed_texture_astc`),i!==null){if(n===37808)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:i.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===37809)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:i.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===37810)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:i.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===37811)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:i.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===37812)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:i.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===37813)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:i.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===37814)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:i.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===37815)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:i.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===37816)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:i.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===37817)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:i.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===37818)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:i.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===37819)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:i.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===37820)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:i.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===37821)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:i.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null}if(n===36492||n===36494||n===36495){if(i=t.get(`EXT_texture_compression_bptc`),i!==null){if(n===36492)return a===`srgb`?i.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:i.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===36494)return i.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===36495)return i.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null}if(n===36283||n===36284||n===36285||n===36286){if(i=t.get(`EXT_texture_compression_rgtc`),i!==null){if(n===36283)return i.COMPRESSED_RED_RGTC1_EXT;if(n===36284)return i.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===36285)return i.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===36286)return i.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null}return n===1020?e.UNSIGNED_INT_24_8:e[n]===void 0?null:e[n]}return{convert:n}}var Bo=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Vo=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Ho=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new G(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ze({vertexShader:Bo,fragmentShader:Vo,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Et(new Vt(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Uo=class extends Re{constructor(e,t){super();let n=this,r=null,i=1,a=null,o=`local-floor`,s=1,c=null,l=null,u=null,d=null,f=null,p=null,m=typeof XRWebGLBinding<`u`,h=new Ho,g={},_=t.getContextAttributes(),v=null,y=null,b=[],x=[],S=new kt,C=null,w=null,T=new Ut;T.viewport=new Ke;let E=new Ut;E.viewport=new Ke;let D=[T,E],O=new At,k=null,A=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(e){let t=b[e];return t===void 0&&(t=new be,b[e]=t),t.getTargetRaySpace()},this.getControllerGrip=function(e){let t=b[e];return t===void 0&&(t=new be,b[e]=t),t.getGripSpace()},this.getHand=function(e){let t=b[e];return t===void 0&&(t=new be,b[e]=t),t.getHandSpace()};function j(e){let t=x.indexOf(e.inputSource);if(t===-1)return;let n=b[t];n!==void 0&&(n.update(e.inputSource,e.frame,c||a),n.dispatchEvent({type:e.type,data:e.inputSource}))}function ee(){r.removeEventListener(`select`,j),r.removeEventListener(`selectstart`,j),r.removeEventListener(`selectend`,j),r.removeEventListener(`squeeze`,j),r.removeEventListener(`squeezestart`,j),r.removeEventListener(`squeezeend`,j),r.removeEventListener(`end`,ee),r.removeEventListener(`inputsourceschange`,M);for(let e=0;e<b.length;e++){let t=x[e];t!==null&&(x[e]=null,b[e].disconnect(t))}k=null,A=null,h.reset();for(let e in g)delete g[e];if(e.setRenderTarget(v),f=null,d=null,u=null,r=null,y=null,re.stop(),n.isPresenting=!1,e.setPixelRatio(C),e.setSize(S.width,S.height,!1),w!==null){let e=w.camera;e.fov=w.fov,e.zoom=w.zoom,e.updateProjectionMatrix(),w=null}n.dispatchEvent({type:`sessionend`})}this.setFramebufferScaleFactor=function(e){i=e,n.isPresenting===!0&&Y(`WebXRManager: Cannot change framebuffer scale while presenting.`)},this.setReferenceSpaceType=function(e){o=e,n.isPresenting===!0&&Y(`WebXRManager: Cannot change reference space type while presenting.`)},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(e){c=e},this.getBaseLayer=function(){return d===null?f:d},this.getBinding=function(){return u===null&&m&&(u=new XRWebGLBinding(r,t)),u},this.getFrame=function(){return p},this.getSession=function(){return r},this.setSession=async function(l){if(r=l,r!==null){if(v=e.getRenderTarget(),r.addEventListener(`select`,j),r.addEventListener(`selectstart`,j),r.addEventListener(`selectend`,j),r.addEventListener(`squeeze`,j),r.addEventListener(`squeezestart`,j),r.addEventListener(`squeezeend`,j),r.addEventListener(`end`,ee),r.addEventListener(`inputsourceschange`,M),_.xrCompatible!==!0&&await t.makeXRCompatible(),C=e.getPixelRatio(),e.getSize(S),m&&`createProjectionLayer`in XRWebGLBinding.prototype){let n=null,a=null,o=null;_.depth&&(o=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,n=_.stencil?Ie:Bt,a=_.stencil?Ve:Be);let s={colorFormat:t.RGBA8,depthFormat:o,scaleFactor:i};u=this.getBinding(),d=u.createProjectionLayer(s),r.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),y=new Pe(d.textureWidth,d.textureHeight,{format:ke,type:Wt,depthTexture:new U(d.textureWidth,d.textureHeight,a,void 0,void 0,void 0,void 0,void 0,void 0,n),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let n={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:i};f=new XRWebGLLayer(r,t,n),r.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),y=new Pe(f.framebufferWidth,f.framebufferHeight,{format:ke,type:Wt,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(s),c=null,a=await r.requestReferenceSpace(o),re.setContext(r),re.start(),n.isPresenting=!0,n.dispatchEvent({type:`sessionstart`})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return h.getDepthTexture()};function M(e){for(let t=0;t<e.removed.length;t++){let n=e.removed[t],r=x.indexOf(n);r>=0&&(x[r]=null,b[r].disconnect(n))}for(let t=0;t<e.added.length;t++){let n=e.added[t],r=x.indexOf(n);if(r===-1){for(let e=0;e<b.length;e++)if(e>=x.length){x.push(n),r=e;break}else if(x[e]===null){x[e]=n,r=e;break}if(r===-1)break}let i=b[r];i&&i.connect(n)}}function te(e,t){t===null?e.matrixWorld.copy(e.matrix):e.matrixWorld.multiplyMatrices(t.matrixWorld,e.matrix),e.matrixWorldInverse.copy(e.matrixWorld).invert()}this.updateCamera=function(e){if(r===null)return;let t=e.near,n=e.far;h.texture!==null&&(h.depthNear>0&&(t=h.depthNear),h.depthFar>0&&(n=h.depthFar)),O.near=E.near=T.near=t,O.far=E.far=T.far=n,(k!==O.near||A!==O.far)&&(r.updateRenderState({depthNear:O.near,depthFar:O.far}),k=O.near,A=O.far),O.layers.mask=e.layers.mask|6,T.layers.mask=O.layers.mask&-5,E.layers.mask=O.layers.mask&-3;let i=e.parent,a=O.cameras;te(O,i);for(let e=0;e<a.length;e++)te(a[e],i);O.projectionMatrix.copy(T.projectionMatrix),O.projectionMatrixInverse.copy(T.projectionMatrixInverse),w===null&&e.isPerspectiveCamera&&(w={camera:e,fov:e.fov,zoom:e.zoom}),N(e,O,i)};function N(e,t,n){n===null?e.matrix.copy(t.matrixWorld):(e.matrix.copy(n.matrixWorld),e.matrix.invert(),e.matrix.multiply(t.matrixWorld)),e.matrix.decompose(e.position,e.quaternion,e.scale),e.updateMatrixWorld(!0),e.projectionMatrix.copy(t.projectionMatrix),e.projectionMatrixInverse.copy(t.projectionMatrixInverse),e.isPerspectiveCamera&&(e.fov=_t*2*Math.atan(1/e.projectionMatrix.elements[5]),e.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(d!==null||f!==null)return s},this.setFoveation=function(e){s=e,d!==null&&(d.fixedFoveation=e),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=e)},this.hasDepthSensing=function(){return h.texture!==null},this.getDepthSensingMesh=function(){return h.getMesh(O)},this.getCameraTexture=function(e){return g[e]};let P=null;function ne(t,i){if(l=i.getViewerPose(c||a),p=i,l!==null){let t=l.views;f!==null&&(e.setRenderTargetFramebuffer(y,f.framebuffer),e.setRenderTarget(y));let i=!1;t.length!==O.cameras.length&&(O.cameras.length=0,i=!0);for(let n=0;n<t.length;n++){let r=t[n],a=null;if(f!==null)a=f.getViewport(r);else{let t=u.getViewSubImage(d,r);a=t.viewport,n===0&&(e.setRenderTargetTextures(y,t.colorTexture,t.depthStencilTexture),e.setRenderTarget(y))}let o=D[n];o===void 0&&(o=new Ut,o.layers.enable(n),o.viewport=new Ke,D[n]=o),o.matrix.fromArray(r.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.projectionMatrix.fromArray(r.projectionMatrix),o.projectionMatrixInverse.copy(o.projectionMatrix).invert(),o.viewport.set(a.x,a.y,a.width,a.height),n===0&&(O.matrix.copy(o.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),i===!0&&O.cameras.push(o)}let a=r.enabledFeatures;if(a&&a.includes(`depth-sensing`)&&r.depthUsage==`gpu-optimized`&&m){u=n.getBinding();let e=u.getDepthInformation(t[0]);e&&e.isValid&&e.texture&&h.init(e,r.renderState)}if(a&&a.includes(`camera-access`)&&m){e.state.unbindTexture(),u=n.getBinding();for(let e=0;e<t.length;e++){let n=t[e].camera;if(n){let e=g[n];e||(e=new G,g[n]=e);let t=u.getCameraImage(n);e.sourceTexture=t}}}}for(let e=0;e<b.length;e++){let t=x[e],n=b[e];t!==null&&n!==void 0&&n.update(t,i,c||a)}P&&P(t,i),i.detectedPlanes&&n.dispatchEvent({type:`planesdetected`,data:i}),p=null}let re=new Vr;re.setAnimationLoop(ne),this.setAnimationLoop=function(e){P=e},this.dispose=function(){}}},Wo=new Qe,Go=new X;Go.set(-1,0,0,0,1,0,0,0,1);function Ko(e,t){function n(e,t){e.matrixAutoUpdate===!0&&e.updateMatrix(),t.value.copy(e.matrix)}function r(t,n){n.color.getRGB(t.fogColor.value,Mt(e)),n.isFog?(t.fogNear.value=n.near,t.fogFar.value=n.far):n.isFogExp2&&(t.fogDensity.value=n.density)}function i(e,t,n,r,i){t.isNodeMaterial?t.uniformsNeedUpdate=!1:t.isMeshBasicMaterial?a(e,t):t.isMeshLambertMaterial?(a(e,t),t.envMap&&(e.envMapIntensity.value=t.envMapIntensity)):t.isMeshToonMaterial?(a(e,t),d(e,t)):t.isMeshPhongMaterial?(a(e,t),u(e,t),t.envMap&&(e.envMapIntensity.value=t.envMapIntensity)):t.isMeshStandardMaterial?(a(e,t),f(e,t),t.isMeshPhysicalMaterial&&p(e,t,i)):t.isMeshMatcapMaterial?(a(e,t),m(e,t)):t.isMeshDepthMaterial?a(e,t):t.isMeshDistanceMaterial?(a(e,t),h(e,t)):t.isMeshNormalMaterial?a(e,t):t.isLineBasicMaterial?(o(e,t),t.isLineDashedMaterial&&s(e,t)):t.isPointsMaterial?c(e,t,n,r):t.isSpriteMaterial?l(e,t):t.isShadowMaterial?(e.color.value.copy(t.color),e.opacity.value=t.opacity):t.isShaderMaterial&&(t.uniformsNeedUpdate=!1)}function a(e,r){e.opacity.value=r.opacity,r.color&&e.diffuse.value.copy(r.color),r.emissive&&e.emissive.value.copy(r.emissive).multiplyScalar(r.emissiveIntensity),r.map&&(e.map.value=r.map,n(r.map,e.mapTransform)),r.alphaMap&&(e.alphaMap.value=r.alphaMap,n(r.alphaMap,e.alphaMapTransform)),r.bumpMap&&(e.bumpMap.value=r.bumpMap,n(r.bumpMap,e.bumpMapTransform),e.bumpScale.value=r.bumpScale,r.side===1&&(e.bumpScale.value*=-1)),r.normalMap&&(e.normalMap.value=r.normalMap,n(r.normalMap,e.normalMapTransform),e.normalScale.value.copy(r.normalScale),r.side===1&&e.normalScale.value.negate()),r.displacementMap&&(e.displacementMap.value=r.displacementMap,n(r.displacementMap,e.displacementMapTransform),e.displacementScale.value=r.displacementScale,e.displacementBias.value=r.displacementBias),r.emissiveMap&&(e.emissiveMap.value=r.emissiveMap,n(r.emissiveMap,e.emissiveMapTransform)),r.specularMap&&(e.specularMap.value=r.specularMap,n(r.specularMap,e.specularMapTransform)),r.alphaTest>0&&(e.alphaTest.value=r.alphaTest);let i=t.get(r),a=i.envMap,o=i.envMapRotation;a&&(e.envMap.value=a,e.envMapRotation.value.setFromMatrix4(Wo.makeRotationFromEuler(o)).transpose(),a.isCubeTexture&&a.isRenderTargetTexture===!1&&e.envMapRotation.value.premultiply(Go),e.reflectivity.value=r.reflectivity,e.ior.value=r.ior,e.refractionRatio.value=r.refractionRatio),r.lightMap&&(e.lightMap.value=r.lightMap,e.lightMapIntensity.value=r.lightMapIntensity,n(r.lightMap,e.lightMapTransform)),r.aoMap&&(e.aoMap.value=r.aoMap,e.aoMapIntensity.value=r.aoMapIntensity,n(r.aoMap,e.aoMapTransform))}function o(e,t){e.diffuse.value.copy(t.color),e.opacity.value=t.opacity,t.map&&(e.map.value=t.map,n(t.map,e.mapTransform))}function s(e,t){e.dashSize.value=t.dashSize,e.totalSize.value=t.dashSize+t.gapSize,e.scale.value=t.scale}function c(e,t,r,i){e.diffuse.value.copy(t.color),e.opacity.value=t.opacity,e.size.value=t.size*r,e.scale.value=i*.5,t.map&&(e.map.value=t.map,n(t.map,e.uvTransform)),t.alphaMap&&(e.alphaMap.value=t.alphaMap,n(t.alphaMap,e.alphaMapTransform)),t.alphaTest>0&&(e.alphaTest.value=t.alphaTest)}function l(e,t){e.diffuse.value.copy(t.color),e.opacity.value=t.opacity,e.rotation.value=t.rotation,t.map&&(e.map.value=t.map,n(t.map,e.mapTransform)),t.alphaMap&&(e.alphaMap.value=t.alphaMap,n(t.alphaMap,e.alphaMapTransform)),t.alphaTest>0&&(e.alphaTest.value=t.alphaTest)}function u(e,t){e.specular.value.copy(t.specular),e.shininess.value=Math.max(t.shininess,1e-4)}function d(e,t){t.gradientMap&&(e.gradientMap.value=t.gradientMap)}function f(e,t){e.metalness.value=t.metalness,t.metalnessMap&&(e.metalnessMap.value=t.metalnessMap,n(t.metalnessMap,e.metalnessMapTransform)),e.roughness.value=t.roughness,t.roughnessMap&&(e.roughnessMap.value=t.roughnessMap,n(t.roughnessMap,e.roughnessMapTransform)),t.envMap&&(e.envMapIntensity.value=t.envMapIntensity)}function p(e,t,r){e.ior.value=t.ior,t.diffuseRoughness>0&&(e.diffuseRoughness.value=t.diffuseRoughness,t.diffuseRoughnessMap&&(e.diffuseRoughnessMap.value=t.diffuseRoughnessMap,n(t.diffuseRoughnessMap,e.diffuseRoughnessMapTransform))),t.sheen>0&&(e.sheenColor.value.copy(t.sheenColor).multiplyScalar(t.sheen),e.sheenRoughness.value=t.sheenRoughness,t.sheenColorMap&&(e.sheenColorMap.value=t.sheenColorMap,n(t.sheenColorMap,e.sheenColorMapTransform)),t.sheenRoughnessMap&&(e.sheenRoughnessMap.value=t.sheenRoughnessMap,n(t.sheenRoughnessMap,e.sheenRoughnessMapTransform))),t.clearcoat>0&&(e.clearcoat.value=t.clearcoat,e.clearcoatRoughness.value=t.clearcoatRoughness,t.clearcoatMap&&(e.clearcoatMap.value=t.clearcoatMap,n(t.clearcoatMap,e.clearcoatMapTransform)),t.clearcoatRoughnessMap&&(e.clearcoatRoughnessMap.value=t.clearcoatRoughnessMap,n(t.clearcoatRoughnessMap,e.clearcoatRoughnessMapTransform)),t.clearcoatNormalMap&&(e.clearcoatNormalMap.value=t.clearcoatNormalMap,n(t.clearcoatNormalMap,e.clearcoatNormalMapTransform),e.clearcoatNormalScale.value.copy(t.clearcoatNormalScale),t.side===1&&e.clearcoatNormalScale.value.negate())),t.dispersion>0&&(e.dispersion.value=t.dispersion),t.retroreflectivity>0&&(e.retroreflectivity.value=t.retroreflectivity),t.iridescence>0&&(e.iridescence.value=t.iridescence,e.iridescenceIOR.value=t.iridescenceIOR,e.iridescenceThicknessMinimum.value=t.iridescenceThicknessMinimum,e.iridescenceThicknessMaximum.value=t.iridescenceThicknessMaximum,t.iridescenceMap&&(e.iridescenceMap.value=t.iridescenceMap,n(t.iridescenceMap,e.iridescenceMapTransform)),t.iridescenceThicknessMap&&(e.iridescenceThicknessMap.value=t.iridescenceThicknessMap,n(t.iridescenceThicknessMap,e.iridescenceThicknessMapTransform))),t.transmission>0&&(e.transmission.value=t.transmission,e.transmissionSamplerMap.value=r.texture,e.transmissionSamplerSize.value.set(r.width,r.height),t.transmissionMap&&(e.transmissionMap.value=t.transmissionMap,n(t.transmissionMap,e.transmissionMapTransform)),e.thickness.value=t.thickness,t.thicknessMap&&(e.thicknessMap.value=t.thicknessMap,n(t.thicknessMap,e.thicknessMapTransform)),e.attenuationDistance.value=t.attenuationDistance,e.attenuationColor.value.copy(t.attenuationColor)),t.anisotropy>0&&(e.anisotropyVector.value.set(t.anisotropy*Math.cos(t.anisotropyRotation),t.anisotropy*Math.sin(t.anisotropyRotation)),t.anisotropyMap&&(e.anisotropyMap.value=t.anisotropyMap,n(t.anisotropyMap,e.anisotropyMapTransform))),e.specularIntensity.value=t.specularIntensity,e.specularColor.value.copy(t.specularColor),t.specularColorMap&&(e.specularColorMap.value=t.specularColorMap,n(t.specularColorMap,e.specularColorMapTransform)),t.specularIntensityMap&&(e.specularIntensityMap.value=t.specularIntensityMap,n(t.specularIntensityMap,e.specularIntensityMapTransform))}function m(e,t){t.matcap&&(e.matcap.value=t.matcap)}function h(e,n){let r=t.get(n).light;e.referencePosition.value.setFromMatrixPosition(r.matrixWorld),e.nearDistance.value=r.shadow.camera.near,e.farDistance.value=r.shadow.camera.far}return{refreshFogUniforms:r,refreshMaterialUniforms:i}}function qo(e,t,n,r){let i={},a={};function o(e,t){let n=t.program;r.uniformBlockBinding(e,n,i[e.id])}function s(e,n){let o=i[e.id];o===void 0&&(m(e),o=c(e),i[e.id]=o,e.addEventListener(`dispose`,g));let s=n.program;r.updateUBOMapping(e,s);let u=t.render.frame;a[e.id]!==u&&(l(e),a[e.id]=u)}function c(t){let n=e.createBuffer(),r=t.__size,i=t.usage;return e.bindBuffer(e.UNIFORM_BUFFER,n),e.bufferData(e.UNIFORM_BUFFER,r,i),e.bindBuffer(e.UNIFORM_BUFFER,null),n}function l(t){let n=i[t.id],r=t.uniforms,a=t.__cache;e.bindBuffer(e.UNIFORM_BUFFER,n);for(let e=0,t=r.length;e<t;e++){let t=r[e];if(Array.isArray(t))for(let n=0,r=t.length;n<r;n++)u(t[n],e,n,a);else u(t,e,0,a)}e.bindBuffer(e.UNIFORM_BUFFER,null)}function u(t,n,r,i){if(f(t,n,r,i)===!0){let n=t.__offset,r=t.value;if(Array.isArray(r)){let e=0;for(let n=0;n<r.length;n++){let i=r[n],a=h(i,!0);d(i,t.__data,e),e+=a.storage/Float32Array.BYTES_PER_ELEMENT}}else d(r,t.__data,0);e.bufferSubData(e.UNIFORM_BUFFER,n,t.__data)}}function d(e,t,n){typeof e==`number`||typeof e==`boolean`?t[n]=e:e.isMatrix3?(t[n]=e.elements[0],t[n+1]=e.elements[1],t[n+2]=e.elements[2],t[n+3]=0,t[n+4]=e.elements[3],t[n+5]=e.elements[4],t[n+6]=e.elements[5],t[n+7]=0,t[n+8]=e.elements[6],t[n+9]=e.elements[7],t[n+10]=e.elements[8],t[n+11]=0):ArrayBuffer.isView(e)?t.set(e.subarray(0,t.length-n),n):e.toArray(t,n)}function f(e,t,n,r){let i=e.value,a=t+`_`+n;if(Array.isArray(i)){r[a]===void 0&&(r[a]=[]);let e=r[a],t=!1;for(let n=0;n<i.length;n++)p(i[n],e,n)===!0&&(t=!0);return t}return p(i,r,a)}function p(e,t,n){if(t[n]===void 0)return t[n]=typeof e==`number`||typeof e==`boolean`?e:ArrayBuffer.isView(e)?e.slice():e.clone(),!0;{let r=t[n];if(typeof e==`number`||typeof e==`boolean`){if(r!==e)return t[n]=e,!0}else if(ArrayBuffer.isView(e))return!0;else if(r.equals(e)===!1)return r.copy(e),!0}return!1}function m(e){let t=e.uniforms,n=0;for(let e=0,r=t.length;e<r;e++){let r=Array.isArray(t[e])?t[e]:[t[e]];for(let i=0,a=r.length;i<a;i++){let a=r[i],o=Array.isArray(a.value)?a.value:[a.value],s=Array.isArray(t[e])||Array.isArray(a.value),c=n;for(let e=0,t=o.length;e<t;e++){let t=o[e],r=h(t,s),i=n%16,a=i%r.boundary,l=i+a;n+=a,l!==0&&16-l<r.storage&&(n+=16-l),e===0&&(c=n),n+=r.storage}a.__data=new(a.type===`int`?Int32Array:a.type===`uint`?Uint32Array:Float32Array)((n-c)/Float32Array.BYTES_PER_ELEMENT),a.__offset=c}}let r=n%16;return r>0&&(n+=16-r),e.__size=n,e.__cache={},this}function h(e,t){let n={boundary:0,storage:0};return typeof e==`number`||typeof e==`boolean`?(n.boundary=4,n.storage=4):e.isVector2?(n.boundary=8,n.storage=8):e.isVector3||e.isColor?(n.boundary=16,n.storage=12):e.isVector4?(n.boundary=16,n.storage=16):e.isMatrix3?(n.boundary=16,n.storage=48):e.isMatrix4?(n.boundary=16,n.storage=64):e.isTexture?Y(`WebGLRenderer: Texture samplers can not be part of an uniforms group.`):ArrayBuffer.isView(e)?(n.boundary=16,n.storage=e.byteLength):Y(`WebGLRenderer: Unsupported uniform value type.`,e),t===!0&&(n.boundary=16,n.storage=Math.ceil(n.storage/16)*16),n}function g(t){let n=t.target;n.removeEventListener(`dispose`,g),e.deleteBuffer(i[n.id]),delete i[n.id],delete a[n.id]}function _(){for(let t in i)e.deleteBuffer(i[t]);i={},a={}}return{bind:o,update:s,dispose:_}}var Jo=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Yo=null;function Xo(){return Yo===null&&(Yo=new $e(Jo,16,16,Ft,je),Yo.name=`DFG_LUT`,Yo.minFilter=Ge,Yo.magFilter=Ge,Yo.wrapS=Pt,Yo.wrapT=Pt,Yo.generateMipmaps=!1,Yo.needsUpdate=!0),Yo}var Zo=class{constructor(e={}){let{canvas:t=Nt(),context:n=null,depth:r=!0,stencil:i=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:s=!0,preserveDrawingBuffer:c=!1,powerPreference:l=`default`,failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Wt}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<`u`&&n instanceof WebGLRenderingContext)throw Error(`THREE.WebGLRenderer: WebGL 1 is not supported since r163.`);p=n.getContextAttributes().alpha}else p=a;let m=f,h=new Set([Me,it,ft]),g=new Set([Wt,Be,we,Ve,Ue,Se]),_=new Uint32Array(4),v=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},b=null,x=null,S=[],C=[],w=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=0,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let T=this,E=!1,D=null,O=null,k=null,A=null;this._outputColorSpace=Le;let j=0,ee=0,M=null,te=-1,N=null,P=new Ke,ne=new Ke,re=null,ie=new q(0),ae=0,F=t.width,oe=t.height,I=1,se=null,L=null,ce=new Ke(0,0,F,oe),le=new Ke(0,0,F,oe),ue=!1,R=new xe,z=new ht,de=!1,fe=!1,pe=new Qe,me=new K,he=new Ke,ge={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},_e=!1;function ve(){return M===null?I:1}let B=n;function ye(e,n){return t.getContext(e,n)}let V,be,H,U,W,G,Ce,Te,Ee,De,Oe,ke,Ae,Ne,Fe,Ie,Re,ze,He,Ge,qe,Ye,Xe;try{let e={alpha:!0,depth:r,stencil:i,antialias:o,premultipliedAlpha:s,preserveDrawingBuffer:c,powerPreference:l,failIfMajorPerformanceCaveat:u};if(`setAttribute`in t&&t.setAttribute(`data-engine`,`three.js r187`),t.addEventListener(`webglcontextlost`,et,!1),t.addEventListener(`webglcontextrestored`,tt,!1),t.addEventListener(`webglcontextcreationerror`,rt,!1),B===null){let t=`webgl2`;if(B=ye(t,e),B===null)throw ye(t)?Error(`THREE.WebGLRenderer: Error creating WebGL context with your selected attributes.`):Error(`THREE.WebGLRenderer: Error creating WebGL context.`)}Ze()}catch(e){throw t.removeEventListener(`webglcontextlost`,et,!1),t.removeEventListener(`webglcontextrestored`,tt,!1),t.removeEventListener(`webglcontextcreationerror`,rt,!1),Z(`WebGLRenderer: `+e.message),e}function Ze(){V=new gi(B),V.init(),qe=new zo(B,V),be=new Xr(B,V,e,qe),H=new Lo(B,V),be.reversedDepthBuffer&&d&&H.buffers.depth.setReversed(!0),O=B.createFramebuffer(),k=B.createFramebuffer(),A=B.createFramebuffer(),U=new yi(B),W=new _o,G=new Ro(B,V,H,W,be,qe,U),Ce=new hi(T),Te=new Hr(B),Ye=new Jr(B,Te),Ee=new _i(B,Te,U,Ye),De=new xi(B,Ee,Te,Ye,U),ze=new bi(B,be,G),Fe=new Zr(W),Oe=new go(T,Ce,V,be,Ye,Fe),ke=new Ko(T,W),Ae=new xo,Ne=new Oo(V),Re=new qr(T,Ce,H,De,p,s),Ie=new Io(T,De,be),Xe=new qo(B,U,be,H),He=new Yr(B,V,U),Ge=new vi(B,V,U),U.programs=Oe.programs,T.capabilities=be,T.extensions=V,T.properties=W,T.renderLists=Ae,T.shadowMap=Ie,T.state=H,T.info=U}m!==1009&&(w=new Ci(m,t.width,t.height,o,r,i));let $e=new Uo(T,B);this.xr=$e,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let e=V.get(`WEBGL_lose_context`);e&&e.loseContext()},this.forceContextRestore=function(){let e=V.get(`WEBGL_lose_context`);e&&e.restoreContext()},this.getPixelRatio=function(){return I},this.setPixelRatio=function(e){e!==void 0&&(I=e,this.setSize(F,oe,!1))},this.getSize=function(e){return e.set(F,oe)},this.setSize=function(e,n,r=!0){$e.isPresenting?Y(`WebGLRenderer: Can't change size while VR device is presenting.`):(F=e,oe=n,t.width=Math.floor(e*I),t.height=Math.floor(n*I),r===!0&&(t.style.width=e+`px`,t.style.height=n+`px`),w!==null&&w.setSize(t.width,t.height),this.setViewport(0,0,e,n))},this.getDrawingBufferSize=function(e){return e.set(F*I,oe*I).floor()},this.setDrawingBufferSize=function(e,n,r){F=e,oe=n,I=r,t.width=Math.floor(e*r),t.height=Math.floor(n*r),this.setViewport(0,0,e,n)},this.setEffects=function(e){if(m===1009)Z(`WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.`);else{if(e){for(let t=0;t<e.length;t++)if(e[t].isOutputPass===!0){Y(`WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.`);break}}w.setEffects(e||[])}},this.getCurrentViewport=function(e){return e.copy(P)},this.getViewport=function(e){return e.copy(ce)},this.setViewport=function(e,t,n,r){e.isVector4?ce.set(e.x,e.y,e.z,e.w):ce.set(e,t,n,r),H.viewport(P.copy(ce).multiplyScalar(ve()).round())},this.getScissor=function(e){return e.copy(le)},this.setScissor=function(e,t,n,r){e.isVector4?le.set(e.x,e.y,e.z,e.w):le.set(e,t,n,r),H.scissor(ne.copy(le).multiplyScalar(ve()).round())},this.getScissorTest=function(){return ue},this.setScissorTest=function(e){H.setScissorTest(ue=e)},this.setOpaqueSort=function(e){se=e},this.setTransparentSort=function(e){L=e},this.getClearColor=function(e){return e.copy(Re.getClearColor())},this.setClearColor=function(){Re.setClearColor(...arguments)},this.getClearAlpha=function(){return Re.getClearAlpha()},this.setClearAlpha=function(){Re.setClearAlpha(...arguments)},this.clear=function(e=!0,t=!0,n=!0){let r=0;if(e){let e=!1;if(M!==null){let t=M.texture.format;e=h.has(t)}if(e){let e=M.texture.type,t=g.has(e),n=Re.getClearColor(),r=Re.getClearAlpha(),i=n.r,a=n.g,o=n.b;t?(_[0]=i,_[1]=a,_[2]=o,_[3]=r,B.clearBufferuiv(B.COLOR,0,_)):(v[0]=i,v[1]=a,v[2]=o,v[3]=r,B.clearBufferiv(B.COLOR,0,v))}else r|=B.COLOR_BUFFER_BIT}t&&(r|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),n&&(r|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),r!==0&&B.clear(r)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(e){e.setRenderer(this),D=e},this.dispose=function(){t.removeEventListener(`webglcontextlost`,et,!1),t.removeEventListener(`webglcontextrestored`,tt,!1),t.removeEventListener(`webglcontextcreationerror`,rt,!1),Re.dispose(),Ae.dispose(),Ne.dispose(),G.dispose(),W.dispose(),Ce.dispose(),De.dispose(),Ee.dispose(),Ye.dispose(),Xe.dispose(),Oe.dispose(),$e.dispose(),$e.removeEventListener(`sessionstart`,dt),$e.removeEventListener(`sessionend`,pt),mt.stop()};function et(e){e.preventDefault(),nt(`WebGLRenderer: Context Lost.`),E=!0}function tt(){nt(`WebGLRenderer: Context Restored.`),E=!1;let e=U.autoReset,t=Ie.enabled,n=Ie.autoUpdate,r=Ie.needsUpdate,i=Ie.type;Ze(),U.autoReset=e,Ie.enabled=t,Ie.autoUpdate=n,Ie.needsUpdate=r,Ie.type=i}function rt(e){Z(`WebGLRenderer: A WebGL context could not be created. Reason: `,e.statusMessage)}function at(e){let t=e.target;t.removeEventListener(`dispose`,at),ot(t)}function ot(e){st(e),W.remove(e)}function st(e){let t=W.get(e).programs;t!==void 0&&(t.forEach(function(e){Oe.releaseProgram(e)}),e.isShaderMaterial&&Oe.releaseShaderCache(e))}this.renderBufferDirect=function(e,t,n,r,i,a){t===null&&(t=ge);let o=i.isMesh&&i.matrixWorld.determinantAffine()<0,s=Tt(e,t,n,r,i);H.setMaterial(r,o);let c=n.index,l=1;if(r.wireframe===!0){if(c=Ee.getWireframeAttribute(n),c===void 0)return;l=2}let u=n.drawRange,d=n.attributes.position,f=u.start*l,p=(u.start+u.count)*l;a!==null&&(f=Math.max(f,a.start*l),p=Math.min(p,(a.start+a.count)*l)),c===null?d!=null&&(f=Math.max(f,0),p=Math.min(p,d.count)):(f=Math.max(f,0),p=Math.min(p,c.count));let m=p-f;if(m<0||m===1/0)return;Ye.setup(i,r,s,n,c);let h,g=He;if(c!==null&&(h=Te.get(c),g=Ge,g.setIndex(h)),i.isMesh)r.wireframe===!0?(H.setLineWidth(r.wireframeLinewidth*ve()),g.setMode(B.LINES)):g.setMode(B.TRIANGLES);else if(i.isLine){let e=r.linewidth;e===void 0&&(e=1),H.setLineWidth(e*ve()),i.isLineSegments?g.setMode(B.LINES):i.isLineLoop?g.setMode(B.LINE_LOOP):g.setMode(B.LINE_STRIP)}else i.isPoints?g.setMode(B.POINTS):i.isSprite&&g.setMode(B.TRIANGLES);if(i.isBatchedMesh){if(V.get(`WEBGL_multi_draw`))g.renderMultiDraw(i._multiDrawStarts,i._multiDrawCounts,i._multiDrawCount);else{let e=i._multiDrawStarts,t=i._multiDrawCounts,n=i._multiDrawCount,a=c?Te.get(c).bytesPerElement:1,o=W.get(r).currentProgram.getUniforms();for(let r=0;r<n;r++)o.setValue(B,`_gl_DrawID`,r),g.render(e[r]/a,t[r])}}else if(i.isInstancedMesh)g.renderInstances(f,m,i.count);else if(n.isInstancedBufferGeometry){let e=n._maxInstanceCount===void 0?1/0:n._maxInstanceCount,t=Math.min(n.instanceCount,e);g.renderInstances(f,m,t)}else g.render(f,m)};function ct(e,t,n,r){D!==null&&e.isNodeMaterial&&D.setObject(r,e),de===!0&&Fe.setState(e,n,!1),e.transparent===!0&&e.side===2&&e.forceSinglePass===!1?(e.side=1,e.needsUpdate=!0,xt(e,t,r),e.side=0,e.needsUpdate=!0,xt(e,t,r),e.side=2):xt(e,t,r)}this.compile=function(e,t,n=null){n===null&&(n=e),D!==null&&D.renderStart(e,t,n),x=Ne.get(n),x.init(t),C.push(x),n.traverseVisible(function(e){e.isLight&&e.layers.test(t.layers)&&(x.pushLight(e),e.castShadow&&x.pushShadow(e))}),e!==n&&e.traverseVisible(function(e){e.isLight&&e.layers.test(t.layers)&&(x.pushLight(e),e.castShadow&&x.pushShadow(e))}),x.setupLights(),D!==null&&D.updateLights(x.state.lightsArray),fe=this.localClippingEnabled,de=Fe.init(this.clippingPlanes,fe),de===!0&&Fe.setGlobalState(this.clippingPlanes,t),D!==null&&Ie.render(x.state.shadowsArray,n,t);let r=new Set;return e.traverse(function(e){if(!(e.isMesh||e.isPoints||e.isLine||e.isSprite))return;let i=e.material;if(i){if(Array.isArray(i))for(let a=0;a<i.length;a++){let o=i[a];ct(o,n,t,e),r.add(o)}else ct(i,n,t,e),r.add(i)}}),x=C.pop(),D!==null&&D.renderEnd(),r},this.compileAsync=function(e,t,n=null){let r=this.compile(e,t,n);return new Promise(t=>{function n(){r.forEach(function(e){let t=W.get(e).currentProgram;(t===void 0||t.isReady())&&r.delete(e)}),r.size===0?t(e):setTimeout(n,10)}V.get(`KHR_parallel_shader_compile`)===null?setTimeout(n,10):n()})};let lt=null;function ut(e){lt&&lt(e)}function dt(){mt.stop()}function pt(){mt.start()}let mt=new Vr;mt.setAnimationLoop(ut),typeof self<`u`&&mt.setContext(self),this.setAnimationLoop=function(e){lt=e,$e.setAnimationLoop(e),e===null?mt.stop():mt.start()},$e.addEventListener(`sessionstart`,dt),$e.addEventListener(`sessionend`,pt),this.render=function(e,t){if(t!==void 0&&t.isCamera!==!0){Z(`WebGLRenderer.render: camera is not an instance of THREE.Camera.`);return}if(E===!0)return;D!==null&&D.renderStart(e,t);let n=$e.enabled===!0&&$e.isPresenting===!0,r=w!==null&&(M===null||n)&&w.begin(T,M);if(e.matrixWorldAutoUpdate===!0&&e.updateMatrixWorld(),t.parent===null&&t.matrixWorldAutoUpdate===!0&&t.updateMatrixWorld(),$e.enabled===!0&&$e.isPresenting===!0&&(w===null||w.isCompositing()===!1)&&($e.cameraAutoUpdate===!0&&$e.updateCamera(t),t=$e.getCamera()),e.isScene===!0&&e.onBeforeRender(T,e,t,M),x=Ne.get(e,C.length),x.init(t),x.state.textureUnits=G.getTextureUnits(),C.push(x),pe.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),t.isArrayCamera?z.setFromArrayCamera(t):R.setFromProjectionMatrix(pe,Je,t.reversedDepth),fe=this.localClippingEnabled,de=Fe.init(this.clippingPlanes,fe),b=Ae.get(e,S.length),b.init(),S.push(b),this.info.render.frame++,$e.enabled===!0&&$e.isPresenting===!0){let e=T.xr.getDepthSensingMesh();e!==null&&X(e,t,-1/0,T.sortObjects)}X(e,t,0,T.sortObjects),b.finish(),D!==null&&D.updateLights(x.state.lightsArray),T.sortObjects===!0&&b.sort(se,L),_e=$e.enabled===!1||$e.isPresenting===!1||$e.hasDepthSensing()===!1,_e&&Re.addToRenderList(b,e),this.info.autoReset===!0&&this.info.reset(),de===!0&&Fe.beginShadows();let i=x.state.shadowsArray;if(Ie.render(i,e,t),de===!0&&Fe.endShadows(),(r&&w.hasRenderPass())===!1){let n=b.opaque,r=b.transmissive;if(x.setupLights(),t.isArrayCamera){let i=t.cameras;if(r.length>0)for(let t=0,a=i.length;t<a;t++){let a=i[t];_t(n,r,e,a)}_e&&Re.render(e);for(let t=0,n=i.length;t<n;t++){let n=i[t];gt(b,e,n,n.viewport)}}else r.length>0&&_t(n,r,e,t),_e&&Re.render(e),gt(b,e,t)}M!==null&&ee===0&&(G.updateMultisampleRenderTarget(M),G.updateRenderTargetMipmap(M)),r&&w.end(T),e.isScene===!0&&e.onAfterRender(T,e,t),Ye.resetDefaultState(),te=-1,N=null,C.pop(),C.length>0?(x=C[C.length-1],G.setTextureUnits(x.state.textureUnits),de===!0&&Fe.setGlobalState(T.clippingPlanes,x.state.camera)):x=null,S.pop(),b=S.length>0?S[S.length-1]:null,D!==null&&D.renderEnd()};function X(e,t,n,r){if(e.visible===!1)return;if(e.layers.test(t.layers)){if(e.isGroup)n=e.renderOrder;else if(e.isLOD)e.autoUpdate===!0&&e.update(t);else if(e.isLight)x.pushLight(e),e.castShadow&&x.pushShadow(e);else if(e.isSprite){let i=t.isArrayCamera?z:R;if(!e.frustumCulled||e.intersectsFrustum(i)){r&&he.setFromMatrixPosition(e.matrixWorld).applyMatrix4(pe);let i=De.update(e),a=e.material;a.visible&&b.push(e,i,a,n,he.z,null,t)}}else if(e.isMesh||e.isLine||e.isPoints){let i=t.isArrayCamera?z:R;if(!e.frustumCulled||e.intersectsFrustum(i)){let i=De.update(e),a=e.material;if(r&&(e.boundingSphere===void 0?(i.boundingSphere===null&&i.computeBoundingSphere(),he.copy(i.boundingSphere.center)):(e.boundingSphere===null&&e.computeBoundingSphere(),he.copy(e.boundingSphere.center)),he.applyMatrix4(e.matrixWorld).applyMatrix4(pe)),Array.isArray(a)){let r=i.groups;for(let o=0,s=r.length;o<s;o++){let s=r[o],c=a[s.materialIndex];c&&c.visible&&b.push(e,i,c,n,he.z,s,t)}}else a.visible&&b.push(e,i,a,n,he.z,null,t)}}}let i=e.children;for(let e=0,a=i.length;e<a;e++)X(i[e],t,n,r)}function gt(e,t,n,r){let{opaque:i,transmissive:a,transparent:o}=e;x.setupLightsView(n),de===!0&&Fe.setGlobalState(T.clippingPlanes,n),r&&H.viewport(P.copy(r)),i.length>0&&vt(i,t,n),a.length>0&&vt(a,t,n),o.length>0&&vt(o,t,n),H.buffers.depth.setTest(!0),H.buffers.depth.setMask(!0),H.buffers.color.setMask(!0),H.setPolygonOffset(!1)}function _t(e,t,n,r){if((n.isScene===!0?n.overrideMaterial:null)!==null)return;if(x.state.transmissionRenderTarget[r.id]===void 0){let e=V.has(`EXT_color_buffer_half_float`)||V.has(`EXT_color_buffer_float`);x.state.transmissionRenderTarget[r.id]=new Pe(1,1,{generateMipmaps:!0,type:e?je:Wt,minFilter:We,samples:Math.max(4,be.samples),stencilBuffer:i,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:J.workingColorSpace})}let a=x.state.transmissionRenderTarget[r.id],o=r.viewport||P;a.setSize(o.z*T.transmissionResolutionScale,o.w*T.transmissionResolutionScale);let s=T.getRenderTarget(),c=T.getActiveCubeFace(),l=T.getActiveMipmapLevel();T.setRenderTarget(a),T.getClearColor(ie),ae=T.getClearAlpha(),ae<1&&T.setClearColor(16777215,.5),T.clear(),_e&&Re.render(n);let u=T.toneMapping;T.toneMapping=0;let d=r.viewport;if(r.viewport!==void 0&&(r.viewport=void 0),x.setupLightsView(r),de===!0&&Fe.setGlobalState(T.clippingPlanes,r),vt(e,n,r),G.updateMultisampleRenderTarget(a),G.updateRenderTargetMipmap(a),V.has(`WEBGL_multisampled_render_to_texture`)===!1){let e=!1;for(let i=0,a=t.length;i<a;i++){let{object:a,geometry:o,material:s,group:c}=t[i];if(s.side===2&&a.layers.test(r.layers)){let t=s.side;s.side=1,s.needsUpdate=!0,yt(a,n,r,o,s,c),s.side=t,s.needsUpdate=!0,e=!0}}e===!0&&(G.updateMultisampleRenderTarget(a),G.updateRenderTargetMipmap(a))}T.setRenderTarget(s,c,l),T.setClearColor(ie,ae),d!==void 0&&(r.viewport=d),T.toneMapping=u}function vt(e,t,n){let r=t.isScene===!0?t.overrideMaterial:null;for(let i=0,a=e.length;i<a;i++){let a=e[i],{object:o,geometry:s,group:c}=a,l=a.material;l.allowOverride===!0&&r!==null&&(l=r),o.layers.test(n.layers)&&yt(o,t,n,s,l,c)}}function yt(e,t,n,r,i,a){D!==null&&i.isNodeMaterial&&D.setObject(e,i),e.onBeforeRender(T,t,n,r,i,a),e.modelViewMatrix.multiplyMatrices(n.matrixWorldInverse,e.matrixWorld),e.normalMatrix.getNormalMatrix(e.modelViewMatrix),i.onBeforeRender(T,t,n,r,e,a),i.transparent===!0&&i.side===2&&i.forceSinglePass===!1?(i.side=1,i.needsUpdate=!0,T.renderBufferDirect(n,t,r,i,e,a),i.side=0,i.needsUpdate=!0,T.renderBufferDirect(n,t,r,i,e,a),i.side=2):T.renderBufferDirect(n,t,r,i,e,a),e.onAfterRender(T,t,n,r,i,a)}function bt(e){let t=0;for(let n of e)n.texture!==null&&t++;return t}function xt(e,t,n){t.isScene!==!0&&(t=ge);let r=W.get(e),i=x.state.lights,a=x.state.shadowsArray,o=i.state.version,s=Oe.getParameters(e,i.state,a,t,n,x.state.lightProbeGridArray),c=Oe.getProgramCacheKey(s),l=r.programs;r.environment=e.isMeshStandardMaterial||e.isMeshLambertMaterial||e.isMeshPhongMaterial?t.environment:null,r.fog=t.fog;let u=e.isMeshStandardMaterial||e.isMeshLambertMaterial&&!e.envMap||e.isMeshPhongMaterial&&!e.envMap;r.envMap=Ce.get(e.envMap||r.environment,u),r.envMapRotation=r.environment!==null&&e.envMap===null?t.environmentRotation:e.envMapRotation,l===void 0&&(e.addEventListener(`dispose`,at),l=new Map,r.programs=l,r.programVariants=new Map);let d=l.get(c);if(d!==void 0){if(r.currentProgram===d&&r.lightsStateVersion===o)return wt(e,s),d}else s.uniforms=Oe.getUniforms(e),D!==null&&e.isNodeMaterial&&D.build(e,n,s),e.onBeforeCompile(s,T),d=Oe.acquireProgram(s,c),l.set(c,d),r.uniforms=s.uniforms;let f=r.uniforms;return(!e.isShaderMaterial&&!e.isRawShaderMaterial||e.clipping===!0)&&(f.clippingPlanes=Fe.uniform),wt(e,s),r.needsLights=Dt(e),r.lightsStateVersion=o,r.needsLights&&(f.ambientLightColor.value=i.state.ambient,f.lightProbe.value=i.state.probe,f.sunLights.value=i.state.sun,f.sunLightShadows.value=i.state.sunShadow,f.directionalLights.value=i.state.directional,f.directionalLightShadows.value=i.state.directionalShadow,f.spotLights.value=i.state.spot,f.spotLightShadows.value=i.state.spotShadow,f.rectAreaLights.value=i.state.rectArea,f.ltc_1.value=i.state.rectAreaLTC1,f.ltc_2.value=i.state.rectAreaLTC2,f.pointLights.value=i.state.point,f.pointLightShadows.value=i.state.pointShadow,f.hemisphereLights.value=i.state.hemi,f.sunShadowMatrix.value=i.state.sunShadowMatrix,f.sunShadowCascade.value=i.state.sunShadowCascade,f.directionalShadowMatrix.value=i.state.directionalShadowMatrix,f.spotLightMatrix.value=i.state.spotLightMatrix,f.spotLightMap.value=i.state.spotLightMap,f.pointShadowMatrix.value=i.state.pointShadowMatrix),r.numLightProbeGrids=bt(x.state.lightProbeGridArray),r.currentProgram=d,r.uniformsList=null,d}function St(e,t,n,r,i){let a=W.get(e),o=a.currentProgram.id+`,`+r+`,`+i,s=a.programVariants.get(o);return s===void 0?(s=xt(e,t,n),a.programVariants.set(o,s)):(a.currentProgram=s,a.uniformsList=null,a.outputColorSpace=r,a.toneMapping=i),s}function Ct(e){if(e.uniformsList===null){let t=e.currentProgram.getUniforms();e.uniformsList=Ma.seqWithValue(t.seq,e.uniforms)}return e.uniformsList}function wt(e,t){let n=W.get(e);n.outputColorSpace=t.outputColorSpace,n.batching=t.batching,n.batchingColor=t.batchingColor,n.instancing=t.instancing,n.instancingColor=t.instancingColor,n.instancingMorph=t.instancingMorph,n.skinning=t.skinning,n.morphTargets=t.morphTargets,n.morphNormals=t.morphNormals,n.morphColors=t.morphColors,n.morphTargetsCount=t.morphTargetsCount,n.numClippingPlanes=t.numClippingPlanes,n.numIntersection=t.numClipIntersection,n.vertexAlphas=t.vertexAlphas,n.vertexTangents=t.vertexTangents,n.toneMapping=t.toneMapping}function Tt(e,t,n,r,i){t.isScene!==!0&&(t=ge),G.resetTextureUnits();let a=t.fog,o=r.isMeshStandardMaterial||r.isMeshLambertMaterial||r.isMeshPhongMaterial?t.environment:null,s=M===null?T.outputColorSpace:M.isXRRenderTarget===!0?M.texture.colorSpace:J.workingColorSpace,c=r.isMeshStandardMaterial||r.isMeshLambertMaterial&&!r.envMap||r.isMeshPhongMaterial&&!r.envMap,l=Ce.get(r.envMap||o,c),u=r.vertexColors===!0&&!!n.attributes.color&&n.attributes.color.itemSize===4,d=!!n.attributes.tangent&&(!!r.normalMap||r.anisotropy>0),f=!!n.morphAttributes.position,p=!!n.morphAttributes.normal,m=!!n.morphAttributes.color,h=0;r.toneMapped&&(M===null||M.isXRRenderTarget===!0)&&(h=T.toneMapping);let g=n.morphAttributes.position||n.morphAttributes.normal||n.morphAttributes.color,_=g===void 0?0:g.length,v=W.get(r),b=x.state.lights;if(de===!0&&(fe===!0||e!==N)){let t=e===N&&r.id===te;Fe.setState(r,e,t)}let S=!1,C=!1;r.version===v.__version?v.needsLights&&v.lightsStateVersion!==b.state.version||i.isBatchedMesh&&v.batching===!1||!i.isBatchedMesh&&v.batching===!0||i.isBatchedMesh&&v.batchingColor===!0&&i._colorsTexture===null||i.isBatchedMesh&&v.batchingColor===!1&&i._colorsTexture!==null||i.isInstancedMesh&&v.instancing===!1||!i.isInstancedMesh&&v.instancing===!0||i.isSkinnedMesh&&v.skinning===!1||!i.isSkinnedMesh&&v.skinning===!0||i.isInstancedMesh&&v.instancingColor===!0&&i.instanceColor===null||i.isInstancedMesh&&v.instancingColor===!1&&i.instanceColor!==null||i.isInstancedMesh&&v.instancingMorph===!0&&i.morphTexture===null||i.isInstancedMesh&&v.instancingMorph===!1&&i.morphTexture!==null?S=!0:v.envMap===l?r.fog===!0&&v.fog!==a||v.numClippingPlanes!==void 0&&(v.numClippingPlanes!==Fe.numPlanes||v.numIntersection!==Fe.numIntersection)?S=!0:v.vertexAlphas===u&&v.vertexTangents===d&&v.morphTargets===f&&v.morphNormals===p&&v.morphColors===m&&v.morphTargetsCount===_&&v.numLightProbeGrids===bt(x.state.lightProbeGridArray)?(v.outputColorSpace!==s||v.toneMapping!==h)&&(C=!0):S=!0:S=!0:(S=!0,v.__version=r.version);let w=v.currentProgram;(S===!0||C===!0)&&(w=C===!0?St(r,t,i,s,h):xt(r,t,i),D&&r.isNodeMaterial&&D.onUpdateProgram(r,w,v));let E=!1,O=!1,k=!1,A=w.getUniforms(),j=v.uniforms;if(H.useProgram(w.program)&&(E=!0,O=!0,k=!0),r.id!==te&&(te=r.id,O=!0),E||N!==e){H.buffers.depth.getReversed()&&e.reversedDepth!==!0&&(e._reversedDepth=!0,e.updateProjectionMatrix()),A.setValue(B,`projectionMatrix`,e.projectionMatrix),A.setValue(B,`viewMatrix`,e.matrixWorldInverse);let t=A.map.cameraPosition;t!==void 0&&t.setValue(B,me.setFromMatrixPosition(e.matrixWorld)),be.logarithmicDepthBuffer&&A.setValue(B,`logDepthBufFC`,2/(Math.log(e.far+1)/Math.LN2)),(r.isMeshPhongMaterial||r.isMeshToonMaterial||r.isMeshLambertMaterial||r.isMeshBasicMaterial||r.isMeshStandardMaterial||r.isShaderMaterial)&&A.setValue(B,`isOrthographic`,e.isOrthographicCamera===!0),N!==e&&(N=e,O=!0,k=!0)}if(v.needsLights&&(b.state.sunShadowMap.length>0&&A.setValue(B,`sunShadowMap`,b.state.sunShadowMap,G),b.state.directionalShadowMap.length>0&&A.setValue(B,`directionalShadowMap`,b.state.directionalShadowMap,G),b.state.spotShadowMap.length>0&&A.setValue(B,`spotShadowMap`,b.state.spotShadowMap,G),b.state.pointShadowMap.length>0&&A.setValue(B,`pointShadowMap`,b.state.pointShadowMap,G)),i.isSkinnedMesh){A.setOptional(B,i,`bindMatrix`),A.setOptional(B,i,`bindMatrixInverse`);let e=i.skeleton;e&&(e.boneTexture===null&&e.computeBoneTexture(),A.setValue(B,`boneTexture`,e.boneTexture,G))}i.isBatchedMesh&&(A.setOptional(B,i,`batchingTexture`),A.setValue(B,`batchingTexture`,i._matricesTexture,G),A.setOptional(B,i,`batchingIdTexture`),A.setValue(B,`batchingIdTexture`,i._indirectTexture,G),A.setOptional(B,i,`batchingColorTexture`),i._colorsTexture!==null&&A.setValue(B,`batchingColorTexture`,i._colorsTexture,G));let ee=n.morphAttributes;if((ee.position!==void 0||ee.normal!==void 0||ee.color!==void 0)&&ze.update(i,n,w),(O||v.receiveShadow!==i.receiveShadow)&&(v.receiveShadow=i.receiveShadow,A.setValue(B,`receiveShadow`,i.receiveShadow)),(r.isMeshStandardMaterial||r.isMeshLambertMaterial||r.isMeshPhongMaterial)&&r.envMap===null&&t.environment!==null&&(j.envMapIntensity.value=t.environmentIntensity),j.dfgLUT!==void 0&&(j.dfgLUT.value=Xo()),O){if(A.setValue(B,`toneMappingExposure`,T.toneMappingExposure),v.needsLights&&Et(j,k),a&&r.fog===!0&&ke.refreshFogUniforms(j,a),ke.refreshMaterialUniforms(j,r,I,oe,x.state.transmissionRenderTarget[e.id]),v.needsLights&&v.numLightProbeGrids>0){let e=y,t=0;for(let n of x.state.lightProbeGridArray)n.texture!==null&&(e.textures[t]=n.texture,e.min[t]=n.boundingBox.min,e.max[t]=n.boundingBox.max,e.resolution[t]=n.resolution,t++);for(let n in e)e[n].length=t;j.probesSH.value=e.textures,j.probesMin.value=e.min,j.probesMax.value=e.max,j.probesResolution.value=e.resolution}Ma.upload(B,Ct(v),j,G)}if(r.isShaderMaterial&&r.uniformsNeedUpdate===!0&&(Ma.upload(B,Ct(v),j,G),r.uniformsNeedUpdate=!1),r.isSpriteMaterial&&A.setValue(B,`center`,i.center),A.setValue(B,`modelViewMatrix`,i.modelViewMatrix),A.setValue(B,`normalMatrix`,i.normalMatrix),A.setValue(B,`modelMatrix`,i.matrixWorld),r.uniformsGroups!==void 0){let e=r.uniformsGroups;for(let t=0,n=e.length;t<n;t++){let n=e[t];Xe.update(n,w),Xe.bind(n,w)}}return w}function Et(e,t){e.ambientLightColor.needsUpdate=t,e.lightProbe.needsUpdate=t,e.sunLights.needsUpdate=t,e.sunLightShadows.needsUpdate=t,e.directionalLights.needsUpdate=t,e.directionalLightShadows.needsUpdate=t,e.pointLights.needsUpdate=t,e.pointLightShadows.needsUpdate=t,e.spotLights.needsUpdate=t,e.spotLightShadows.needsUpdate=t,e.rectAreaLights.needsUpdate=t,e.hemisphereLights.needsUpdate=t}function Dt(e){return e.isMeshLambertMaterial||e.isMeshToonMaterial||e.isMeshPhongMaterial||e.isMeshStandardMaterial||e.isShadowMaterial||e.isShaderMaterial&&e.lights===!0}this.getActiveCubeFace=function(){return j},this.getActiveMipmapLevel=function(){return ee},this.getRenderTarget=function(){return M},this.setRenderTargetTextures=function(e,t,n){let r=W.get(e);r.__autoAllocateDepthBuffer=e.resolveDepthBuffer===!1,r.__autoAllocateDepthBuffer===!1&&(r.__useRenderToTexture=!1),W.get(e.texture).__webglTexture=t,W.get(e.depthTexture).__webglTexture=r.__autoAllocateDepthBuffer?void 0:n,r.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(e,t){let n=W.get(e);n.__webglFramebuffer=t,n.__useDefaultFramebuffer=t===void 0},this.setRenderTarget=function(e,t=0,n=0){M=e,j=t,ee=n;let r=null,i=!1,a=!1;if(e){let o=W.get(e);if(o.__useDefaultFramebuffer!==void 0){H.bindFramebuffer(B.FRAMEBUFFER,o.__webglFramebuffer),P.copy(e.viewport),ne.copy(e.scissor),re=e.scissorTest,H.viewport(P),H.scissor(ne),H.setScissorTest(re),te=-1;return}if(o.__webglFramebuffer===void 0)G.setupRenderTarget(e);else if(o.__hasExternalTextures)G.rebindTextures(e,W.get(e.texture).__webglTexture,W.get(e.depthTexture).__webglTexture);else if(e.depthBuffer){let t=e.depthTexture;if(o.__boundDepthTexture!==t){if(t!==null&&W.has(t)&&(e.width!==t.image.width||e.height!==t.image.height))throw Error(`THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.`);G.setupDepthRenderbuffer(e)}}let s=e.texture;(s.isData3DTexture||s.isDataArrayTexture||s.isCompressedArrayTexture)&&(a=!0);let c=W.get(e).__webglFramebuffer;e.isWebGLCubeRenderTarget?(r=Array.isArray(c[t])?c[t][n]:c[t],i=!0):r=e.samples>0&&G.useMultisampledRTT(e)===!1?W.get(e).__webglMultisampledFramebuffer:Array.isArray(c)?c[n]:c,P.copy(e.viewport),ne.copy(e.scissor),re=e.scissorTest}else P.copy(ce).multiplyScalar(I).floor(),ne.copy(le).multiplyScalar(I).floor(),re=ue;if(n!==0&&(r=O),H.bindFramebuffer(B.FRAMEBUFFER,r)&&H.drawBuffers(e,r),H.viewport(P),H.scissor(ne),H.setScissorTest(re),i){let r=W.get(e.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+t,r.__webglTexture,n)}else if(a){let r=t;for(let t=0;t<e.textures.length;t++){let i=W.get(e.textures[t]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+t,i.__webglTexture,n,r)}}else if(e!==null&&n!==0){let t=W.get(e.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,t.__webglTexture,n)}te=-1};function Ot(e){let t=W.get(e);return(t.__readFormat!==e.format||t.__readType!==e.type)&&(t.__readFormat=e.format,t.__readType=e.type,t.__formatReadable=be.textureFormatReadable(e.format),t.__typeReadable=be.textureTypeReadable(e.type)),t}this.readRenderTargetPixels=function(e,t,n,r,i,a,o,s=0){if(!(e&&e.isWebGLRenderTarget)){Z(`WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.`);return}let c=W.get(e).__webglFramebuffer;if(e.isWebGLCubeRenderTarget&&o!==void 0&&(c=c[o],Array.isArray(c)&&(c=c[0])),c){H.bindFramebuffer(B.FRAMEBUFFER,c);try{let o=e.textures[s],c=o.format,l=o.type;e.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+s);let u=Ot(o);if(u.__formatReadable===!1){Z(`WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.`);return}if(u.__typeReadable===!1){Z(`WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.`);return}t>=0&&t<=e.width-r&&n>=0&&n<=e.height-i&&B.readPixels(t,n,r,i,qe.convert(c),qe.convert(l),a)}finally{let e=M===null?null:W.get(M).__webglFramebuffer;H.bindFramebuffer(B.FRAMEBUFFER,e)}}},this.readRenderTargetPixelsAsync=async function(e,t,n,r,i,a,o,s=0){if(!(e&&e.isWebGLRenderTarget))throw Error(`THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.`);let c=W.get(e).__webglFramebuffer;if(e.isWebGLCubeRenderTarget&&o!==void 0&&(c=c[o],Array.isArray(c)&&(c=c[0])),c){if(t>=0&&t<=e.width-r&&n>=0&&n<=e.height-i){H.bindFramebuffer(B.FRAMEBUFFER,c);let o=e.textures[s],l=o.format,u=o.type;e.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+s);let d=Ot(o);if(d.__formatReadable===!1)throw Error(`THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.`);if(d.__typeReadable===!1)throw Error(`THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.`);let f=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,f),B.bufferData(B.PIXEL_PACK_BUFFER,a.byteLength,B.STREAM_READ),B.readPixels(t,n,r,i,qe.convert(l),qe.convert(u),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let p=M===null?null:W.get(M).__webglFramebuffer;H.bindFramebuffer(B.FRAMEBUFFER,p);let m=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await It(B,m,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,f),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,a),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(f),B.deleteSync(m),a}throw Error(`THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.`)}},this.copyFramebufferToTexture=function(e,t=null,n=0){let r=2**-n,i=Math.floor(e.image.width*r),a=Math.floor(e.image.height*r),o=t===null?0:t.x,s=t===null?0:t.y;G.setTexture2D(e,0),B.copyTexSubImage2D(B.TEXTURE_2D,n,0,0,o,s,i,a),H.unbindTexture()},this.copyTextureToTexture=function(e,t,n=null,r=null,i=0,a=0){let o,s,c,l,u,d,f,p,m,h=e.isCompressedTexture?e.mipmaps[a]:e.image;if(n!==null)o=n.max.x-n.min.x,s=n.max.y-n.min.y,c=n.isBox3?n.max.z-n.min.z:1,l=n.min.x,u=n.min.y,d=n.isBox3?n.min.z:0;else{let t=2**-i;o=Math.floor(h.width*t),s=Math.floor(h.height*t),c=e.isDataArrayTexture?h.depth:e.isData3DTexture?Math.floor(h.depth*t):1,l=0,u=0,d=0}r===null?(f=0,p=0,m=0):(f=r.x,p=r.y,m=r.z);let g=qe.convert(t.format),_=qe.convert(t.type),v;t.isData3DTexture?(G.setTexture3D(t,0),v=B.TEXTURE_3D):t.isDataArrayTexture||t.isCompressedArrayTexture?(G.setTexture2DArray(t,0),v=B.TEXTURE_2D_ARRAY):(G.setTexture2D(t,0),v=B.TEXTURE_2D),H.activeTexture(B.TEXTURE0),H.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,t.flipY),H.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,t.premultiplyAlpha),H.pixelStorei(B.UNPACK_ALIGNMENT,t.unpackAlignment);let y=H.getParameter(B.UNPACK_ROW_LENGTH),b=H.getParameter(B.UNPACK_IMAGE_HEIGHT),x=H.getParameter(B.UNPACK_SKIP_PIXELS),S=H.getParameter(B.UNPACK_SKIP_ROWS),C=H.getParameter(B.UNPACK_SKIP_IMAGES);H.pixelStorei(B.UNPACK_ROW_LENGTH,h.width),H.pixelStorei(B.UNPACK_IMAGE_HEIGHT,h.height),H.pixelStorei(B.UNPACK_SKIP_PIXELS,l),H.pixelStorei(B.UNPACK_SKIP_ROWS,u),H.pixelStorei(B.UNPACK_SKIP_IMAGES,d);let w=e.isDataArrayTexture||e.isData3DTexture,T=t.isDataArrayTexture||t.isData3DTexture;if(e.isDepthTexture){let n=W.get(e),r=W.get(t),h=W.get(n.__renderTarget),g=W.get(r.__renderTarget);H.bindFramebuffer(B.READ_FRAMEBUFFER,h.__webglFramebuffer),H.bindFramebuffer(B.DRAW_FRAMEBUFFER,g.__webglFramebuffer);for(let n=0;n<c;n++)w&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,W.get(e).__webglTexture,i,d+n),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,W.get(t).__webglTexture,a,m+n)),B.blitFramebuffer(l,u,l+o,u+s,f,p,f+o,p+s,B.DEPTH_BUFFER_BIT,B.NEAREST);H.bindFramebuffer(B.READ_FRAMEBUFFER,null),H.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(i!==0||e.isRenderTargetTexture||W.has(e)){let n=W.get(e),r=W.get(t);H.bindFramebuffer(B.READ_FRAMEBUFFER,k),H.bindFramebuffer(B.DRAW_FRAMEBUFFER,A);for(let e=0;e<c;e++)w?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,n.__webglTexture,i,d+e):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,n.__webglTexture,i),T?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,r.__webglTexture,a,m+e):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,r.__webglTexture,a),i===0?T?B.copyTexSubImage3D(v,a,f,p,m+e,l,u,o,s):B.copyTexSubImage2D(v,a,f,p,l,u,o,s):B.blitFramebuffer(l,u,l+o,u+s,f,p,f+o,p+s,B.COLOR_BUFFER_BIT,B.NEAREST);H.bindFramebuffer(B.READ_FRAMEBUFFER,null),H.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else T?e.isDataTexture||e.isData3DTexture?B.texSubImage3D(v,a,f,p,m,o,s,c,g,_,h.data):t.isCompressedArrayTexture?B.compressedTexSubImage3D(v,a,f,p,m,o,s,c,g,h.data):B.texSubImage3D(v,a,f,p,m,o,s,c,g,_,h):e.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,a,f,p,o,s,g,_,h.data):e.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,a,f,p,h.width,h.height,g,h.data):B.texSubImage2D(B.TEXTURE_2D,a,f,p,o,s,g,_,h);H.pixelStorei(B.UNPACK_ROW_LENGTH,y),H.pixelStorei(B.UNPACK_IMAGE_HEIGHT,b),H.pixelStorei(B.UNPACK_SKIP_PIXELS,x),H.pixelStorei(B.UNPACK_SKIP_ROWS,S),H.pixelStorei(B.UNPACK_SKIP_IMAGES,C),a===0&&t.generateMipmaps===!0&&t.mipmapsAutoUpdate===!0&&B.generateMipmap(v),H.unbindTexture()},this.initRenderTarget=function(e){W.get(e).__webglFramebuffer===void 0&&G.setupRenderTarget(e)},this.initTexture=function(e){e.isCubeTexture?G.setTextureCube(e,0):e.isData3DTexture?G.setTexture3D(e,0):e.isDataArrayTexture||e.isCompressedArrayTexture?G.setTexture2DArray(e,0):G.setTexture2D(e,0),H.unbindTexture()},this.resetState=function(){j=0,ee=0,M=null,H.reset(),Ye.reset()},typeof __THREE_DEVTOOLS__<`u`&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent(`observe`,{detail:this}))}get coordinateSystem(){return Je}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=J._getDrawingBufferColorSpace(e),t.unpackColorSpace=J._getUnpackColorSpace()}};function Qo(e,t){let n=null,r=0;return()=>n??=e(r).catch(e=>{throw n=null,r+=1,Error(`The code of ${t} could not be fetched. The next use requests it again.`,{cause:e})})}function $o(e){let t=e.getAttribute(`position`),n=[1/0,1/0,1/0],r=[-1/0,-1/0,-1/0];for(let e=0;e<t.count;e+=1)for(let i=0;i<3;i+=1){let a=t.getComponent(e,i);n[i]=Math.min(n[i]??a,a),r[i]=Math.max(r[i]??a,a)}let i=n.map((e,t)=>(r[t]??e)-e),a=n.map((e,t)=>((r[t]??e)+e)/2),o=1/Math.max(...i);for(let e=0;e<t.count;e+=1)for(let n=0;n<3;n+=1)t.setComponent(e,n,(t.getComponent(e,n)-(a[n]??0))*o);return e.boundingBox=null,e.boundingSphere=null,e}var es=[`box`,`sphere`,`cylinder`,`cone`,`pyramid`,`torus`,`torus-knot`,`teapot`,`plane`],ts=new Set(es.filter(e=>e!==`plane`)),ns=Qo(()=>mn(()=>import(`./solids-wsoucnVU.js`),__vite__mapDeps([6,7,8]),import.meta.url),`the solid shapes`),rs=Qo(()=>mn(()=>import(`./teapot-DYLMVShE.js`),__vite__mapDeps([9,7]),import.meta.url),`the teapot`),is=e=>async t=>(await ns()).SOLIDS[e](t),as={box:{segments:1,least:1,create:e=>new wt(1,1,1,e,e,e)},sphere:{segments:64,least:3,create:e=>new H(.5,e,Math.max(2,Math.round(e/2)))},cylinder:{segments:64,least:3,create:is(`cylinder`)},cone:{segments:64,least:3,create:is(`cone`)},pyramid:{segments:1,least:1,create:is(`pyramid`)},torus:{segments:64,least:3,create:is(`torus`)},"torus-knot":{segments:256,least:32,create:async e=>$o(await is(`torus-knot`)(e))},teapot:{segments:64,least:12,create:async e=>$o((await rs()).teapotGeometry(e))},plane:{segments:1,least:1,create:e=>new Vt(1,1,e,e).rotateX(-Math.PI/2)}};function os(e,t){let n=as[e];return Math.max(n.least,Math.round(t??n.segments))}function ss(e,t){return as[e].create(os(e,t))}var cs=new Map,ls=(e,t)=>`${e} ${String(os(e,t))}`;function us(e,t){let n=ls(e,t),r=cs.get(n);if(r)return r.users+=1,r.geometry;let i=ss(e,t),a={geometry:i,users:1};return cs.set(n,a),i instanceof Promise&&i.catch(()=>{cs.get(n)===a&&cs.delete(n)}),i}function ds(e,t){let n=ls(e,t),r=cs.get(n);r&&(--r.users,r.users>0||(cs.delete(n),r.geometry instanceof Promise?r.geometry.then(e=>{e.dispose()},()=>void 0):r.geometry.dispose()))}var fs=[`gltf`,`glb`,`obj`,`stl`,`ply`,`model/gltf-binary`,`model/gltf+json`,`model/obj`,`model/stl`,`model/ply`],ps=0xe8d4a51000,ms=c(``,`the address of a model, a Blob or a File`),hs={...ms,check:e=>gs(e)?e:ms.check(e)};function gs(e){return/^\[object (Blob|File)\]$/.test(Object.prototype.toString.call(e))}var _s={...kn,src:hs,type:f(d(`gltf`,fs)),geometry:f(d(`box`,es)),segments:f(a(1,{min:1,max:512,integer:!0}))},vs={min:-r.coordinate,max:r.coordinate},ys={name:c(),..._s,position:p([0,0,0],vs),rotation:p([0,0,0],vs),scale:u([1,1,1],{min:-0xe8d4a51000,max:ps}),shading:f(d(`phong`,Tr)),reflection:f(d(`phong`,Er))},bs=class extends Tn{static observedAttributes=x(ys);constructor(){let t=new e(ys);super(t,e=>{(e===`src`||e===`geometry`)&&t.notify(e)})}};y(bs.prototype,ys);var xs=globalThis,Ss=xs.ShadowRoot&&(xs.ShadyCSS===void 0||xs.ShadyCSS.nativeShadow)&&`adoptedStyleSheets`in Document.prototype&&`replace`in CSSStyleSheet.prototype,Cs=Symbol(),ws=new WeakMap,Ts=class{constructor(e,t,n){if(this._$cssResult$=!0,n!==Cs)throw Error("CSSResult is not constructable. Use `unsafeCSS` or `css` instead.");this.cssText=e,this.t=t}get styleSheet(){let e=this.o,t=this.t;if(Ss&&e===void 0){let n=t!==void 0&&t.length===1;n&&(e=ws.get(t)),e===void 0&&((this.o=e=new CSSStyleSheet).replaceSync(this.cssText),n&&ws.set(t,e))}return e}toString(){return this.cssText}},Es=e=>new Ts(typeof e==`string`?e:e+``,void 0,Cs),Ds=(e,t)=>{if(Ss)e.adoptedStyleSheets=t.map(e=>e instanceof CSSStyleSheet?e:e.styleSheet);else for(let n of t){let t=document.createElement(`style`),r=xs.litNonce;r!==void 0&&t.setAttribute(`nonce`,r),t.textContent=n.cssText,e.appendChild(t)}},Os=Ss?e=>e:e=>e instanceof CSSStyleSheet?(e=>{let t=``;for(let n of e.cssRules)t+=n.cssText;return Es(t)})(e):e,{is:ks,defineProperty:As,getOwnPropertyDescriptor:js,getOwnPropertyNames:Ms,getOwnPropertySymbols:Ns,getPrototypeOf:Ps}=Object,Fs=globalThis,Is=Fs.trustedTypes,Ls=Is?Is.emptyScript:``,Rs=Fs.reactiveElementPolyfillSupport,zs=(e,t)=>e,Bs={toAttribute(e,t){switch(t){case Boolean:e=e?Ls:null;break;case Object:case Array:e=e==null?e:JSON.stringify(e)}return e},fromAttribute(e,t){let n=e;switch(t){case Boolean:n=e!==null;break;case Number:n=e===null?null:Number(e);break;case Object:case Array:try{n=JSON.parse(e)}catch{n=null}}return n}},Vs=(e,t)=>!ks(e,t),Hs={attribute:!0,type:String,converter:Bs,reflect:!1,useDefault:!1,hasChanged:Vs};Symbol.metadata??=Symbol(`metadata`),Fs.litPropertyMetadata??=new WeakMap;var Us=class extends HTMLElement{static addInitializer(e){this._$Ei(),(this.l??=[]).push(e)}static get observedAttributes(){return this.finalize(),this._$Eh&&[...this._$Eh.keys()]}static createProperty(e,t=Hs){if(t.state&&(t.attribute=!1),this._$Ei(),this.prototype.hasOwnProperty(e)&&((t=Object.create(t)).wrapped=!0),this.elementProperties.set(e,t),!t.noAccessor){let n=Symbol(),r=this.getPropertyDescriptor(e,n,t);r!==void 0&&As(this.prototype,e,r)}}static getPropertyDescriptor(e,t,n){let{get:r,set:i}=js(this.prototype,e)??{get(){return this[t]},set(e){this[t]=e}};return{get:r,set(t){let a=r?.call(this);i?.call(this,t),this.requestUpdate(e,a,n)},configurable:!0,enumerable:!0}}static getPropertyOptions(e){return this.elementProperties.get(e)??Hs}static _$Ei(){if(this.hasOwnProperty(zs(`elementProperties`)))return;let e=Ps(this);e.finalize(),e.l!==void 0&&(this.l=[...e.l]),this.elementProperties=new Map(e.elementProperties)}static finalize(){if(this.hasOwnProperty(zs(`finalized`)))return;if(this.finalized=!0,this._$Ei(),this.hasOwnProperty(zs(`properties`))){let e=this.properties,t=[...Ms(e),...Ns(e)];for(let n of t)this.createProperty(n,e[n])}let e=this[Symbol.metadata];if(e!==null){let t=litPropertyMetadata.get(e);if(t!==void 0)for(let[e,n]of t)this.elementProperties.set(e,n)}this._$Eh=new Map;for(let[e,t]of this.elementProperties){let n=this._$Eu(e,t);n!==void 0&&this._$Eh.set(n,e)}this.elementStyles=this.finalizeStyles(this.styles)}static finalizeStyles(e){let t=[];if(Array.isArray(e)){let n=new Set(e.flat(1/0).reverse());for(let e of n)t.unshift(Os(e))}else e!==void 0&&t.push(Os(e));return t}static _$Eu(e,t){let n=t.attribute;return!1===n?void 0:typeof n==`string`?n:typeof e==`string`?e.toLowerCase():void 0}constructor(){super(),this._$Ep=void 0,this.isUpdatePending=!1,this.hasUpdated=!1,this._$Em=null,this._$Ev()}_$Ev(){this._$ES=new Promise(e=>this.enableUpdating=e),this._$AL=new Map,this._$E_(),this.requestUpdate(),this.constructor.l?.forEach(e=>e(this))}addController(e){(this._$EO??=new Set).add(e),this.renderRoot!==void 0&&this.isConnected&&e.hostConnected?.()}removeController(e){this._$EO?.delete(e)}_$E_(){let e=new Map,t=this.constructor.elementProperties;for(let n of t.keys())this.hasOwnProperty(n)&&(e.set(n,this[n]),delete this[n]);e.size>0&&(this._$Ep=e)}createRenderRoot(){let e=this.shadowRoot??this.attachShadow(this.constructor.shadowRootOptions);return Ds(e,this.constructor.elementStyles),e}connectedCallback(){this.renderRoot??=this.createRenderRoot(),this.enableUpdating(!0),this._$EO?.forEach(e=>e.hostConnected?.())}enableUpdating(e){}disconnectedCallback(){this._$EO?.forEach(e=>e.hostDisconnected?.())}attributeChangedCallback(e,t,n){this._$AK(e,n)}_$ET(e,t){let n=this.constructor.elementProperties.get(e),r=this.constructor._$Eu(e,n);if(r!==void 0&&!0===n.reflect){let i=(n.converter?.toAttribute===void 0?Bs:n.converter).toAttribute(t,n.type);this._$Em=e,i==null?this.removeAttribute(r):this.setAttribute(r,i),this._$Em=null}}_$AK(e,t){let n=this.constructor,r=n._$Eh.get(e);if(r!==void 0&&this._$Em!==r){let e=n.getPropertyOptions(r),i=typeof e.converter==`function`?{fromAttribute:e.converter}:e.converter?.fromAttribute===void 0?Bs:e.converter;this._$Em=r;let a=i.fromAttribute(t,e.type);this[r]=a??this._$Ej?.get(r)??a,this._$Em=null}}requestUpdate(e,t,n,r=!1,i){if(e!==void 0){let a=this.constructor;if(!1===r&&(i=this[e]),n??=a.getPropertyOptions(e),!((n.hasChanged??Vs)(i,t)||n.useDefault&&n.reflect&&i===this._$Ej?.get(e)&&!this.hasAttribute(a._$Eu(e,n))))return;this.C(e,t,n)}!1===this.isUpdatePending&&(this._$ES=this._$EP())}C(e,t,{useDefault:n,reflect:r,wrapped:i},a){n&&!(this._$Ej??=new Map).has(e)&&(this._$Ej.set(e,a??t??this[e]),!0!==i||a!==void 0)||(this._$AL.has(e)||(this.hasUpdated||n||(t=void 0),this._$AL.set(e,t)),!0===r&&this._$Em!==e&&(this._$Eq??=new Set).add(e))}async _$EP(){this.isUpdatePending=!0;try{await this._$ES}catch(e){Promise.reject(e)}let e=this.scheduleUpdate();return e!=null&&await e,!this.isUpdatePending}scheduleUpdate(){return this.performUpdate()}performUpdate(){if(!this.isUpdatePending)return;if(!this.hasUpdated){if(this.renderRoot??=this.createRenderRoot(),this._$Ep){for(let[e,t]of this._$Ep)this[e]=t;this._$Ep=void 0}let e=this.constructor.elementProperties;if(e.size>0)for(let[t,n]of e){let{wrapped:e}=n,r=this[t];!0!==e||this._$AL.has(t)||r===void 0||this.C(t,void 0,n,r)}}let e=!1,t=this._$AL;try{e=this.shouldUpdate(t),e?(this.willUpdate(t),this._$EO?.forEach(e=>e.hostUpdate?.()),this.update(t)):this._$EM()}catch(t){throw e=!1,this._$EM(),t}e&&this._$AE(t)}willUpdate(e){}_$AE(e){this._$EO?.forEach(e=>e.hostUpdated?.()),this.hasUpdated||(this.hasUpdated=!0,this.firstUpdated(e)),this.updated(e)}_$EM(){this._$AL=new Map,this.isUpdatePending=!1}get updateComplete(){return this.getUpdateComplete()}getUpdateComplete(){return this._$ES}shouldUpdate(e){return!0}update(e){this._$Eq&&=this._$Eq.forEach(e=>this._$ET(e,this[e])),this._$EM()}updated(e){}firstUpdated(e){}};Us.elementStyles=[],Us.shadowRootOptions={mode:`open`},Us[zs(`elementProperties`)]=new Map,Us[zs(`finalized`)]=new Map,Rs?.({ReactiveElement:Us}),(Fs.reactiveElementVersions??=[]).push(`2.1.2`);var Ws=class{#e=[];#t=[];#n=new Map;#r;#i=0;#a=0;constructor(e=()=>void 0){this.#r=e}get version(){return this.#i}get kindVersion(){return this.#a}get lights(){return this.#e}get values(){return this.#t}assign(e){if(!(e.length===this.#e.length&&e.every((e,t)=>e===this.#e[t]))){for(let[e,t]of this.#n)e.unlisten(t);this.#n.clear(),this.#e.splice(0,1/0,...e),this.#t.splice(0,1/0,...e.map(({values:e})=>e));for(let t of e)this.#o(t);this.#a+=1,this.#s(null)}}add(e){this.#e.push(e),this.#t.push(e.values),this.#o(e),this.#a+=1,this.#s(null)}remove(e){let t=this.#n.get(e);if(t!==void 0){e.unlisten(t),this.#n.delete(e);for(let t=this.#e.indexOf(e);t>=0;t=this.#e.indexOf(e))this.#e.splice(t,1),this.#t.splice(t,1);this.#a+=1,this.#s(null)}}#o(e){let{values:t}=e,n=t.position[3],r=r=>{(r!==`position`||t.position[3]!==n)&&(this.#a+=1),n=t.position[3],this.#s(e)};e.listen(r),this.#n.set(e,r)}#s(e){this.#i+=1,this.#r(e)}},Gs=0x38d7ea4c68000,Ks=Object.freeze({theta:30,phi:70,radius:4,target:Object.freeze([0,0,0])}),qs=class{#e=Ks.theta;#t=Ks.phi;#n=Ks.radius;#r=Ks.target;#i=0;#a;constructor(e={}){this.set(e),this.#i=0}get version(){return this.#i}get theta(){return this.#e}get phi(){return this.#t}get radius(){return this.#n}get target(){return this.#r}get pose(){return this.#a??=Object.freeze({theta:this.#e,phi:this.#t,radius:this.#n,target:this.#r}),this.#a}set(e){let{theta:t=this.#e,phi:n=this.#t,radius:r=this.#n,target:i=this.#r}=e;if(!Number.isFinite(t)||!Number.isFinite(n)||!Number.isFinite(r)||!(r>0))throw RangeError(`a camera needs finite angles and a finite radius above 0`);let a=i===this.#r?i:Zs(i,this.#r),o=t+0,s=Math.min(Math.max(n,0),180)+0,c=Math.min(r,Gs);(o!==this.#e||s!==this.#t||c!==this.#n||a!==this.#r)&&(this.#e=o,this.#t=s,this.#n=c,this.#r=a,this.#a=void 0,this.#i+=1)}offset(e=[0,0,0]){Xs(this,e);for(let t=0;t<3;t++)e[t]*=this.#n;return e}eye(e=[0,0,0]){this.offset(e);for(let t=0;t<3;t++)e[t]+=this.#r[t];return e}basis(e=Js()){return Ys(this,e)}},Js=()=>({right:[1,0,0],up:[0,1,0],back:[0,0,1]});function Ys(e,t=Js()){let{right:n,up:r}=t,i=L(e.theta),a=ce(e.theta),o=ce(e.phi);return n[0]=a,n[1]=0,n[2]=0-i,r[0]=0-o*i,r[1]=L(e.phi),r[2]=0-o*a,Xs(e,t.back),t}function Xs({theta:e,phi:t},n){let r=L(t);n[0]=r*L(e)+0,n[1]=ce(t),n[2]=r*ce(e)+0}function Zs(e,t){if(!e.every(Number.isFinite))throw RangeError(`a camera needs a finite target`);let n=[Qs(e[0]),Qs(e[1]),Qs(e[2])];return n[0]===t[0]&&n[1]===t[1]&&n[2]===t[2]?t:Object.freeze(n)}var Qs=e=>Math.min(Math.max(e,-0x38d7ea4c68000),Gs)+0,$s=1.05,ec=4,tc=1e3;function nc(e,t,n){return e===null||!e.centre.every(Number.isFinite)?{target:[0,0,0],radius:ec}:{target:e.centre,radius:rc(e.radius,t,n)}}function rc(e,t,n){let r=L(t/2),i=r/ce(t/2)*(n>0&&n<1?n:1),a=Math.min(r,i/Math.hypot(1,i)),o=$s*e/a;return o>0?Math.min(o,Gs):ec}function ic(e){let t=e!==null&&e.radius>0?e.radius:1;return{min:Math.min(t,Gs)/tc,max:Math.min(t*tc,Gs)}}function ac(e,t,n={near:0,far:0}){let r=Math.max(e.radius,oc),{back:i}=Ys(e,cc),a=r;for(let n=0;t!==null&&n<3;n++)a+=(e.target[n]-t.centre[n])*i[n];let o=t===null?0:Math.max(t.radius,0);return Math.abs(a)+o<sc||(a=r,o=0),n.far=1.01*Math.max(a+o,r/1e3),n.near=Math.max(.99*(a-o),Math.min(n.far/1e3,r/10)),n}var oc=1e-30,sc=1e30,cc=Js(),lc=192,uc=96,dc=61,fc=new WeakMap;function pc(e){let t=fc.get(e);return t===void 0&&fc.set(e,t=gc(e)),t}function mc(e,t){fc.set(t,pc(e))}function hc(e){fc.delete(e)}function gc(e){let t=e.getAttribute(`position`),n=t instanceof jt&&t.itemSize===3&&t.array instanceof Float32Array?_c(t.array):null;return n&&Number.isFinite(n.radius)?n:_c(vc(t))}function _c(e){let t=yc();bc(t,e,0,e.length);let[n,r,i,a,o,s]=t;if(!(n<=a))return null;let c=[n+(a-n)/2,r+(o-r)/2,i+(s-i)/2],l=0;for(let t=0;t<e.length;t+=3){let n=e[t]-c[0],r=e[t+1]-c[1],i=e[t+2]-c[2];l=Math.max(l,n*n+r*r+i*i)}let u=Math.sqrt(l),d=e.length/3;return{points:Dc(e,d<=lc?Array.from({length:d},(e,t)=>3*t):xc(e,t)),center:c,radius:u}}function vc(e){let t=new Float64Array(3*e.count),n=0;for(let r=0;r<e.count;r++){let[i,a,o]=[e.getX(r),e.getY(r),e.getZ(r)];Number.isFinite(i+a+o)&&(t[n++]=i,t[n++]=a,t[n++]=o)}return t.subarray(0,n)}var yc=()=>[1/0,1/0,1/0,-1/0,-1/0,-1/0];function bc(e,t,n,r){let[i,a,o,s,c,l]=e;for(let e=n;e<r;e+=3){let[n,r,u]=[t[e],t[e+1],t[e+2]];n<i&&(i=n),n>s&&(s=n),r<a&&(a=r),r>c&&(c=r),u<o&&(o=u),u>l&&(l=u)}e[0]=i,e[1]=a,e[2]=o,e[3]=s,e[4]=c,e[5]=l}function xc(e,t){let n=wc(t),r=new Float64Array(uc).fill(1/0),i=new Float64Array(uc).fill(-1/0),a=new Uint32Array(uc),o=new Uint32Array(uc);for(let t of Sc(e.length)){let s=Math.min(t+192,e.length),[c,l,u,d,f,p]=Cc(e,t,s);for(let m=0;m<uc;m++){let[h,g,_]=[n[3*m],n[3*m+1],n[3*m+2]],v=h*(h>0?d:c)+g*(g>0?f:l)+_*(_>0?p:u),y=h*(h>0?c:d)+g*(g>0?l:f)+_*(_>0?u:p);if(!(v<=i[m]&&y>=r[m]))for(let n=t;n<s;n+=3){let t=h*e[n]+g*e[n+1]+_*e[n+2];t<r[m]&&(r[m]=t,a[m]=n),t>i[m]&&(i[m]=t,o[m]=n)}}}return new Set([...a,...o])}function*Sc(e){for(let t=0;t<dc;t++)for(let n=t;192*n<e;n+=dc)yield 192*n}function Cc(e,t,n){let r=yc();return bc(r,e,t,n),r}function wc([e,t,n,r,i,a]){let o=[r-e,i-t,a-n].map(e=>e>0?1/e:0);return Float64Array.from([1,0,0,0,1,0,0,0,1,...Ec(93)]).map((e,t)=>e*o[t%3])}var Tc=Math.PI*(3-Math.sqrt(5));function*Ec(e){for(let t=0;t<e;t++){let n=1-(t+.5)/e,r=Math.sqrt(1-n*n);yield r*Math.cos(t*Tc),yield n,yield r*Math.sin(t*Tc)}}function Dc(e,t){let n=new Map;for(let r of t){let t=[...e.subarray(r,r+3)];n.set(t.join(),t)}return Float64Array.from([...n.values()].flat())}var Oc={empty:!0,center:[0,0,0],radiusAbout:()=>0};function kc(e){let t=Mc(e);if(t.length===0)return Oc;let n=[1/0,1/0,1/0],r=[-1/0,-1/0,-1/0],i=({extremes:e,matrix:t},i)=>{let a=Ic(e.points,i,t);for(let e=0;e<i;e++){let t=a[e],i=e%3;t<n[i]&&(n[i]=t),t>r[i]&&(r[i]=t)}},a=({center:e,radius:t})=>{let i=.999999999*t;for(let t of[0,1,2])if(e[t]-i<n[t]||e[t]+i>r[t])return!1;return!0};for(let e of t)i(e,3);for(let e of t)a(e)||i(e,e.extremes.points.length);let o=e=>n[e]+(r[e]-n[e])/2;return{empty:!1,center:[o(0),o(1),o(2)],radiusAbout:e=>Pc(e,t)}}function Ac(e,t){if(!e.visible)return 0;let n=0,{geometry:r,boundingSphere:i}=e,a=e.matrixWorld.elements;if(i!==void 0){let r=i??Vc(e),{x:o,y:s,z:c}=r.center;r.radius>=0&&(n=Bc(a,o,s,c,r.radius,t))}else if(r!==void 0){let e=Nc(r);if(e!==null){let[r,i,o]=e.center;n=Bc(a,r,i,o,e.radius,t)}}for(let r of e.children){let e=Ac(r,t);e>n&&(n=e)}return n}function jc(e){e.traverse(e=>{let{geometry:t}=e,n=e;n.boundingBox!==void 0&&(n.boundingBox=null),n.boundingSphere!==void 0&&(n.boundingSphere=null),t!==void 0&&(hc(t),t.boundingSphere=null,t.boundingBox=null)})}function Mc(e){let t=[];return e.traverseVisible(e=>{let{isMesh:n,geometry:r}=e,i=n===!0&&r!==void 0?Nc(r):null;if(i===null)return;let a=e.matrixWorld.elements,{center:o,radius:s}=i;t.push({extremes:i,matrix:a,center:Lc(a,...o),radius:s*zc(a)})}),t}var Nc=e=>`position`in e.attributes?pc(e):null;function Pc(e,t){let n=0;for(let{extremes:r,matrix:i,center:a,radius:o}of t){if(Rc(e,...a)+o<=n*1.000000001)continue;let{length:t}=r.points,s=Ic(r.points,t,i);for(let r=0;r<t;r+=3)n=Math.max(n,Rc(e,s[r],s[r+1],s[r+2]))}return n}var Fc=new Float64Array;function Ic(e,t,n){Fc.length<t&&(Fc=new Float64Array(t));for(let r=0;r<t;r+=3){let[t,i,a]=[e[r],e[r+1],e[r+2]];Fc[r]=n[0]*t+n[4]*i+n[8]*a+n[12],Fc[r+1]=n[1]*t+n[5]*i+n[9]*a+n[13],Fc[r+2]=n[2]*t+n[6]*i+n[10]*a+n[14]}return Fc}var Lc=(e,t,n,r)=>[e[0]*t+e[4]*n+e[8]*r+e[12],e[1]*t+e[5]*n+e[9]*r+e[13],e[2]*t+e[6]*n+e[10]*r+e[14]],Rc=([e,t,n],r,i,a)=>Math.sqrt((r-e)**2+(i-t)**2+(a-n)**2);function zc(e){let t=(t,n)=>Math.abs(e[t]*e[n]+e[t+1]*e[n+1]+e[t+2]*e[n+2]),[n,r,i]=[t(0,4),t(0,8),t(4,8)];return Math.sqrt(Math.max(t(0,0)+n+r,t(4,4)+n+i,t(8,8)+r+i))}function Bc(e,t,n,r,i,a){let o=Rc(a,...Lc(e,t,n,r))+i*zc(e);return Number.isFinite(o)?o:0}function Vc(e){let t=e;return t.computeBoundingSphere(),t.boundingSphere}var Hc=class{#e;#t;#n={target:`auto`,radius:`auto`};#r=Oc;#i=null;#a=!0;#o=!0;#s=null;#c=1;constructor(e,t){this.#e=e,this.#t=t}get framing(){return this.#n}set framing(e){this.#n=e,this.#o=!0}get bounds(){return this.#i}depthBounds(){let e=this.#i?.centre??Uc,t=Ac(this.#e.scene,e),n=this.#s;return(n===null||n.centre!==e||n.radius!==t)&&(this.#s=t===0&&this.#i===null?null:{centre:e,radius:t}),this.#s}reshaped(){this.#a=!0,this.#o=!0}resized(e,t){e>0&&t>0&&(this.#c=e/t),this.#o=!0}fovChanged(){this.#o=!0}settle(e){return this.#a&&this.#l(),this.#o?(this.#o=!1,this.#u(e)):!1}#l(){this.#a=!1,this.#e.update(),this.#r=kc(this.#e.scene);let{center:e}=this.#r;this.#i=this.#r.empty?null:{centre:e,radius:this.#r.radiusAbout(e)}}#u(e){if(this.#n===null)return!1;let{target:t,radius:n}=this.#n,r=nc(this.#i,e,this.#c),i=t===`auto`?r.target:t,a=t===`auto`||this.#r.empty?r.radius:rc(this.#r.radiusAbout(t),e,this.#c),o=this.#t.version;return this.#t.set({target:i,radius:n===`auto`?a:n}),this.#t.version!==o}},Uc=[0,0,0],Wc=class{#e;#t=new Set;#n=new Set;#r=0;#i=null;constructor(e){this.#e=e}request(e){e!==this.#i&&(this.#i=e,this.#t.add(e),this.#r===0&&(this.#r=this.#e.requestAnimationFrame(this.#a)))}cancel(e){this.#t.delete(e),e===this.#i&&(this.#i=null),this.#t.size>0||this.#r===0||(this.#e.cancelAnimationFrame(this.#r),this.#r=0)}#a=e=>{this.#r=0,this.#i=null,[this.#t,this.#n]=[this.#n,this.#t],this.#o(e=>{e.prepare()}),this.#o(t=>{t.advance(e)&&this.request(t)}),this.#o(e=>{e.draw()}),this.#n.clear()};#o(e){for(let t of this.#n)try{e(t)}catch(e){reportError(e)}}},Gc=new WeakMap;function Kc(e){let t=Gc.get(e)??new Wc(e);return Gc.set(e,t),t}var qc=1e-9;function Jc(e,t,n,r){return e===`double`||Yc(n)?!1:e===`single`||Xc(t,n,r)}function Yc({elements:e}){let[t,n,r,i,a,o,s,c,l]=[e[0],e[1],e[2],e[4],e[5],e[6],e[8],e[9],e[10]],u=t*(a*l-o*c)-i*(n*l-r*c)+s*(n*o-r*a),d=(t*t+n*n+r*r)*(i*i+a*a+o*o)*(s*s+c*c+l*l);return!(u*u>qc*qc*d)}function Xc(e,t,n){e.boundingBox===null&&e.computeBoundingBox(),e.boundingSphere===null&&e.computeBoundingSphere();let{boundingBox:r,boundingSphere:i}=e;if(r===null||i===null||r.isEmpty())return!1;let{elements:a}=t,{elements:o}=n.matrixWorld,[s,c,l]=[o[8],o[9],o[10]],u=(r.min.x+r.max.x)/2,d=(r.min.y+r.max.y)/2,f=(r.min.z+r.max.z)/2,p=o[12]-(a[0]*u+a[4]*d+a[8]*f+a[12]),m=o[13]-(a[1]*u+a[5]*d+a[9]*f+a[13]),h=o[14]-(a[2]*u+a[6]*d+a[10]*f+a[14]),g=e=>a[e]*s+a[e+1]*c+a[e+2]*l,[_,v,y]=[g(0),g(4),g(8)],b=(r.max.x-r.min.x)/2,x=(r.max.y-r.min.y)/2,S=(r.max.z-r.min.z)/2,C=Math.hypot(i.center.x-u,i.center.y-d,i.center.z-f),w=(i.radius+C)*Math.sqrt(_*_+v*v+y*y),T=b*Math.abs(_)+x*Math.abs(v)+S*Math.abs(y);if(p*s+m*c+h*l-Math.min(w,T)>$c(n))return!0;let E=el(n);return Zc(a,4,8,0,b,p,m,h,E)||Zc(a,8,0,4,x,p,m,h,E)||Zc(a,0,4,8,S,p,m,h,E)}function Zc(e,t,n,r,i,a,o,s,c){let l=e[t+1]*e[n+2]-e[t+2]*e[n+1],u=e[t+2]*e[n]-e[t]*e[n+2],d=e[t]*e[n+1]-e[t+1]*e[n],f=Math.sqrt(l*l+u*u+d*d),p=i*Math.abs(l*e[r]+u*e[r+1]+d*e[r+2]);return Math.abs(l*a+u*o+d*s)>p+c*f}var Qc=({projectionMatrix:e})=>e.elements[11]!==0;function $c(e){let t=e.projectionMatrix.elements;return Qc(e)?t[14]/(t[10]+t[11]):(t[14]+1)/t[10]}function el(e){let t=e.projectionMatrix.elements,n=$c(e),r=Qc(e),i=r?n:1,a=r?-t[11]:1,o=i*(a+Math.abs(r?t[8]:t[12]))/t[0],s=i*(a+Math.abs(r?t[9]:t[13]))/t[5];return Math.sqrt(n*n+o*o+s*s)}function tl(e,t){let n=e.elements,r=Math.max(Math.abs(n[0]),Math.abs(n[1]),Math.abs(n[2]),Math.abs(n[4]),Math.abs(n[5]),Math.abs(n[6]),Math.abs(n[8]),Math.abs(n[9]),Math.abs(n[10]));if(!(r>0)){t.set(0,0,0,0,0,0,0,0,0);return}let i=n[0]/r,a=n[1]/r,o=n[2]/r,s=n[4]/r,c=n[5]/r,l=n[6]/r,u=n[8]/r,d=n[9]/r,f=n[10]/r,p=c*f-l*d,m=l*u-s*f,h=s*d-c*u,g=d*o-f*a,_=f*i-u*o,v=u*a-d*i,y=a*l-o*c,b=o*s-i*l,x=i*c-a*s,S=i*p+a*m+o*h,C=Math.max(Math.abs(p),Math.abs(m),Math.abs(h),Math.abs(g),Math.abs(_),Math.abs(v),Math.abs(y),Math.abs(b),Math.abs(x)),w=C>0?S<0?-C:C:1;t.set(p,g,y,m,_,b,h,v,x);let{elements:T}=t;for(let e=0;e<9;e++)T[e]=(T[e]??0)/w}var nl=20,rl=4,il=32,al=new WeakSet,ol=0,sl=class{#e=new Map;#t=0;#n={now:0,before:0};#r=null;#i=null;begin(){this.#t+=1,this.#n={now:ol,before:this.#n.now},this.#i===null?this.#r!==null&&this.#s():this.#c(this.#i),this.#r=null}choose(e,t,n){let r=this.#e.get(e)??this.#a(e),i=r.frame!==this.#t,a=r.frame===this.#t-1;r.frame=this.#t;let{state:o}=r;if(o.name===`specialised`)return o.probe.variant;if(o.name===`linked`)return this.#l(r,o.probe);if(o.name===`general`&&i){let e=a?o.frames+1:1;r.state={name:`general`,frames:e},e>=nl&&(this.#r??={entry:r,drawing:t,specialise:n})}return null}dispose(){for(let e of this.#e.values())ul(e);this.#e.clear(),this.#i=null,this.#r=null}#a(e){this.#e.size>=il&&this.#o();let t={state:{name:`general`,frames:0},frame:-1};return this.#e.set(e,t),t}#o(){for(let[e,t]of this.#e)t.frame>=this.#t-1||(this.#i===t&&(this.#i=null),ul(t),this.#e.delete(e))}#s(){let{entry:e,drawing:t,specialise:n}=this.#r,{renderer:r,camera:i,mesh:a}=t,o=n(),s=new st({...ll(o),glslVersion:Ee}),c={material:s,variant:o,renderer:r};r.compile(new Et(a.geometry,s),i);let l=dl(c);l!==void 0&&al.add(l),e.state={name:`compiling`,probe:c,frames:0},this.#i=e}#c(e){let{state:t}=e;if(t.name!==`compiling`)return;let{probe:n,frames:r}=t,{renderer:i}=n,a=dl(n),o=i.extensions.has(`KHR_parallel_shader_compile`);if(a!==void 0&&!(o?a.isReady():r>=rl)){e.state={...t,frames:r+1};return}this.#i=null;let s=i.getContext();if(a===void 0||s.isContextLost()){e.state={name:`general`,frames:0};return}let c=s.getProgramParameter(a.program,s.LINK_STATUS)===!0;al.delete(a),c||(cl(s,a.program),ul(e)),e.state=c?{name:`linked`,probe:n}:{name:`failed`}}#l(e,t){return ol===this.#n.before?(ol+=1,e.state={name:`specialised`,probe:t},t.variant):null}};function cl(e,t){let n=e.getAttachedShaders(t)??[],r=[e.getProgramInfoLog(t),...n.map(t=>e.getShaderInfoLog(t))].filter(e=>e!==null&&e!==``).join(`
`);reportError(Error(`PhongMaterial: a program does not link: ${r}`))}var ll=({defines:e,vertexShader:t,fragmentShader:n})=>({defines:{...e},vertexShader:t,fragmentShader:n});function ul({state:e}){`probe`in e&&e.probe.material.dispose()}var dl=({renderer:e,material:t})=>e.properties.get(t).currentProgram,fl=class{#e;#t;#n=null;#r=[];#i=new Set;#a=!0;#o=null;#s=null;#c={featureVersion:-1,capacity:-1};#l=``;#u={materialKey:``,form:``,lights:``,key:``};constructor(e,t){this.#e=e,this.#t=t}describe(e,{ks:t,shininess:n}){this.#n=e,this.#r=e.terms.filter(e=>e!==`specular`||!N(t));let r=ml(this.#t,e);this.#o=!r&&ee(n)?n:null,(r||!k(n))&&(this.#a=!1),this.#s=null}choose(e){let t=this.#e,n=this.#f(t.capacityFor(e.renderer)),r=t.lightsOf(e.mesh);if(this.#t.unlit)return{variant:n,lights:r};let i=t.gridOf(e.mesh),a=t.formFor(r,i);if(a===null)return{variant:n,lights:r};let o=t.programs.choose(this.#d(a,r),e,()=>Nr(n,{terms:this.#r,integerShininess:this.#o},a,r.packed));return o===null?{variant:n,lights:r}:{variant:o,lights:i??r}}#d(e,{contentKey:t,featureKey:n}){let r=e===`inlined`?t:n,i=this.#l,a=this.#u;if(a.materialKey===i&&a.form===e&&a.lights===r)return a.key;let o=`${i} ${e} ${r}`;return this.#u={materialKey:i,form:e,lights:r,key:o},o}#f(e){let t=this.#e,{featureVersion:n}=t,r=this.#c;if(this.#s!==null&&r.featureVersion===n&&r.capacity===e)return this.#s;for(let e of this.#r)this.#i.add(e);let i=this.#t,{vertexColors:a,alphaMode:o,unlit:s}=i,c=this.#n;return this.#s=Ar({...c,terms:[...this.#i],linear:t.linear,shininessTo64:this.#a,vertexColors:a,alphaMode:o,unlit:s,emissive:pl(i),metalness:!s&&i.metalness>0,roughness:ml(i,c),maps:hl(i,c)},t.declared,e),this.#c={featureVersion:n,capacity:e},this.#l=`${this.#s.key} ${this.#r.join()} ${String(this.#o)}`,this.#s}},pl=({unlit:e,emissive:t})=>!e&&!N(t),ml=({unlit:e,roughness:t,metalRoughMap:n},{shading:r})=>!e&&t!==null&&n!==null&&r!==`gouraud`;function hl(e,t){let{map:n,emissiveMap:r,metalRoughMap:i,normalMap:a,unlit:o,metalness:s}=e,c={};return n!==null&&(c.map=n.channel),r!==null&&pl(e)&&(c.emissiveMap=r.channel),i!==null&&(!o&&s>0||ml(e,t))&&(c.metalRoughMap=i.channel),a!==null&&!o&&t.shading===`phong`&&(c.normalMap=a.channel),c}var gl={baseColor:[1,1,1],opacity:1,alphaMode:`opaque`,alphaCutoff:.5,map:null,vertexColors:!1,...dr},_l={shading:`phong`,reflection:`phong`,terms:Or,antialias:`edges`},vl={ka:kn.ka.fallback,kd:kn.kd.fallback,ks:kn.ks.fallback,shininess:kn.shininess.fallback},yl=[0,0,0],bl=new WeakMap,xl=class e extends st{sides=`double`;look;#e;#t=vl;#n=_l;#r;#i=!1;#a=null;#o=new Qe;#s=null;#c=0;#l;constructor(e,t=gl){let n={...gl,...t},r={...Sl(n),uModelToShading:{value:new Qe},uNormalToShading:{value:new X},uEye:e.eye,uShadingToClip:e.clip,uKa:{value:new K},uKd:{value:new K},uKs:{value:new K},uShininess:{value:0},uOpacity:{value:n.opacity},uAlphaCutoff:{value:n.alphaCutoff},uLightRows:{value:new Float32Array(4),needsUpdate:!0},uLightTexture:{value:null},uLightTextureScale:{value:new kt}};super({uniforms:r,glslVersion:Ee,side:2,vertexColors:n.vertexColors,premultipliedAlpha:!0,blending:1,transparent:n.alphaMode===`blend`,toneMapped:!1}),this.#l=r,this.#e=e,this.look=n,this.#r=new fl(e,n),this.#p()}get surface(){return this.#t}get style(){return this.#n}get linear(){return this.#e.linear}setSurface(e){let{ka:t,kd:n,ks:r,shininess:i}={...this.#t,...e};this.#t={ka:kn.ka.check(t),kd:kn.kd.check(n),ks:kn.ks.check(r),shininess:kn.shininess.check(i)},this.#p()}setStyle(e){this.#n={...this.#n,...e},this.#p()}clone(){let t=new e(this.#e,this.look);return Ct.prototype.copy.call(t,this),t.sides=this.sides,t.setStyle(this.#n),t.setSurface(this.#t),t}onBeforeRender(...[e,,t,n,r]){let i=r,a=Jc(this.sides,n,i.matrixWorld,t);this.side=a?0:2,this.#i!==this.linear&&this.#p();let{variant:o,lights:s}=this.#r.choose({renderer:e,camera:t,mesh:i});this.#d(o);let{uLightRows:c,uLightTexture:l,uLightTextureScale:u}=this.#l,d=o.defines.LIGHT_STORAGE;d!==`STORAGE_INLINED`&&this.#e.countUpload(s),c.needsUpdate=d===`STORAGE_UNIFORMS`&&!this.#u(e,s),c.needsUpdate&&(c.value=s.rows),d===`STORAGE_TEXTURE`&&(l.value=s.sendTexture(e),u.value.copy(s.textureScale));let f=this.#f(i),p=this.#e.aim(t);this.uniformsNeedUpdate=!f||p!==this.#c||c.needsUpdate,this.#c=p}dispose(){super.dispose(),bl=new WeakMap}#u({properties:e},{contentKey:t}){let n=bl.get(e);n===void 0&&bl.set(e,n=new Map);let r=this.#a?.key??``;return n.get(r)===t||(n.set(r,t),!1)}#d(e){e.key!==this.#a?.key&&(this.#a=e,Object.assign(this,ll(e)),this.needsUpdate=!0)}#f(e){let{origin:t}=this.#e,n=this.#o.copy(e.matrixWorld),r=n.elements;r[12]-=t[0],r[13]-=t[1],r[14]-=t[2];let{uModelToShading:i,uNormalToShading:a,uMirrored:o}=this.#l,s=i.value;s.equals(n)||(tl(s.copy(n),a.value),o.value=n.determinant()<0?-1:1);let c=e===this.#s;return this.#s=e,c}#p(){let{uKa:e,uKd:t,uKs:n,uShininess:r,uBaseColor:i,uEmissive:a,uLobeScale:o}=this.#l,{look:s}=this,c=this.#i=this.linear,{terms:l}=this.#n,{ka:u,kd:d,ks:f,shininess:p}=this.#t,m=(e,t,n,r)=>{let i=e=>c?me(n[e]/255)*me(r[e]):n[e]/255*r[e];l.includes(t)?e.set(i(0),i(1),i(2)):e.set(...yl)};m(e.value,`ambient`,u,s.baseColor),m(t.value,`diffuse`,d,s.baseColor),m(n.value,`specular`,f,gl.baseColor),r.value=p;let h=e=>c?ge(e,me):e;i.value.set(...h(s.baseColor)),a.value.set(...h(s.emissive)),o.value=s.roughness===null?1:mr(p),!(s.metalness>0)&&!ml(s,this.#n)&&n.value.multiplyScalar(o.value),this.#r.describe(this.#n,this.#t)}};function Sl(e){let{map:t,emissiveMap:n,metalRoughMap:r,normalMap:i}=e,a=e=>({value:e?.matrix??new X});return{uMap:{value:t},uMapTransform:a(t),uEmissiveMap:{value:n},uEmissiveMapTransform:a(n),uMetalRoughMap:{value:r},uMetalRoughMapTransform:a(r),uNormalMap:{value:i},uNormalMapTransform:a(i),uNormalScale:{value:e.normalScale},uMirrored:{value:1},uBaseColor:{value:new K},uEmissive:{value:new K},uMetalness:{value:e.metalness},uRoughness:{value:e.roughness??1},uLobeScale:{value:1}}}function Cl(e,t,n,r=[]){if(!e.visible)return r;let{material:i,geometry:a,isMesh:o}=e;if((i===void 0||Array.isArray(i)||i.visible)&&e.layers.test(t.layers)){let t=i instanceof xl?i:null,s=o===!0&&t!==null?n(e):void 0;r.push({object:e,matrixWorld:e.matrixWorld.clone(),geometry:a,material:i,owner:s,phong:s===void 0||t===null?null:wl(t)})}for(let i of e.children)Cl(i,t,n,r);return r}var wl=({look:e,sides:t,surface:n,style:r,linear:i})=>({look:e,sides:t,surface:n,style:r,linear:i}),Tl=({origin:e,eye:t,right:n,up:r,back:i})=>({origin:e,eye:[...t],right:[...n],up:[...r],back:[...i]}),El=1e-5,Dl=6,Ol=class{#e=0;#t=0;#n=0;#r=0;#i=0;#a=0;#o=0;#s=1;#c=!0;read({data:e},t){let n=(t+z.spot.position)*4,r=(t+z.spot.axis)*4;this.#e=e[n],this.#t=e[n+1],this.#n=e[n+2],this.#r=e[r],this.#i=e[r+1],this.#a=e[r+2];let i=e[(t+z.spot.ambient)*4+3],a=Math.abs(i);return this.#c=i===4,this.#o=2*Math.sqrt(Math.max(a*(1-a),0)),this.#s=(i<0?-1:1)*(1-2*a),this}reaches(e,t,n,r,i,a,o=Dl){if(this.#c)return!0;let s=r-e,c=i-t,l=a-n,u=e+s/2,d=t+c/2,f=n+l/2,p=kl(s,c,l)/2,m=this.#l(u,d,f)-this.#f(u,d,f,p);if(m>p)return!1;if(o===0||m<=0)return!0;let h=o-1;return s>=c&&s>=l?this.reaches(e,t,n,u,i,a,h)||this.reaches(u,t,n,r,i,a,h):c>=l?this.reaches(e,t,n,r,d,a,h)||this.reaches(e,d,n,r,i,a,h):this.reaches(e,t,n,r,i,f,h)||this.reaches(e,t,f,r,i,a,h)}#l(e,t,n){let r=this.#u(e,t,n),i=this.#d(e,t,n),a=i*this.#s-r*this.#o;return a>0&&r*this.#s+i*this.#o<0?kl(e-this.#e,t-this.#t,n-this.#n):a}#u(e,t,n){return(e-this.#e)*this.#r+(t-this.#t)*this.#i+(n-this.#n)*this.#a}#d(e,t,n){let[r,i,a]=[e-this.#e,t-this.#t,n-this.#n],[o,s,c]=[this.#r,this.#i,this.#a];return kl(i*c-a*s,a*o-r*c,r*s-i*o)}#f(e,t,n,r){return El*(Math.abs(this.#e)+Math.abs(this.#t)+Math.abs(this.#n)+Math.abs(e)+Math.abs(t)+Math.abs(n)+r)+le}},kl=(e,t,n)=>Math.sqrt(e*e+t*t+n*n);function Al(e,t,n){let{directional:r,point:i}=e.counts,a=r+i;n.fill(1,0,e.sent);let o=e.sent,s=R.rows+r*z.directional.rows+i*z.point.rows;for(let r=a;r<e.sent;r++,s+=z.spot.rows)jl.read(e,s).reaches(t[0],t[1],t[2],t[3],t[4],t[5])||(n[r]=0,--o);return o}var jl=new Ol,Ml=4096,Nl=.5,Pl={cell:.001,coordinate:1e-6};function Fl(e,t,n){let{directional:r,point:i,spot:a}=e.counts;if(a<24||r+i>e.sent/2)return!1;let o=Il(t),s=o.size[0]*o.size[1]*o.size[2];if(s<2)return!1;let c=new Int32Array(Math.floor(s*Nl)),l=[],u=0,d=r+i,f=()=>d+u/s>e.sent/2;return Un(e,(t,n,r)=>{if(n!==`spot`||f())return;let i=Ll(e,r,o,c);i===null?d+=1:u+=i.length,l.push({light:t,row:r,cells:i})}),!f()&&(zl(Rl(e,l,n),o,s,u,n),!0)}function Il(e){let t=[e[3]-e[0],e[4]-e[1],e[5]-e[2]],n=Math.max(...t),r=n/Ml,i=e=>Math.max(1,Math.floor(e/r)),a=()=>i(t[0])*i(t[1])*i(t[2])<=Ml;if(!(n>0))r=1;else for(;!a();)r*=1.02;let o=[i(t[0]),i(t[1]),i(t[2])],s=Math.max(...e.map(Math.abs));return{box:e,size:o,step:[t[0]/o[0],t[1]/o[1],t[2]/o[2]],pad:Pl.cell*r+Pl.coordinate*s}}function Ll(e,t,{box:n,size:r,step:i,pad:a},o){let s=new Ol().read(e,t),c=0,l=(e,t,u,d,f,p)=>{if(c>o.length)return;let m=n[0]+e*i[0]-a,h=n[1]+t*i[1]-a,g=n[2]+u*i[2]-a,_=n[0]+d*i[0]+a,v=n[1]+f*i[1]+a,y=n[2]+p*i[2]+a;if(!s.reaches(m,h,g,_,v,y,0))return;let b=d-e,x=f-t,S=p-u;b===1&&x===1&&S===1?(c<o.length&&(o[c]=e+r[0]*(t+r[1]*u)),c+=1):b>=x&&b>=S?(l(e,t,u,e+(b>>1),f,p),l(e+(b>>1),t,u,d,f,p)):x>=S?(l(e,t,u,d,t+(x>>1),p),l(e,t+(x>>1),u,d,f,p)):(l(e,t,u,d,f,u+(S>>1)),l(e,t,u+(S>>1),d,f,p))};return l(0,0,0,r[0],r[1],r[2]),c>o.length?null:o.slice(0,c)}function Rl(e,t,n){let{directional:r,point:i}=e.counts,a=r+i,o=R.rows+r*z.directional.rows+i*z.point.rows;Gn(n,e.rows,e.sent),n.data.set(e.data.subarray(0,o*4)),n.features.set(e.features.subarray(0,a)),n.active=e.active,n.sent=e.sent,n.rows=e.rows,Object.assign(n.counts,e.counts);let s=[...t.filter(({cells:e})=>e===null),...t.filter(({cells:e})=>e!==null)],{rows:c}=z.spot;return s.map(({light:t,row:r,cells:i},s)=>{let l=o+s*c;return n.data.set(e.data.subarray(r*4,(r+c)*4),l*4),n.features[a+s]=e.features[t],{light:a+s,row:l,cells:i}})}function zl(e,{box:t,size:n,step:r},i,a,o){let s=o.rows,c=s+fe.rows,l=c+i;o.rows=l+Math.ceil(a/4),Gn(o,o.rows,o.sent);let{data:u}=o;u.fill(0,s*4,o.rows*4);let d=(e,t)=>u.set(t,e*4);u[R.counts*4+3]=s,d(s+fe.low,[t[0],t[1],t[2],c]),d(s+fe.scale,[...r.map(e=>e>0?1/e:0),l]),d(s+fe.size,[...n,e.filter(({cells:e})=>e===null).length]);let f=e=>(c+e)*4;for(let{cells:t}of e)for(let e of t??[])u[f(e)+1]+=1;let p=new Int32Array(i),m=0;for(let e=0;e<i;e++)u[f(e)]=m,p[e]=m,m+=u[f(e)+1];for(let{row:t,cells:n}of e)for(let e of n??[])u[l*4+p[e]]=t,p[e]+=1}var Bl=1024,Vl=0,Hl=class{packed;#e=new Float32Array(Bl*4);#t=this.#e.subarray(0,0);#n=0;#r=0;#i=[];#a=``;#o=``;#s=Vl+=1;#c=new G;#l=null;#u={from:0,to:0};constructor(e=An()){this.packed=e}textureScale=new kt(1/Bl,1);get version(){return this.#r}get featureKey(){return this.#a}get contentKey(){return this.#o}get rows(){return this.#t}changed(){let{data:e,rows:t}=this.packed;t*4>this.#e.length&&this.#p(t);let n=t*4,r=this.#e;this.#t.length!==n&&(this.#t=r.subarray(0,n)),this.#n=Math.max(this.#n,t);let i=0;for(;i<n&&r[i]===e[i];)i+=1;if(i===n)return;let a=n-1;for(;r[a]===e[a];)--a;for(let t=i;t<=a;t++)r[t]=e[t];this.#r+=1,this.#o=`${String(this.#s)}:${String(this.#r)}`,this.#f(i>>2,(a>>2)+1),this.#d()}sendTexture(e){let{from:t,to:n}=this.#u,{state:r,properties:i}=e,a=this.#l?.properties!==i;if(t===n&&!a)return this.#c;this.#u={from:0,to:0};let o=e.getContext();return a&&(this.dispose(),this.#c.sourceTexture=o.createTexture(),this.#l={renderer:e,properties:i}),r.bindTexture(o.TEXTURE_2D,this.#c.sourceTexture),a&&(o.texParameteri(o.TEXTURE_2D,o.TEXTURE_MIN_FILTER,o.NEAREST),o.texParameteri(o.TEXTURE_2D,o.TEXTURE_MAG_FILTER,o.NEAREST),o.texStorage2D(o.TEXTURE_2D,1,o.RGBA32F,Bl,this.#e.length/(Bl*4))),r.pixelStorei(o.UNPACK_FLIP_Y_WEBGL,!1),r.pixelStorei(o.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),r.pixelStorei(o.UNPACK_ALIGNMENT,4),Ul(o,this.#e,a?0:t,a?this.#n:n),this.#c}dispose(){let e=this.#l;e!==null&&e.properties===e.renderer.properties&&e.renderer.getContext().deleteTexture(this.#c.sourceTexture),this.#c.sourceTexture=null,this.#l=null}#d(){let{packed:e}=this,t=Rr(e,-1),n=j.flatMap(n=>[e.counts[n],t[n]]);n.every((e,t)=>e===this.#i[t])||(this.#i=n,this.#a=n.join())}#f(e,t){let{from:n,to:r}=this.#u;this.#u=n<r?{from:Math.min(e,n),to:Math.max(t,r)}:{from:e,to:t}}#p(e){let t=Math.ceil(Math.max(e*4,this.#e.length*2)/(Bl*4));this.textureScale.y=1/t;let n=new Float32Array(t*Bl*4);n.set(this.#e),this.#e=n,this.#t=n.subarray(0,0),this.dispose()}};function Ul(e,t,n,r){let i=n>>10,a=Math.ceil(r/Bl)-i,o=a===1?n-i*Bl:0,s=a===1?r-n:Bl,c=(i*Bl+o)*4;e.texSubImage2D(e.TEXTURE_2D,0,o,i,s,a,e.RGBA,e.FLOAT,t,c)}var Wl=class{all=new Hl;#e=new Map;#t=new Set;#n=new WeakMap;#r=0;#i=0;#a=[0,0,0];#o=new Uint8Array(64);begin(e){for(let[e,t]of this.#e)t.frame!==this.#i&&(t.buffer.dispose(),this.#e.delete(e));for(let e of this.#t)e.frame!==this.#i&&(e.dispose(),this.#t.delete(e));this.#i+=1,this.#a=e}changed(){this.all.changed(),this.#r+=1}of(e){if(this.all.packed.counts.spot===0)return this.all;let t=this.#s(e),{subset:n}=t;return n!==null&&n.version===this.#r&&(n.frame=this.#i),t.buffer}gridOf(e){if(this.all.packed.counts.spot<24||this.of(e).packed.counts.spot<24)return null;let t=this.#s(e),n=t.grid??=new ql;return n.frame=this.#i,this.#t.add(n),n.of(t)}reaches(e,t){return this.of(e)===this.all||this.#s(e).mask[t]===1}dispose(){this.all.dispose();for(let{buffer:e}of this.#e.values())e.dispose();for(let e of this.#t)e.dispose()}#s(e){let t=this.#n.get(e);t===void 0&&this.#n.set(e,t=new Gl(e,this.all));let n=t.moved(this.#a),r=t.subset===null||this.#e.get(t.subset.key)===t.subset;return(n||!r||t.version!==this.#r)&&this.#c(t),t}#c(e){let{packed:t}=this.all;if(e.version=this.#r,e.changes+=1,e.subset=null,e.buffer=this.all,e.box===null)return;this.#o.length<t.sent&&(this.#o=new Uint8Array(t.features.length));let n=this.#o.subarray(0,t.sent);Al(t,e.box,n)!==t.sent&&(e.mask=n.slice(),e.subset=this.#l(e.mask),e.buffer=e.subset.buffer)}#l(e){let t=Jl.decode(e),n=this.#e.get(t);return n===void 0&&(n={key:t,buffer:new Hl,version:-1,frame:0},this.#e.set(t,n)),n.frame=this.#i,n.version===this.#r||(n.version=this.#r,Wn(this.all.packed,e,n.buffer.packed),n.buffer.changed()),n}},Gl=class{#e;buffer;subset=null;mask=new Uint8Array;version=-1;changes=0;grid=null;#t=null;#n=[0,0,0];#r=new Qe;#i=null;constructor(e,t){this.#e=e,this.buffer=t}get box(){return this.#i}moved(e){let{geometry:t,matrixWorld:n}=this.#e,[r,i,a]=this.#n;return this.#t===t&&r===e[0]&&i===e[1]&&a===e[2]&&this.#r.equals(n)?!1:(this.#t=t,this.#n=[e[0],e[1],e[2]],this.#r.copy(n),this.#i=Xl(this.#e,e),!0)}},Kl=63,ql=class{frame=0;#e=new Hl;#t=-1;#n=!1;#r=0;#i=0;of({buffer:e,box:t,changes:n}){return n!==this.#t&&(this.#t=n,this.#n=!1,this.#r>0?--this.#r:t!==null&&this.#a(e,t)),this.#n?this.#e:null}dispose(){this.#e.dispose()}#a({packed:e},t){this.#n=Fl(e,t,this.#e.packed),this.#n&&this.#e.changed(),this.#i=this.#n?0:Math.min(2*this.#i+1,Kl),this.#r=this.#i}},Jl=new TextDecoder(`latin1`),Yl=new Xe;function Xl({geometry:e,matrixWorld:t},n){if(e.boundingBox===null&&e.computeBoundingBox(),e.boundingBox===null)return null;let{min:r,max:i}=Yl.copy(e.boundingBox).applyMatrix4(t),a=[r.x-n[0],r.y-n[1],r.z-n[2],i.x-n[0],i.y-n[1],i.z-n[2]];return a.every((e,t)=>Number.isFinite(e)&&(t<3||e>=a[t-3]))?a:null}var Zl=16,Ql=16,$l=[200,1e3],eu=24,tu=class{lights;eye={value:new K};clip={value:new Qe};declared=ie();programs=new sl;#e=new Wl;#t=!1;#n=[0,0,0];#r=0;#i=-1;#a=-1;#o=!1;#s=!1;#c=0;#l=null;#u=0;#d=new WeakMap;#f=new Qe;#p=null;#m=0;#h={view:new Qe,projection:new Qe};#g=cu();#_=cu();constructor(e=new Ws){this.lights=e}get linear(){return this.#t}set linear(e){e!==this.#t&&(this.#t=e,this.#i=-1,this.#r+=1)}get origin(){return this.#n}get featureVersion(){return this.#r}get packed(){return this.#e.all.packed}get uploads(){return this.#u}update(e,t=[0,0,0]){let n=e.matrixWorld.elements;this.updateFrame({origin:t,eye:[n[12]-t[0],n[13]-t[1],n[14]-t[2]],right:[n[0],n[1],n[2]],up:[n[4],n[5],n[6]],back:[n[8],n[9],n[10]]})}updateFrame(e,t=null){let{origin:n,eye:r,right:i,up:a,back:o}=e;this.#p=t,this.#f.set(i[0],i[1],i[2],-ve(i,r),a[0],a[1],a[2],-ve(a,r),o[0],o[1],o[2],-ve(o,r),0,0,0,1);let s=this.#n,c=n[0]!==s[0]||n[1]!==s[1]||n[2]!==s[2];if(this.#n=[n[0],n[1],n[2]],this.eye.value.set(r[0],r[1],r[2]),this.#e.begin(this.#n),this.programs.begin(),this.#y(),this.#o=!1,this.#i===this.lights.version&&!c&&!this.#s)return;this.#i=this.lights.version,lu(this.#g,au,ou,su,[-n[0],-n[1],-n[2]]),lu(this.#_,e.right,e.up,e.back,r);let l={worldToShading:this.#g,cameraToShading:this.#_,linear:this.#t},{all:u}=this.#e,{version:d}=u;jn(this.lights.values,l,u.packed),this.#e.changed(),this.#o=u.version!==d}aim(e){let{view:t,projection:n}=this.#h,r=e===this.#p?this.#f:this.#v(e);return t.equals(r)&&n.equals(e.projectionMatrix)?this.#m:(t.copy(r),n.copy(e.projectionMatrix),this.clip.value.multiplyMatrices(n,t),this.#m+=1)}lightsOf(e){return this.#e.of(e)}gridOf(e){return this.#e.gridOf(e)}countReaching(e){let t=[...e],{sent:n}=this.packed;if(t.length===0)return n;let r=0;for(let e=0;e<n;e++)t.some(t=>this.#e.reaches(t,e))&&(r+=1);return r}capacityFor(e){this.#l?.renderer!==e&&(this.dispose(),this.#l=ru(e),this.#c=0);let{rows:t}=this.packed,{capacities:n}=this.#l;for(;t>(n[this.#c]??1/0);)this.#c+=1,this.#r+=1;return n[this.#c]??0}formFor(e,t){if(this.#l===null)return null;if(t!==null)return`grid`;let{sent:n}=e.packed,{software:r,capacities:i}=this.#l;return r?n<=Zl&&!this.#o?`inlined`:null:n<=Ql&&this.#c<i.length?`counted`:null}countUpload(e){this.#d.get(e)!==e.version&&(this.#d.set(e,e.version),this.#u+=1)}dispose(){this.#e.dispose(),this.programs.dispose(),this.#l=null}#v({matrixWorldInverse:e}){let[t,n,r]=this.#n;return iu.makeTranslation(t,n,r).premultiply(e)}#y(){let{kindVersion:e,values:t}=this.lights;if(this.#a===e)return;this.#a=e,this.#s=!1;let n=!1;for(let e of t)E(e,this.declared)&&(n=!0),e.active&&e.space===`camera`&&(this.#s=!0);n&&(this.#r+=1)}},nu=new WeakMap;function ru(e){let t=nu.get(e);if(t!==void 0)return t;let n=e.getContext(),r=n.getExtension(`WEBGL_debug_renderer_info`),i=String(n.getParameter(r?.UNMASKED_RENDERER_WEBGL??n.RENDERER)),a=Math.min(n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS)),o=/swiftshader|llvmpipe|softpipe|software|basic render/i.test(i),s={renderer:e,software:o,capacities:o?[]:$l.filter(e=>e<=a-eu)};return nu.set(e,s),s}var iu=new Qe,au=[1,0,0],ou=[0,1,0],su=[0,0,1],cu=()=>new Float64Array([1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]);function lu(e,t,n,r,i){e.set(t,0),e.set(n,4),e.set(r,8),e.set(i,12)}function uu(e){e.traverse(e=>{let{geometry:t,material:n}=e;t?.dispose();for(let e of[n??[]].flat()){e.dispose();let{uniforms:t={}}=e;for(let{value:e}of Object.values(t))e instanceof De&&e.dispose()}})}var du=class{scene=new zt;lighting;#e;#t=0;constructor(e,t){this.lighting=new tu(e),this.#e=t,this.scene.matrixWorldAutoUpdate=!1}paint(e,{camera:t,frame:n}){this.lighting.updateFrame(n,t),e.render(this.scene,t),this.#t=e.info.render.calls}release(){uu(this.scene),this.lighting.dispose()}get stats(){let{lighting:e}=this,t=t=>e.countReaching(t.map(({mesh:e})=>e)),n=[...this.#e].filter(({parts:e})=>e.length>0);return{lightsActive:e.packed.active,lightsSent:t(n.flatMap(({parts:e})=>e)),lightsSentByMesh:n.map(({parts:e})=>t(e)),uploads:e.uploads,drawCalls:this.#t}}},fu=class{#e;#t=new Map;#n=new Map;#r=new Set;#i=null;#a=_l;constructor(e){this.#e=e}get style(){return this.#a}set style(e){this.#a=e;for(let{material:e,appearance:t}of this.#n.values())e.setStyle(this.#l(t))}acquire(e){let t=this.#i,n=t!==null&&pu(t.appearance,e)?t:this.#o(e);return this.#i=n,n.users+=1,this.#r.delete(n),n.material}exchange(e,t){let n=mu(t),r=this.#n.get(e);if(r?.key===n)return e;if(r?.users===1&&!this.#t.has(n)&&r.appearance.look===t.look&&r.appearance.sides===t.sides)return this.#t.delete(r.key),this.#t.set(n,r),r.key=n,this.#c(r,t),e;let i=this.acquire(t);return this.release(e),i}release(e){let t=this.#n.get(e);t!==void 0&&(--t.users,t.users===0&&this.#r.add(t))}sweep(){if(this.#r.size!==0){this.#i=null;for(let{key:e,material:t}of this.#r)this.#t.delete(e),this.#n.delete(t),t.dispose();this.#r.clear()}}#o(e){let t=mu(e);return this.#t.get(t)??this.#s(e,t)}#s(e,t){let n=new xl(this.#e,e.look);n.sides=e.sides;let r={material:n,appearance:e,key:t,users:0};return this.#c(r,e),this.#t.set(t,r),this.#n.set(n,r),r}#c(e,t){e.appearance=t,e.material.setStyle(this.#l(t)),e.material.setSurface(t.surface)}#l({shading:e,reflection:t}){let n=this.#a;return{...n,shading:e??n.shading,reflection:t??n.reflection}}},pu=(e,t)=>e.look===t.look&&e.sides===t.sides&&e.shading===t.shading&&e.reflection===t.reflection&&e.surface.ka===t.surface.ka&&e.surface.kd===t.surface.kd&&e.surface.ks===t.surface.ks&&e.surface.shininess===t.surface.shininess;function mu({look:e,sides:t,surface:n,shading:r,reflection:i}){let{ka:a,kd:o,ks:s,shininess:c}=n;return[gu(e),t,...a,...o,...s,c,r,i].join(` `)}var hu=new WeakMap;function gu(e){let t=hu.get(e);if(t===void 0){let n=Object.entries(e).map(([e,t])=>[e,_u(t)]);hu.set(e,t=n.join(` `))}return t}var _u=e=>e?.uuid??String(e),vu=class{scene;#e;constructor(e,t){this.scene=e,this.#e=t}get meshes(){return this.#e}add(e){this.#e.add(e),e.attach(this.scene)}remove(e){this.#e.delete(e),e.dispose()}arrange(e){for(let t of e)this.#e.delete(t)&&this.#e.add(t)}update(){let{children:e}=this.scene,t=0;for(let{root:n}of this.#e)n!==null&&n.parent===this.scene&&(e[t]!==n&&this.#t(),t+=1);for(let n=0;n<e.length;n++)e[n].updateMatrixWorld(n>=t)}#t(){let e=new Map;for(let{root:t}of this.#e)t!==null&&e.set(t,e.size);let t=t=>e.get(t)??e.size;this.scene.children.sort((e,n)=>t(e)-t(n))}},yu=()=>screen.width*screen.height*devicePixelRatio**2,bu=class{#e=new Map;#t=new Set;show(e,t,{x:n,y:r,width:i,height:a}){let o=this.#e.get(e),s=o??this.#n(e);this.#e.delete(e),this.#e.set(e,s),this.#t.add(e);let c=s.width!==i||s.height!==a;c&&(s.width=i,s.height=a);let l=o===void 0||c,u=s.getContext(`2d`);u!==null&&(u.globalCompositeOperation=l?`source-over`:`copy`,u.drawImage(t,n,t.height-r-a,i,a,0,0,i,a),e.holder.firstChild!==s&&e.holder.replaceChildren(s))}#n(e){let t=e.holder.ownerDocument.createElement(`canvas`);return t.addEventListener(`contextrestored`,()=>{this.#e.get(e)===t&&e.invalidate()}),t}drop(e){let t=this.#e.get(e);t!==void 0&&(this.#e.delete(e),this.#t.delete(e),t.remove(),t.width=0,t.height=0)}trim(){if(this.#t.size===0)return;let e=e=>e.drawable||this.#t.has(e),t=-2*yu();for(let[n,{width:r,height:i}]of this.#e)e(n)||(t+=r*i);for(let[n,{width:r,height:i}]of this.#e){if(t<=0)break;e(n)||(t-=r*i,this.drop(n),n.invalidate())}this.#t.clear()}};function xu(e,t){let n=e.reduce((e,{width:t,height:n})=>e+t*n,0),r=e.reduce((e,{width:t})=>Math.max(e,t),0),i=Math.max(r,Math.ceil(Math.sqrt(Math.min(n,t.area,t.side**2)))),a=Su(e,i,t),o=Su(e,Math.min(i+r,t.side),t),s=o.places.length-a.places.length,c=o.width*o.height<a.width*a.height;return s>0||s===0&&c?o:a}function Su(e,t,n){let r=[],i=0,a=0,o=0,s=0;for(let{width:c,height:l}of e){i+c>t&&(i=0,a=s);let e=Math.max(o,i+c),u=Math.max(s,a+l);if(r.length>0&&(u>n.side||e*u>n.area))break;r.push({x:i,y:a,width:c,height:l}),i+=c,o=e,s=u}return{width:o,height:s,places:r}}var Cu=class extends Error{name=`NoWebGL2Error`},wu={alpha:!0,antialias:!0,depth:!0,stencil:!1,premultipliedAlpha:!0},Tu=4096;function Eu({width:e,height:t}){let n=document.createElement(`canvas`),r=Math.max(e,t)<=Tu;n.width=r?e:1,n.height=r?t:1;let i;try{let e=n.getContext(`webgl2`,wu);if(e!==null)return e}catch(e){i=e}throw new Cu(`this browser gives no WebGL 2 context`,{cause:i})}function Du(e){let t=e.canvas,n=Tt();at((t,...r)=>{e.isContextLost()||(n===null?console.warn(...r):n(t,...r))});let r;try{r=new Zo({canvas:t,context:e,antialias:!0,alpha:!0})}finally{at(n)}return r.autoClear=!1,r.setOpaqueSort(Ou),r.setTransparentSort(ku),r}var Ou=(e,t)=>e.groupOrder-t.groupOrder||e.renderOrder-t.renderOrder,ku=(e,t)=>Ou(e,t)||t.z-e.z;function Au(e){let t=[...e.getParameter(e.MAX_VIEWPORT_DIMS)??[],e.getParameter(e.MAX_RENDERBUFFER_SIZE),e.getParameter(e.MAX_TEXTURE_SIZE)];return Math.min(...t.map(Number))}function ju(e){e.clearColor(1,1,1,1),e.clear(e.COLOR_BUFFER_BIT);let t=document.createElement(`canvas`).getContext(`2d`,{willReadFrequently:!0});return t?.drawImage(e.canvas,0,0),t?.getImageData(0,0,1,1).data[3]===255}function Mu(e){let t=()=>e.getExtension(`WEBGL_lose_context`)?.loseContext();e.canvas.addEventListener(`webglcontextrestored`,t,{once:!0}),t()}function Nu(e,t){let n=document.createElement(`canvas`);n.width=e,n.height=t;let r=n.getContext(`2d`);return r!==null&&Pu(r,e,t)?r:null}function Pu(e,t,n){if(e.canvas.width!==t||e.canvas.height!==n)return!1;let r=[t-1,n-1,1,1];try{e.fillRect(...r);let t=e.getImageData(...r).data[3]===255;return e.clearRect(...r),t}catch{return!1}}var Fu=class{#e=new WeakSet;constructor(e){e.debug.checkShaderErrors=!1}check(e){let t=e.getContext();for(let n of e.info.programs??[])this.#e.has(n)||al.has(n)||!n.isReady()||(this.#e.add(n),t.getProgramParameter(n.program,t.LINK_STATUS)===!0||t.isContextLost()||cl(t,n.program))}},Iu={side:1/0,area:1/0},Lu=class{#e;#t=`closed`;#n=null;#r=null;#i=null;#a=Iu;constructor(e){this.#e=e}get renderer(){return this.#r}get unavailable(){return this.#t===`lost`||this.#t===`refused`}get limit(){return this.#a}open(e){if(this.#r!==null||this.#t===`lost`)return this.#r;if(this.#n===null){this.#n=Eu(e);let{canvas:t}=this.#n;t.addEventListener(`webglcontextlost`,this.#d),t.addEventListener(`webglcontextrestored`,this.#f)}let t=this.#t===`refused`||this.#t===`retrying`;return this.#o(this.#n),t&&!this.unavailable&&this.#e.restored(),this.#r}refuse(e){this.#t=`refused`,document.addEventListener(`visibilitychange`,this.#u),this.#e.missing(e)}retry(){this.#t===`refused`&&(this.#t=`retrying`,this.#e.retrying())}noticeLoss(){return this.#t===`open`&&this.#n?.isContextLost()===!0&&this.#s(),this.#t===`lost`}checkLinks(){this.#r!==null&&this.#i?.check(this.#r)}resize({width:e,height:t}){let n=this.#r;if(n===null)return!1;let r=n.domElement;if(r.width===e&&r.height===t)return!0;n.setSize(e,t,!1);let{drawingBufferWidth:i,drawingBufferHeight:a}=n.getContext();if(i>=e&&a>=t)return!0;let o=i*a;return o>0&&(this.#a={...this.#a,area:Math.min(this.#a.area,o)}),n.setSize(1,1,!1),!1}close(){document.removeEventListener(`visibilitychange`,this.#u),this.#a=Iu,this.#c()}#o(e){this.#t=`open`,document.removeEventListener(`visibilitychange`,this.#u);try{this.#a={...this.#a,side:Au(e)},this.#r=Du(e),this.#i=new Fu(this.#r)}catch(e){if(!this.noticeLoss())throw e}this.noticeLoss()}#s(){this.#t=`lost`,this.#e.lost(),this.#l()}#c(){this.#t=`closed`;let e=this.#n;e!==null&&(this.#n=null,e.canvas.removeEventListener(`webglcontextlost`,this.#d),e.canvas.removeEventListener(`webglcontextrestored`,this.#f),this.#l(),Mu(e))}#l(){this.#r?.dispose(),this.#r=null,this.#i=null}#u=()=>{document.visibilityState===`visible`&&this.retry()};#d=e=>{e.stopImmediatePropagation(),e.preventDefault(),this.#t===`open`&&this.#s()};#f=e=>{if(e.stopImmediatePropagation(),this.#n===null)return;let{canvas:t}=this.#n;t.width*t.height>4096**2&&(this.#a={...this.#a,area:Tu**2}),t.width=t.height=1,ju(this.#n)||this.#n.isContextLost()?this.#o(this.#n):this.#c(),this.unavailable||this.#e.restored()}},Ru=30,zu={width:1,height:1},Bu=class{#e=new Set;#t=new bu;#n=new Lu({lost:()=>{this.#i.clear(),this.#r.clear();for(let e of this.#e)e.contextLost()},restored:()=>{for(let e of this.#e)e.contextRestored()},missing:e=>{for(let t of this.#e)t.contextMissing(e)},retrying:()=>{this.#d()}});#r=new Map;#i=new Map;#a=0;#o=!1;#s=0;add(e){this.#e.has(e)||(this.#e.add(e),this.#e.size===2&&this.#d(),this.#n.retry())}remove(e){this.#e.delete(e)&&(this.#g(),this.#t.drop(e),e.holder.replaceChildren(),this.#e.size===1?this.#d():this.#e.size>1&&this.#n.resize(zu),this.#e.size===0&&queueMicrotask(this.#y))}get lost(){return this.#n.unavailable}get programs(){return this.#n.renderer?.info.programs?.length??0}get viewersDrawn(){return this.#s}shareOf({width:e,height:t}){let{side:n,area:r}=this.#n.limit;return Math.min(1,n/Math.max(e,t,1),Math.sqrt(r/Math.max(e*t,1)))}draw(e,t){try{let n=this.#e.size===1&&e.holder.ownerDocument===document,r=this.#n.open(n?e:this.#p(e).atlas);return r!==null&&(this.#_(),n?this.#c(e,r,t):this.#l(e,r,t),this.#n.checkLinks(),!0)}catch(e){if(e instanceof Cu)this.#n.refuse(e);else if(!this.#n.noticeLoss())throw e;return!1}}capture({width:e,height:t},n){let r=Nu(e,t);if(r===null)throw this.#n.noticeLoss()||e*t<=4096**2?Uu():RangeError(`a picture of ${String(e)} × ${String(t)} is too large`);this.#e.size===0&&queueMicrotask(this.#y);try{let i={width:Math.min(e,Tu),height:Math.min(t,Tu)},a=this.#n.open(i);a!==null&&this.#u(a,r,n)}catch(e){if(!this.#n.noticeLoss())throw e}if(this.#n.noticeLoss())throw Uu();return r.canvas}#c(e,t,n){this.#h(),this.#n.resize(e)||this.#n.resize(e);let{width:r,height:i}=e;Vu(t),Hu(t,{x:0,y:0,width:r,height:i},n),this.#t.drop(e);let{domElement:a}=t;e.holder.firstChild!==a&&e.holder.replaceChildren(a)}#l(e,t,n){let r=this.#f(e,t);Hu(t,r,n),this.#i.set(e,r)}#u(e,t,n){this.#h();let{width:r,height:i}=t.canvas,a=e.domElement,o={width:a.width,height:a.height},s=Math.min(this.#n.limit.side,Tu);for(let o=0;o<i;o+=s)for(let c=0;c<r;c+=s){let l={x:c,y:o,width:Math.min(s,r-c),height:Math.min(s,i-o)};if(!(l.width<=a.width&&l.height<=a.height)&&!this.#n.resize(l))throw RangeError(`the GPU has no memory to draw ${String(r)} × ${String(i)} pixels`);Vu(e),Hu(e,{x:0,y:0,width:l.width,height:l.height},e=>{n(e,l)});let u=a.height-l.height;t.drawImage(a,0,u,l.width,l.height,c,o,l.width,l.height)}if(this.#n.checkLinks(),this.#e.size===1)for(let e of this.#e)e.redraw();else this.#n.resize(o)}#d(){for(let e of this.#e)e.invalidate()}#f(e,t){let n=this.#r.get(e);if(this.#r.delete(e),n?.width===e.width&&n.height===e.height)return n;this.#h();let{pictures:r,atlas:i}=this.#p(e);return this.#m(t,i)||({pictures:r,atlas:i}=this.#p(e),this.#m(t,i)),Vu(t),i.places.forEach((t,n)=>{let i=r[n];i!==void 0&&i!==e&&this.#r.set(i,t)}),{x:0,y:0,width:e.width,height:e.height}}#p(e){let t=[e];for(let n of this.#e)n!==e&&n.drawable&&!n.upToDate&&t.push(n);let{side:n,area:r}=this.#n.limit;return{pictures:t,atlas:xu(t,{side:n,area:Math.min(r,yu())})}}#m(e,{width:t,height:n}){let r=e.domElement,i=t<=r.width&&n<=r.height,a=i&&4*t*n<r.width*r.height;if(this.#a=a?this.#a+1:0,i&&this.#a<Ru)return!0;this.#a=0;let o={width:Math.max(t,r.width),height:Math.max(n,r.height)},s=o.width*o.height<=Math.min(this.#n.limit.area,yu());return this.#n.resize(!i&&s?o:{width:t,height:n})}#h(){if(this.#g(),this.#n.unavailable)throw Uu()}#g(){if(this.#r.clear(),this.#i.size===0||this.#n.noticeLoss())return;let e=this.#n.renderer?.domElement;if(e!==void 0)for(let[t,n]of this.#i)this.#t.show(t,e,n);this.#i.clear()}#_(){this.#o||(this.#o=!0,this.#s=0,Promise.resolve().then(this.#v)),this.#s+=1}#v=()=>{this.#o=!1,this.#g(),this.#t.trim()};#y=()=>{this.#e.size===0&&this.#n.close()}};function Vu(e){e.setScissorTest(!1),e.setClearColor(0,0),e.clear(!0,!0,!1)}function Hu(e,{x:t,y:n,width:r,height:i},a){let o=e.domElement.width===r&&e.domElement.height===i;e.setViewport(t,n,r,i),e.setScissor(t,n,r,i),e.setScissorTest(!o),a(e)}var Uu=()=>Error(`the graphics context is lost: there is no picture until the browser restores it`),Wu=new Bu,Gu=class{camera=new Ut;frame;#e;#t=Js();#n=[0,0,0];#r=[0,0,0];#i={near:.1,far:100};#a=[];constructor(e){this.#e=e,this.frame={get origin(){return e.target},eye:this.#r,...this.#t},this.camera.matrixAutoUpdate=!1,this.camera.matrixWorldAutoUpdate=!1}aim(e,t,r,i,a){let o=[this.#e.version,e,t,r,i,a];if(n(o,this.#a))return;this.#a=o;let{camera:s}=this,{right:c,up:l,back:u}=this.#e.basis(this.#t),d=this.#e.eye(this.#n);this.#e.offset(this.#r),s.matrixWorld.set(c[0],l[0],u[0],d[0],c[1],l[1],u[1],d[1],c[2],l[2],u[2],d[2],0,0,0,1),s.matrixWorldInverse.set(c[0],c[1],c[2],-ve(c,d),l[0],l[1],l[2],-ve(l,d),u[0],u[1],u[2],-ve(u,d),0,0,0,1),s.matrix.copy(s.matrixWorld),s.matrix.decompose(s.position,s.quaternion,s.scale);let{near:f,far:p}=ac(this.#e.pose,t,this.#i);s.near=f,s.far=p,s.fov=e,s.aspect=r/i,a===void 0?s.clearViewOffset():s.setViewOffset(r,i,a.x,a.y,a.width,a.height),s.updateProjectionMatrix(),Ku(s,this.#e.pose.radius)}};function Ku(e,t){if(t>1/qu&&t<qu)return;let n=2**-Math.round(Math.log2(t));e.projectionMatrix.multiplyScalar(n),e.projectionMatrixInverse.multiplyScalar(1/n)}var qu=1e9,Ju=class{holder;orbit=new qs;materials;#e;#t;#n;#r;#i=new Gu(this.orbit);#a={width:0,height:0};#o=void 0;#s=!1;#c=null;#l=!0;#u=45;#d=0;constructor(e,t,n){this.holder=e;let r=new Set;this.#e=new du(t,r),this.materials=new fu(this.#e.lighting),this.#t=new vu(this.#e.scene,r),this.#n=new Hc(this.#t,this.orbit),this.#r=n}get width(){return Math.floor(this.#a.width*Wu.shareOf(this.#a))}get height(){return Math.floor(this.#a.height*Wu.shareOf(this.#a))}get scene(){return this.#e.scene}get lighting(){return this.#e.lighting}attach(){let e=this.holder.ownerDocument.defaultView;e!==null&&(this.#c=Kc(e),Wu.add(this),this.#s=!0,Wu.lost?this.#r.contextLost():this.#r.contextRestored(),this.invalidate())}detach(){this.#s=!1,this.#o=void 0,this.#c?.cancel(this),Wu.remove(this),this.#m()}get fov(){return this.#u}set fov(e){e!==this.#u&&(this.#u=e,this.#n.fovChanged(),this.invalidate())}get style(){return this.materials.style}set style(e){this.materials.style=e;for(let e of this.#t.meshes)e.restyle();this.invalidate()}set linear(e){e!==this.lighting.linear&&this.invalidate(),this.lighting.linear=e}get framing(){return this.#n.framing}set framing(e){this.#n.framing=e,this.invalidate()}set near(e){this.#o=e,this.#g()}resize(e,t){(e!==this.#a.width||t!==this.#a.height)&&(this.#a={width:e,height:t},this.#n.resized(e,t),this.#l=!0,this.#g())}add(e){this.#t.add(e),this.reshaped()}remove(e){this.#t.remove(e),this.reshaped()}arrange(e){this.#t.arrange(e),this.invalidate()}reshaped(){this.#n.reshaped(),this.invalidate()}refit(){jc(this.scene),this.reshaped()}get drawable(){return!this.#s||Wu.lost||this.#o===!1?!1:this.#o===void 0||this.width>0&&this.height>0}get upToDate(){return!this.#l}invalidate(){this.#l=!0,this.drawable&&this.#c?.request(this)}animate(){this.drawable&&this.#c?.request(this)}prepare(){this.#o===void 0&&this.#r.needsLayout()}advance(e){return this.drawable&&this.#r.beforeFrame(e)}draw(){this.#l&&this.drawable&&this.redraw()}redraw(){if(!this.drawable||this.#o===void 0)this.#l=!0;else{this.#l=!1;try{this.#f()?(this.#r.painted(),this.#d+=1,this.#r.drawn()):this.#l=!0,this.materials.sweep()}catch(e){if(!this.#r.undrawable(e,this.#f))throw e;this.redraw()}finally{this.#r.afterFrame()}}}settle(){this.#n.settle(this.#u)&&this.#d>0&&this.#r.fitted()}get zoomLimits(){return this.settle(),ic(this.#n.bounds)}capture(e,t){return this.#p(),this.#m(),Wu.capture({width:e,height:t},(n,r)=>{this.#i.aim(this.#u,this.#n.depthBounds(),e,t,r),this.#e.paint(n,this.#i)})}snapshot(e){let{width:t,height:n}=this;this.#p(),this.#i.aim(this.#u,this.#n.depthBounds(),t,n);let{camera:r,frame:i}=this.#i,a=new Map;for(let t of this.#t.meshes)for(let n of t.parts)a.set(n.mesh,e(t));let o=Cl(this.scene,r,e=>a.get(e));return{width:t,height:n,frame:Tl(i),camera:r.clone(),objects:o}}get stats(){let{programs:e,viewersDrawn:t}=Wu;return{...this.#e.stats,frames:this.#d,programs:e,viewersDrawn:t}}contextLost(){this.#l=!0,this.#c?.cancel(this),this.#h(),this.#r.contextLost(),this.#r.afterFrame()}contextRestored(){this.#g(),this.#r.contextRestored()}#f=()=>(this.#p(),Wu.draw(this,e=>{this.#i.aim(this.#u,this.#n.depthBounds(),this.width,this.height),this.#e.paint(e,this.#i)}));contextMissing(e){this.#c?.cancel(this),this.#r.contextMissing(e),this.#r.afterFrame()}#p(){this.settle(),this.#t.update()}#m(){queueMicrotask(()=>{this.#s||this.#h()})}#h(){this.materials.sweep(),this.#e.release()}#g(){this.drawable?this.#l&&this.#c?.request(this):this.#c?.cancel(this)}},Yu={theta:a(30,{}),phi:a(70,{min:0,max:180}),radius:h(`auto`,a(4,{above:0,max:r.coordinate})),target:h(`auto`,p([0,0,0],{min:-r.coordinate,max:r.coordinate}))},Xu={..._s,alt:c(),poster:c(``,`the address of an image`),loading:d(`auto`,[`auto`,`eager`,`lazy`]),droppable:o(),crossOrigin:{...f(d(`anonymous`,[`anonymous`,`use-credentials`])),empty:`anonymous`},...Yu,fov:a(45,{min:1,max:170}),orbit:g(!0),zoom:g(!0),autoRotate:a(0,{min:-1e6,max:1e6}),shading:d(`phong`,Tr),reflection:d(`phong`,Er),terms:s(Or),colorInterpolation:d(`srgb`,[`srgb`,`linear`]),antialias:d(`edges`,Dr),gui:o()},Zu=new Set([`src`,`geometry`,`gui`]),Qu=[...Object.keys(_s),`loading`,`crossOrigin`],$u=new WeakMap,ed=new WeakMap;function td(e,t){let n=($u.get(e)??new Set).add(t);$u.set(e,n);for(let t of n){let n=rd(e.ownerDocument,t);n!==null&&!e.adoptedStyleSheets.includes(n)&&e.adoptedStyleSheets.push(n)}}function nd(e,t){$u.get(e)?.delete(t);let n=rd(e.ownerDocument,t);e.adoptedStyleSheets=e.adoptedStyleSheets.filter(e=>e!==n)}function rd(e,t){let n=e.defaultView;if(n===null)return null;let r=ed.get(e)??new Map;ed.set(e,r);let i=r.get(t);return i===void 0&&(i=new n.CSSStyleSheet,i.replaceSync(t),r.set(t,i)),i}var id=class{view;#e=new Map;#t=null;constructor(e){this.view=e}get margin(){return this.view.screen.height}get#n(){let{view:e}=this,t=`${String(this.margin)}px`,n=`scrollMargin`in e.IntersectionObserver.prototype,r=e.parent!==e&&e.frameElement===null;return n&&!r?{scrollMargin:t}:{root:e.document,rootMargin:t}}watch(e,t){this.#t??=this.#r(),this.#e.set(e,t);let{intersection:n,surroundings:r,resize:i}=this.#t;n.observe(e),r.observe(e);try{i.observe(e,{box:`device-pixel-content-box`})}catch{i.observe(e)}}unwatch(e){if(!this.#e.delete(e)||this.#t===null)return;let{intersection:t,surroundings:n,resize:r,listeners:i}=this.#t;t.unobserve(e),n.unobserve(e),r.unobserve(e),this.#e.size>0||(this.#t=null,t.disconnect(),n.disconnect(),r.disconnect(),i.abort())}#r(){let{view:e}=this,t=new AbortController,{signal:n}=t;return e.document.addEventListener(`visibilitychange`,()=>this.#a(`shown`),{signal:n}),e.addEventListener(`beforeprint`,()=>this.#a(`printed`),{signal:n}),e!==window&&e.addEventListener(`pagehide`,()=>this.#a(`closed`),{signal:n}),this.#i(n),{intersection:new e.IntersectionObserver(e=>{for(let t of e)this.#e.get(t.target)?.intersected(t)},{threshold:[0,1e-6]}),surroundings:new e.IntersectionObserver(e=>{for(let t of e)this.#e.get(t.target)?.neared(t)},this.#n),resize:new e.ResizeObserver(e=>{for(let t of e)this.#e.get(t.target)?.resized(t)}),listeners:t}}#i(e){this.view.matchMedia(`(resolution: ${String(this.view.devicePixelRatio)}dppx)`).addEventListener(`change`,()=>{this.#i(e),this.#a(`scaled`)},{once:!0,signal:e})}#a(e){for(let t of[...this.#e.values()])t[e]()}},ad=new WeakMap;function od(e){let t=e.defaultView;if(t===null)return null;let n=ad.get(e)??new id(t);return ad.set(e,n),n}var sd=class{#e;#t;#n;#r=null;#i=null;#a=null;#o={width:0,height:0,pixelWidth:0,pixelHeight:0};constructor(e,t,n){this.#e=e,this.#t=t,this.#n=n}get size(){return this.#o}get connected(){return this.#r!==null}get looked(){return this.#i!==null||this.#a!==null}hostConnected(){let{ownerDocument:e}=this.#e;this.#r=od(e),this.#t.ownerDocument!==e&&e.adoptNode(this.#t),this.#r?.watch(this.#t,this);for(let e of cd)this.#t.addEventListener(e,this.#c)}hostDisconnected(){this.#r?.unwatch(this.#t),this.#r=null;for(let e of cd)this.#t.removeEventListener(e,this.#c);this.#i=null,this.#a=null}look(){if(this.#r===null)return;let e=ud(this.#t);this.#i=e<0,this.#a=e<this.#r.margin,this.#u(this.#t.clientWidth,this.#t.clientHeight),this.shown()}printed(){this.#u(this.#t.clientWidth,this.#t.clientHeight);let e=this.#i===!0;this.#n({painted:!0,near:!0,visible:e,printing:!0,...this.#o}),this.shown()}intersected(e){this.#i=e.isIntersecting&&e.intersectionRatio>0,this.shown()}neared(e){this.#a=e.isIntersecting,this.shown()}resized(e){let{width:t,height:n}=e.contentRect;this.#u(t,n);let r=e.devicePixelContentBoxSize?.[0];r!==void 0&&this.#l(r),this.shown()}scaled(){this.#u(this.#o.width,this.#o.height),this.shown()}shown(){if(!this.looked)return;let e=!this.#s&&ld(this.#t),t=e&&this.#i===!0,n=t||e&&this.#a===!0&&!pd(this.#t);this.#n({painted:e,near:n,visible:t,printing:!1,...this.#o})}closed(){this.#e.disconnectedCallback()}get#s(){return this.#e.ownerDocument.visibilityState===`hidden`}#c=({propertyName:e})=>{e===`visibility`&&this.shown()};#l(e){let t=(this.#r?.view.getComputedStyle(this.#t))?.writingMode.startsWith(`horizontal`)??!0,n=t?e.inlineSize:e.blockSize,r=t?e.blockSize:e.inlineSize;Math.abs(n-this.#o.pixelWidth)>1||Math.abs(r-this.#o.pixelHeight)>1||(this.#o.pixelWidth=n,this.#o.pixelHeight=r)}#u(e,t){let n=this.#t.currentCSSZoom??1,r=(this.#r?.view.devicePixelRatio??1)*n;this.#o={width:e,height:t,pixelWidth:Math.round(e*r),pixelHeight:Math.round(t*r)}}},cd=[`transitionrun`,`transitionend`,`transitioncancel`];function ld(e){let{checkVisibility:t}=e;return t?.call(e,{visibilityProperty:!0})??!0}function ud(e){let t=e.ownerDocument.defaultView,n=e.getBoundingClientRect();if(t===null||n.width===0||n.height===0)return 1/0;let r=fd(n,{top:0,left:0,bottom:t.innerHeight,right:t.innerWidth}),{position:i}=t.getComputedStyle(e);for(let a=md(e);a!==null&&i!==`fixed`;a=md(a)){let e=t.getComputedStyle(a);(i!==`absolute`||e.position!==`static`)&&({position:i}=e,e.overflow!==`visible`&&!dd(a)&&(r=Math.max(r,fd(n,a.getBoundingClientRect()))))}return t.frameElement===null?r:Math.max(r,ud(t.frameElement))}var dd=e=>e===e.ownerDocument.documentElement||e===e.ownerDocument.body,fd=(e,t)=>Math.max(e.top-t.bottom,t.top-e.bottom,e.left-t.right,t.left-e.right);function pd(e){let t=e.ownerDocument.defaultView;for(let n=e;n!==null;n=md(n))if((n.clientWidth===0||n.clientHeight===0)&&t?.getComputedStyle(n).overflow.includes(`visible`)===!1)return!0;return!1}var md=e=>e.assignedSlot??e.parentElement??e.getRootNode().host??null,hd=`:host{contain:strict;width:300px;height:150px;display:inline-block;position:relative;overflow:hidden}:host([hidden]){display:none}.surface,.holder,.poster,.message{position:absolute;inset:0}.corner{position:absolute;top:0;left:0}.corner.right{left:100%}.corner.low{top:100%}.holder{transition:visibility 1ms}.surface{cursor:grab;touch-action:pan-y;-webkit-user-select:none;user-select:none;outline:none}.surface:active{cursor:grabbing}.surface.fixed{cursor:default}.surface:focus-visible:after{content:"";outline-offset:-4px;pointer-events:none;border:2px solid canvas;outline:2px solid canvastext;position:absolute;inset:0}canvas{width:100%;height:100%;display:block}.poster{object-fit:contain;pointer-events:none;width:100%;height:100%}.message{pointer-events:none;place-items:center;display:grid}.message>*{pointer-events:auto}.notice{box-sizing:border-box;color:#ffe3e0;overflow-wrap:anywhere;background:#2b1d1d;border-radius:.375em;max-width:90%;margin:0;padding:.5em .75em;font:.875rem/1.4 system-ui,sans-serif}.message{grid-template-rows:100%}.notice{max-height:100%;overflow-y:auto}.reader{clip-path:inset(50%);white-space:nowrap;pointer-events:none;-webkit-user-select:none;user-select:none;width:1px;height:1px;list-style:none;position:absolute;overflow:hidden}.panel{overscroll-behavior:contain;max-width:100%;max-height:100%;position:absolute;top:0;right:0;overflow:hidden auto}slot:not([name]){display:none}`,gd=1e3,_d=[`input`,`change`,`click`,`keydown`,`pointermove`],vd=class{#e;#t=en(`div`,{class:`reader`});#n=en(`ul`,{role:`list`});#r=null;#i=null;#a=0;#o=null;#s=null;#c=!1;#l=!1;#u=new Set;#d=null;constructor(e){this.#e=e,e.addEventListener(`render`,()=>this.#f()),e.addEventListener(`camera-change`,({detail:e})=>this.#p(e.source)),e.addEventListener(`light-change`,({detail:e})=>this.#m(e.lights))}connect({surface:e,panel:t}){this.#r=e,e.after(this.#t);for(let e of _d)t.addEventListener(e,e=>this.#d=e,{capture:!0,passive:!0})}hostDisconnected(){clearTimeout(this.#a),this.#a=0,this.#v()}update(){this.#r!==null&&(this.#t.hidden=!rn(this.#r,this.#e,this.#S),this.#b(),this.#o!==null&&this.#s!==this.#S&&this.#f())}#f(){this.#a===0&&this.#g(this.#o===null?0:gd)}#p(e){e!==`script`&&e!==`auto`&&(this.#c=!0,this.#h())}#m(e){if((this.#d?.eventPhase??Event.NONE)!==Event.NONE){e.length===0&&(this.#l=!0);for(let t of e)this.#u.add(t);this.#h()}}#h(){this.#i===null&&this.#t.append(this.#i=en(`p`,{"aria-live":`polite`})),clearTimeout(this.#a),this.#g(gd)}#g(e){this.#a=window.setTimeout(()=>{this.#a=0,this.#_(),this.#y()},e)}#_(){let{camera:e,lights:t}=this.#e,n=this.#c?[ne(this.#S,e)]:[];this.#l&&n.push(M(this.#S,t.length));let r=[...this.#u].filter(e=>t.includes(e)).slice(-3);for(let e of r)n.push(`${this.#x(e,t.indexOf(e))}.`);this.#v(),n.length>0&&this.#i!==null&&(this.#i.textContent=n.join(` `))}#v(){this.#c=!1,this.#l=!1,this.#u.clear()}#y(){let e=this.#s=this.#S,{camera:t,lights:n,meshes:r}=this.#e,i=n.map((t,n)=>P(e,yd(t,n),t));this.#o=`${ne(e,t)} ${C(e,i)}`,this.#b();let a=[...n.map((e,t)=>this.#x(e,t)),...r.map((t,n)=>te(e,t,n))],o=this.#n;for(;o.childElementCount>a.length;)o.lastChild?.remove();a.forEach((e,t)=>bd(o.children[t]??o.appendChild(en(`li`,{})),e)),tn(o,`aria-label`,T(e,`Lights and meshes`)),a.length===0?o.remove():o.parentNode===null&&this.#t.prepend(o)}#b(){let e=[an(this.#e,this.#S),this.#o??``];this.#r!==null&&tn(this.#r,`aria-description`,e.join(` `).trim())}#x(e,t){return A(this.#S,yd(e,t),F(e).store.values)}get#S(){return this.#e.texts??null}},yd=(e,t)=>F(e).store.values.name||Dn(t);function bd(e,t){e.textContent!==t&&(e.textContent=t)}function xd(e,t,n,{width:r,height:i}){return r>0&&i>0?Sd(e,-(360*t)/r,-(180*n)/i):e}function Sd(e,t,n){return t===0&&n===0||!Number.isFinite(t)||!Number.isFinite(n)?e:{...e,theta:t===0?e.theta:I(e.theta)+t,phi:Dd(e.phi+n,0,180)}}function Cd(e,t,n,r){if(t===0&&n===0)return e;let i=wd(e.radius,r),{right:a,up:o}=Ys(e),s=r=>Qs(e.target[r]+i*(o[r]*n-a[r]*t)),c=[s(0),s(1),s(2)];return c.every(Number.isFinite)?{...e,target:c}:e}function wd(e,{height:t,fov:n}){return t>0?2*e*L(n/2)/(ce(n/2)*t):NaN}function Td(e,t,n,r){return t>0&&t!==n?Ed(e,t/n,r):e}function Ed(e,t,n){let r=Math.min(n.min,e.radius),i=Math.max(n.max,e.radius),a=Dd(e.radius*t,r,i);return a>0&&Number.isFinite(a)?{...e,radius:a}:e}var Dd=(e,t,n)=>Math.min(Math.max(e,t),n),Od=[1,0,0,1],kd=1e-5,Ad=class{#e;#t=[];#n=`turn`;#r;#i=!1;constructor(e){this.#e=e}get pointers(){return this.#t.map(e=>e.id)}get active(){return this.#t.length>0}get dragged(){return this.#i}has(e){return this.#t.some(t=>t.id===e)}press(e,t,n,r){return this.#t.length>=2||this.has(e)||!Number.isFinite(t+n)?!1:(this.active||(this.#i=!1),this.#n=this.active?`turn`:r,this.#t=[...this.#t,{id:e,anchorX:t,anchorY:n,x:t,y:n}],this.reanchor(),!0)}move(e,t,n){let r=this.#t.find(t=>t.id===e);if(r===void 0||!Number.isFinite(t+n))return!1;let i=this.#r;(i===void 0||this.#a(i))&&(i=this.reanchor()),r.x=t,r.y=n;let{orbit:a}=this.#e;a.set(this.#o(i));let o=a.version!==i.version;return i.version=a.version,this.#i||=o,o}lift(e){this.has(e)&&(this.#t=this.#t.filter(t=>t.id!==e),this.active&&this.reanchor())}reanchor(){for(let e of this.#t)e.anchorX=e.x,e.anchorY=e.y;let{orbit:e}=this.#e,{width:t,height:n,axes:r=Od}=this.#e.size(),i={width:t,height:n,fov:this.#e.fov()};return this.#r={pose:e.pose,view:i,axes:r,...this.#e.allows(),version:e.version},this.#r}#a({view:e,axes:t,orbit:n,zoom:r,version:i}){let{width:a,height:o,axes:s=Od}=this.#e.size(),c=this.#e.allows(),l=e.width===a&&e.height===o&&e.fov===this.#e.fov(),u=s.every((e,n)=>Math.abs(e-t[n])<kd);return!l||!u||c.orbit!==n||c.zoom!==r||this.#e.orbit.version!==i}#o({pose:e,view:t,axes:n,orbit:r,zoom:i}){let[a,o]=this.#t;if(a===void 0)return e;let s=a.x-a.anchorX,c=a.y-a.anchorY;if(o===void 0){if(!r)return e;let i=jd(n,s,c);return this.#n===`turn`?xd(e,...i,t):Cd(e,...i,t)}let l=Math.hypot(o.anchorX-a.anchorX,o.anchorY-a.anchorY),u=Math.hypot(o.x-a.x,o.y-a.y),d=i?Td(e,l,u,this.#e.radiusLimits()):e;return r?Cd(d,...jd(n,(s+o.x-o.anchorX)/2,(c+o.y-o.anchorY)/2),t):d}};function jd([e,t,n,r],i,a){let o=e*r-t*n;return o===0?[0,0]:[(i*r-a*n)/o,(a*e-i*t)/o]}var Md=16,Nd=.001,Pd=1.1,Fd=5,Id=1;function Ld(e,t,n,r){let i=t.deltaMode===1?Md:t.deltaMode===2?n:1;return Ed(e,Math.exp(Nd*t.deltaY*i),r)}function Rd(e,t){let n=t?Id:Fd;switch(e){case`ArrowRight`:return{kind:`turn`,theta:-n,phi:0};case`ArrowLeft`:return{kind:`turn`,theta:n,phi:0};case`ArrowDown`:return{kind:`turn`,theta:0,phi:-n};case`ArrowUp`:return{kind:`turn`,theta:0,phi:n};case`+`:case`=`:case`PageUp`:return{kind:`zoom`,factor:1/Pd};case`-`:case`_`:case`PageDown`:return{kind:`zoom`,factor:Pd};case`Home`:return{kind:`reset`};default:return}}function zd(e,t,n){return t.kind===`turn`?Sd(e,t.theta,t.phi):Ed(e,t.factor,n)}var Bd=0,Vd=2,Hd=300,Ud=32,Wd=class{#e;#t;#n;#r;#i=Bd;#a=!1;#o;#s=-1;constructor(e,t){this.#e=e,this.#t=t,this.#n=new Ad(t)}get dragging(){return this.#n.active}connect(){if(this.#r!==void 0)return;this.#r=new AbortController;let{signal:e}=this.#r,t=this.#e,n={signal:e,passive:!1};for(let e of Object.keys(this.#l)){let r=/down|wheel/.test(e);t.addEventListener(e,e=>{r&&e.defaultPrevented||this.take(e)},n)}for(let n of[`selectstart`,`dragstart`])t.addEventListener(n,e=>this.#g(e),{signal:e});t.addEventListener(`touchstart`,e=>this.#h(e),n),t.addEventListener(`touchmove`,e=>this.#h(e),n);let r=t.ownerDocument.defaultView;r?.addEventListener(`blur`,()=>this.#C(),{signal:e}),r?.addEventListener(`contextmenu`,e=>this.#m(e),{signal:e})}take(e){this.#l[e.type]?.(e)}disconnect(){this.#r?.abort(),this.#r=void 0,this.#C()}reanchor(){this.#n.active&&this.#n.reanchor()}#c=e=>{this.#p(e)};#l={pointerdown:e=>{this.#u(e)},pointermove:e=>{this.#d(e)},pointerup:this.#c,pointercancel:this.#c,lostpointercapture:this.#c,wheel:e=>{this.#_(e)},keydown:e=>{this.#v(e)}};#u(e){let{orbit:t,zoom:n}=this.#t.allows(),r=e.pointerType===`touch`;if(!t&&!n||e.button!==Bd&&e.button!==Vd||(this.#e.focus({preventScroll:!0}),this.#s=-1,this.#n.has(e.pointerId)&&this.#S(e.pointerId),r?this.#n.active&&!this.#a:this.#n.active||!t))return;let i=!this.#n.active,a=e.button===Vd||e.shiftKey?`shift`:`turn`;this.#n.press(e.pointerId,e.clientX,e.clientY,a)&&(this.#i=e.button,this.#a=r,this.#o=r&&i?{x:e.clientX,y:e.clientY}:void 0,this.#x(e.pointerId),i&&this.#t.held?.(!0))}#d(e){if(!this.#n.has(e.pointerId))return;let t=this.#i===Vd?2:1;if((e.buttons&t)===0)this.#S(e.pointerId);else if(this.#f(e))return;else this.#n.move(e.pointerId,e.clientX,e.clientY)&&this.#t.moved(`pointer`)}#f(e){if(this.#o===void 0)return!1;let t=Math.abs(e.clientX-this.#o.x),n=Math.abs(e.clientY-this.#o.y);return n>t&&n<Ud||(this.#o=void 0,!1)}#p(e){this.#n.has(e.pointerId)&&(this.#S(e.pointerId),this.#i===Vd&&this.#n.dragged&&(this.#s=e.timeStamp+Hd))}#m(e){let t=!(this.#n.active&&this.#i===Vd)&&!(e.timeStamp<=this.#s);this.#s=-1,t?this.#a||this.#C():e.preventDefault()}#h(e){e.cancelable&&e.targetTouches.length>1&&this.#n.active&&e.preventDefault()}#g(e){this.#n.active&&e.preventDefault()}#_(e){if(e.deltaY===0||!this.#t.allows().zoom||!this.#b())return;e.preventDefault();let{orbit:t}=this.#t;this.#y(Ld(t.pose,e,this.#t.size().height,this.#t.radiusLimits()),`wheel`)}#v(e){if(e.ctrlKey||e.altKey||e.metaKey)return;let t=Rd(e.key,e.shiftKey),{orbit:n,zoom:r}=this.#t.allows();t!==void 0&&(t.kind===`turn`?n:t.kind===`zoom`?r:n||r)&&(e.preventDefault(),t.kind===`reset`?(this.#t.reset(),this.reanchor()):this.#y(zd(this.#t.orbit.pose,t,this.#t.radiusLimits()),`key`))}#y(e,t){let{orbit:n}=this.#t,r=n.version;n.set(e),n.version!==r&&(this.reanchor(),this.#t.moved(t))}#b(){let e=this.#t.focusArea??this.#e,{activeElement:t}=e.getRootNode();return e.contains(t)}#x(e){try{this.#e.setPointerCapture(e)}catch{}}#S(e){this.#n.lift(e),this.#e.hasPointerCapture(e)&&this.#e.releasePointerCapture(e),this.#n.active||this.#t.held?.(!1)}#C(){for(let e of this.#n.pointers)this.#S(e)}},Gd=class{#e;#t=NaN;#n={theta:0};step(e,t,n){if(!Number.isFinite(t)||!(Math.abs(n)<=Kd))return!1;let r=this.#e;if(r===void 0||r.speed!==n||e.theta!==this.#t)return this.#e={theta:e.theta%360,time:t,speed:n},this.#t=e.theta,!1;let i=e.version;return this.#n.theta=(r.theta+qd(n,t-r.time))%360,e.set(this.#n),this.#t=e.theta,e.version!==i}rest(){this.#e=void 0}},Kd=0x38d7ea4c68000;function qd(e,t){let n=Math.fround(e),r=Math.trunc(t);return(n*r%36e4+((e-n)*r+e*(t-r)))/1e3%360}var Jd=class{#e;#t;constructor(e){this.#e=e,this.#t=[`corner`,`corner right`,`corner low`].map(e=>Object.assign(document.createElement(`i`),{className:e})),e.append(...this.#t)}get box(){let{clientWidth:e,clientHeight:t}=this.#e,[n,r,i]=this.#t.map(e=>e.getBoundingClientRect());if(n===void 0||r===void 0||i===void 0)return{width:e,height:t};let a=[(r.left-n.left)/e,(r.top-n.top)/e],o=[(i.left-n.left)/t,(i.top-n.top)/t];return{width:e,height:t,axes:[...a,...o]}}},Yd=new Set([`theta`,`phi`,`radius`,`target`]),Xd=class{#e;#t=new Gd;#n=null;#r=!1;#i=null;#a=`script`;constructor(e){this.#e=e}listenTo(e){this.#i=new Wd(e,this.#c(e)),this.#i.connect()}hostConnected(){this.#i?.connect();let e=this.#e.viewport.holder.ownerDocument.defaultView;this.#n=e?.matchMedia(`(prefers-reduced-motion: reduce)`)??null,this.#n?.addEventListener(`change`,this.#o)}hostDisconnected(){this.#i?.disconnect(),this.inView=!1,this.#n?.removeEventListener(`change`,this.#o)}get state(){let{viewport:e}=this.#e;e.settle();let{orbit:t}=e,{theta:n,phi:r,radius:i,target:a}=t.pose,{up:o}=t.basis(Js());return Object.freeze({eye:Object.freeze(t.eye()),target:a,up:Object.freeze(o),theta:I(n),phi:r,radius:i})}assigned(e){if(!Yd.has(e))return;let{values:t,viewport:n}=this.#e,{theta:r,phi:i,radius:a,target:o}=t,{orbit:s}=n,c=s.version,l=this.#a===`panel`;if(e===`theta`||e===`phi`)s.set(e===`theta`?{theta:r}:{phi:i}),l&&(n.framing=null);else{let{pose:r}=s,i=n.framing??{radius:r.radius,target:r.target};n.framing=e===`radius`?{...i,radius:a}:{...i,target:o},n.settle(),l&&t[e]!==`auto`&&(n.framing=null)}this.#i?.reanchor(),s.version!==c&&this.#s(this.#a)}reset(e=`script`){let{values:t,viewport:n}=this.#e,{theta:r,phi:i,radius:a,target:o}=t,s=n.orbit.version;n.orbit.set({theta:r,phi:i}),n.framing={radius:a,target:o},n.settle(),this.#i?.reanchor(),n.orbit.version!==s&&this.#s(e)}from(e,t){let n=this.#a;this.#a=e;try{t()}finally{this.#a=n}}resized(){this.#i?.reanchor()}frame(e){if(!this.turning)return this.#t.rest(),!1;let{viewport:t,values:n}=this.#e;return this.#t.step(t.orbit,e,n.autoRotate)&&this.#s(`auto`),!0}set inView(e){this.#r=e,e?this.#o():this.#t.rest()}get turning(){let{autoRotate:e}=this.#e.values;return e!==0&&this.#r&&this.#n?.matches!==!0&&this.#i?.dragging!==!0}#o=()=>{this.turning&&this.#e.viewport.animate()};#s(e){this.#e.viewport.invalidate(),this.#e.moved(e)}#c(e){let{viewport:t,values:n}=this.#e,r=new Jd(e);return{orbit:t.orbit,size:()=>r.box,focusArea:e.getRootNode().host,fov:()=>t.fov,radiusLimits:()=>t.zoomLimits,allows:()=>({orbit:n.orbit,zoom:n.zoom}),moved:e=>{t.framing=null,this.#s(e)},reset:()=>{this.reset(`key`)},held:e=>{e||this.#o()}}}};function Zd(e){let t=String(e);return e instanceof RangeError?!/offset|bounds|multiple|call stack|recursion/i.test(t):/out of memory|allocation size/i.test(t)}var Qd=e=>/^data:/i.test(e);function $d(e){let t=e.indexOf(`,`);if(!Qd(e)||t<0)throw new Gt(`bad-model`,`A data: URI has no comma before its data.`);let[n,...r]=e.slice(5,t).split(`;`),i=r.at(-1)?.trim().toLowerCase()===`base64`,[a=``]=e.slice(t+1).split(`#`,1),o=a.includes(`%`)?ef(a):a;return{type:(n??``).trim().toLowerCase()||`text/plain`,bytes:i?tf(o):nf(o)}}function ef(e){return e.replace(/%([0-9a-f]{2})/gi,(e,t)=>String.fromCharCode(parseInt(t,16)))}function tf(e){try{return nf(atob(e))}catch(e){throw new Gt(`bad-model`,`A data: URI holds broken base64.`,{cause:e})}}function nf(e){let t=new Uint8Array(e.length);for(let n=0;n<e.length;n+=1)t[n]=e.charCodeAt(n);return t}function rf(e,t,{signal:n,crossOrigin:r}){let i=r===`use-credentials`?`include`:`same-origin`,a=new AbortController,o=af(e,a.signal),s=fetch(e,{signal:n,redirect:t,credentials:i});return s.catch(()=>void 0),{response:s,refusal:o,stop:()=>{a.abort()}}}function af(e,t){let n=e.href.split(`#`,1)[0];return new Promise(r=>{typeof document<`u`&&document.addEventListener(`securitypolicyviolation`,t=>{let i=t.blockedURI===n||t.blockedURI===e.origin;t.disposition===`enforce`&&i&&r(t.effectiveDirective)},{signal:t})})}var of={parts:[],dispose:()=>void 0};function sf(e,t){let n=t??void 0,r=us(e,n),i=ts.has(e)?`closed`:`double`,a=t=>({parts:[{name:e,geometry:t,matrix:cf,look:gl,sides:i,surface:{}}],dispose:()=>{ds(e,n)}});return r instanceof Promise?r.then(a):a(r)}var cf=new Qe,lf=Qo(()=>mn(()=>import(`./model-content-QpVRDcEv.js`).then(e=>e.t),__vite__mapDeps([10,11,12,5]),import.meta.url),`models`);async function uf(e,t,n){let r=n!==null||Qd(e.href)?null:rf(e,`follow`,t);return(await lf()).modelContent(e,t,n??r)}var df=class{#e;#t=null;#n=!1;#r=null;constructor(e){this.#e=e}get pending(){return this.#t!==null}has(e){return!this.pending&&!this.#n&&n(this.#r,this.#i(e))}request(e){let t=this.#e,{src:r,type:i,geometry:a,segments:o}=e,s=this.#i(e);if(n(s,this.#r)||r!==``&&!t.mayLoad)return;if(this.drop(),this.#r=s,r!==``){let e=ff(r);this.#o(e,t=>this.#a(e,{src:r,type:i},t));return}let c;try{c=a===null?of:sf(a,o)}catch(e){this.fail(null,e);return}c instanceof Promise?this.#o(null,()=>c):t.arrived(c,null,!1)}fail(e,t){this.#n=!0,this.#e.failed(e,t)}retry(){this.#n&&(this.#r=null)}suspend(){this.pending&&this.drop()}drop(){let e=this.pending||this.#n;this.#t?.abort(),this.#t=null,this.#n=!1,this.#r=null,e&&this.#e.dropped()}#i({src:e,type:t,geometry:n,segments:r}){return e===``?[n,r]:[e,t,this.#e.crossOrigin]}async#a(e,{src:t,type:n},r){if(e===null)throw TypeError(`src=${JSON.stringify(t)} is not an address`);let{crossOrigin:i}=this.#e;return uf(e,{signal:r,onProgress:(e,t)=>{this.#e.progress(e,t)},crossOrigin:i,type:n??``},typeof t==`string`?null:t)}#o(e,t){let n=new AbortController;this.#t=n,t(n.signal).then(t=>{this.#t===n?(this.#t=null,this.#e.arrived(t,e,!0)):t.dispose()},t=>{this.#t===n&&(this.#t=null,n.abort(),this.fail(e,t))})}};function ff(e){return typeof e==`string`?URL.canParse(e,document.baseURI)?new URL(e,document.baseURI):null:new URL(encodeURIComponent(pe(e)),`file:///`)}var pf=new WeakMap;function mf(e){let t=pf.get(e);if(t)return t;let n=hf(e);return pf.set(e,n),e.addEventListener(`dispose`,()=>{n.dispose()}),n}function hf(e){let{index:t}=e,n=t?.count??e.getAttribute(`position`).count,r=n-n%3,i=new tt;i.name=e.name;for(let[n,a]of Object.entries(e.attributes)){if(n===`normal`)continue;let e=gf(a,t,r);i.setAttribute(n,new jt(e,a.itemSize)),n===`position`&&i.setAttribute(`normal`,new jt(_f(e),3))}return i}function gf(e,t,n){let{itemSize:r,array:i}=e,a=new Float32Array(n*r),o=`isBufferAttribute`in e&&i instanceof Float32Array;for(let s=0;s<r;s+=1)for(let c=0,l=s;c<n;c+=1,l+=r){let n=t===null?c:t.array[c];a[l]=o?i[n*r+s]:e.getComponent(n,s)}return a}function _f(e){let t=new Float32Array(e.length);for(let n=0;n<e.length;n+=9){let r=e[n],i=e[n+1],a=e[n+2],o=e[n+3]-r,s=e[n+4]-i,c=e[n+5]-a,l=e[n+6]-r,u=e[n+7]-i,d=e[n+8]-a,f=s*d-c*u,p=c*l-o*d,m=o*u-s*l,h=Math.sqrt(f*f+p*p+m*m);if(h>0)for(let e=n;e<n+9;e+=3)t[e]=f/h,t[e+1]=p/h,t[e+2]=m/h}return t}var vf=2**28,yf=2**24,bf=3*2**20,xf=1e8,Sf=1e4,Cf=3e4,wf=2**21,Tf=2**26,Ef=8192,Df=2**25,Of=95e7,kf=class{#e=0;#t=0;#n=0;#r=0;#i=0;#a=0;add({corners:e=0,values:t=0,parts:n=0,nodes:r=0,json:i=0,pixels:a=0}){Af(this.#i+=i,wf,`values in its JSON`),Af(this.#r+=r,Cf,`nodes`),Af(this.#n+=n,Sf,`draws`),Af(this.#e+=e,yf,`triangle corners`),Af(this.#t+=t,xf,`numbers in its vertices`),Af(this.#a+=a,Tf,`pixels in its images`),Af(this.#o,Of,`bytes in memory (vertices and images)`)}get#o(){let e=Math.min(this.#a,Df);return Math.ceil(8*this.#t+9.4*this.#a+8*e+12e3*this.#n+2e3*this.#r)}};function Af(e,t,n){if(e<=t)return;let[r,i]=[e,t].map(e=>e.toLocaleString(`en`));throw new Gt(`too-large`,`The model has ${r??``} ${n}; at most ${i??``} can be shown.`)}var jf={content:of,parts:[],root:null,url:null};function Mf(e,t){return t&&Nf(e),e.map(({geometry:e})=>{if(pc(e),!t)return e;let n=mf(e);return mc(e,n),n})}function Nf(e){let t=0;for(let{attributes:n,index:r}of new Set(e.map(({geometry:e})=>e))){let e=Object.entries(n).map(([e,{itemSize:t}])=>e===`normal`?0:t),i=r?.count??n.position?.count??0;t+=i*e.reduce((e,t)=>e+t,3)}if(t>1e8)throw new Gt(`too-large`,`The model has too many triangles for shading="flat".`)}function Pf(e,t,n,r){return e.parts.map((e,i)=>{let a=r(e),o=n.acquire(a),s=new Et(t[i],o);return s.name=e.name,s.matrixAutoUpdate=!1,{mesh:s,material:o,look:a.look,surface:a.surface,source:e}})}function Ff(e){let[t]=e;if(t===void 0)return null;if(e.length===1&&t.source.matrix.equals(If))return t.mesh;let n=new Oe;n.matrixAutoUpdate=!1;for(let{mesh:t,source:r}of e)t.matrix.copy(r.matrix),n.add(t);return n}var If=new Qe,Lf=[`ka`,`kd`,`ks`,`shininess`];function Rf(e,t){let n={};for(let r of Lf)n[r]=e.given(r)?e.values[r]:t.surface[r]??e.values[r];return n}function zf(e,{look:t}){if(t.roughness===null||!e.given(`shininess`))return t;let n=Bf.get(t)??{...t,roughness:null};return Bf.set(t,n),n}var Bf=new WeakMap,Vf=(e,t)=>e.ka===t.ka&&e.kd===t.kd&&e.ks===t.ks&&e.shininess===t.shininess,Hf=class{#e;#t;#n;#r=null;#i=jf;#a=null;#o=!1;#s=[];#c=null;#l=null;#u=null;constructor(e,t){this.#e=e,this.#t=t,this.#n=new df({get crossOrigin(){return t.crossOrigin},get mayLoad(){return t.mayLoad},progress:(e,n)=>{t.progress(this,e,n)},arrived:(e,n,r)=>{this.#_(e,n)&&r&&(this.#g(),this.restyle(),t.ended(this,n,null))},failed:(e,n)=>{t.ended(this,e,n)},dropped:()=>{t.dropped(this)}})}get root(){return this.#i.root}attach(e){this.#r=e,this.root!==null&&e.add(this.root)}get#d(){return this.#e.values}get loading(){return this.#n.pending}get wanted(){return this.#d.src!==``||this.#d.geometry!==null}get complete(){return this.root===null||!this.#n.has(this.#d)?null:this.#i.url===null?`shape`:`model`}get parts(){return this.#i.parts}update(){this.#n.request(this.#d),this.#g(),this.restyle()}retry(){this.#n.retry()}suspend(){this.#n.suspend()}drawn(){this.#a!==null&&this.#y(this.#a),this.#a=null}revert(e){let t=this.#i;this.#v(this.#a??jf),this.#a=null,this.#y(t),this.#l=null,this.#g(),this.restyle(),this.#n.fail(t.url,Zd(e)?e:Uf(e))}restyle(){let{reflection:e=null}=this.#d,{materials:t}=this.#t,n=this.#f(),r=n!==this.#c||e!==this.#u;this.#c=n,this.#u=e;for(let e of this.#i.parts){let n=this.#h(e.source),{look:i,surface:a}=n;(r||i!==e.look||!Vf(a,e.surface))&&(e.look=i,e.surface=a,e.material=t.exchange(e.material,n),e.mesh.material=e.material)}this.#t.changed()}#f(){let{shading:e=null}=this.#d,t=this.#m;if(t===`flat`&&this.#o)return this.#l;if(t!==this.#l)try{let e=Mf(this.#i.content.parts,t===`flat`);this.parts.forEach(({mesh:t},n)=>{t.geometry=e[n]}),this.#l=t}catch(e){return this.#o=!0,this.#t.ended(this,this.#i.url,e),this.#l}return this.#p(),e}#p(){this.#o&&this.#t.dropped(this),this.#o=!1}get#m(){return this.#d.shading??this.#t.materials.style.shading}dispose(){this.#n.drop(),this.#t.removed(this),this.#r=null;let e=this.#i;this.#v(jf),this.#y(e),this.drawn()}#h(e){let t=this.#e,n=zf(t,e),r=Rf(t,e),{sides:i}=e;return{look:n,sides:i,surface:r,shading:this.#c,reflection:this.#u}}#g(){let{position:e=Wf,rotation:t=Wf,scale:n=Gf,name:r=``}=this.#d,[i]=this.parts,{root:a}=this;a!==null&&(a.name=r===``&&i?.mesh===a?i.source.name:r);let o=[e,t,n];o.every((e,t)=>e===this.#s[t])||(this.#s=o,a!==null&&(a.position.set(...e),a.rotation.set(se(t[0]),se(t[1]),se(t[2])),a.scale.set(...n),a.updateMatrix()),this.#t.reshaped())}#_(e,t){let n;try{n=Mf(e.parts,this.#m===`flat`)}catch(n){return e.dispose(),this.#n.fail(t,n),!1}this.#l=this.#m;let{shading:r=null,reflection:i=null}=this.#d;this.#c=r,this.#u=i;let a=Pf(e,n,this.#t.materials,e=>this.#h(e)),o={content:e,parts:a,root:Ff(a),url:t},s=this.#i;this.#v(o),this.#p();let c=o.root!==null&&this.#t.shown(this);return c&&this.#a===null?this.#a=s:(this.#y(s),c||this.drawn()),!0}#v(e){this.root?.removeFromParent(),this.#i=e,e.root!==null&&this.#r?.add(e.root),this.#s=[]}#y({content:e,parts:t}){for(let{material:e}of t)this.#t.materials.release(e);e.dispose()}};function Uf(e){return new Gt(`bad-model`,`Drawing failed: ${String(e)}`,{cause:e})}var Wf=[0,0,0],Gf=[1,1,1],Kf=()=>new t({space:`camera`,position:[0,0,1,0]}),qf=class{#e;#t;#n;#r=Kf();#i=new Map;#a=new Map;#o=new Map;#s=new Set;#c=new Set;#l=[];#u=Object.freeze([]);#d=Object.freeze([]);constructor(e,t){this.#e=e,this.#t=t,this.#n=qt(e),t.lightSet.assign([this.#r]),this.#n.listen(this)}get lights(){return this.sort(),this.#u}get meshes(){return this.sort(),this.#d}get sceneMeshes(){return this.#a.keys()}lightOf(e){return this.#i.get(e)??null}elementOf(e){return this.#a.get(e)}added(e){e instanceof En?this.#p(e):e instanceof bs&&this.#g(e)}removed(e){e instanceof En?this.#m(e):e instanceof bs&&this.#_(e)}moved(){this.#t.viewport.invalidate()}connected(){this.refresh(),_n(this.#e),this.#e.shadowRoot?.addEventListener(`slotchange`,this.#f)}#f=()=>vn(this.#e);refresh(){let e=this.#e.querySelectorAll(`phong-light, phong-mesh`);for(let t of[...this.#n.inOrder,...e])wn(t)}sort(){this.#e.isConnected||this.refresh();let{inOrder:e}=this.#n;e!==this.#l&&(this.#l=e,this.#h(e.filter(e=>e instanceof En)),this.#y(e.filter(e=>e instanceof bs)))}flush=()=>{if(this.#s.size===0&&this.#c.size===0)return;let e=[...this.#s],t=[...this.#c];this.#s.clear(),this.#c.clear();for(let e of t)this.#v(e);for(let t of e)this.#a.has(t)&&t.update();this.#t.meshesChanged()};#p(e){let{lightSet:t}=this.#t,n=F(e).store;this.#i.set(n,e),this.#i.size===1?t.assign([n]):t.add(n)}#m(e){let{lightSet:t}=this.#t,n=F(e).store;this.#i.delete(n),this.#i.size===0?t.assign([this.#r]):t.remove(n)}#h(e){Jf(e,this.#u)||(this.#u=Object.freeze(e),e.length!==0&&this.#t.lightSet.assign(e.map(e=>F(e).store)))}#g(e){let{store:t}=F(e);this.#c.delete(e);let n=this.#o.get(e);if(n===void 0){let r=new Hf(t,this.#t.meshHost);n={mesh:r,written:e=>{(e===`src`||e===`geometry`)&&r.retry(),this.#b(r)}},this.#o.set(e,n),this.#a.set(r,e),this.#t.viewport.add(r)}t.listen(n.written),n.written()}#_(e){this.#x(),this.#c.add(e)}#v(e){let t=this.#o.get(e);t!==void 0&&(F(e).store.unlisten(t.written),this.#o.delete(e),this.#a.delete(t.mesh),this.#t.viewport.remove(t.mesh))}#y(e){Jf(e,this.#d)||(this.#d=Object.freeze(e),this.#t.viewport.arrange(e.flatMap(e=>this.#o.get(e)?.mesh??[])),this.#t.meshesChanged())}#b(e){this.#x(),this.#s.add(e)}#x(){this.#s.size===0&&this.#c.size===0&&queueMicrotask(this.flush)}},Jf=(e,t)=>e.length===t.length&&e.every((e,n)=>e===t[n]),Yf=class{#e;#t=new Map;#n=new Set;constructor(e){this.#e=e}enqueue(e,t,n=null){this.#t.size===0&&Promise.resolve().then(this.#r);let r=this.#t.get(e)??new Map;this.#t.set(e,r.set(n,t))}enqueueLight(e){(e===null||this.#n.size===0)&&this.enqueue(`light-change`,{lights:[]}),e!==null&&this.#n.add(e)}#r=()=>{let e=this.#t;this.#t=new Map,e.get(`light-change`)?.set(null,{lights:Object.freeze([...this.#n])}),this.#n.clear();for(let[t,n]of e)for(let e of n.values())this.#e.dispatchEvent(new CustomEvent(t,{detail:e}))}};function Xf(e){let t=0,n=t=>{let{dataTransfer:n,defaultPrevented:r}=t;return!e.droppable||r||n?.types.includes(`Files`)!==!0?null:(t.preventDefault(),n)};e.addEventListener(`dragover`,e=>{let t=n(e);t!==null&&(t.dropEffect=`copy`)}),e.addEventListener(`drop`,r=>{let i=n(r);if(i===null)return;let a=Array.from(i.items,e=>e.webkitGetAsEntry()).filter(e=>e!==null),o=[...i.files],s=++t;lf().then(({droppedModel:e})=>e(a,o)).then(n=>{s===t&&n!==null&&(e.src=n)}).catch(e=>{console.warn(`<phong-viewer droppable>: ${String(e)}`)})})}function Zf(e,t){let n=Qf(e),r=e instanceof Error?e.message:String(e);return n===`too-large`&&!(e instanceof Gt)&&(r=`There is not enough memory to show this.`),{code:n,message:l(r),url:t?.href??null}}function Qf(e){return e instanceof Gt?e.code:Zd(e)?`too-large`:e instanceof Cu?`no-webgl2`:`load-failed`}var $f=class{#e;#t=new ep;ownMesh;#n=!1;#r=!1;#i;#a=new Set;constructor(e){this.#e=e,this.ownMesh=new Hf(e.store,this),e.viewport.add(this.ownMesh),Xf(e.viewer)}get materials(){return this.#e.viewport.materials}get crossOrigin(){return this.#e.store.values.crossOrigin}get mayLoad(){return!this.#r&&(this.#n||this.#e.store.values.loading!==`lazy`)}changed(){this.#e.viewport.invalidate()}reshaped(){this.#e.viewport.reshaped()}shown(e){return this.#a.add(e),this.#e.viewport.drawable}drawn(){for(let e of this.#a)e.drawn();this.#a.clear()}undrawable(e,t){let n=[...this.#a];if(n.length===0)return!1;let r=e=>{for(let{root:t}of n)t!==null&&(t.visible=e)};r(!1);try{t()}catch{return!1}finally{r(!0)}this.#a.clear();for(let t of n)t.revert(e);return!0}removed(e){this.#a.delete(e)}progress(e,t,n){this.#t.update(e,t,n),this.#o()}dropped(e){this.#t.end(e),this.#e.cleared(e)}ended(e,t,n){this.#t.end(e);let r=this.#e.elementOf(e);if(n!==null){let i=Zf(n,t);r?.dispatchEvent(new CustomEvent(`error`,{detail:i})),this.#e.failed(e,i)}else if(t!==null){let e={url:t.href};this.#o(),r?.dispatchEvent(new CustomEvent(`load`,{detail:e})),this.#e.events.enqueue(`load`,e,e)}this.#e.ended()}get pending(){return this.#s().some(e=>e.loading)}get loaded(){let e=this.#s().filter(e=>e.wanted);return e.length>0&&e.every(e=>e.complete===`model`||e.complete===`shape`&&!this.#a.has(e))}hostConnected(){clearTimeout(this.#i),this.#r&&(this.#r=!1,this.update())}hostDisconnected(){this.#i=setTimeout(()=>{this.#r=!0;for(let e of this.#s())e.suspend()})}neared(){this.#n||(this.#n=!0,this.#e.store.values.loading===`lazy`&&this.update())}apply(e){(e.has(`src`)||e.has(`geometry`))&&this.ownMesh.retry(),Qu.some(t=>e.has(t))&&this.update()}update(){for(let e of this.#s())e.update()}#o(){this.#e.events.enqueue(`progress`,{totalProgress:this.#t.share})}#s(){return[this.ownMesh,...this.#e.childMeshes()]}},ep=class{#e=new Map;update(e,t,n){this.#e.set(e,{loaded:t,total:n})}end(e){this.#e.delete(e)}get share(){let e=0,t=0;for(let n of this.#e.values())n.total>0&&(e+=Math.min(n.loaded,n.total)),t+=n.total>0?n.total:n.loaded;return t>0?e/t:1}},tp={},np=class{#e;#t;#n=new Map;constructor(e,t){this.#e=e,this.#t=t}get message(){return[...this.#n.values()].at(-1)?.message??null}report(e,t){this.#n.delete(e),this.#n.set(e,t),this.#e.requestUpdate(),this.#t.enqueue(`error`,t,t)}cleared(e){this.#n.delete(e)&&this.#e.requestUpdate()}contextMissing(e){this.#r(Zf(e,null))}contextLost(){this.#r({code:`context-lost`,message:`The graphics context was lost. The picture returns when the browser restores the context.`,url:null})}contextRestored(){this.cleared(tp)}#r(e){this.#n.get(tp)?.code!==e.code&&this.report(tp,e)}},rp=null;function ip(e){rp=e}var ap=class{#e;#t=new Set;#n=null;#r=!1;constructor(e){this.#e=e}async toggle(e,t){if(this.#r=e,!e){this.#n?.dispose(),this.#n=null;return}if(rp===null||t===null)return;let n=await rp().catch(e=>{console.warn(`<phong-viewer gui>: ${e.message}`)});if(n===void 0)return;let r=this.#e.shadowRoot;this.#r&&this.#n===null&&r!==null&&(this.#n=n.createPanel(this.#e,t,r))}changed(e){this.#n!==null&&(this.#t.size===0&&queueMicrotask(this.#i),this.#t.add(e))}#i=()=>{let e=[...this.#t];this.#t.clear();for(let t of e)this.#n?.update(t)}},op=class{#e;#t=Promise.resolve();#n=null;constructor(e){this.#e=e}get promise(){return this.check(),this.#n===null&&!this.#e()&&this.#r(),this.#t}supersede(){this.#n!==null&&this.#r()}check(){let e=this.#n;e!==null&&this.#e()&&(e(),this.#n===e&&(this.#n=null))}#r(){this.#n?.(),this.#t=new Promise(e=>{this.#n=e})}};function sp(e){let{theta:t,phi:n,radius:r,target:i}=e.camera,a=[...e.meshes.map(e=>cp(e,F(e).store)+dp(e)),...e.lights.map(e=>cp(e,F(e).store)+dp(e))],o=a.length===0?``:`\n${a.map(e=>`  ${e}\n`).join(``)}`;return cp(e,F(e).store,{theta:t,phi:n,radius:r,target:i})+o+dp(e)}function cp({localName:e},t,n={}){let r=`<${e}`;for(let i of Object.keys(t.fields)){let a=i in n;if(!a&&!t.given(i))continue;let o=a?n[i]:t.values[i],s=o instanceof Blob?up(e,o):b(o,t.fields[i]);s!==null&&(r+=` ${v(i)}${s===``?``:`="${fp(s)}"`}`)}return`${r}>`}var lp=new WeakSet;function up(e,t){let n=pe(t);return lp.has(t)||(lp.add(t),console.warn(`<${e} src="${n}"> is a file on this device. The markup shows it once it is hosted beside the page.`)),encodeURIComponent(n)}var dp=({localName:e})=>`</${e}>`,fp=e=>e.replace(/[&"<>\r]/g,e=>`&#${String(e.charCodeAt(0))};`);function pp(e,t,n,r){let{holder:i}=t,a=i.currentCSSZoom??1;return{scene:i.getClientRects().length>0?t.snapshot(t=>n.elementOf(t)??e):null,width:r.width*a,height:r.height*a,lights:t.lighting.lights.lights.map((e,t)=>{let r=n.lightOf(e);return{light:r,name:r===null?`head-light`:e.values.name||Dn(t),values:{...e.values}}})}}function mp(e,t){let n=t.width??Math.max(e.width,1),r=t.height??Math.max(e.height,1);return[n,r].every(e=>Number.isInteger(e)&&e>=1)?e.capture(n,r):null}var hp={picture:Qo(()=>mn(()=>import(`./picture-blob-V6Sz6c5w.js`),[],import.meta.url),`toBlob`),shadeAt:Qo(()=>mn(()=>import(`./shade-at-CFth73sH.js`),__vite__mapDeps([13,8,7,3,14]),import.meta.url),`shadeAt`)},gp=class extends Us{static shadowRootOptions={mode:`open`,delegatesFocus:!0};static get observedAttributes(){return[...super.observedAttributes,...x(Xu),...nn]}#e=new e(Xu);#t=new ae(this,this.#e,e=>{this.#f.assigned(e),Zu.has(e)&&this.requestUpdate(e)});#n=Object.assign(document.createElement(`div`),{className:`holder`});#r=new Yf(this);#i=new ap(this);#a=new vd(this);#o=new np(this,this.#r);#s=new op(()=>this.#v);#c=new Ws(e=>{this.#l.invalidate();let t=e===null?null:this.#d.lightOf(e);this.#r.enqueueLight(t),this.#i.changed(t===null?`lights`:`light`)});#l=new Ju(this.#n,this.#c,{needsLayout:()=>this.#p.look(),beforeFrame:e=>(this.#d.sort(),this.#f.frame(e)),painted:()=>this.#u.drawn(),undrawable:(e,t)=>this.#u.undrawable(e,t),drawn:()=>{this.#y(),this.dispatchEvent(new CustomEvent(`render`))},afterFrame:()=>this.#s.check(),fitted:()=>this.#b(`auto`),contextMissing:e=>this.#o.contextMissing(e),contextLost:()=>this.#o.contextLost(),contextRestored:()=>this.#o.contextRestored()});#u=new $f({viewer:this,store:this.#e,viewport:this.#l,events:this.#r,elementOf:e=>this.#d.elementOf(e),childMeshes:()=>this.#d.sceneMeshes,failed:(e,t)=>this.#o.report(e,t),cleared:e=>{this.#o.cleared(e),queueMicrotask(()=>this.#s.check())},ended:()=>this.#s.check()});#d=new qf(this,{viewport:this.#l,lightSet:this.#c,meshHost:this.#u,meshesChanged:()=>this.#i.changed(`meshes`)});#f=new Xd({values:this.#e.values,viewport:this.#l,moved:e=>this.#b(e)});#p=new sd(this,this.#n,e=>{e.near&&this.#u.neared(),this.#l.resize(e.pixelWidth,e.pixelHeight),this.#l.near=this.#e.values.loading===`eager`?e.painted:e.near,e.printing&&(this.#d.sort(),this.#l.redraw()),this.#f.resized(),this.#f.inView=e.visible,this.#s.check()});#m=null;#h=!1;constructor(){super(),this.#e.listen(e=>this.requestUpdate(e));for(let e of[this.#p,this.#f,this.#u,this.#a])this.addController(e);_.set(this,this.#f)}get lights(){return this.#d.lights}get meshes(){return this.#d.meshes}get camera(){return this.#_(),this.#f.state}get loaded(){return this.#_(),this.#u.loaded}get scene(){return this.#l.scene}get stats(){return{lightsDeclared:this.lights.length,...this.#l.stats}}get ready(){return this.#s.promise}requestRender(){this.#l.invalidate()}refit(){this.#l.refit()}async toBlob(e={}){this.#_();let t=mp(this.#l,e);return(await hp.picture()).pictureBlob(t,e)}async shadeAt(e,t){this.#_();let n=pp(this,this.#l,this.#d,this.#p.size);return(await hp.shadeAt()).shadeAt(n,e,t)}toHTML(){return sp(this)}resetCamera(){this.#f.reset()}connectedCallback(){this.ownerDocument.defaultView!==null&&(super.connectedCallback(),td(this.renderRoot,hd),this.#t.upgrade(),this.performUpdate(),this.#d.connected(),this.#l.attach())}disconnectedCallback(){super.disconnectedCallback(),this.#l.detach(),this.#s.check()}connectedMoveCallback(){this.#p.look()}attributeChangedCallback(e,t,n){super.attributeChangedCallback(e,t,n),this.#t.attributeChanged(e,n)||this.requestUpdate()}createRenderRoot(){let e=super.createRenderRoot();return this.#m=new $t(e,this.#n),this.#f.listenTo(this.#m.surface),this.#a.connect(this.#m),e}update(e){super.update(e),this.#m?.update({poster:this.#h?``:this.poster,fixed:!this.orbit,notice:this.#o.message}),this.#a.update()}updated(e){e.size>0&&this.#g(e)}#g(e){let{values:t}=this.#e,n=this.#l;if(n.fov=t.fov,n.linear=t.colorInterpolation===`linear`,[`shading`,`reflection`,`terms`,`antialias`].some(t=>e.has(t))){let{shading:e,reflection:r,terms:i,antialias:a}=t;n.style={shading:e,reflection:r,terms:i,antialias:a}}e.has(`src`)&&this.#s.supersede(),this.#u.apply(e),e.has(`loading`)&&this.#p.shown(),e.has(`autoRotate`)&&this.#f.turning&&n.animate(),e.has(`gui`)&&this.#i.toggle(t.gui,this.#m?.panel??null),this.#i.changed(`viewer`)}#_(){this.isUpdatePending&&this.hasUpdated?this.performUpdate():this.hasUpdated||this.#g({has:()=>!0}),this.#p.connected&&!this.#p.looked&&this.#p.look(),this.#d.sort(),this.#d.flush()}get#v(){return this.#_(),!this.#p.connected||!this.#u.pending&&(this.#l.upToDate||!this.#l.drawable)}#y(){this.#h||this.#u.pending||this.#o.message!==null||(this.#h=!0,this.#e.values.poster!==``&&this.requestUpdate())}#b(e){this.hasUpdated&&this.#r.enqueue(`camera-change`,{source:e}),this.#i.changed(`camera`)}};if(y(gp.prototype,Xu),ip(Qo(()=>mn(()=>import(`./panel-BLZleFSd.js`),__vite__mapDeps([15,2,1,3,4,5,16]),import.meta.url),`the control panel`)),typeof customElements<`u`&&typeof document<`u`)for(let[e,t]of[[`phong-light`,En],[`phong-mesh`,bs],[`phong-viewer`,gp]])customElements.get(e)===void 0&&customElements.define(e,t);function _p(e){for(let t of e.querySelectorAll(`input[data-for]`)){let{for:e,set:n,values:r,format:i=`{}`}=t.dataset,a=document.getElementById(e??``);if(a===null||n===void 0)throw Error(`a dial needs data-for and data-set`);let o=r?.split(` `),s=t.parentElement?.querySelector(`output`),c=()=>{let e=o?.[t.valueAsNumber]??t.value;return s&&(s.textContent=e),t.setAttribute(`aria-valuetext`,e),e};t.addEventListener(`input`,()=>{a.setAttribute(n,i.replace(`{}`,c()))}),c()}}function vp(e){for(let t of e.querySelectorAll(`[data-linked]`)){let e=[...t.querySelectorAll(`phong-viewer`)];for(let t of e)t.addEventListener(`camera-change`,n=>{let{source:r}=n.detail;if(r!==`pointer`&&r!==`key`)return;let{theta:i,phi:a}=t.camera;for(let n of e)n!==t&&Object.assign(n,{theta:i,phi:a})})}}function yp(e,t){let n=[...e.children].flatMap(e=>[Sp(`
`),...bp(e,`  `,t),...xp(e)]),r=n.length===0?xp(e):[Sp(`
`),...xp(e)];return[...bp(e,``,t),...n,...r]}function bp(e,t,n){let r=e.localName,i=[Sp(`${t}<`),{kind:`tag`,text:r}],a=t.length+1+r.length;for(let{name:r,value:o}of e.attributes){if(/^(id|class|loading|data-.*)$/.test(r))continue;let e=o===``?``:`"${o.replaceAll(`&`,`&amp;`).replaceAll(`"`,`&quot;`)}"`,s=r.length+(e===``?0:e.length+1),c=a+1+s>n,l=c?`\n${t}    `:` `;a=(c?t.length+4:a+1)+s,i.push(Sp(l+r+(e===``?``:`=`))),e!==``&&i.push({kind:`value`,text:e})}return[...i,Sp(`>`)]}var xp=e=>[Sp(`</`),{kind:`tag`,text:e.localName},Sp(`>`)],Sp=e=>({kind:`plain`,text:e});function Cp(e){for(let t of e.querySelectorAll(`.aside, .wide`)){let e=t.querySelectorAll(`phong-viewer`);e.length>0&&t.append(Tp([...e]))}for(let t of e.querySelectorAll(`.listing[data-of]`))Ep([...e.querySelectorAll(t.dataset.of??``)],wp(t,t.dataset.title??`The markup of this picture`))}function wp(e,t){let n=document.createElement(`pre`);n.translate=!1,e.classList.contains(`tall`)&&(n.tabIndex=0,n.setAttribute(`role`,`region`),n.setAttribute(`aria-label`,t));let r=document.createElement(`div`);r.className=`caption`;let i=document.createElement(`span`);return i.textContent=t,r.append(i,kp(n,t)),e.append(r,n),n}function Tp(e){let t=document.createElement(`details`);t.className=`source`;let n=document.createElement(`summary`);n.textContent=`markup`;let r=document.createElement(`div`);return r.className=`listing`,t.append(n,r),Ep(e,wp(r,e.length>1?`The picture last touched`:`This picture`)),t}function Ep(e,t){let[n]=e,r=()=>{n!==void 0&&t.replaceChildren(...yp(n,Dp()).map(Op))},i=new MutationObserver(r);for(let t of e)i.observe(t,{attributes:!0,childList:!0,subtree:!0}),t.addEventListener(`focusin`,()=>{n=t,r()});r()}var Dp=()=>Math.min(76,Math.floor(document.documentElement.clientWidth/8.5));function Op({kind:e,text:t}){if(e===`plain`)return document.createTextNode(t);let n=document.createElement(`span`);return n.className=e,n.textContent=t,n}function kp(e,t){let n=document.createElement(`button`);return n.type=`button`,n.textContent=`Copy`,n.setAttribute(`aria-label`,`Copy: ${t}`),n.addEventListener(`click`,()=>{Ap(e).then(e=>{n.textContent=e?`Copied`:`Selected`,setTimeout(()=>n.textContent=`Copy`,1500)})}),n}async function Ap(e){try{return await navigator.clipboard.writeText(e.textContent),!0}catch{return getSelection()?.selectAllChildren(e),!1}}Cp(document),_p(document),vp(document);export{jn as A,Tr as C,pr as D,dr as E,Jt as F,yn as M,mn as N,mr as O,sn as P,Er as S,br as T,tl as _,Df as a,Qo as b,Sf as c,$d as d,Qd as f,Cu as g,nd as h,bf as i,kn as j,An as k,Af as l,td as m,vf as n,Ef as o,Zd as p,yf as r,kf as s,wp as t,rf as u,Jc as v,Or as w,Dr as x,kc as y};