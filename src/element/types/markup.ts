// What templates of any framework accept on the elements: every value under its property's and its attribute's name,
// and the element's own events. Derived from the interfaces behind the tables of fields. Types only.
import type { LightValues } from '../../light/light-state.js';
import type { MeshValues } from '../../scene/mesh/mesh-fields.js';
import type { PhongCompareEventMap, PhongMeshEventMap, PhongViewerEventMap } from '../events.js';
import type { Inputs } from '../fields/properties.js';
import type { CompareValues } from '../fields/compare-fields.js';
import type { ControlValues } from '../fields/control-fields.js';
import type { ViewerTexts } from '../fields/texts.js';
import type { ViewerValues } from '../fields/viewer-fields.js';
import type { PhongCompare, PhongControl, PhongLight, PhongMesh, PhongViewer } from '../elements.js';

/** Class, values, properties without an attribute, and events of each element. */
export interface Elements {
  readonly light: {
    readonly element: PhongLight;
    readonly values: LightValues;
    readonly properties: object;
    readonly events: object;
  };
  readonly mesh: {
    readonly element: PhongMesh;
    readonly values: MeshValues;
    readonly properties: object;
    readonly events: PhongMeshEventMap;
  };
  readonly viewer: {
    readonly element: PhongViewer;
    readonly values: ViewerValues;
    readonly properties: {
      readonly texts?: ViewerTexts | null | undefined;
      readonly maxTriangles?: number | null | undefined;
    };
    readonly events: PhongViewerEventMap;
  };
  readonly compare: {
    readonly element: PhongCompare;
    readonly values: CompareValues;
    readonly properties: object;
    readonly events: PhongCompareEventMap;
  };
  readonly control: {
    readonly element: PhongControl;
    readonly values: ControlValues;
    readonly properties: object;
    readonly events: object;
  };
}

export type AnyElement = Elements[keyof Elements];

type Dashed<S extends string> = S extends `${infer Head}${infer Tail}`
  ? `${Head extends Lowercase<Head> ? Head : `-${Lowercase<Head>}`}${Dashed<Tail>}`
  : S;

/** As `attributeOf` names them. */
export type AttributeName<K extends string> = K extends 'crossOrigin' ? 'crossorigin' : Dashed<K>;

/** Every value under its property's and its attribute's name. */
export type ValueProps<V> = {
  readonly [K in keyof V & string as K | AttributeName<K>]?: Inputs<V>[K];
};

/** Handlers by the events' names, with a prefix such as `on`. */
export type EventProps<Events, Prefix extends string> = {
  readonly [K in keyof Events & string as `${Prefix}${K}`]?: ((event: Events[K]) => unknown) | undefined;
};

/** As frameworks spell events in camel case: `CameraChange` for `camera-change`. */
type Pascal<S extends string> = S extends `${infer Head}-${infer Tail}`
  ? `${Capitalize<Head>}${Pascal<Tail>}`
  : Capitalize<S>;

/** Handlers such as `onCameraChange` for `camera-change`. */
export type Handlers<Events> = {
  readonly [K in keyof Events & string as `on${Pascal<K>}`]?: ((event: Events[K]) => unknown) | undefined;
};
