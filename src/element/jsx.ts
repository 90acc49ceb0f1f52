// What JSX accepts on the elements: types for React 19, which sets properties where an element has them, attributes
// otherwise, and listens to `onload`, `oncamera-change` and so on under the events' own names. Types only.
import type { AnyElement, Elements, EventProps, Handlers, ValueProps } from './types/markup.js';

// React is no dependency. Without it, or without its types, this import is an error that must not reach users of this
// package, and the types below are unused. With it they need no import of their own.
// eslint-disable-next-line @typescript-eslint/ban-ts-comment
/** @ts-ignore */
import type { ClassAttributes, HTMLAttributes } from 'react';

/** React's own `onLoad` and the like do not receive events that do not bubble. */
type Unheard<Events> = `on${Capitalize<keyof Events & string>}`;

/** React's `color` is for SVG and old HTML: a guess at `diffuse` or `kd` must not pass. */
type ElementProps<E extends AnyElement> = ValueProps<E['values']> &
  E['properties'] &
  EventProps<E['events'], 'on'> &
  ClassAttributes<E['element']> &
  Omit<HTMLAttributes<E['element']>, keyof ValueProps<E['values']> | Unheard<E['events']> | 'color'>;

/** Props of a component of `phong-viewer/react` for an element with these props and events. */
export type ComponentProps<Props, Events> = Omit<Props, keyof EventProps<Events, 'on'>> & Handlers<Events>;

export type PhongLightProps = ElementProps<Elements['light']>;
export type PhongMeshProps = ElementProps<Elements['mesh']>;
export type PhongViewerProps = ElementProps<Elements['viewer']>;
export type PhongCompareProps = ElementProps<Elements['compare']>;
export type PhongControlProps = ElementProps<Elements['control']>;

// eslint-disable-next-line @typescript-eslint/ban-ts-comment
/** @ts-ignore */
declare module 'react' {
  // eslint-disable-next-line @typescript-eslint/no-namespace
  namespace JSX {
    interface IntrinsicElements {
      'phong-light': PhongLightProps;
      'phong-mesh': PhongMeshProps;
      'phong-viewer': PhongViewerProps;
      'phong-compare': PhongCompareProps;
      'phong-control': PhongControlProps;
    }
  }
}
