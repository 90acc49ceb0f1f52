// What Solid's JSX accepts on the elements. Solid turns an attribute's name into that of a property (`autoRotate` for
// `auto-rotate`, but `autorotate` for `autoRotate`), except after `prop:` and `attr:`. Handlers are `on:camera-change`.
// Types only.
import type { Inputs } from '../fields/properties.js';
import type { AnyElement, AttributeName, Elements, EventProps } from './markup.js';

// Solid is no dependency. Without it this import is an error that must not reach users of this package, and the types
// below are unused.
// eslint-disable-next-line @typescript-eslint/ban-ts-comment
/** @ts-ignore */
import type { JSX } from 'solid-js';

/** Without `crossorigin`, which Solid would write to a property of that name. `attr:crossorigin` works. */
type Values<V> = {
  readonly [K in Exclude<keyof V & string, 'crossOrigin'> as AttributeName<K>]?: Inputs<V>[K];
} & { readonly [K in keyof V & string as `prop:${K}`]?: Inputs<V>[K] } & {
  readonly [K in keyof V & string as `attr:${AttributeName<K>}`]?: string | number | boolean | undefined;
};

type Properties<P> = P & { readonly [K in keyof P & string as `prop:${K}`]?: P[K] };

type OwnProps<E extends AnyElement> = Values<E['values']> &
  Properties<E['properties']> &
  EventProps<E['events'], 'on:'>;

/** Solid's own `onLoad` and `onload` promise other events than these. */
type Mistyped<Events> = Lowercase<`on${keyof Events & string}`> | `on${Capitalize<keyof Events & string>}`;

type Attributes<E extends AnyElement> = OwnProps<E> &
  Omit<JSX.HTMLAttributes<E['element']>, keyof OwnProps<E> | Mistyped<E['events']>>;

// eslint-disable-next-line @typescript-eslint/ban-ts-comment
/** @ts-ignore */
declare module 'solid-js' {
  // eslint-disable-next-line @typescript-eslint/no-namespace
  namespace JSX {
    interface IntrinsicElements {
      'phong-light': Attributes<Elements['light']>;
      'phong-mesh': Attributes<Elements['mesh']>;
      'phong-viewer': Attributes<Elements['viewer']>;
      'phong-compare': Attributes<Elements['compare']>;
      'phong-control': Attributes<Elements['control']>;
    }
  }
}
