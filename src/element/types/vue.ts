// What Vue's templates accept on the elements, for vue-tsc and editors. Handlers are `@camera-change` and so on. Types
// only.
import type { AnyElement, Elements, Handlers, ValueProps } from './markup.js';

// Vue is no dependency. Without it this import is an error that must not reach users of this package, and the types
// below are unused.
// eslint-disable-next-line @typescript-eslint/ban-ts-comment
/** @ts-ignore */
import type { HTMLAttributes, PublicProps } from 'vue';

/** Vue writes `null` and `undefined` as 0, false or an empty text, not as the default. */
type Given<Props> = { readonly [K in keyof Props]?: NonNullable<Props[K]> };

type OwnProps<E extends AnyElement> = Given<ValueProps<E['values']>> & E['properties'] & Handlers<E['events']>;

/** A global component, as vue-tsc reads it: its props, and the element that a template ref holds. */
type Component<E extends AnyElement> = new () => E['element'] & {
  readonly $props: OwnProps<E> & Omit<HTMLAttributes, keyof OwnProps<E>> & Omit<PublicProps, keyof OwnProps<E>>;
};

// eslint-disable-next-line @typescript-eslint/ban-ts-comment
/** @ts-ignore */
declare module 'vue' {
  interface GlobalComponents {
    'phong-light': Component<Elements['light']>;
    'phong-mesh': Component<Elements['mesh']>;
    'phong-viewer': Component<Elements['viewer']>;
    'phong-compare': Component<Elements['compare']>;
    'phong-control': Component<Elements['control']>;
  }
}
