/**
 * `phong-viewer/react`: the elements as typed components for React 18 and later, on the server and
 * on the client. Values are written as the text of attributes: React omits arrays and `false` from
 * a server's markup and does not set them when it hydrates.
 */
import {
  createElement,
  forwardRef,
  type ForwardRefExoticComponent as Component,
  type ReactNode,
  useEffect,
  useImperativeHandle,
  useLayoutEffect,
  useRef,
} from 'react';
import { attributeOf } from '../../phong/fields/attribute-text.js';
import type { ElementTypes, ViewerOwnProps } from '../../viewer/element/elements.js';
import type { ExerciseOwnProps } from '../../viewer/element/phong-exercise.js';
import type { ComponentProps, Handlers } from '../../viewer/element/template-types.js';
import * as elements from '../../viewer/index.js';

export type PhongLightElement = elements.PhongLight;
export type PhongMeshElement = elements.PhongMesh;
export type PhongViewerElement = elements.PhongViewer;
export type PhongCompareElement = elements.PhongCompare;
export type PhongControlElement = elements.PhongControl;
export type PhongProbeElement = elements.PhongProbe;
export type PhongExerciseElement = elements.PhongExercise;

export type PhongLightProps = ComponentProps<'phong-light'>;
export type PhongMeshProps = ComponentProps<'phong-mesh'>;
export type PhongViewerProps = ComponentProps<'phong-viewer'>;
export type PhongCompareProps = ComponentProps<'phong-compare'>;
export type PhongControlProps = ComponentProps<'phong-control'>;
export type PhongProbeProps = ComponentProps<'phong-probe'>;
export type PhongExerciseProps = ComponentProps<'phong-exercise'>;

/**
 * `<phong-light>`. Props are its values in camel case, and what every HTML element accepts. `null`
 * restores a default.
 */
export const PhongLight: Component<PhongLightProps> = component(
  'phong-light',
  elements.PhongLight.observedAttributes,
);

/** `<phong-mesh>`, as {@link PhongLight}, with the events `onLoad` and `onError`. */
export const PhongMesh: Component<PhongMeshProps> = component(
  'phong-mesh',
  elements.PhongMesh.observedAttributes,
);

/**
 * `<phong-viewer>`, as {@link PhongLight}, with `onLoad`, `onProgress`, `onError`,
 * `onCameraChange`, `onLightChange`, `onProbeChange` and `onRender`. A model may load
 * before the page hydrates: then there is no `onLoad`, but `ref.current.loaded` is true.
 */
export const PhongViewer: Component<PhongViewerProps> = component(
  'phong-viewer',
  elements.PhongViewer.observedAttributes,
);

/**
 * `<phong-compare>`, as {@link PhongLight}, with the event `onDividerChange`. Its children are
 * {@link PhongViewer}s.
 */
export const PhongCompare: Component<PhongCompareProps> = component(
  'phong-compare',
  elements.PhongCompare.observedAttributes,
);

/** `<phong-control>`, as {@link PhongLight}. Its children are its label. */
export const PhongControl: Component<PhongControlProps> = component(
  'phong-control',
  // Written out: the table of fields would bring its code.
  ['for', 'attribute', 'component', 'values', 'min', 'max', 'step', 'type'],
);

/** `<phong-probe>`, as {@link PhongLight}, with the event `onAnswer`. */
export const PhongProbe: Component<PhongProbeProps> = component('phong-probe', [
  'for',
  'as',
  'at',
  'ask',
  'seed',
  'name',
  'required',
]);

/** `<phong-exercise>`, as {@link PhongLight}, with the event `onCheck`. */
export const PhongExercise: Component<PhongExerciseProps> = component('phong-exercise', [
  'for',
  'name',
  'terms',
  'kinds',
  'hint',
  'solution',
  'required',
]);

/** The elements' own events by their props. React itself adds no such listener when it hydrates. */
const EVENTS: ReadonlyMap<string, string> = new Map(
  Object.entries({
    onLoad: 'load',
    onProgress: 'progress',
    onError: 'error',
    onCameraChange: 'camera-change',
    onLightChange: 'light-change',
    onProbeChange: 'probe-change',
    onAnswer: 'answer',
    onRender: 'render',
    onDividerChange: 'divider-change',
    onCheck: 'check',
  } satisfies Record<keyof Handlers<Record<EventName, Event>, unknown>, EventName>),
);

const OWN_PROPS: readonly string[] = ['texts', 'maxTriangles', 'maxMemory', 'value'] satisfies (
  | keyof ViewerOwnProps
  | keyof ExerciseOwnProps
)[];

type EventName = {
  [T in keyof ElementTypes]: keyof ElementTypes[T]['events'];
}[keyof ElementTypes];

/** Props that are neither a value nor an event of the element are left to React. */
function component<P extends object>(tag: string, attributes: readonly string[]): Component<P> {
  const isValue = new Set(attributes);
  const made = forwardRef<unknown, object>((props, ref) => {
    const element = useRef<HTMLElement>(null);
    const rendered: Record<string, unknown> = { ref: element };
    const handlers: [type: string, handler: EventListener][] = [];
    for (const [name, value] of Object.entries(props)) {
      const type = EVENTS.get(name);
      if (OWN_PROPS.includes(name)) continue;
      const attribute = attributeOf(name);
      const text = isValue.has(attribute) ? attributeText(value) : undefined;
      if (type !== undefined) {
        if (typeof value === 'function') {
          handlers.push([type, value as EventListener]);
        }
      } else if (text !== undefined) {
        rendered[attributeProp(attribute)] = text;
      }
      // React 18 knows no className on custom elements.
      else {
        rendered[name === 'className' ? 'class' : name] = value;
      }
    }
    useImperativeHandle(ref, () => element.current, []);
    // A property without an attribute: React 18 would write one, and no version sets it when it
    // hydrates.
    for (const name of OWN_PROPS) {
      const value: unknown = Reflect.get(props, name);
      useClientEffect(() => {
        if (element.current !== null) {
          Reflect.set(element.current, name, value);
        }
      }, [value]);
    }
    useClientEffect(() => {
      const target = element.current;
      for (const [type, handler] of handlers) {
        target?.addEventListener(type, handler);
      }
      return () => {
        for (const [type, handler] of handlers) {
          target?.removeEventListener(type, handler);
        }
      };
    });
    return tag === 'phong-viewer'
      ? createElement(tag, rendered, posterImage(props), rendered['children'] as ReactNode)
      : createElement(tag, rendered);
  });
  made.displayName = tag;
  return made as Component<P>;
}

/** The poster as an image, which shows before any script, and so in a server's markup. */
function posterImage(props: { readonly poster?: unknown; readonly alt?: unknown }): ReactNode {
  const { poster: src, alt } = props;
  return typeof src === 'string' && src !== ''
    ? createElement('img', {
        slot: 'poster',
        src,
        alt: typeof alt === 'string' ? alt : '',
        decoding: 'async',
      })
    : null;
}

const onServer = typeof document === 'undefined';

/**
 * Runs in the task that inserts or hydrates an element, before its events. React 18 warns of layout
 * effects on servers.
 */
const useClientEffect = onServer ? useEffect : useLayoutEffect;

/**
 * The prop that React writes as this attribute. Where an element has a property of a prop's exact
 * name, React would write the property, which throws for a bad value and leaves the server's
 * attribute as it was. Attribute names ignore case.
 */
const attributeProp = (attribute: string): string =>
  onServer ? attribute : attribute.toUpperCase();

/**
 * Lists become words separated by spaces, texts that may contain some by commas. Null removes the
 * attribute; undefined: the value has no text (a file).
 */
function attributeText(value: unknown): string | null | undefined {
  if (Array.isArray(value) || ArrayBuffer.isView(value)) {
    const list = Array.from(value as ArrayLike<unknown>);
    return list.join(typeof list[0] === 'string' ? ', ' : ' ');
  }
  if (value === null || value === undefined) return null;
  return typeof value === 'object' ? undefined : `${value as string | number | boolean}`;
}
