// What JSX may write on the elements: types for React 19, which sets properties where an element has them, attributes
// else, and listens to `onload`, `oncamera-change` and so on under the events' own names. Types only.
import type { LightValues } from '../light/light-state.js';
import type { Vec3, Vec4 } from '../math/vector.js';
import type { MeshValues } from '../scene/mesh/mesh-fields.js';
import type { PhongMeshEventMap, PhongViewerEventMap } from './events.js';
import type { PhongLight } from './phong-light.js';
import type { PhongMesh } from './phong-mesh.js';
import type { PhongViewer } from './phong-viewer.js';
import type { ViewerValues } from './fields/viewer-fields.js';

// React is no dependency. Without it (or without its types) the name is an error here that must not reach whoever
// imports this package, and the types below stand idle; with it they need no import of their own.
// eslint-disable-next-line @typescript-eslint/ban-ts-comment
/** @ts-ignore */
import type { ClassAttributes, HTMLAttributes } from 'react';

/** Values where one number stands for three: grey, or the same along every axis. */
export type SingleNumber = 'ambient' | 'diffuse' | 'specular' | 'ka' | 'kd' | 'ks' | 'scale';

/** A value as its property takes it, the attribute's text, or null or undefined for the default. */
type Written<K, T> =
  | (T extends string ? T : T extends boolean ? T | 'true' | 'false' | '' : T | string)
  | (T extends Vec4 ? Vec3 : never)
  | (K extends SingleNumber ? number : never)
  | null
  | undefined;

type Dashed<S extends string> = S extends `${infer Head}${infer Tail}`
  ? `${Head extends Lowercase<Head> ? Head : `-${Lowercase<Head>}`}${Dashed<Tail>}`
  : S;

/** As `attributeOf` names them. */
type AttributeName<K extends string> = K extends 'crossOrigin' ? 'crossorigin' : Dashed<K>;

/** Every value under its property's and its attribute's name. */
type ValueProps<V> = {
  readonly [K in keyof V & string as K | AttributeName<K>]?: Written<K, NonNullable<V[K]>>;
};

type EventProps<Events> = {
  readonly [K in keyof Events & string as `on${K}`]?: ((event: Events[K]) => unknown) | undefined;
};

/** React's own `onLoad` and the like never hear an event that does not bubble. */
type Unheard<Events> = `on${Capitalize<keyof Events & string>}`;

type ElementProps<E, V, Events> = ValueProps<V> &
  EventProps<Events> &
  ClassAttributes<E> &
  Omit<HTMLAttributes<E>, keyof ValueProps<V> | Unheard<Events>>;

export type PhongLightProps = ElementProps<PhongLight, LightValues, object>;
export type PhongMeshProps = ElementProps<PhongMesh, MeshValues, PhongMeshEventMap>;
export type PhongViewerProps = ElementProps<PhongViewer, ViewerValues, PhongViewerEventMap>;

// eslint-disable-next-line @typescript-eslint/ban-ts-comment
/** @ts-ignore */
declare module 'react' {
  // eslint-disable-next-line @typescript-eslint/no-namespace
  namespace JSX {
    interface IntrinsicElements {
      'phong-light': PhongLightProps;
      'phong-mesh': PhongMeshProps;
      'phong-viewer': PhongViewerProps;
    }
  }
}
