// What templates of React, Solid, Svelte and Vue accept on the elements: every value under its
// property's and its attribute's name, and the element's own events. Derived from the interfaces
// behind the tables of fields. Types only.

// No framework is a dependency. Without it, or without its types, its import is an error that must
// not reach users of this package, and its types below are unused. With it they need no import of
// their own.
/* oxlint-disable typescript/ban-ts-comment, typescript/no-namespace, typescript/no-empty-object-type */
/** @ts-ignore */
import type { ClassAttributes, HTMLAttributes } from 'react';
/** @ts-ignore */
import type { JSX } from 'solid-js';
/** @ts-ignore */
import type { HTMLAttributes as SvelteAttributes } from 'svelte/elements';
/** @ts-ignore */
import type { HTMLAttributes as VueAttributes, PublicProps } from 'vue';
import type { ElementTypes as Elements } from './elements.js';
import type { Inputs } from './fields/properties.js';

type AnyElement = Elements[keyof Elements];

type Dashed<S extends string> = S extends `${infer Head}${infer Tail}`
  ? `${Head extends Lowercase<Head> ? Head : `-${Lowercase<Head>}`}${Dashed<Tail>}`
  : S;

/** As `attributeOf` names them. */
type AttributeName<K extends string> = K extends 'crossOrigin' ? 'crossorigin' : Dashed<K>;

/** Every value under its property's and its attribute's name. */
type ValueProps<V> = {
  readonly [K in keyof V & string as K | AttributeName<K>]?: Inputs<V>[K];
};

/** Handlers by the events' names, with a prefix such as `on`. */
type EventProps<Events, Prefix extends string, Element> = {
  readonly [K in keyof Events & string as `${Prefix}${K}`]?:
    | ((event: Heard<Events[K], Element>) => unknown)
    | undefined;
};

/** An event as a handler on the element gets it. */
type Heard<Event, Element> = Event & { readonly currentTarget: Element };

/** As frameworks spell events in camel case: `CameraChange` for `camera-change`. */
type Pascal<S extends string> = S extends `${infer Head}-${infer Tail}`
  ? `${Capitalize<Head>}${Pascal<Tail>}`
  : Capitalize<S>;

/** Handlers such as `onCameraChange` for `camera-change`. */
export type Handlers<Events, Element> = {
  readonly [K in keyof Events & string as `on${Pascal<K>}`]?:
    | ((event: Heard<Events[K], Element>) => unknown)
    | undefined;
};

// React 19 sets properties where an element has them, attributes otherwise, and listens to
// `onload`, `oncamera-change` and so on under the events' own names.

/** React's own `onLoad` and the like do not receive events that do not bubble. */
type Unheard<Events> = `on${Capitalize<keyof Events & string>}`;

/** React's `color` is for SVG and old HTML: a guess at `diffuse` or `kd` must not pass. */
type ReactProps<E extends AnyElement> = ValueProps<E['values']> &
  E['properties'] &
  EventProps<E['events'], 'on', E['element']> &
  ClassAttributes<E['element']> &
  Omit<
    HTMLAttributes<E['element']>,
    keyof ValueProps<E['values']> | Unheard<E['events']> | 'color'
  >;

type ReactElements = { [Tag in keyof Elements]: ReactProps<Elements[Tag]> };

export type PhongLightProps = ReactElements['phong-light'];
export type PhongMeshProps = ReactElements['phong-mesh'];
export type PhongViewerProps = ReactElements['phong-viewer'];
export type PhongCompareProps = ReactElements['phong-compare'];
export type PhongControlProps = ReactElements['phong-control'];
export type PhongProbeProps = ReactElements['phong-probe'];
export type PhongExerciseProps = ReactElements['phong-exercise'];

/** Props of a component of `phong-viewer/react` for an element with these props and events. */
export type ComponentProps<Tag extends keyof Elements> = Omit<
  ReactElements[Tag],
  keyof EventProps<Elements[Tag]['events'], 'on', unknown>
> &
  Handlers<Elements[Tag]['events'], Elements[Tag]['element']>;

/** @ts-ignore */
declare module 'react' {
  namespace JSX {
    interface IntrinsicElements extends ReactElements {}
  }
}

// Solid turns an attribute's name into that of a property (`autoRotate` for `auto-rotate`, but
// `autorotate` for `autoRotate`), except after `prop:` and `attr:`. Handlers are
// `on:camera-change`.

/**
 * Without `crossorigin`, which Solid would write to a property of that name. `attr:crossorigin`
 * works.
 */
type SolidValues<V> = {
  readonly [K in Exclude<keyof V & string, 'crossOrigin'> as AttributeName<K>]?: Inputs<V>[K];
} & { readonly [K in keyof V & string as `prop:${K}`]?: Inputs<V>[K] } & {
  readonly [K in keyof V & string as `attr:${AttributeName<K>}`]?:
    | string
    | number
    | boolean
    | undefined;
};

type SolidProperties<P> = P & { readonly [K in keyof P & string as `prop:${K}`]?: P[K] };

type OwnSolidProps<E extends AnyElement> = SolidValues<E['values']> &
  SolidProperties<E['properties']> &
  EventProps<E['events'], 'on:', E['element']>;

/** Solid's own `onLoad` and `onload` promise other events than these. */
type Mistyped<Events> = Lowercase<`on${keyof Events & string}`> | Unheard<Events>;

type SolidProps<E extends AnyElement> = OwnSolidProps<E> &
  Omit<JSX.HTMLAttributes<E['element']>, keyof OwnSolidProps<E> | Mistyped<E['events']>>;

type SolidElements = { [Tag in keyof Elements]: SolidProps<Elements[Tag]> };

/** @ts-ignore */
declare module 'solid-js' {
  namespace JSX {
    interface IntrinsicElements extends SolidElements {}
  }
}

// Svelte, for svelte-check and editors. Handlers are `oncamera-change` or, in older templates,
// `on:camera-change`.

type OwnSvelteProps<E extends AnyElement> = ValueProps<E['values']> &
  E['properties'] &
  EventProps<E['events'], 'on', E['element']> &
  EventProps<E['events'], 'on:', E['element']>;

type SvelteElements = {
  [Tag in keyof Elements]: OwnSvelteProps<Elements[Tag]> &
    Omit<SvelteAttributes<Elements[Tag]['element']>, keyof OwnSvelteProps<Elements[Tag]>>;
};

/** @ts-ignore */
declare module 'svelte/elements' {
  interface SvelteHTMLElements extends SvelteElements {}
}

// Vue, for vue-tsc and editors. Handlers are `@camera-change` and so on.

/** Vue writes `null` and `undefined` as 0, false or an empty text, not as the default. */
type Given<Props> = { readonly [K in keyof Props]?: NonNullable<Props[K]> };

type OwnVueProps<E extends AnyElement> = Given<ValueProps<E['values']>> &
  E['properties'] &
  Handlers<E['events'], E['element']>;

/**
 * A global component, as vue-tsc reads it: its props, and the element that a template ref holds.
 */
type VueComponent<E extends AnyElement> = new () => E['element'] & {
  readonly $props: OwnVueProps<E> &
    Omit<VueAttributes, keyof OwnVueProps<E>> &
    Omit<PublicProps, keyof OwnVueProps<E>>;
};

type VueComponents = { [Tag in keyof Elements]: VueComponent<Elements[Tag]> };

/** @ts-ignore */
declare module 'vue' {
  interface GlobalComponents extends VueComponents {}
}
