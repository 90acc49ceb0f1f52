// What JSX accepts on the elements: types for React 19, which sets properties where an element has them, attributes
// otherwise, and listens to `onload`, `oncamera-change` and so on under the events' own names. Types only.
import type { LightValues } from '../light/light-state.js';
import type { MeshValues } from '../scene/mesh/mesh-fields.js';
import type { PhongMeshEventMap, PhongViewerEventMap } from './events.js';
import type { PhongLight } from './phong-light.js';
import type { PhongMesh } from './phong-mesh.js';
import type { PhongViewer } from './phong-viewer.js';
import type { Inputs } from './fields/properties.js';
import type { ViewerValues } from './fields/viewer-fields.js';

// React is no dependency. Without it, or without its types, this import is an error that must not reach users of this
// package, and the types below are unused. With it they need no import of their own.
// eslint-disable-next-line @typescript-eslint/ban-ts-comment
/** @ts-ignore */
import type { ClassAttributes, HTMLAttributes } from 'react';

type Dashed<S extends string> = S extends `${infer Head}${infer Tail}`
  ? `${Head extends Lowercase<Head> ? Head : `-${Lowercase<Head>}`}${Dashed<Tail>}`
  : S;

/** As `attributeOf` names them. */
type AttributeName<K extends string> = K extends 'crossOrigin' ? 'crossorigin' : Dashed<K>;

/** Every value under its property's and its attribute's name. */
type ValueProps<V> = {
  readonly [K in keyof V & string as K | AttributeName<K>]?: Inputs<V>[K];
};

type EventProps<Events> = {
  readonly [K in keyof Events & string as `on${K}`]?: ((event: Events[K]) => unknown) | undefined;
};

/** React's own `onLoad` and the like do not receive events that do not bubble. */
type Unheard<Events> = `on${Capitalize<keyof Events & string>}`;

type ElementProps<E, V, Events> = ValueProps<V> &
  EventProps<Events> &
  ClassAttributes<E> &
  Omit<HTMLAttributes<E>, keyof ValueProps<V> | Unheard<Events>>;

/** As React spells handlers: `onCameraChange` for `camera-change`. */
type Pascal<S extends string> = S extends `${infer Head}-${infer Tail}`
  ? `${Capitalize<Head>}${Pascal<Tail>}`
  : Capitalize<S>;

/** Handlers of an element's own events, by the names that the components of `phong-viewer/react` give them. */
export type Handlers<Events> = {
  readonly [K in keyof Events & string as `on${Pascal<K>}`]?: ((event: Events[K]) => unknown) | undefined;
};

/** Props of a component of `phong-viewer/react` for an element with these props and events. */
export type ComponentProps<Props, Events> = Omit<Props, keyof EventProps<Events>> & Handlers<Events>;

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
