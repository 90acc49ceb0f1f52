// Steps of histories with unusual trees: wrappers, shadow trees, slots, nested viewers, and
// malformed values. Also checks, in the page, what must hold after any of these steps.

import { type Dice } from '../../visual/random-scene.js';
import type { Step } from './history-deeds.js';
import type { PhongViewer } from '../support/viewer.js';

type Deed = (viewer: PhongViewer, step: Step) => void;

/** In the page. */
interface Trees {
  readonly deeds: Readonly<Record<string, Deed>>;
  /** Descriptions of what is wrong now. */
  faults(): string[];
}

declare global {
  interface Window {
    walkTrees: Trees;
  }
}

/** Runs in the page, after `installWatch`. */
export function installTrees(): void {
  type Parent = Element | ShadowRoot;
  const { viewers } = window.walkWatch;
  const round = <T>(list: readonly T[], i: number) => list[i % list.length];
  /** Closed ones too. */
  const shadows = new WeakMap<Element, ShadowRoot>();
  const MOST_ELEMENTS = 100;
  const isFull = () => document.querySelectorAll('section *').length > MOST_ELEMENTS;

  /** Everything under a node in document order, a shadow tree before what its host contains. */
  function* under(parent: Parent): Generator<Element> {
    for (const child of parent.children) {
      yield child;
      const shadow = shadows.get(child);
      if (shadow !== undefined) {
        yield* under(shadow);
      }
      yield* under(child);
    }
  }
  const parentsIn = (viewer: PhongViewer) => [
    viewer,
    ...[...under(viewer)].flatMap((element) => [shadows.get(element) ?? [], element].flat()),
  ];
  const wrappersIn = (viewer: PhongViewer) =>
    [...under(viewer)].filter(({ localName }) => !localName.startsWith('phong-'));
  const contains = (outer: Node, inner: Node | null): boolean =>
    inner !== null &&
    (inner === outer ||
      contains(outer, inner.parentNode ?? (inner as Partial<ShadowRoot>).host ?? null));
  function insert(
    parent: Parent | undefined,
    element: Element | undefined,
    how: string | undefined,
  ) {
    if (parent === undefined || element === undefined || contains(element, parent)) return;
    const before =
      { prepend: parent.firstChild, between: parent.children[1] ?? null }[how ?? ''] ?? null;
    if (how === 'moveBefore' && element.isConnected && parent.isConnected) {
      parent.moveBefore(element, before);
    } else {
      parent.insertBefore(element, before);
    }
  }
  function made(kind: string | undefined): Element {
    const element = document.createElement(kind?.startsWith('phong-') === true ? kind : 'div');
    if (kind === 'slotted') {
      element.slot = 'error';
    }
    if (kind === 'open' || kind === 'closed') {
      shadows.set(element, element.attachShadow({ mode: kind }));
    }
    return element;
  }
  /** Where and how a step inserts, by its value, and the kind of element that it makes. */
  const targetOf = (step: Step) => {
    const [how, at, kind] = step.value.split(' ');
    const viewer = round(viewers(), step.viewer + Number(step.key));
    return { how, kind, parent: viewer && round(parentsIn(viewer), Number(at)) };
  };

  const deeds: Record<string, Deed> = {
    make: (_, step) => {
      const { how, kind, parent } = targetOf(step);
      if (!isFull()) {
        insert(parent, made(kind), how);
      }
    },
    carry: (viewer, step) => {
      const { how, parent } = targetOf(step);
      insert(parent, round([...under(viewer)], step.child), how);
    },
    copy: (viewer, step) => {
      const { how, parent } = targetOf(step);
      const pattern = round([...under(viewer)], step.child);
      if (!isFull()) {
        insert(parent, pattern?.cloneNode(true) as Element | undefined, how);
      }
    },
    nest: (viewer, step) => {
      const { how, parent } = targetOf(step);
      // Viewers inside shadow trees would not be found again.
      if (parent !== undefined && document.contains(parent)) {
        insert(parent, viewer, how);
      }
    },
    adopt: (viewer, step) => {
      const element = round([...under(viewer)], step.child);
      if (element === undefined || viewers().some((other) => element.contains(other))) return;
      document.createElement('template').content.append(element);
      const { how, parent } = targetOf(step);
      insert(parent, element, how);
    },
    unwrap: (viewer, { child }) => {
      const wrapper = round(wrappersIn(viewer), child);
      wrapper?.replaceWith(...wrapper.childNodes);
    },
    'wrapper-away': (viewer, { child }) => {
      const wrapper = round(wrappersIn(viewer), child);
      if (wrapper?.querySelector('phong-viewer') === null) {
        wrapper.remove();
      }
    },
    reverse: (viewer, { child }) => {
      const parent = round(parentsIn(viewer), child);
      if (parent?.querySelector('phong-viewer') === null) {
        parent.replaceChildren(...[...parent.children].reverse());
      }
    },
    'junk property': (viewer, { child, key, value }) => {
      const element = round([viewer, ...viewer.lights, ...viewer.meshes], child)!;
      try {
        Reflect.set(element, key, JSON.parse(value));
      } catch (error) {
        if (!(error instanceof TypeError || error instanceof RangeError)) throw error;
        if (error.message.length > 600) {
          throw new Error(`a message of ${error.message.length} characters`);
        }
      }
    },
    'junk attribute': (viewer, { child, key, value }) =>
      round([viewer, ...viewer.lights, ...viewer.meshes], child)!.setAttribute(key, value),
  };

  /**
   * The children that belong to a viewer by the contract: all inside, except in its slots and in
   * other viewers.
   */
  function belonging(viewer: PhongViewer) {
    const found: Element[] = [];
    const visit = (parent: Parent) => {
      for (const child of parent.children) {
        if (
          child.localName === 'phong-viewer' ||
          (child.parentNode === viewer && child.slot !== '')
        ) {
          continue;
        }
        if (child.localName.startsWith('phong-')) {
          found.push(child);
        }
        const shadow = shadows.get(child);
        if (shadow !== undefined) {
          visit(shadow);
        }
        visit(child);
      }
    };
    visit(viewer);
    return found;
  }
  function notFinite(element: Element) {
    const { observedAttributes } = element.constructor as unknown as {
      observedAttributes: readonly string[];
    };
    return observedAttributes.filter((name) => {
      const key = name.replace(/-([a-z])/g, (_, letter: string) => letter.toUpperCase());
      const value: unknown = Reflect.get(element, key);
      return [value].flat().some((one) => typeof one === 'number' && !Number.isFinite(one));
    });
  }
  function faults() {
    const found: string[] = [];
    for (const viewer of viewers()) {
      const wanted = belonging(viewer);
      for (const [kind, listed] of [
        ['light', viewer.lights],
        ['mesh', viewer.meshes],
      ] as const) {
        const own = wanted.filter(({ localName }) => localName === `phong-${kind}`);
        if (own.length !== listed.length || own.some((element, i) => element !== listed[i])) {
          found.push(`${listed.length} of kind ${kind}, not ${own.length}, or another order`);
        }
      }
      for (const element of [viewer, ...wanted]) {
        found.push(
          ...notFinite(element).map((name) => `<${element.localName}> ${name} is not finite`),
        );
      }
      const { eye, target, up, theta, phi, radius } = viewer.camera;
      if (![...eye, ...target, ...up, theta, phi, radius].every(Number.isFinite)) {
        found.push('the camera is not finite');
      }
    }
    return found;
  }

  window.walkTrees = { deeds, faults };
}

const HOW = ['append', 'append', 'prepend', 'between', 'moveBefore', 'moveBefore'];
const KINDS = 'div div open closed slotted slotted phong-light phong-light phong-mesh'.split(' ');
/** Malformed or barely valid values. */
const JUNK = [
  'x'.repeat(2000),
  '😀'.repeat(300),
  'color-mix('.repeat(30),
  'rgb('.repeat(5e4),
  '1 '.repeat(3000),
  '\0',
  ' ',
  '1e309',
  '-1e-320',
  '1,2,3',
  '1;2',
  'NaN NaN NaN',
  'calc(1)',
  'rgb(1 2 3',
  '-0',
  '１２３',
  'constructor',
  '__proto__',
  'auto',
  'none',
  'null',
  '[object Object]',
  '0x10',
  '1 2 3 0',
  '1e6',
  '0 0 0',
  '1e15 -1e15 1e15',
];
const JUNK_JSON = [
  '[]',
  '{}',
  '[[]]',
  '[null]',
  '[1,2]',
  '[1,2,3,0]',
  '1e308',
  '-1e308',
  '7',
  'true',
  '[1e15,0,-1e15]',
  '["1","2","3"]',
  '[1,2,3,4,5,6,7]',
  JSON.stringify('y'.repeat(5000)),
  JSON.stringify(Array(500).fill('z')),
];
const STRAYS = [
  'difuse',
  'shadng',
  'color',
  'constructor',
  '__proto__',
  'autorotate',
  'x'.repeat(300),
];

/** A random step. `keys`: attributes that may have any value. */
export function treeStep(dice: Dice, keys: readonly string[]): Partial<Step> {
  const where = {
    key: dice.pick(['0', '0', '0', '1']),
    value: `${dice.pick(HOW)} ${Math.floor(dice.from(0, 60))}`,
  };
  const what = dice.pick(
    'make make make make carry carry carry carry copy nest adopt unwrap wrapper-away reverse junk junk junk'.split(
      ' ',
    ),
  );
  if (what === 'make') return { what, ...where, value: `${where.value} ${dice.pick(KINDS)}` };
  if (what !== 'junk') return { what, ...where };
  const key = dice.pick(keys);
  const property = key.replace(/-([a-z])/g, (_, letter: string) => letter.toUpperCase());
  if (dice.chance(0.4)) {
    return { what: 'junk property', key: property, value: dice.pick(JUNK_JSON) };
  }
  return {
    what: 'junk attribute',
    key: dice.chance(0.2) ? dice.pick(STRAYS) : key,
    value: dice.pick(JUNK),
  };
}
