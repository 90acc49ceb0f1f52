/*!
 * lil-gui 0.21.0: Copyright (c) 2019 George Michael Brower, MIT
 * Licences: THIRD-PARTY-LICENSES.txt
 */
import{S as e,_ as t,g as n,s as r,x as i}from"./description-C1KtsLjY.js";import{n as a,o,r as s}from"./light-state-BZRv3YOF.js";import{C as c,S as l,h as u,m as d,w as f,x as p,y as ee}from"./page-CQ301dgX.js";var m=class e{constructor(t,n,r,i,a=`div`){this.parent=t,this.object=n,this.property=r,this._disabled=!1,this._hidden=!1,this.initialValue=this.getValue(),this.domElement=document.createElement(a),this.domElement.classList.add(`lil-controller`),this.domElement.classList.add(i),this.$name=document.createElement(`div`),this.$name.classList.add(`lil-name`),e.nextNameID=e.nextNameID||0,this.$name.id=`lil-gui-name-${++e.nextNameID}`,this.$widget=document.createElement(`div`),this.$widget.classList.add(`lil-widget`),this.$disable=this.$widget,this.domElement.appendChild(this.$name),this.domElement.appendChild(this.$widget),this.domElement.addEventListener(`keydown`,e=>e.stopPropagation()),this.domElement.addEventListener(`keyup`,e=>e.stopPropagation()),this.parent.children.push(this),this.parent.controllers.push(this),this.parent.$children.appendChild(this.domElement),this._listenCallback=this._listenCallback.bind(this),this.name(r)}name(e){return this._name=e,this.$name.textContent=e,this}onChange(e){return this._onChange=e,this}_callOnChange(){this.parent._callOnChange(this),this._onChange!==void 0&&this._onChange.call(this,this.getValue()),this._changed=!0}onFinishChange(e){return this._onFinishChange=e,this}_callOnFinishChange(){this._changed&&(this.parent._callOnFinishChange(this),this._onFinishChange!==void 0&&this._onFinishChange.call(this,this.getValue())),this._changed=!1}reset(){return this.setValue(this.initialValue),this._callOnFinishChange(),this}enable(e=!0){return this.disable(!e)}disable(e=!0){return e===this._disabled||(this._disabled=e,this.domElement.classList.toggle(`lil-disabled`,e),this.$disable.toggleAttribute(`disabled`,e)),this}show(e=!0){return this._hidden=!e,this.domElement.style.display=this._hidden?`none`:``,this}hide(){return this.show(!1)}options(e){let t=this.parent.add(this.object,this.property,e);return t.name(this._name),this.destroy(),t}min(e){return this}max(e){return this}step(e){return this}decimals(e){return this}listen(e=!0){return this._listening=e,this._listenCallbackID!==void 0&&(cancelAnimationFrame(this._listenCallbackID),this._listenCallbackID=void 0),this._listening&&this._listenCallback(),this}_listenCallback(){this._listenCallbackID=requestAnimationFrame(this._listenCallback);let e=this.save();e!==this._listenPrevValue&&this.updateDisplay(),this._listenPrevValue=e}getValue(){return this.object[this.property]}setValue(e){return this.getValue()!==e&&(this.object[this.property]=e,this._callOnChange(),this.updateDisplay()),this}updateDisplay(){return this}load(e){return this.setValue(e),this._callOnFinishChange(),this}save(){return this.getValue()}destroy(){this.listen(!1),this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.controllers.splice(this.parent.controllers.indexOf(this),1),this.parent.$children.removeChild(this.domElement)}},te=class extends m{constructor(e,t,n){super(e,t,n,`lil-boolean`,`label`),this.$input=document.createElement(`input`),this.$input.setAttribute(`type`,`checkbox`),this.$input.setAttribute(`aria-labelledby`,this.$name.id),this.$widget.appendChild(this.$input),this.$input.addEventListener(`change`,()=>{this.setValue(this.$input.checked),this._callOnFinishChange()}),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.checked=this.getValue(),this}};function h(e){let t,n;return(t=e.match(/(#|0x)?([a-f0-9]{6})/i))?n=t[2]:(t=e.match(/rgb\(\s*(\d*)\s*,\s*(\d*)\s*,\s*(\d*)\s*\)/))?n=parseInt(t[1]).toString(16).padStart(2,0)+parseInt(t[2]).toString(16).padStart(2,0)+parseInt(t[3]).toString(16).padStart(2,0):(t=e.match(/^#?([a-f0-9])([a-f0-9])([a-f0-9])$/i))&&(n=t[1]+t[1]+t[2]+t[2]+t[3]+t[3]),n?`#`+n:!1}var ne={isPrimitive:!0,match:e=>typeof e==`string`,fromHexString:h,toHexString:h},g={isPrimitive:!0,match:e=>typeof e==`number`,fromHexString:e=>parseInt(e.substring(1),16),toHexString:e=>`#`+e.toString(16).padStart(6,0)},_=[ne,g,{isPrimitive:!1,match:e=>Array.isArray(e)||ArrayBuffer.isView(e),fromHexString(e,t,n=1){let r=g.fromHexString(e);t[0]=(r>>16&255)/255*n,t[1]=(r>>8&255)/255*n,t[2]=(r&255)/255*n},toHexString([e,t,n],r=1){r=255/r;let i=e*r<<16^t*r<<8^(n*r|0);return g.toHexString(i)}},{isPrimitive:!1,match:e=>Object(e)===e,fromHexString(e,t,n=1){let r=g.fromHexString(e);t.r=(r>>16&255)/255*n,t.g=(r>>8&255)/255*n,t.b=(r&255)/255*n},toHexString({r:e,g:t,b:n},r=1){r=255/r;let i=e*r<<16^t*r<<8^(n*r|0);return g.toHexString(i)}}];function v(e){return _.find(t=>t.match(e))}var y=class extends m{constructor(e,t,n,r){super(e,t,n,`lil-color`),this.$input=document.createElement(`input`),this.$input.setAttribute(`type`,`color`),this.$input.setAttribute(`tabindex`,-1),this.$input.setAttribute(`aria-labelledby`,this.$name.id),this.$text=document.createElement(`input`),this.$text.setAttribute(`type`,`text`),this.$text.setAttribute(`spellcheck`,`false`),this.$text.setAttribute(`aria-labelledby`,this.$name.id),this.$display=document.createElement(`div`),this.$display.classList.add(`lil-display`),this.$display.appendChild(this.$input),this.$widget.appendChild(this.$display),this.$widget.appendChild(this.$text),this._format=v(this.initialValue),this._rgbScale=r,this._initialValueHexString=this.save(),this._textFocused=!1,this.$input.addEventListener(`input`,()=>{this._setValueFromHexString(this.$input.value)}),this.$input.addEventListener(`blur`,()=>{this._callOnFinishChange()}),this.$text.addEventListener(`input`,()=>{let e=h(this.$text.value);e&&this._setValueFromHexString(e)}),this.$text.addEventListener(`focus`,()=>{this._textFocused=!0,this.$text.select()}),this.$text.addEventListener(`blur`,()=>{this._textFocused=!1,this.updateDisplay(),this._callOnFinishChange()}),this.$disable=this.$text,this.updateDisplay()}reset(){return this._setValueFromHexString(this._initialValueHexString),this}_setValueFromHexString(e){if(this._format.isPrimitive){let t=this._format.fromHexString(e);this.setValue(t)}else this._format.fromHexString(e,this.getValue(),this._rgbScale),this._callOnChange(),this.updateDisplay()}save(){return this._format.toHexString(this.getValue(),this._rgbScale)}load(e){return this._setValueFromHexString(e),this._callOnFinishChange(),this}updateDisplay(){return this.$input.value=this._format.toHexString(this.getValue(),this._rgbScale),this._textFocused||(this.$text.value=this.$input.value.substring(1)),this.$display.style.backgroundColor=this.$input.value,this}},b=class extends m{constructor(e,t,n){super(e,t,n,`lil-function`),this.$button=document.createElement(`button`),this.$button.appendChild(this.$name),this.$widget.appendChild(this.$button),this.$button.addEventListener(`click`,e=>{e.preventDefault(),this.getValue().call(this.object),this._callOnChange()}),this.$button.addEventListener(`touchstart`,()=>{},{passive:!0}),this.$disable=this.$button}},re=class extends m{constructor(e,t,n,r,i,a){super(e,t,n,`lil-number`),this._initInput(),this.min(r),this.max(i);let o=a!==void 0;this.step(o?a:this._getImplicitStep(),o),this.updateDisplay()}decimals(e){return this._decimals=e,this.updateDisplay(),this}min(e){return this._min=e,this._onUpdateMinMax(),this}max(e){return this._max=e,this._onUpdateMinMax(),this}step(e,t=!0){return this._step=e,this._stepExplicit=t,this}updateDisplay(){let e=this.getValue();if(this._hasSlider){let t=(e-this._min)/(this._max-this._min);t=Math.max(0,Math.min(t,1)),this.$fill.style.width=t*100+`%`}return this._inputFocused||(this.$input.value=this._decimals===void 0?e:e.toFixed(this._decimals)),this}_initInput(){this.$input=document.createElement(`input`),this.$input.setAttribute(`type`,`text`),this.$input.setAttribute(`aria-labelledby`,this.$name.id),window.matchMedia(`(pointer: coarse)`).matches&&(this.$input.setAttribute(`type`,`number`),this.$input.setAttribute(`step`,`any`)),this.$widget.appendChild(this.$input),this.$disable=this.$input;let e=()=>{let e=parseFloat(this.$input.value);isNaN(e)||(this._stepExplicit&&(e=this._snap(e)),this.setValue(this._clamp(e)))},t=e=>{let t=parseFloat(this.$input.value);isNaN(t)||(this._snapClampSetValue(t+e),this.$input.value=this.getValue())},n=e=>{e.key===`Enter`&&this.$input.blur(),e.code===`ArrowUp`&&(e.preventDefault(),t(this._step*this._arrowKeyMultiplier(e))),e.code===`ArrowDown`&&(e.preventDefault(),t(this._step*this._arrowKeyMultiplier(e)*-1))},r=e=>{this._inputFocused&&(e.preventDefault(),t(this._step*this._normalizeMouseWheel(e)))},i=!1,a,o,s,c,l,u=e=>{a=e.clientX,o=s=e.clientY,i=!0,c=this.getValue(),l=0,window.addEventListener(`mousemove`,d),window.addEventListener(`mouseup`,f)},d=e=>{if(i){let t=e.clientX-a,n=e.clientY-o;Math.abs(n)>5?(e.preventDefault(),this.$input.blur(),i=!1,this._setDraggingStyle(!0,`vertical`)):Math.abs(t)>5&&f()}if(!i){let t=e.clientY-s;l-=t*this._step*this._arrowKeyMultiplier(e),c+l>this._max?l=this._max-c:c+l<this._min&&(l=this._min-c),this._snapClampSetValue(c+l)}s=e.clientY},f=()=>{this._setDraggingStyle(!1,`vertical`),this._callOnFinishChange(),window.removeEventListener(`mousemove`,d),window.removeEventListener(`mouseup`,f)};this.$input.addEventListener(`input`,e),this.$input.addEventListener(`keydown`,n),this.$input.addEventListener(`wheel`,r,{passive:!1}),this.$input.addEventListener(`mousedown`,u),this.$input.addEventListener(`focus`,()=>{this._inputFocused=!0}),this.$input.addEventListener(`blur`,()=>{this._inputFocused=!1,this.updateDisplay(),this._callOnFinishChange()})}_initSlider(){this._hasSlider=!0,this.$slider=document.createElement(`div`),this.$slider.classList.add(`lil-slider`),this.$fill=document.createElement(`div`),this.$fill.classList.add(`lil-fill`),this.$slider.appendChild(this.$fill),this.$widget.insertBefore(this.$slider,this.$input),this.domElement.classList.add(`lil-has-slider`);let e=(e,t,n,r,i)=>(e-t)/(n-t)*(i-r)+r,t=t=>{let n=this.$slider.getBoundingClientRect(),r=e(t,n.left,n.right,this._min,this._max);this._snapClampSetValue(r)},n=e=>{this._setDraggingStyle(!0),t(e.clientX),window.addEventListener(`mousemove`,r),window.addEventListener(`mouseup`,i)},r=e=>{t(e.clientX)},i=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener(`mousemove`,r),window.removeEventListener(`mouseup`,i)},a=!1,o,s,c=e=>{e.preventDefault(),this._setDraggingStyle(!0),t(e.touches[0].clientX),a=!1},l=e=>{e.touches.length>1||(this._hasScrollBar?(o=e.touches[0].clientX,s=e.touches[0].clientY,a=!0):c(e),window.addEventListener(`touchmove`,u,{passive:!1}),window.addEventListener(`touchend`,d))},u=e=>{if(a){let t=e.touches[0].clientX-o,n=e.touches[0].clientY-s;Math.abs(t)>Math.abs(n)?c(e):(window.removeEventListener(`touchmove`,u),window.removeEventListener(`touchend`,d))}else e.preventDefault(),t(e.touches[0].clientX)},d=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener(`touchmove`,u),window.removeEventListener(`touchend`,d)},f=this._callOnFinishChange.bind(this),p;this.$slider.addEventListener(`mousedown`,n),this.$slider.addEventListener(`touchstart`,l,{passive:!1}),this.$slider.addEventListener(`wheel`,e=>{if(Math.abs(e.deltaX)<Math.abs(e.deltaY)&&this._hasScrollBar)return;e.preventDefault();let t=this._normalizeMouseWheel(e)*this._step;this._snapClampSetValue(this.getValue()+t),this.$input.value=this.getValue(),clearTimeout(p),p=setTimeout(f,400)},{passive:!1})}_setDraggingStyle(e,t=`horizontal`){this.$slider&&this.$slider.classList.toggle(`lil-active`,e),document.body.classList.toggle(`lil-dragging`,e),document.body.classList.toggle(`lil-${t}`,e)}_getImplicitStep(){return this._hasMin&&this._hasMax?(this._max-this._min)/1e3:.1}_onUpdateMinMax(){!this._hasSlider&&this._hasMin&&this._hasMax&&(this._stepExplicit||this.step(this._getImplicitStep(),!1),this._initSlider(),this.updateDisplay())}_normalizeMouseWheel(e){let{deltaX:t,deltaY:n}=e;return Math.floor(e.deltaY)!==e.deltaY&&e.wheelDelta&&(t=0,n=-e.wheelDelta/120,n*=this._stepExplicit?1:10),t+-n}_arrowKeyMultiplier(e){let t=this._stepExplicit?1:10;return e.shiftKey?t*=10:e.altKey&&(t/=10),t}_snap(e){let t=0;return this._hasMin?t=this._min:this._hasMax&&(t=this._max),e-=t,e=Math.round(e/this._step)*this._step,e+=t,e=parseFloat(e.toPrecision(15)),e}_clamp(e){return e<this._min&&(e=this._min),e>this._max&&(e=this._max),e}_snapClampSetValue(e){this.setValue(this._clamp(this._snap(e)))}get _hasScrollBar(){let e=this.parent.root.$children;return e.scrollHeight>e.clientHeight}get _hasMin(){return this._min!==void 0}get _hasMax(){return this._max!==void 0}},x=class extends m{constructor(e,t,n,r){super(e,t,n,`lil-option`),this.$select=document.createElement(`select`),this.$select.setAttribute(`aria-labelledby`,this.$name.id),this.$display=document.createElement(`div`),this.$display.classList.add(`lil-display`),this.$select.addEventListener(`change`,()=>{this.setValue(this._values[this.$select.selectedIndex]),this._callOnFinishChange()}),this.$select.addEventListener(`focus`,()=>{this.$display.classList.add(`lil-focus`)}),this.$select.addEventListener(`blur`,()=>{this.$display.classList.remove(`lil-focus`)}),this.$widget.appendChild(this.$select),this.$widget.appendChild(this.$display),this.$disable=this.$select,this.options(r)}options(e){return this._values=Array.isArray(e)?e:Object.values(e),this._names=Array.isArray(e)?e:Object.keys(e),this.$select.replaceChildren(),this._names.forEach(e=>{let t=document.createElement(`option`);t.textContent=e,this.$select.appendChild(t)}),this.updateDisplay(),this}updateDisplay(){let e=this.getValue(),t=this._values.indexOf(e);return this.$select.selectedIndex=t,this.$display.textContent=t===-1?e:this._names[t],this}},S=class extends m{constructor(e,t,n){super(e,t,n,`lil-string`),this.$input=document.createElement(`input`),this.$input.setAttribute(`type`,`text`),this.$input.setAttribute(`spellcheck`,`false`),this.$input.setAttribute(`aria-labelledby`,this.$name.id),this.$input.addEventListener(`input`,()=>{this.setValue(this.$input.value)}),this.$input.addEventListener(`keydown`,e=>{e.code===`Enter`&&this.$input.blur()}),this.$input.addEventListener(`blur`,()=>{this._callOnFinishChange()}),this.$widget.appendChild(this.$input),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.value=this.getValue(),this}},ie=`.lil-gui {
  font-family: var(--font-family);
  font-size: var(--font-size);
  line-height: 1;
  font-weight: normal;
  font-style: normal;
  text-align: left;
  color: var(--text-color);
  user-select: none;
  -webkit-user-select: none;
  touch-action: manipulation;
  --background-color: #1f1f1f;
  --text-color: #ebebeb;
  --title-background-color: #111111;
  --title-text-color: #ebebeb;
  --widget-color: #424242;
  --hover-color: #4f4f4f;
  --focus-color: #595959;
  --number-color: #2cc9ff;
  --string-color: #a2db3c;
  --font-size: 11px;
  --input-font-size: 11px;
  --font-family: -apple-system, BlinkMacSystemFont, "Segoe UI", Roboto, Arial, sans-serif;
  --font-family-mono: Menlo, Monaco, Consolas, "Droid Sans Mono", monospace;
  --padding: 4px;
  --spacing: 4px;
  --widget-height: 20px;
  --title-height: calc(var(--widget-height) + var(--spacing) * 1.25);
  --name-width: 45%;
  --slider-knob-width: 2px;
  --slider-input-width: 27%;
  --color-input-width: 27%;
  --slider-input-min-width: 45px;
  --color-input-min-width: 45px;
  --folder-indent: 7px;
  --widget-padding: 0 0 0 3px;
  --widget-border-radius: 2px;
  --checkbox-size: calc(0.75 * var(--widget-height));
  --scrollbar-width: 5px;
}
.lil-gui, .lil-gui * {
  box-sizing: border-box;
  margin: 0;
  padding: 0;
}
.lil-gui.lil-root {
  width: var(--width, 245px);
  display: flex;
  flex-direction: column;
  background: var(--background-color);
}
.lil-gui.lil-root > .lil-title {
  background: var(--title-background-color);
  color: var(--title-text-color);
}
.lil-gui.lil-root > .lil-children {
  overflow-x: hidden;
  overflow-y: auto;
}
.lil-gui.lil-root > .lil-children::-webkit-scrollbar {
  width: var(--scrollbar-width);
  height: var(--scrollbar-width);
  background: var(--background-color);
}
.lil-gui.lil-root > .lil-children::-webkit-scrollbar-thumb {
  border-radius: var(--scrollbar-width);
  background: var(--focus-color);
}
@media (pointer: coarse) {
  .lil-gui.lil-allow-touch-styles, .lil-gui.lil-allow-touch-styles .lil-gui {
    --widget-height: 28px;
    --padding: 6px;
    --spacing: 6px;
    --font-size: 13px;
    --input-font-size: 16px;
    --folder-indent: 10px;
    --scrollbar-width: 7px;
    --slider-input-min-width: 50px;
    --color-input-min-width: 65px;
  }
}
.lil-gui.lil-force-touch-styles, .lil-gui.lil-force-touch-styles .lil-gui {
  --widget-height: 28px;
  --padding: 6px;
  --spacing: 6px;
  --font-size: 13px;
  --input-font-size: 16px;
  --folder-indent: 10px;
  --scrollbar-width: 7px;
  --slider-input-min-width: 50px;
  --color-input-min-width: 65px;
}
.lil-gui.lil-auto-place, .lil-gui.autoPlace {
  max-height: 100%;
  position: fixed;
  top: 0;
  right: 15px;
  z-index: 1001;
}

.lil-controller {
  display: flex;
  align-items: center;
  padding: 0 var(--padding);
  margin: var(--spacing) 0;
}
.lil-controller.lil-disabled {
  opacity: 0.5;
}
.lil-controller.lil-disabled, .lil-controller.lil-disabled * {
  pointer-events: none !important;
}
.lil-controller > .lil-name {
  min-width: var(--name-width);
  flex-shrink: 0;
  white-space: pre;
  padding-right: var(--spacing);
  line-height: var(--widget-height);
}
.lil-controller .lil-widget {
  position: relative;
  display: flex;
  align-items: center;
  width: 100%;
  min-height: var(--widget-height);
}
.lil-controller.lil-string input {
  color: var(--string-color);
}
.lil-controller.lil-boolean {
  cursor: pointer;
}
.lil-controller.lil-color .lil-display {
  width: 100%;
  height: var(--widget-height);
  border-radius: var(--widget-border-radius);
  position: relative;
}
@media (hover: hover) {
  .lil-controller.lil-color .lil-display:hover:before {
    content: " ";
    display: block;
    position: absolute;
    border-radius: var(--widget-border-radius);
    border: 1px solid #fff9;
    top: 0;
    right: 0;
    bottom: 0;
    left: 0;
  }
}
.lil-controller.lil-color input[type=color] {
  opacity: 0;
  width: 100%;
  height: 100%;
  cursor: pointer;
}
.lil-controller.lil-color input[type=text] {
  margin-left: var(--spacing);
  font-family: var(--font-family-mono);
  min-width: var(--color-input-min-width);
  width: var(--color-input-width);
  flex-shrink: 0;
}
.lil-controller.lil-option select {
  opacity: 0;
  position: absolute;
  width: 100%;
  max-width: 100%;
}
.lil-controller.lil-option .lil-display {
  position: relative;
  pointer-events: none;
  border-radius: var(--widget-border-radius);
  height: var(--widget-height);
  line-height: var(--widget-height);
  max-width: 100%;
  overflow: hidden;
  word-break: break-all;
  padding-left: 0.55em;
  padding-right: 1.75em;
  background: var(--widget-color);
}
@media (hover: hover) {
  .lil-controller.lil-option .lil-display.lil-focus {
    background: var(--focus-color);
  }
}
.lil-controller.lil-option .lil-display.lil-active {
  background: var(--focus-color);
}
.lil-controller.lil-option .lil-display:after {
  font-family: "lil-gui";
  content: "↕";
  position: absolute;
  top: 0;
  right: 0;
  bottom: 0;
  padding-right: 0.375em;
}
.lil-controller.lil-option .lil-widget,
.lil-controller.lil-option select {
  cursor: pointer;
}
@media (hover: hover) {
  .lil-controller.lil-option .lil-widget:hover .lil-display {
    background: var(--hover-color);
  }
}
.lil-controller.lil-number input {
  color: var(--number-color);
}
.lil-controller.lil-number.lil-has-slider input {
  margin-left: var(--spacing);
  width: var(--slider-input-width);
  min-width: var(--slider-input-min-width);
  flex-shrink: 0;
}
.lil-controller.lil-number .lil-slider {
  width: 100%;
  height: var(--widget-height);
  background: var(--widget-color);
  border-radius: var(--widget-border-radius);
  padding-right: var(--slider-knob-width);
  overflow: hidden;
  cursor: ew-resize;
  touch-action: pan-y;
}
@media (hover: hover) {
  .lil-controller.lil-number .lil-slider:hover {
    background: var(--hover-color);
  }
}
.lil-controller.lil-number .lil-slider.lil-active {
  background: var(--focus-color);
}
.lil-controller.lil-number .lil-slider.lil-active .lil-fill {
  opacity: 0.95;
}
.lil-controller.lil-number .lil-fill {
  height: 100%;
  border-right: var(--slider-knob-width) solid var(--number-color);
  box-sizing: content-box;
}

.lil-dragging .lil-gui {
  --hover-color: var(--widget-color);
}
.lil-dragging * {
  cursor: ew-resize !important;
}
.lil-dragging.lil-vertical * {
  cursor: ns-resize !important;
}

.lil-gui .lil-title {
  height: var(--title-height);
  font-weight: 600;
  padding: 0 var(--padding);
  width: 100%;
  text-align: left;
  background: none;
  text-decoration-skip: objects;
}
.lil-gui .lil-title:before {
  font-family: "lil-gui";
  content: "▾";
  padding-right: 2px;
  display: inline-block;
}
.lil-gui .lil-title:active {
  background: var(--title-background-color);
  opacity: 0.75;
}
@media (hover: hover) {
  body:not(.lil-dragging) .lil-gui .lil-title:hover {
    background: var(--title-background-color);
    opacity: 0.85;
  }
  .lil-gui .lil-title:focus {
    text-decoration: underline var(--focus-color);
  }
}
.lil-gui.lil-root > .lil-title:focus {
  text-decoration: none !important;
}
.lil-gui.lil-closed > .lil-title:before {
  content: "▸";
}
.lil-gui.lil-closed > .lil-children {
  transform: translateY(-7px);
  opacity: 0;
}
.lil-gui.lil-closed:not(.lil-transition) > .lil-children {
  display: none;
}
.lil-gui.lil-transition > .lil-children {
  transition-duration: 300ms;
  transition-property: height, opacity, transform;
  transition-timing-function: cubic-bezier(0.2, 0.6, 0.35, 1);
  overflow: hidden;
  pointer-events: none;
}
.lil-gui .lil-children:empty:before {
  content: "Empty";
  padding: 0 var(--padding);
  margin: var(--spacing) 0;
  display: block;
  height: var(--widget-height);
  font-style: italic;
  line-height: var(--widget-height);
  opacity: 0.5;
}
.lil-gui.lil-root > .lil-children > .lil-gui > .lil-title {
  border: 0 solid var(--widget-color);
  border-width: 1px 0;
  transition: border-color 300ms;
}
.lil-gui.lil-root > .lil-children > .lil-gui.lil-closed > .lil-title {
  border-bottom-color: transparent;
}
.lil-gui + .lil-controller {
  border-top: 1px solid var(--widget-color);
  margin-top: 0;
  padding-top: var(--spacing);
}
.lil-gui .lil-gui .lil-gui > .lil-title {
  border: none;
}
.lil-gui .lil-gui .lil-gui > .lil-children {
  border: none;
  margin-left: var(--folder-indent);
  border-left: 2px solid var(--widget-color);
}
.lil-gui .lil-gui .lil-controller {
  border: none;
}

.lil-gui label, .lil-gui input, .lil-gui button {
  -webkit-tap-highlight-color: transparent;
}
.lil-gui input {
  border: 0;
  outline: none;
  font-family: var(--font-family);
  font-size: var(--input-font-size);
  border-radius: var(--widget-border-radius);
  height: var(--widget-height);
  background: var(--widget-color);
  color: var(--text-color);
  width: 100%;
}
@media (hover: hover) {
  .lil-gui input:hover {
    background: var(--hover-color);
  }
  .lil-gui input:active {
    background: var(--focus-color);
  }
}
.lil-gui input:disabled {
  opacity: 1;
}
.lil-gui input[type=text],
.lil-gui input[type=number] {
  padding: var(--widget-padding);
  -moz-appearance: textfield;
}
.lil-gui input[type=text]:focus,
.lil-gui input[type=number]:focus {
  background: var(--focus-color);
}
.lil-gui input[type=checkbox] {
  appearance: none;
  width: var(--checkbox-size);
  height: var(--checkbox-size);
  border-radius: var(--widget-border-radius);
  text-align: center;
  cursor: pointer;
}
.lil-gui input[type=checkbox]:checked:before {
  font-family: "lil-gui";
  content: "✓";
  font-size: var(--checkbox-size);
  line-height: var(--checkbox-size);
}
@media (hover: hover) {
  .lil-gui input[type=checkbox]:focus {
    box-shadow: inset 0 0 0 1px var(--focus-color);
  }
}
.lil-gui button {
  outline: none;
  cursor: pointer;
  font-family: var(--font-family);
  font-size: var(--font-size);
  color: var(--text-color);
  width: 100%;
  border: none;
}
.lil-gui .lil-controller button {
  height: var(--widget-height);
  text-transform: none;
  background: var(--widget-color);
  border-radius: var(--widget-border-radius);
}
@media (hover: hover) {
  .lil-gui .lil-controller button:hover {
    background: var(--hover-color);
  }
  .lil-gui .lil-controller button:focus {
    box-shadow: inset 0 0 0 1px var(--focus-color);
  }
}
.lil-gui .lil-controller button:active {
  background: var(--focus-color);
}

@font-face {
  font-family: "lil-gui";
  src: url("data:application/font-woff2;charset=utf-8;base64,d09GMgABAAAAAALkAAsAAAAABtQAAAKVAAEAAAAAAAAAAAAAAAAAAAAAAAAAAAAAHFQGYACDMgqBBIEbATYCJAMUCwwABCAFhAoHgQQbHAbIDiUFEYVARAAAYQTVWNmz9MxhEgodq49wYRUFKE8GWNiUBxI2LBRaVnc51U83Gmhs0Q7JXWMiz5eteLwrKwuxHO8VFxUX9UpZBs6pa5ABRwHA+t3UxUnH20EvVknRerzQgX6xC/GH6ZUvTcAjAv122dF28OTqCXrPuyaDER30YBA1xnkVutDDo4oCi71Ca7rrV9xS8dZHbPHefsuwIyCpmT7j+MnjAH5X3984UZoFFuJ0yiZ4XEJFxjagEBeqs+e1iyK8Xf/nOuwF+vVK0ur765+vf7txotUi0m3N0m/84RGSrBCNrh8Ee5GjODjF4gnWP+dJrH/Lk9k4oT6d+gr6g/wssA2j64JJGP6cmx554vUZnpZfn6ZfX2bMwPPrlANsB86/DiHjhl0OP+c87+gaJo/gY084s3HoYL/ZkWHTRfBXvvoHnnkHvngKun4KBE/ede7tvq3/vQOxDXB1/fdNz6XbPdcr0Vhpojj9dG+owuSKFsslCi1tgEjirjXdwMiov2EioadxmqTHUCIwo8NgQaeIasAi0fTYSPTbSmwbMOFduyh9wvBrESGY0MtgRjtgQR8Q1bRPohn2UoCRZf9wyYANMXFeJTysqAe0I4mrherOekFdKMrYvJjLvOIUM9SuwYB5DVZUwwVjJJOaUnZCmcEkIZZrKqNvRGRMvmFZsmhP4VMKCSXBhSqUBxgMS7h0cZvEd71AWkEhGWaeMFcNnpqyJkyXgYL7PQ1MoSq0wDAkRtJIijkZSmqYTiSImfLiSWXIZwhRh3Rug2X0kk1Dgj+Iu43u5p98ghopcpSo0Uyc8SnjlYX59WUeaMoDqmVD2TOWD9a4pCRAzf2ECgwGcrHjPOWY9bNxq/OL3I/QjwEAAAA=") format("woff2");
}`;function ae(e){let t=document.createElement(`style`);t.innerHTML=e;let n=document.querySelector(`head link[rel=stylesheet], head style`);n?document.head.insertBefore(t,n):document.head.appendChild(t)}var C=!1,oe=class e{constructor({parent:e,autoPlace:t=e===void 0,container:n,width:r,title:i=`Controls`,closeFolders:a=!1,injectStyles:o=!0,touchStyles:s=!0}={}){this.parent=e,this.root=e?e.root:this,this.children=[],this.controllers=[],this.folders=[],this._closed=!1,this._hidden=!1,this.domElement=document.createElement(`div`),this.domElement.classList.add(`lil-gui`),this.$title=document.createElement(`button`),this.$title.classList.add(`lil-title`),this.$title.setAttribute(`aria-expanded`,!0),this.$title.addEventListener(`click`,()=>this.openAnimated(this._closed)),this.$title.addEventListener(`touchstart`,()=>{},{passive:!0}),this.$children=document.createElement(`div`),this.$children.classList.add(`lil-children`),this.domElement.appendChild(this.$title),this.domElement.appendChild(this.$children),this.title(i),this.parent?(this.parent.children.push(this),this.parent.folders.push(this),this.parent.$children.appendChild(this.domElement)):(this.domElement.classList.add(`lil-root`),s&&this.domElement.classList.add(`lil-allow-touch-styles`),!C&&o&&(ae(ie),C=!0),n?n.appendChild(this.domElement):t&&(this.domElement.classList.add(`lil-auto-place`,`autoPlace`),document.body.appendChild(this.domElement)),r&&this.domElement.style.setProperty(`--width`,r+`px`),this._closeFolders=a)}add(e,t,n,r,i){if(Object(n)===n)return new x(this,e,t,n);let a=e[t];switch(typeof a){case`number`:return new re(this,e,t,n,r,i);case`boolean`:return new te(this,e,t);case`string`:return new S(this,e,t);case`function`:return new b(this,e,t)}console.error(`gui.add failed
	property:`,t,`
	object:`,e,`
	value:`,a)}addColor(e,t,n=1){return new y(this,e,t,n)}addFolder(t){let n=new e({parent:this,title:t});return this.root._closeFolders&&n.close(),n}load(e,t=!0){return e.controllers&&this.controllers.forEach(t=>{t instanceof b||t._name in e.controllers&&t.load(e.controllers[t._name])}),t&&e.folders&&this.folders.forEach(t=>{t._title in e.folders&&t.load(e.folders[t._title])}),this}save(e=!0){let t={controllers:{},folders:{}};return this.controllers.forEach(e=>{if(!(e instanceof b)){if(e._name in t.controllers)throw Error(`Cannot save GUI with duplicate property "${e._name}"`);t.controllers[e._name]=e.save()}}),e&&this.folders.forEach(e=>{if(e._title in t.folders)throw Error(`Cannot save GUI with duplicate folder "${e._title}"`);t.folders[e._title]=e.save()}),t}open(e=!0){return this._setClosed(!e),this.$title.setAttribute(`aria-expanded`,!this._closed),this.domElement.classList.toggle(`lil-closed`,this._closed),this}close(){return this.open(!1)}_setClosed(e){this._closed!==e&&(this._closed=e,this._callOnOpenClose(this))}show(e=!0){return this._hidden=!e,this.domElement.style.display=this._hidden?`none`:``,this}hide(){return this.show(!1)}openAnimated(e=!0){return this._setClosed(!e),this.$title.setAttribute(`aria-expanded`,!this._closed),requestAnimationFrame(()=>{let t=this.$children.clientHeight;this.$children.style.height=t+`px`,this.domElement.classList.add(`lil-transition`);let n=e=>{e.target===this.$children&&(this.$children.style.height=``,this.domElement.classList.remove(`lil-transition`),this.$children.removeEventListener(`transitionend`,n))};this.$children.addEventListener(`transitionend`,n);let r=e?this.$children.scrollHeight:0;this.domElement.classList.toggle(`lil-closed`,!e),requestAnimationFrame(()=>{this.$children.style.height=r+`px`})}),this}title(e){return this._title=e,this.$title.textContent=e,this}reset(e=!0){return(e?this.controllersRecursive():this.controllers).forEach(e=>e.reset()),this}onChange(e){return this._onChange=e,this}_callOnChange(e){this.parent&&this.parent._callOnChange(e),this._onChange!==void 0&&this._onChange.call(this,{object:e.object,property:e.property,value:e.getValue(),controller:e})}onFinishChange(e){return this._onFinishChange=e,this}_callOnFinishChange(e){this.parent&&this.parent._callOnFinishChange(e),this._onFinishChange!==void 0&&this._onFinishChange.call(this,{object:e.object,property:e.property,value:e.getValue(),controller:e})}onOpenClose(e){return this._onOpenClose=e,this}_callOnOpenClose(e){this.parent&&this.parent._callOnOpenClose(e),this._onOpenClose!==void 0&&this._onOpenClose.call(this,e)}destroy(){this.parent&&(this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.folders.splice(this.parent.folders.indexOf(this),1)),this.domElement.parentElement&&this.domElement.parentElement.removeChild(this.domElement),Array.from(this.children).forEach(e=>e.destroy())}controllersRecursive(){let e=Array.from(this.controllers);return this.folders.forEach(t=>{e=e.concat(t.controllersRecursive())}),e}foldersRecursive(){let e=Array.from(this.folders);return this.folders.forEach(t=>{e=e.concat(t.foldersRecursive())}),e}},w=(e,t=()=>void 0)=>({get value(){return e()},set value(e){t(e)}}),T=[0,0,0],se=[255,255,255],ce=class{#e=null;split(e){if(this.#e!==null&&o(E(this.#e),e))return this.#e;let t=Math.max(...e);if(t===0)return{color:this.#e?.color??T,intensity:0};let n=e=>e*255/t,r={color:[n(e[0]),n(e[1]),n(e[2])],intensity:t/255};return this.#e=r,r}recolor(e,t){let{intensity:n}=this.split(e);return this.#n({color:t,intensity:this.#t(e)?1:n})}intensify(e,t){let{color:n}=this.split(e);return this.#n({color:this.#t(e)?se:n,intensity:t})}#t(e){return this.#e===null&&o(e,T)}#n(e){return this.#e=e,E(e)}};function E({color:e,intensity:t}){let n=e=>Math.min(Number((e*t).toPrecision(6)),s.color);return[n(e[0]),n(e[1]),n(e[2])]}var le=e=>`#${e.map(e=>Math.round(Math.min(Math.max(e,0),255)).toString(16).padStart(2,`0`)).join(``)}`,ue=e=>[parseInt(e.slice(1,3),16),parseInt(e.slice(3,5),16),parseInt(e.slice(5,7),16)];function D(e){let t=10**Math.floor(Math.log10(e));return O(([1,2,5,10].find(n=>e<=n*t*(1+1e-9))??10)*t)}var O=e=>Number(e.toPrecision(12)),de=200;function k(e,t,n=D((t-e)/de)){return{start:e,end:t,step:n,place:e=>e,value:O,stepAt:()=>n,reaching(r){if(r>=e&&r<=t)return this;let i=r<e?r<0?-D(-r):0:e,a=r>t?r>0?D(r):0:t;return k(i,a,Math.max(n,D((a-i)/400)))}}}function A(e,t){let n=Math.log1p(t/e),r=e=>Number(e.toPrecision(3));return{start:0,end:1,step:1/400,place:t=>Math.log1p(Math.max(t,0)/e)/n,value:i=>i>=1?t:r(e*Math.expm1(i*n)),stepAt:t=>t===0?e/10:10**(Math.floor(Math.log10(Math.abs(t)))-1),reaching(n){return n<=t?this:A(e,D(n))}}}function j(e,t=0){return Math.abs(e)<=1e-9*t?`0`:String(Number(e.toPrecision(6)))}var fe=class extends m{#e=document.createElement(`input`);#t=document.createElement(`input`);#n;#r;#i=!1;constructor(e,t,n,r){super(e,t,`value`,`lil-number`),this.name(n),this.#n=r,this.#r=r,this.domElement.classList.add(`lil-has-slider`),this.$disable=this.#t,this.#o(),this.#s(),this.updateDisplay()}set travel(e){this.#n=e}updateDisplay(){let e=this.#a;return this.#i||this.#f(e),this.#t.matches(`:focus`)||this.#d(e),this}get#a(){return this.getValue()}#o(){let e=this.#e;e.type=`range`,e.tabIndex=-1,e.setAttribute(`aria-labelledby`,this.$name.id),e.addEventListener(`pointerdown`,()=>{this.#i=!0});for(let t of[`pointerup`,`pointercancel`,`lostpointercapture`,`change`,`blur`])e.addEventListener(t,()=>{this.#i=!1,this.updateDisplay()});e.addEventListener(`input`,()=>{this.#c(this.#r.value(Number(e.value))),this.#p(Number(e.value))}),this.$widget.append(e)}#s(){let e=this.#t;e.type=matchMedia(`(pointer: coarse)`).matches?`number`:`text`,e.setAttribute(`aria-labelledby`,this.$name.id),e.setAttribute(`step`,`any`),e.autocomplete=`off`,e.spellcheck=!1,e.addEventListener(`focus`,()=>{e.select()}),e.addEventListener(`input`,()=>{let t=Number(e.value.trim().replace(`,`,`.`));this.#u=e.value.trim()!==``&&this.#c(t)}),e.addEventListener(`keydown`,t=>{if(t.key===`Enter`&&e.blur(),t.key!==`ArrowUp`&&t.key!==`ArrowDown`)return;t.preventDefault();let n=t.shiftKey?10:t.altKey?.1:1;this.#l((t.key===`ArrowUp`?1:-1)*n)}),e.addEventListener(`blur`,()=>{this.#u=!0,this.#d(this.#a)}),this.$widget.append(e)}#c(e){if(!Number.isFinite(e))return!1;try{return this.setValue(e),!0}catch(e){if(e instanceof RangeError)return!1;throw e}}#l(e){let t=this.#a;this.#c(O(t+e*this.#r.stepAt(t))),this.#u=!0,this.#d(this.#a)}set#u(e){e?this.#t.removeAttribute(`aria-invalid`):this.#t.setAttribute(`aria-invalid`,`true`)}#d(e){let t=j(e,this.#r.end-this.#r.start);this.#t.value!==t&&(this.#t.value=t),this.#e.getAttribute(`aria-valuetext`)!==t&&this.#e.setAttribute(`aria-valuetext`,t)}#f(e){let t=this.#n.reaching(e),{start:n,end:r,step:i}=this.#r=t,a=this.#e;a.min=String(n),a.max=String(r),a.step=String(i),a.value=String(t.place(e)),this.#p(t.place(e))}#p(e){let{start:t,end:n}=this.#r,r=Math.min(Math.max((e-t)/(n-t),0),1);this.#e.style.setProperty(`--share`,r.toFixed(4))}};function M(e,t,n,r,i){return new fe(e,w(r,i),t,n)}function N(e,t,n,r,i){return[0,1,2].map(a=>M(e,t[a],n(a),()=>r()[a],e=>{let[t,n,o]=r();i([a===0?e:t,a===1?e:n,a===2?e:o])}))}var P=e=>[`${e} x`,`${e} y`,`${e} z`];function F(e,t,n,r,i){let a=new ce,o=new y(e,w(()=>le(a.split(r()).color),e=>{i(a.recolor(r(),ue(e)))}),`value`,1).name(t);o.$input.tabIndex=0;let s=M(e,`× intensity`,k(0,n,.01),()=>a.split(r()).intensity,e=>{i(a.intensify(r(),e))}),c=`${o.$name.id} ${s.$name.id}`;for(let e of s.$widget.children)e.setAttribute(`aria-labelledby`,c);s.domElement.classList.add(`below`)}function I(e,t,n,r){return e.add(w(n,r),`value`).name(t)}function pe(e,t,n,r){return new S(e,w(n,r),`value`).name(t)}function L(e,t,n,r,i){return new x(e,w(r,i),`value`,n).name(t)}function R(e,t,n){return new b(e,{value:n},`value`).name(t)}var z=e=>Object.fromEntries(e.map(e=>[e,e]));function B(e){e instanceof S&&e.$input.matches(`:focus`)||e instanceof x&&e._values[e.$select.selectedIndex]===e.getValue()||e.updateDisplay()}var V=class{gui;#e;#t;#n=!1;#r=!0;constructor(e,t,n){this.gui=H(e,t).close(),this.#e=n}update(){this.#r=!0,this.refreshVisible()}refreshVisible(){if(this.#r&&W(this.gui)){this.#r=!1,this.#n||(this.#n=!0,this.#t=this.#e(this.gui)),this.#t?.();for(let e of this.gui.controllers)B(e)}}},H=(e,t)=>U(e.addFolder(t));function U(e){return e.openAnimated=(t=!0)=>e.open(t),e}var W=e=>e===void 0||!e._closed&&!e._hidden&&W(e.parent),me=class extends m{constructor(e,t,n){super(e,w(t),`value`,`readout`),this.name(n),this.updateDisplay()}updateDisplay(){return this.$widget.textContent=this.getValue(),this}},G=[`theta`,`phi`,`radius`,`target`],he=class{folder;#e;#t;#n;#r=null;constructor(e,t,n){this.#e=t,this.#t=n,this.#n=t.camera,this.folder=new V(e,`Camera`,e=>this.#i(e))}update(){this.folder.update()}#i(e){let t=this.#e;M(e,`θ azimuth °`,k(-180,180,1),()=>this.#n.theta,e=>{this.#c(()=>t.theta=e)}),M(e,`φ polar °`,k(0,180,1),()=>this.#n.phi,e=>{this.#c(()=>t.phi=e)});let n=M(e,`radius`,this.#a,()=>this.#n.radius,e=>{this.#c(()=>t.radius=e)});new me(e,()=>this.#o,`eye`);let r=N(e,P(`target`),e=>this.#t.place(e),()=>this.#n.target,e=>{this.#s(e)});M(e,`fov °`,k(1,170,1),()=>t.fov,e=>t.fov=e);let i=M(e,`auto-rotate`,k(-90,90,1),()=>t.autoRotate,e=>t.autoRotate=e);return i.domElement.title=`Degrees per second about y`,R(e,`reset camera`,()=>{this.#l()}),()=>{this.#n=t.camera,n.travel=this.#a,r.forEach((e,t)=>{e.travel=this.#t.place(t)})}}get#a(){return A(this.#t.reach/100,this.#t.reach*10)}get#o(){let{eye:e,radius:t}=this.#n,n=10**(Math.floor(Math.log10(t))-3);return e.map(e=>j(Math.round(e/n)*n,n)).join(`, `)}#s(e){let t=this.#e;this.#c(()=>{t.radius===`auto`&&(t.radius=this.#n.radius),t.target=e})}#c(t){let n=this.#u,r=this.#r!==null&&K(this.#r.written,n);try{e(this.#e,`panel`,t)}finally{this.#r={declared:r?this.#r.declared:n,written:this.#u},this.#n=this.#e.camera}}#l(){let t=this.#r,n=t!==null&&K(t.written,this.#u)?t.declared:this.#u;this.#r=null,e(this.#e,`panel`,()=>{G.forEach((e,t)=>i(this.#e).set(e,n[t]))})}get#u(){let{store:e}=i(this.#e);return G.map(t=>e.given(t)?e.values[t]:null)}},K=(e,t)=>e.every((e,n)=>o(e,t[n])),q=class{#e;#t;#n=new Map;constructor(e,t){this.#e=e,this.#t=t}folderOf(e){return this.#n.get(e)?.folder}update(e){let t=new Set(e);for(let[e,{folder:n}]of this.#n)t.has(e)||(this.#n.delete(e),n.gui.destroy());let n=this.#e.$children,r=null;e.forEach((e,t)=>{let i=this.#n.get(e)??this.#r(e),a=i.folder.gui.domElement,o=r===null?n.querySelector(`:scope > .lil-gui`):r.nextElementSibling;a!==o&&n.insertBefore(a,o),r=a,i.update(t)})}refreshVisible(){for(let{folder:e}of this.#n.values())e.refreshVisible()}#r(e){let t=this.#t(e);return this.#n.set(e,t),t}},J=`copy HTML`,ge=2e3,_e=class{#e;#t=document.createElement(`textarea`);#n=0;constructor(e,t){this.#e=R(e,J,()=>{this.#r(t())}),this.#e.$name.setAttribute(`aria-live`,`polite`),this.#t.readOnly=!0,this.#t.className=`markup`,this.#t.rows=6,this.#t.setAttribute(`aria-label`,`The scene's HTML`),this.#t.addEventListener(`keydown`,e=>{e.stopPropagation()})}dispose(){clearTimeout(this.#n)}async#r(e){try{await navigator.clipboard.writeText(e),this.#t.remove(),this.#i(`copied ✓`)}catch{this.#t.value=e,this.#e.domElement.after(this.#t),this.#t.select(),this.#t.scrollIntoView({block:`nearest`}),this.#i(`select and copy below`)}}#i(e){clearTimeout(this.#n),this.#e.name(e),this.#n=window.setTimeout(()=>this.#e.name(J),ge)}},ve=[`directional`,`point`,`spot`],ye=`Directional: w = 0. Point: w = 1. Spot: w = 1 with a cone or decay; the other kinds set aperture 180 and cutoff 0.`,be={aperture:30,cutoff:8},xe={aperture:180,cutoff:0},Se=class{#e=null;writesFor(e,r,i,a){if(t(e)===r)return{};let[o,s,c]=e.position,l=[o,s,c,r===`directional`?0:1];if(r!==`spot`)return n(e)?(this.#e={aperture:e.aperture,cutoff:e.cutoff},{position:l,...xe}):{position:l};let u=(i||n(e)||this.#e!==null)&&e.axis.some(e=>e!==0)?{}:{axis:Ce(e.position,a)},d=n({...e,...u})?{}:this.#e??be;return{position:l,...u,...d}}};function Ce([e,t,n],r){let i=[r[0]-e,r[1]-t,r[2]-n],a=Math.max(...i.map(Math.abs));if(a===0)return[0,-1,0];let o=e=>Number((e/a).toFixed(3))+0;return[o(i[0]),o(i[1]),o(i[2])]}var we=4,Te=class{folder;#e;#t;#n;#r;#i=new Se;#a=document.createElement(`input`);#o=-1;#s=``;#c=``;constructor(e,t,n,r,i){this.#e=t,this.#t=n,this.#n=r,this.#r=i,this.folder=new V(e,``,e=>this.#d(e)),this.#u()}update(e){let{name:t,active:n}=i(this.#e).store.values;(e!==this.#o||t!==this.#s)&&this.#l(e,t),this.#a.checked=n,this.folder.gui.domElement.classList.toggle(`off`,!n),this.folder.update()}#l(e,t){this.#o=e,this.#s=t;let n=t===``?`light ${String(e+1)}`:t;this.#c=n,this.folder.gui.title(n),this.#a.setAttribute(`aria-label`,`${n} active`)}#u(){this.#a.type=`checkbox`,this.#a.className=`switch`,this.#a.addEventListener(`change`,()=>{this.#e.active=this.#a.checked}),this.folder.gui.$title.after(this.#a)}#d(e){let r=this.#e,{store:o}=i(r),{values:s}=o,c=pe(e,`name`,()=>s.name,e=>r.name=e);I(e,`active`,()=>s.active,e=>r.active=e);let l=L(e,`kind`,z(ve),()=>t(s),e=>{Object.assign(r,this.#i.writesFor(s,e,o.given(`axis`),this.#p))});l.domElement.title=ye;for(let t of[`ambient`,`diffuse`,`specular`])F(e,t,we,()=>s[t],e=>r[t]=e);let u=N(e,P(`position`),()=>this.#n.vector(),()=>[s.position[0],s.position[1],s.position[2]],([e,t,n])=>r.position=[e,t,n,s.position[3]]),d=this.#f(e),f=N(e,[`kc constant`,`kl linear`,`kq quadratic`],()=>k(0,2,.01),()=>s.attenuation,e=>r.attenuation=e);return L(e,`space`,z(a),()=>s.space,e=>r.space=e),R(e,`remove`,this.#r),()=>{c.$input.placeholder=this.#c;let e=s.position[3]===1;for(let t of f)t.show(e);let t=n(s)||d.some(e=>e.domElement.matches(`:focus-within`));for(let e of d)e.show(t);let r=e&&s.space===`world`;u.forEach((e,t)=>{e.travel=r?this.#n.place(t):this.#n.vector()})}}#f(e){let t=this.#e,{values:n}=i(t).store;return[...N(e,P(`axis`),()=>k(-1,1,.01),()=>n.axis,e=>t.axis=e),M(e,`aperture °`,k(0,180,.5),()=>n.aperture,e=>t.aperture=e),M(e,`cutoff`,A(1,1e3),()=>n.cutoff,e=>t.cutoff=e)]}get#p(){let{target:e,radius:t}=this.#t.camera;return this.#e.space===`camera`?[0,0,-t]:e}},Y=`as viewer`;function Ee(e,t){let n=new V(e,`Material`,e=>{X(e,t,e=>{i(t).set(e,null)})});return{folder:n,update(){n.gui.show(t.geometry!==null||t.src!==``),n.update()}}}var De=class{folder;#e;#t=``;constructor(e,t,n){this.#e=t,this.folder=new V(e,``,e=>(X(e,t,e=>{i(t).set(e,null)}),Oe(e,t),ke(e,t,n)))}update(e){let t=r(this.#e,e);t!==this.#t&&this.folder.gui.title(this.#t=t),this.folder.update()}};function X(e,t,n){for(let n of[`ka`,`kd`,`ks`])F(e,n,1,()=>t[n],e=>t[n]=e);M(e,`shininess`,A(1,1e6),()=>t.shininess,e=>t.shininess=e),R(e,`reset material`,()=>{for(let e of[`ka`,`kd`,`ks`,`shininess`])n(e)})}function Oe(e,t){L(e,`shading`,{[Y]:null,...z(c)},()=>t.shading,e=>t.shading=e),L(e,`reflection`,{[Y]:null,...z(l)},()=>t.reflection,e=>t.reflection=e)}function ke(e,t,n){let r=N(e,P(`position`),e=>n.place(e),()=>t.position,e=>t.position=e);return N(e,[`rotation x °`,`rotation y °`,`rotation z °`],()=>k(-180,180,1),()=>t.rotation,e=>t.rotation=e),N(e,P(`scale`),()=>k(0,4,.02),()=>t.scale,e=>t.scale=e),()=>{r.forEach((e,t)=>{e.travel=n.place(t)})}}var Ae=Math.PI*(3-Math.sqrt(5)),Z=[140,140,140];function Q(e,t,n){let r=Ae*(e+1),i=n/2,a=(e,t)=>Number((t+i*e).toPrecision(3));return{position:[a(.8*Math.sin(r),t[0]),a(.6,t[1]),a(.8*Math.cos(r),t[2]),1],diffuse:Z,specular:Z}}var je=`input[type=checkbox]{appearance:none;border-radius:4px;place-items:center;width:24px;height:24px;margin:-2px -5px;display:grid}input[type=checkbox]:before,input[type=checkbox]:checked:after{content:"";box-sizing:border-box;border:1px solid var(--faint);background:var(--raised);border-radius:3px;grid-area:1/1;width:15px;height:15px}input[type=checkbox]:checked:before{border-color:var(--accent);background:var(--accent)}input[type=checkbox]:checked:after{clip-path:polygon(20% 50%,32% 38%,44% 52%,70% 22%,82% 34%,45% 76%);background:#18181e;border:0}input[type=color]{min-height:24px}.switch{top:5px}@media (pointer:coarse){.switch{top:9px}}@media (forced-colors:active){.panel{--ground:Canvas}input[type=checkbox]{appearance:auto}input[type=checkbox]:before,input[type=checkbox]:checked:after{display:none}.lil-controller :is(input:not([type=checkbox]),select,button),.markup{border:1px solid}.lil-title:before,.lil-option .lil-widget:after{forced-color-adjust:none;background:canvastext}.lil-display,input[type=color],input[type=range]{--accent:Highlight;--raised:Canvas;forced-color-adjust:none}}`,Me=`.lil-controller{min-height:var(--line);align-items:center;padding:2px 10px;display:flex}.lil-controller>.lil-name{text-overflow:ellipsis;white-space:nowrap;flex:none;width:36%;padding-right:6px;overflow:hidden}.lil-controller.below>.lil-name{color:var(--faint);padding-left:10px}.lil-widget{flex:1;align-items:center;gap:6px;min-width:0;display:flex}.readout .lil-widget{color:var(--faint);font-variant-numeric:tabular-nums;-webkit-user-select:text;user-select:text;padding-left:6px}.lil-controller input:not([type=checkbox],[type=range],[type=color]),.lil-controller select,.lil-controller button,.markup{width:100%;min-width:0;height:calc(var(--line) - 2px);background:var(--raised);color:var(--text);font:inherit;font-size:var(--typed,inherit);font-variant-numeric:tabular-nums;text-align:left;-webkit-user-select:text;user-select:text;border:0;border-radius:3px;padding:0 6px}.lil-controller button{text-align:center;cursor:pointer;-webkit-user-select:none;user-select:none}.lil-controller.lil-number input:not([type=range]){appearance:textfield;flex:none;width:62px}.lil-controller input[aria-invalid=true]{box-shadow:inset 0 0 0 1px #ff8a80}.markup{resize:vertical;width:calc(100% - 20px);height:auto;margin:2px 10px 8px;padding:4px 6px;font:11px/1.4 ui-monospace,monospace;display:block}.lil-controller ::placeholder{color:var(--faint);opacity:1}input[type=checkbox]{width:15px;height:15px;accent-color:var(--accent);cursor:pointer;flex:none}.lil-boolean{cursor:pointer}.lil-option .lil-widget{position:relative}.lil-option .lil-widget:after{content:"";clip-path:polygon(0 25%,100% 25%,50% 85%);pointer-events:none;background:currentColor;width:8px;height:8px;position:absolute;right:8px}.lil-option select{appearance:none;cursor:pointer;padding-right:22px}.lil-option option{background:var(--raised);color:var(--text)}.lil-option .lil-display{display:none}.lil-color .lil-display{height:calc(var(--line) - 2px);border:1px solid var(--rule);border-radius:3px;flex:1}.lil-color input[type=color]{opacity:0;cursor:pointer;width:100%;height:100%;display:block}.lil-controller.lil-color input[type=text]{flex:none;width:62px}.lil-number input[type=range]{min-width:0;height:calc(var(--line) - 2px);background:linear-gradient(var(--accent), var(--accent)) no-repeat 0 50% / calc(var(--share,0) * 100%) 2px var(--raised);appearance:none;cursor:ew-resize;touch-action:pan-y;border-radius:3px;flex:1}.lil-number input[type=range]::-webkit-slider-thumb{width:4px;height:calc(var(--line) - 6px);background:var(--accent);appearance:none;border-radius:2px}.lil-number input[type=range]::-moz-range-thumb{width:4px;height:calc(var(--line) - 6px);background:var(--accent);border:0;border-radius:2px}@media (hover:hover){.lil-controller :is(button,select,input[type=range],input[type=text]):hover{background-color:var(--hover)}}.lil-gui :is(button,select,input,textarea):focus-visible,.lil-color .lil-display:focus-within{outline:2px solid var(--accent);outline-offset:-2px}input[type=checkbox]:focus-visible{outline-offset:1px}@media (pointer:coarse){.lil-controller :is(input,select){--typed:16px}input[type=checkbox]{width:20px;height:20px}.lil-controller.lil-number input:not([type=range]),.lil-controller.lil-color input[type=text]{width:84px}}`,Ne=`.panel{--gap:8px;--line:26px;--text:#ececf1;--faint:#b9b9c6;--ground:#18181ef0;--raised:#34343f;--hover:#444452;--rule:#ffffff24;--accent:#7cc0ff;top:var(--gap);right:var(--gap);max-width:calc(100% - 2 * var(--gap));max-height:calc(100% - 2 * var(--gap));border-radius:6px;flex-direction:column;display:flex;overflow:hidden}.panel:empty{display:none}.lil-gui,.lil-gui *{box-sizing:border-box;margin:0;padding:0}.lil-root{border:1px solid var(--rule);border-radius:inherit;background:var(--ground);width:280px;max-width:100%;min-height:0;color:var(--text);--lightningcss-light: ;--lightningcss-dark:initial;color-scheme:dark;text-align:left;cursor:default;-webkit-user-select:none;user-select:none;touch-action:pan-y;outline:none;flex-direction:column;font:12px/1.3 system-ui,sans-serif;display:flex}.lil-root.lil-closed{width:auto}.lil-root>.lil-title{flex:none}.lil-root>.lil-children{overscroll-behavior:contain;scrollbar-width:thin;border-top:1px solid var(--rule);min-height:0;overflow:hidden auto}.lil-closed>.lil-children{display:none}.lil-gui .lil-gui{position:relative}.lil-gui .lil-gui+.lil-gui,.lil-gui .lil-controller+.lil-gui{border-top:1px solid var(--rule)}.lil-gui .lil-gui .lil-gui{border-left:1px solid var(--rule);margin-left:10px}.lil-gui .lil-gui .lil-children{padding-bottom:4px}.lil-function+.lil-gui{margin-top:4px}.lil-title{width:100%;min-height:calc(var(--line) + 4px);color:inherit;font:inherit;text-align:left;overflow-wrap:anywhere;cursor:pointer;background:0 0;border:0;border-radius:0;align-items:center;gap:7px;padding:0 10px 0 8px;font-weight:600;display:flex}.lil-title:before{content:"";clip-path:polygon(0 20%,100% 20%,50% 85%);background:currentColor;flex:none;width:8px;height:8px}.lil-closed>.lil-title:before{clip-path:polygon(20% 0,85% 50%,20% 100%)}.lil-title:has(+.switch){padding-right:36px}.off>.lil-title{color:var(--faint);font-weight:400}.switch{position:absolute;top:6px;right:10px}@media (hover:hover){.lil-title:hover{background:#ffffff14}}@media (pointer:coarse){.panel{--line:34px}.lil-root{font-size:13px}.switch{top:9px}}`;function Pe(e){let t=Ne+Me+je;return d(e,t),()=>{u(e,t)}}var Fe=3,$=5,Ie=class{#e;#t=[0,0,0];#n=$;#r=!0;constructor(e){this.#e=e}expire(){this.#r=!0}get center(){return this.#i(),this.#t}get reach(){return this.#i(),this.#n}place(e){this.#i();let t=D(this.#n/500),n=Math.round(this.#t[e]/t)*t,r=Math.abs(n)<this.#n/2?0:n;return k(r-this.#n,r+this.#n,t)}vector(){return k(-this.reach,this.reach,D(this.reach/500))}#i(){if(!this.#r)return;this.#r=!1;let{scene:e}=this.#e;e.updateMatrixWorld();let t=ee(e),n=t.empty?0:t.radiusAbout(t.center);this.#t=t.center,this.#n=n>0?D(Fe*n):$}};function Le(e,t){return new V(e,`Shading`,e=>{L(e,`shading`,z(c),()=>t.shading,e=>t.shading=e),L(e,`reflection`,z(l),()=>t.reflection,e=>t.reflection=e);for(let n of f)I(e,`${n} term`,()=>t.terms.includes(n),e=>{t.terms=f.filter(r=>r===n?e:t.terms.includes(r))});L(e,`colour space`,z([`srgb`,`linear`]),()=>t.colorInterpolation,e=>t.colorInterpolation=e),L(e,`antialias`,z(p),()=>t.antialias,e=>t.antialias=e)})}var Re=480,ze=(e,t,n)=>new Be(e,t,n),Be=class{#e;#t;#n;#r;#i;#a;#o;#s;#c;#l;#u;#d;#f;#p=[];constructor(e,t,n){this.#e=e,this.#d=Pe(n);let r=Ve(t);this.#t=r,this.#n=new Ie(e),this.#r=H(r,`Lights`),R(this.#r,`add light`,()=>{this.#v()}),this.#i=new q(this.#r,e=>this.#_(e)),this.#s=new he(r,e,this.#n),this.#c=Le(r,e),this.#l=Ee(r,e),this.#a=H(r,`Meshes`).close(),this.#o=new q(this.#a,e=>new De(this.#a,e,this.#n)),this.#u=new _e(r,()=>e.toHTML());for(let e of[`lights`,`camera`,`viewer`,`meshes`])this.update(e);r.onOpenClose(()=>{this.#m()}),e.addEventListener(`load`,this.#g),this.#f=He(r,e)}update(e){e===`light`||e===`lights`?this.#i.update(this.#e.lights):e===`mesh`||e===`meshes`?this.#h():this.#s.update(),e===`viewer`&&(this.#c.update(),this.#l.update())}dispose(){this.#e.removeEventListener(`load`,this.#g),this.#f(),this.#u.dispose(),this.#t.destroy(),this.#d()}#m(){this.#i.refreshVisible(),this.#o.refreshVisible();for(let e of[this.#s.folder,this.#c,this.#l.folder])e.refreshVisible()}#h(){let{meshes:e}=this.#e;e!==this.#p&&this.#n.expire(),this.#p=e,this.#a.show(e.length>0),this.#o.update(e)}#g=()=>{this.#n.expire(),this.#i.update(this.#e.lights),this.#s.update(),this.#h()};#_(e){return new Te(this.#r,e,this.#e,this.#n,()=>{this.#y(e)})}#v(){let e=document.createElement(`phong-light`);Object.assign(e,Q(this.#e.lights.length,this.#n.center,this.#n.reach)),this.#e.append(e),this.update(`lights`);let t=this.#i.folderOf(e);if(t===void 0)return;t.gui.open(),t.gui.$title.focus({preventScroll:!0});let n=this.#t.$children;n.scrollTop+=t.gui.domElement.getBoundingClientRect().top-n.getBoundingClientRect().top}#y(e){let t=this.#e.lights.indexOf(e);e.remove(),this.update(`lights`);let{lights:n}=this.#e,r=n[t]??n.at(-1);(r===void 0?this.#r:this.#i.folderOf(r)?.gui)?.$title.focus({preventScroll:!0})}};function Ve(e){let t=U(new oe({container:e,injectStyles:!1,title:`Controls`}));return t.domElement.tabIndex=-1,t.domElement.setAttribute(`role`,`group`),t.domElement.setAttribute(`aria-label`,`Controls`),t}function He(e,t){let n=()=>(e.open(t.clientWidth>=Re),t.clientWidth>0&&t.clientHeight>0),r=t.ownerDocument.defaultView;if(n()||r===null)return()=>void 0;e.close();let i=new r.ResizeObserver(()=>{n()&&i.disconnect()});return i.observe(t),()=>{i.disconnect()}}export{ze as createPanel};