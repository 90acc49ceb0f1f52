/*!
 * phong-viewer 0.1.0, MIT
 */
import{t as e}from"./page-CQ301dgX.js";var t=document.querySelector(`phong-viewer`),n=t.getElementsByTagName(`phong-light`);function r(){let e=n.length*2.39996,r=.27*Math.sqrt(n.length),i=document.createElement(`phong-light`);i.setAttribute(`position`,`${(r*Math.cos(e)).toFixed(2)} 1.4 ${(r*Math.sin(e)).toFixed(2)}`),i.setAttribute(`axis`,`0 -1 0`),i.setAttribute(`aperture`,`10`),i.setAttribute(`cutoff`,`240`),i.setAttribute(`diffuse`,`hsl(${n.length*47%360} 80% 62%)`),t.append(i)}function i(){n.length>1&&n[n.length-1].remove()}function a(){for(let e of n)e.setAttribute(`active`,String(!e.active))}var o=64;function s(e){let t=document.querySelector(`#count`),n=document.querySelector(`#tally`),s=document.querySelector(`#switches`);if(t===null||n===null||s===null)throw Error(`the board is not on this page`);let l=e.getElementsByTagName(`phong-light`),u=e=>{for(;l.length>e;)i();for(;l.length<e;)r()},d=()=>{t.value=String(l.length),n.textContent=t.value,s.replaceChildren(...Array.from(l,c))},f=(e,t)=>{document.getElementById(e)?.addEventListener(`click`,t)};f(`add`,()=>u(Math.min(l.length+1,o))),f(`remove`,i),f(`toggle`,()=>{a(),d()}),t.addEventListener(`input`,()=>u(t.valueAsNumber)),new MutationObserver(d).observe(e,{childList:!0}),u(t.valueAsNumber)}function c(e){let t=document.createElement(`label`),n=document.createElement(`input`);return n.type=`checkbox`,n.checked=e.active,n.setAttribute(`aria-label`,e.name),n.style.accentColor=e.getAttribute(`axis`)===null?``:e.getAttribute(`diffuse`)??``,n.addEventListener(`change`,()=>{e.setAttribute(`active`,String(n.checked))}),t.append(n),t}var l=`const viewer = document.querySelector('phong-viewer')!;
const lights = viewer.getElementsByTagName('phong-light');

/** Adds a spot on a spiral. The golden angle, about 137.5°, spreads the spots evenly. */
export function add() {
  const turn = lights.length * 2.39996;
  const r = 0.27 * Math.sqrt(lights.length);
  const light = document.createElement('phong-light');
  light.setAttribute('position', \`\${(r * Math.cos(turn)).toFixed(2)} 1.4 \${(r * Math.sin(turn)).toFixed(2)}\`);
  light.setAttribute('axis', '0 -1 0');
  light.setAttribute('aperture', '10');
  light.setAttribute('cutoff', '240');
  light.setAttribute('diffuse', \`hsl(\${(lights.length * 47) % 360} 80% 62%)\`);
  viewer.append(light);
}

export function remove() {
  if (lights.length > 1) lights[lights.length - 1]!.remove();
}

export function toggle() {
  for (const light of lights) light.setAttribute('active', String(!light.active));
}
`,u=document.querySelector(`phong-viewer`);u!==null&&s(u);var d=document.getElementById(`script`);if(d!==null){let t=l.trim().replaceAll(/^export /gm,``);e(d,d.dataset.title??``).textContent=t}