// What Svelte's templates accept on the elements, for svelte-check and editors. Handlers are `oncamera-change` or, in
// older templates, `on:camera-change`. Types only.
import type { AnyElement, Elements, EventProps, ValueProps } from './markup.js';

// Svelte is no dependency. Without it this import is an error that must not reach users of this package, and the types
// below are unused.
// eslint-disable-next-line @typescript-eslint/ban-ts-comment
/** @ts-ignore */
import type { HTMLAttributes } from 'svelte/elements';

type OwnProps<E extends AnyElement> = ValueProps<E['values']> &
  E['properties'] &
  EventProps<E['events'], 'on'> &
  EventProps<E['events'], 'on:'>;

type Attributes<E extends AnyElement> = OwnProps<E> & Omit<HTMLAttributes<E['element']>, keyof OwnProps<E>>;

// eslint-disable-next-line @typescript-eslint/ban-ts-comment
/** @ts-ignore */
declare module 'svelte/elements' {
  interface SvelteHTMLElements {
    'phong-light': Attributes<Elements['light']>;
    'phong-mesh': Attributes<Elements['mesh']>;
    'phong-viewer': Attributes<Elements['viewer']>;
    'phong-compare': Attributes<Elements['compare']>;
    'phong-control': Attributes<Elements['control']>;
  }
}
