// What the elements' properties return and accept. A getter returns the typed value. A setter also
// accepts the attribute's text, other lists of numbers, and null or undefined for the default.
// Types only; words and domains are inherited from the values' own interfaces. Accessors are
// written out because a mapped type cannot give a setter another type than its getter;
// manifest.test.ts lets the compiler check that none is missing.
import type { LightValues } from '../../../phong/light/light-state.js';
import type { MeshValues, ShapeValues } from '../../../phong/model/mesh-fields.js';

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

/**
 * Properties where one number may stand for a list: a grey, the same scale along every axis, the
 * only divider.
 */
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

/** What the getters of `P` give: the values without what the setters accept. */
export type ValuesOf<P> = { [K in keyof P]: P[K] };

type Light = Inputs<LightValues>;
type Shape = Inputs<ShapeValues>;
type Mesh = Inputs<MeshValues>;

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

export interface ShapeProperties extends ShapeValues {
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
