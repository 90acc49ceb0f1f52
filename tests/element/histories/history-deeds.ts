// Performs the steps of a history in the page.

import type * as Three from 'three';
import type { PhongMesh, PhongViewer } from '../support/viewer.js';

/** One step. Indices wrap around: viewer 5 of three is the third. */
export interface Step {
  readonly what: string;
  readonly viewer: number;
  /** Index among the children with this tag; -1: the last one used, in any viewer. */
  readonly child: number;
  /** The element whose attribute or property changes, or the kind of child. */
  readonly tag: 'phong-viewer' | 'phong-light' | 'phong-mesh';
  readonly key: string;
  readonly value: string;
}

/** In the page. */
interface Deeds {
  /** Performs the steps in one task where that is possible. */
  take(steps: readonly Step[]): Promise<void>;
  /** Promises of calls that the steps did not await. */
  readonly pending: Promise<unknown>[];
  /** Places of the page's own objects. */
  ownOf(viewer: PhongViewer): readonly string[];
  addOwn(viewer: PhongViewer, place: string): Promise<void>;
  /** Makes sure that the page has a viewer. */
  bringBack(): void;
}

declare global {
  interface Window {
    walkDeeds: Deeds;
  }
}

/** Runs in the page, after `installWatch` and `installTrees`. */
export function installDeeds(): void {
  const watch = window.walkWatch;
  const { viewers, frame } = watch;
  const round = <T>(list: readonly T[], i: number) => list[i % list.length];

  // The page's own objects: balls of one colour.
  let three: typeof Three | null = null;
  const owned = new WeakMap<object, Map<string, Three.Mesh>>();
  const ownOf = (viewer: PhongViewer) => {
    const present = owned.get(viewer) ?? new Map<string, Three.Mesh>();
    owned.set(viewer, present);
    return present;
  };
  async function addOwn(viewer: PhongViewer, place: string) {
    const address = '/node_modules/three/build/three.module.js';
    const library = (three ??= (await import(address)) as typeof Three);
    const [x = 0, y = 0, z = 0] = place.split(' ').map(Number);
    const material = new library.ShaderMaterial({
      vertexShader:
        'void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
      fragmentShader: 'void main() { gl_FragColor = vec4(0.25, 0.5, 0.75, 1.0); }',
    });
    const ball = new library.Mesh(new library.SphereGeometry(0.2, 8, 6), material);
    ball.position.set(x, y, z);
    viewer.scene.add(ball);
    viewer.refit(); // a new page fits it too
    ownOf(viewer).set(place, ball);
  }

  // Steps. Only those that return a promise are awaited.
  const away: PhongViewer[] = [];
  const pending: Promise<unknown>[] = [];
  const MOST_VIEWERS = 3;
  const place = (i: number): Element => round([...document.querySelectorAll('section')], i)!;
  /** The last child used, by tag. */
  const latest = new Map<string, Element>();
  const touched = (element: Element | null | undefined) => {
    if (element) {
      latest.set(element.localName, element);
    }
    return element ?? undefined;
  };
  const childOf = (viewer: PhongViewer, { tag, child }: Step) =>
    touched(child < 0 ? latest.get(tag) : round([...viewer.querySelectorAll(tag)], child));
  const targetOf = (viewer: PhongViewer, step: Step) =>
    step.tag === 'phong-viewer' ? viewer : childOf(viewer, step);
  const other = (step: Step) => round(viewers(), step.viewer + Number(step.value))!;
  async function frames(count: number, each: () => void) {
    for (let i = 0; i < count; i++) {
      each();
      await frame();
    }
  }
  function assign(target: Element | undefined, key: string, value: string | null) {
    if (target === undefined) return;
    try {
      Reflect.set(target, key, value);
    } catch (error) {
      if (!(error instanceof TypeError || error instanceof RangeError)) throw error; // bad values throw these two
    }
  }
  /** The coordinate, limited to its domain, in digits that `toHTML()` keeps. */
  const inside = (x: number) => Number(Math.min(Math.max(x, -1e15), 1e15).toPrecision(8));
  type Deed = (viewer: PhongViewer, step: Step) => void | Promise<void>;
  const DEEDS: Readonly<Record<string, Deed>> = {
    ...window.walkTrees.deeds,
    'set attribute': (viewer, step) => targetOf(viewer, step)?.setAttribute(step.key, step.value),
    'remove attribute': (viewer, step) => targetOf(viewer, step)?.removeAttribute(step.key),
    'set property': (viewer, step) => assign(targetOf(viewer, step), step.key, step.value),
    'clear property': (viewer, step) => assign(targetOf(viewer, step), step.key, null),
    add: (viewer, { child, value }) => {
      const first = child % 2 !== 0;
      viewer.insertAdjacentHTML(first ? 'afterbegin' : 'beforeend', value);
      touched(first ? viewer.firstElementChild : viewer.lastElementChild);
    },
    remove: (viewer, step) => childOf(viewer, step)?.remove(),
    'to the end': (viewer, step) => viewer.append(childOf(viewer, step) ?? ''),
    'to the front': (viewer, step) => viewer.prepend(childOf(viewer, step) ?? ''),
    'to another': (viewer, step) => {
      const [moved, parent] = [childOf(viewer, step), other(step)];
      // In unusual trees the other viewer may stand inside the child.
      if (moved !== undefined && !moved.contains(parent)) {
        parent.append(moved);
      }
    },
    clone: (viewer, step) => {
      const copy = childOf(viewer, step)?.cloneNode();
      if (copy !== undefined) {
        other(step).append(copy);
      }
      touched(copy as Element | undefined);
    },
    children: (viewer, { value }) => void (viewer.innerHTML = value),
    style: (viewer, { key, value }) => viewer.style.setProperty(key, value),
    scroll: (_, { value }) => scrollTo(0, Number(value)),
    'to another parent': (viewer, { child }) => place(child).append(viewer),
    'take away': (viewer) => {
      away.push(viewer);
      viewer.remove();
    },
    'bring back': (_, { child }) => {
      if (viewers().length < MOST_VIEWERS) {
        place(child).append(away.shift() ?? '');
      }
    },
    'another viewer': (_, { child, value }) => {
      if (viewers().length < MOST_VIEWERS) {
        place(child).insertAdjacentHTML('beforeend', value);
      }
    },
    'clone viewer': (viewer) => {
      if (viewers().length < MOST_VIEWERS) {
        viewer.after(viewer.cloneNode(true));
      }
    },
    'no viewer': (viewer) => {
      if (viewers().length > 1) {
        viewer.remove();
      }
    },
    'reset camera': (viewer) => {
      viewer.resetCamera();
      watch.handled.delete(viewer);
    },
    picture: (viewer, { value }) => {
      const [width = 1, height = 1] = value.split(' ').map(Number);
      // While the context is lost there is no picture.
      pending.push(
        viewer
          .toBlob({ width, height })
          .catch((error: unknown) => (watch.lost ? null : Promise.reject(error as Error))),
      );
    },
    explain: (viewer, { value }) => {
      const [x = 0, y = 0] = value.split(' ').map(Number);
      pending.push(viewer.shadeAt(x, y));
    },
    'draw again': (viewer) => viewer.requestRender(),
    'an own object': (viewer, { value }) => addOwn(viewer, value),
    'own object away': (viewer) => {
      for (const ball of ownOf(viewer).values()) {
        viewer.scene.remove(ball);
      }
      ownOf(viewer).clear();
      viewer.refit();
    },
    print: () => void dispatchEvent(new Event('beforeprint')),
    lose: watch.lose,
    restore: watch.restore,
    'move lights': (viewer, { value }) =>
      frames(Number(value), () => {
        for (const light of viewer.lights) {
          const [x, y, z, w] = light.position;
          light.position = [inside(x + 0.02 * z), y, inside(z - 0.02 * x), w];
        }
      }),
    'move a mesh': (viewer, step) =>
      frames(Number(step.value), () => {
        const mesh = childOf(viewer, { ...step, tag: 'phong-mesh' }) as PhongMesh | undefined;
        if (mesh !== undefined) {
          mesh.position = [
            inside(mesh.position[0] + 0.01),
            mesh.position[1],
            inside(mesh.position[2] - 0.02),
          ];
        }
      }),
    'draw on': (_, { value }) =>
      frames(Number(value), () => viewers().forEach((viewer) => viewer.requestRender())),
    'stand still': (_, { value }) => frames(Number(value), () => undefined),
    turn: async (viewer, { value }) => {
      viewer.autoRotate = Number(value);
      await frames(5, () => undefined);
      viewer.autoRotate = 0;
    },
  };

  async function take(steps: readonly Step[]) {
    for (const step of steps) {
      const viewer = round(viewers(), step.viewer);
      const anywhere = ['bring back', 'another viewer', 'scroll', 'restore'].includes(step.what);
      if (viewer === undefined && !anywhere) continue;
      const done = DEEDS[step.what]?.(viewer!, step);
      if (done !== undefined) {
        await done;
      }
    }
    for (const fault of window.walkTrees.faults()) {
      console.error(fault);
    }
  }

  window.walkDeeds = {
    take,
    pending,
    addOwn,
    ownOf: (viewer) => [...ownOf(viewer).keys()],
    bringBack() {
      if (viewers().length === 0) {
        place(0).append(away.shift() ?? '');
      }
    },
  };
}
