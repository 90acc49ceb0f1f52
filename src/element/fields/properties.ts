// What the elements' properties return and accept. A getter returns the typed value. A setter also accepts the
// attribute's text, other lists of numbers, and null or undefined for the default. Types only; words and domains are
// inherited from the values' own interfaces. Accessors are written out because a mapped type cannot give a setter
// another type than its getter; manifest.test.ts lets the compiler check that none is missing.
import type { LightValues } from '../../light/light-state.js';
import type { MeshValues, ShapeValues } from '../../scene/mesh/mesh-fields.js';
import type { CompareValues } from './compare-fields.js';
import type { ControlValues } from './control-fields.js';
import type { ViewerValues } from './viewer-fields.js';

/** Numbers in a list: an array or a typed array. */
export type NumberList =
  | readonly number[]
  | Float64Array
  | Float32Array
  | Int32Array
  | Int16Array
  | Int8Array
  | Uint32Array
  | Uint16Array
  | Uint8Array
  | Uint8ClampedArray;

/** Properties where one number may stand for a list: a grey, the same scale along every axis, the only divider. */
export type SingleNumber = 'ambient' | 'diffuse' | 'specular' | 'ka' | 'kd' | 'ks' | 'scale' | 'at';

/** What the property `K` accepts for values of type `T`. */
type Input<K, T> =
  | (T extends readonly number[]
      ? NumberList | string
      : T extends boolean
        ? T | 'true' | 'false' | ''
        : T extends string
          ? T
          : T | string)
  | (K extends SingleNumber ? number : never)
  | (K extends 'labels' ? readonly string[] : never)
  | null
  | undefined;

/** What each property accepts, by its name. */
export type Inputs<V> = { readonly [K in keyof V]: Input<K, NonNullable<V[K]>> };

type Light = Inputs<LightValues>;
type Shape = Inputs<ShapeValues>;
type Mesh = Inputs<MeshValues>;
type Viewer = Inputs<ViewerValues>;
type Compare = Inputs<CompareValues>;
type Control = Inputs<ControlValues>;

export interface LightProperties extends LightValues {
  get name(): LightValues['name'];
  set name(value: Light['name']);
  get active(): LightValues['active'];
  set active(value: Light['active']);
  get ambient(): LightValues['ambient'];
  set ambient(value: Light['ambient']);
  get diffuse(): LightValues['diffuse'];
  set diffuse(value: Light['diffuse']);
  get specular(): LightValues['specular'];
  set specular(value: Light['specular']);
  get position(): LightValues['position'];
  set position(value: Light['position']);
  get axis(): LightValues['axis'];
  set axis(value: Light['axis']);
  get aperture(): LightValues['aperture'];
  set aperture(value: Light['aperture']);
  get cutoff(): LightValues['cutoff'];
  set cutoff(value: Light['cutoff']);
  get attenuation(): LightValues['attenuation'];
  set attenuation(value: Light['attenuation']);
  get space(): LightValues['space'];
  set space(value: Light['space']);
}

interface ShapeProperties extends ShapeValues {
  get src(): ShapeValues['src'];
  set src(value: Shape['src']);
  get type(): ShapeValues['type'];
  set type(value: Shape['type']);
  get geometry(): ShapeValues['geometry'];
  set geometry(value: Shape['geometry']);
  get segments(): ShapeValues['segments'];
  set segments(value: Shape['segments']);
  get autoplay(): ShapeValues['autoplay'];
  set autoplay(value: Shape['autoplay']);
  get animationName(): ShapeValues['animationName'];
  set animationName(value: Shape['animationName']);
  get ka(): ShapeValues['ka'];
  set ka(value: Shape['ka']);
  get kd(): ShapeValues['kd'];
  set kd(value: Shape['kd']);
  get ks(): ShapeValues['ks'];
  set ks(value: Shape['ks']);
  get shininess(): ShapeValues['shininess'];
  set shininess(value: Shape['shininess']);
}

export interface MeshProperties extends ShapeProperties, MeshValues {
  get name(): MeshValues['name'];
  set name(value: Mesh['name']);
  get position(): MeshValues['position'];
  set position(value: Mesh['position']);
  get rotation(): MeshValues['rotation'];
  set rotation(value: Mesh['rotation']);
  get scale(): MeshValues['scale'];
  set scale(value: Mesh['scale']);
  get shading(): MeshValues['shading'];
  set shading(value: Mesh['shading']);
  get reflection(): MeshValues['reflection'];
  set reflection(value: Mesh['reflection']);
}

export interface ViewerProperties extends ShapeProperties, ViewerValues {
  get theta(): ViewerValues['theta'];
  set theta(value: Viewer['theta']);
  get phi(): ViewerValues['phi'];
  set phi(value: Viewer['phi']);
  get radius(): ViewerValues['radius'];
  set radius(value: Viewer['radius']);
  get target(): ViewerValues['target'];
  set target(value: Viewer['target']);
  get alt(): ViewerValues['alt'];
  set alt(value: Viewer['alt']);
  get poster(): ViewerValues['poster'];
  set poster(value: Viewer['poster']);
  get loading(): ViewerValues['loading'];
  set loading(value: Viewer['loading']);
  get droppable(): ViewerValues['droppable'];
  set droppable(value: Viewer['droppable']);
  get crossOrigin(): ViewerValues['crossOrigin'];
  set crossOrigin(value: Viewer['crossOrigin']);
  get fov(): ViewerValues['fov'];
  set fov(value: Viewer['fov']);
  get orbit(): ViewerValues['orbit'];
  set orbit(value: Viewer['orbit']);
  get zoom(): ViewerValues['zoom'];
  set zoom(value: Viewer['zoom']);
  get autoRotate(): ViewerValues['autoRotate'];
  set autoRotate(value: Viewer['autoRotate']);
  get shading(): ViewerValues['shading'];
  set shading(value: Viewer['shading']);
  get reflection(): ViewerValues['reflection'];
  set reflection(value: Viewer['reflection']);
  get terms(): ViewerValues['terms'];
  set terms(value: Viewer['terms']);
  get colorInterpolation(): ViewerValues['colorInterpolation'];
  set colorInterpolation(value: Viewer['colorInterpolation']);
  get antialias(): ViewerValues['antialias'];
  set antialias(value: Viewer['antialias']);
  get samples(): ViewerValues['samples'];
  set samples(value: Viewer['samples']);
  get pixelRatio(): ViewerValues['pixelRatio'];
  set pixelRatio(value: Viewer['pixelRatio']);
  get helpers(): ViewerValues['helpers'];
  set helpers(value: Viewer['helpers']);
  get view(): ViewerValues['view'];
  set view(value: Viewer['view']);
  get viewLight(): ViewerValues['viewLight'];
  set viewLight(value: Viewer['viewLight']);
  get probe(): ViewerValues['probe'];
  set probe(value: Viewer['probe']);
  get probeAt(): ViewerValues['probeAt'];
  set probeAt(value: Viewer['probeAt']);
  get cameraGroup(): ViewerValues['cameraGroup'];
  set cameraGroup(value: Viewer['cameraGroup']);
  get gui(): ViewerValues['gui'];
  set gui(value: Viewer['gui']);
}

export interface CompareProperties extends CompareValues {
  get layout(): CompareValues['layout'];
  set layout(value: Compare['layout']);
  get direction(): CompareValues['direction'];
  set direction(value: Compare['direction']);
  get at(): CompareValues['at'];
  set at(value: Compare['at']);
  get labels(): CompareValues['labels'];
  set labels(value: Compare['labels']);
}

export interface ControlProperties extends ControlValues {
  get for(): ControlValues['for'];
  set for(value: Control['for']);
  get attribute(): ControlValues['attribute'];
  set attribute(value: Control['attribute']);
  get component(): ControlValues['component'];
  set component(value: Control['component']);
  get values(): ControlValues['values'];
  set values(value: Control['values']);
  get min(): ControlValues['min'];
  set min(value: Control['min']);
  get max(): ControlValues['max'];
  set max(value: Control['max']);
  get step(): ControlValues['step'];
  set step(value: Control['step']);
  get type(): ControlValues['type'];
  set type(value: Control['type']);
}
