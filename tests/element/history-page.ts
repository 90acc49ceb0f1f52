// What a history does inside the page: takes its steps, keeps what was last seen of each viewer, and tells what is seen,
// what `toBlob` draws, and by which programs. The same script runs in a page within the page, where the same markup begins anew.

import type { Page } from '@playwright/test';
import type { PhongLight, PhongMesh, PhongViewer } from './support.js';

/** One thing that happens to a page. Numbers go round: viewer 5 of three is the third. */
export interface Step {
  readonly what: string;
  readonly viewer: number;
  /** Of the children of its kind. */
  readonly child: number;
  /** Whose attribute, property or child it is about. */
  readonly tag: 'phong-viewer' | 'phong-light' | 'phong-mesh';
  readonly key: string;
  readonly value: string;
}

export interface Drawn {
  readonly width: number;
  readonly height: number;
  /** RGBA in base64. */
  readonly data: string;
  /** Texts of the programs it was drawn by, as short numbers, sorted. */
  readonly programs: string;
}

/** One viewer at rest. */
export interface Rest {
  /** Null where nothing of it can be seen. */
  readonly seen: Drawn | null;
  readonly blob: Drawn;
  /** As `toHTML` gives it, and with the camera as it is declared where no hand has moved it. */
  readonly html: string;
  readonly asDeclared: string | null;
  readonly css: readonly [width: number, height: number];
  /** Device pixels that the picture is to have. */
  readonly pixels: readonly [width: number, height: number];
  readonly camera: readonly number[];
  readonly stats: Readonly<Record<string, unknown>>;
  /** Lights that the page declares active. */
  readonly active: number;
  /** Objects of one's own in the scene. */
  readonly own: readonly string[];
}

export type Began = Pick<Rest, 'blob' | 'camera' | 'stats'>;

declare global {
  interface Window {
    walk: {
      /** All that can in one task. */
      take(steps: readonly Step[]): Promise<void>;
      /** Waits until nothing is to come; tells what still came then. */
      settle(): Promise<string>;
      rest(): Promise<Rest[]>;
      /** The same viewers, but new ones. */
      begin(rests: readonly Pick<Rest, 'html' | 'css' | 'pixels' | 'own'>[]): Promise<Began[]>;
    };
  }
}

/** For pages of this context that are opened from now on. */
export async function walkOn(page: Page): Promise<void> {
  await page.addInitScript(installWalk);
}

/** Runs in the page. */
function installWalk(): void {
  type Call = (this: unknown, ...given: unknown[]) => unknown;
  const nextFrame = window.requestAnimationFrame.bind(window);
  const frame = (): Promise<number> => new Promise((resolve) => nextFrame(resolve));
  const viewers = (): PhongViewer[] => [...document.querySelectorAll<PhongViewer>('phong-viewer')];
  const round = <T>(list: readonly T[], i: number): T | undefined => list[i % list.length];

  // What is drawn by which program, and whether anything happens.
  const gl = WebGL2RenderingContext.prototype;
  const texts = new WeakMap<object, string>();
  const current = new WeakMap<object, string>();
  let drawnBy = new Set<string>();
  let happened: string[] = [];
  const wrap = (owner: object, name: string, before: (self: object, given: unknown[]) => void): void => {
    const real = Object.getOwnPropertyDescriptor(owner, name)?.value as Call | undefined;
    if (typeof real !== 'function') return;
    Reflect.set(owner, name, function (this: object, ...given: unknown[]) {
      before(this, given);
      return Reflect.apply(real, this, given);
    });
  };
  /** Two texts of the same number are as good as never met. */
  const numbered = (text: string): string => {
    let sum = 0;
    for (let i = 0; i < text.length; i++) sum = (Math.imul(sum, 31) + text.charCodeAt(i)) | 0;
    return `${text.includes('#define EXACT_LIGHTS') ? 'exact' : 'general'}${sum >>> 0}`;
  };
  const add = (self: object, text: string): void => void texts.set(self, (texts.get(self) ?? '') + text);
  wrap(gl, 'shaderSource', (_, [shader, text]) => add(shader as object, String(text)));
  wrap(gl, 'attachShader', (_, [program, shader]) =>
    add(program as object, texts.get(shader as object) ?? ''),
  );
  wrap(gl, 'useProgram', (self, [program]) => {
    if (program !== null) current.set(self, numbered(texts.get(program as object) ?? ''));
  });
  for (const name of ['drawElements', 'drawArrays'])
    wrap(gl, name, (self) => drawnBy.add(current.get(self) ?? ''));
  const note = (what: string): void => void (happened.length < 8 && happened.push(what));
  for (const name of Object.getOwnPropertyNames(gl)) wrap(gl, name, () => note(name));
  wrap(window, 'requestAnimationFrame', () => note('requestAnimationFrame'));
  const takeDrawn = (): string => {
    const taken = [...drawnBy].sort().join();
    drawnBy = new Set();
    return taken;
  };

  // The context that all share, to be lost.
  let context: WebGL2RenderingContext | null = null;
  let lost: WEBGL_lose_context | null = null;
  const realContext = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...given: unknown[]) {
    const made = Reflect.apply(realContext, this, given) as unknown;
    if (made instanceof WebGL2RenderingContext) context = made;
    return made;
  } as typeof realContext;
  /** From a task to one much later: what the browser tells of a context comes by itself. */
  const soon = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 20));
  async function lose(): Promise<void> {
    if (lost !== null || context === null || context.isContextLost()) return;
    lost = context.getExtension('WEBGL_lose_context');
    lost?.loseContext();
    await soon();
  }
  async function restore(): Promise<void> {
    lost?.restoreContext();
    lost = null;
    await soon();
  }

  // What was last seen of a viewer whose canvas is WebGL's own, which is empty once the page has shown it.
  const copies = new WeakMap<object, OffscreenCanvas>();
  const seenBy = new WeakMap<object, string>();
  /** Moved by hand. */
  const handled = new WeakSet();
  const canvasOf = (viewer: PhongViewer): HTMLCanvasElement | null =>
    viewer.shadowRoot?.querySelector('canvas') ?? null;
  function copied(source: CanvasImageSource, width: number, height: number): OffscreenCanvas {
    const canvas = new OffscreenCanvas(width, height);
    canvas.getContext('2d')!.drawImage(source, 0, 0);
    return canvas;
  }
  const listen = (type: string, heard: (viewer: PhongViewer, event: Event) => void): void => {
    addEventListener(type, (event) => heard(event.target as PhongViewer, event), true); // on its way to the viewer
  };
  listen('render', (viewer) => {
    seenBy.set(viewer, takeDrawn());
    note('render');
    const canvas = canvasOf(viewer);
    if (canvas === null || viewers().length > 1) return;
    copies.set(viewer, copied(canvas, canvas.width, canvas.height));
  });
  listen('camera-change', (viewer, event) => {
    const { source } = (event as CustomEvent<{ source: string }>).detail;
    if (['pointer', 'wheel', 'key'].includes(source)) handled.add(viewer);
  });

  function dataOf(canvas: OffscreenCanvas): string {
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
    let text = '';
    for (let i = 0; i < data.length; i += 4096) text += String.fromCharCode(...data.subarray(i, i + 4096));
    return btoa(text);
  }
  function seenOf(viewer: PhongViewer): Drawn | null {
    const { left, top, right, bottom } = viewer.getBoundingClientRect();
    const inside =
      right > left && bottom > top && bottom > 0 && right > 0 && top < innerHeight && left < innerWidth;
    if (!inside || !viewer.checkVisibility({ visibilityProperty: true })) return null;
    const canvas = canvasOf(viewer);
    const programs = seenBy.get(viewer) ?? '';
    if (canvas === null) return { width: 0, height: 0, data: '', programs };
    const flat = canvas.getContext('2d') !== null;
    const copy = flat ? copied(canvas, canvas.width, canvas.height) : copies.get(viewer)!;
    return { width: copy.width, height: copy.height, data: dataOf(copy), programs };
  }
  async function blobOf(viewer: PhongViewer, [width, height]: readonly [number, number]): Promise<Drawn> {
    takeDrawn();
    const coming = viewer.toBlob({ width, height });
    const programs = takeDrawn() || (seenBy.get(viewer) ?? ''); // alone, it is drawn again as it is seen
    const bitmap = await createImageBitmap(await coming);
    return { width, height, data: dataOf(copied(bitmap, width, height)), programs };
  }

  // Objects of one's own: balls of one colour.
  type Three = typeof import('three');
  let three: Three | null = null;
  const owned = new WeakMap<object, Map<string, InstanceType<Three['Mesh']>>>();
  const ownOf = (viewer: PhongViewer): Map<string, InstanceType<Three['Mesh']>> => {
    const present = owned.get(viewer) ?? new Map<string, InstanceType<Three['Mesh']>>();
    owned.set(viewer, present);
    return present;
  };
  async function addOwn(viewer: PhongViewer, place: string): Promise<void> {
    const address = '/node_modules/three/build/three.module.js';
    const library = (three ??= (await import(address)) as Three);
    const [x = 0, y = 0, z = 0] = place.split(' ').map(Number);
    const material = new library.ShaderMaterial({
      vertexShader: 'void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
      fragmentShader: 'void main() { gl_FragColor = vec4(0.25, 0.5, 0.75, 1.0); }',
    });
    const ball = new library.Mesh(new library.SphereGeometry(0.2, 8, 6), material);
    ball.position.set(x, y, z);
    viewer.scene.add(ball);
    viewer.requestRender();
    ownOf(viewer).set(place, ball);
  }

  // Steps. What waits is told apart by its promise.
  const away: PhongViewer[] = [];
  const pending: Promise<unknown>[] = [];
  const MOST_VIEWERS = 3;
  const place = (i: number): Element => round([...document.querySelectorAll('section')], i)!;
  const childOf = (viewer: PhongViewer, { tag, child }: Step): Element | undefined =>
    round([...viewer.querySelectorAll(tag)], child);
  const targetOf = (viewer: PhongViewer, step: Step): Element | undefined =>
    step.tag === 'phong-viewer' ? viewer : childOf(viewer, step);
  const other = (step: Step): PhongViewer => round(viewers(), step.viewer + Number(step.value))!;
  async function frames(count: number, each: () => void): Promise<void> {
    for (let i = 0; i < count; i++) {
      each();
      await frame();
    }
  }
  function assign(target: Element | undefined, key: string, value: string | null): void {
    if (target === undefined) return;
    try {
      Reflect.set(target, key, value);
    } catch (error) {
      if (!(error instanceof TypeError || error instanceof RangeError)) throw error; // of bad values
    }
  }
  type Deed = (viewer: PhongViewer, step: Step) => void | Promise<void>;
  const DEEDS: Readonly<Record<string, Deed>> = {
    'set attribute': (viewer, step) => targetOf(viewer, step)?.setAttribute(step.key, step.value),
    'remove attribute': (viewer, step) => targetOf(viewer, step)?.removeAttribute(step.key),
    'set property': (viewer, step) => assign(targetOf(viewer, step), step.key, step.value),
    'clear property': (viewer, step) => assign(targetOf(viewer, step), step.key, null),
    add: (viewer, { child, value }) =>
      viewer.insertAdjacentHTML(child % 2 === 0 ? 'beforeend' : 'afterbegin', value),
    remove: (viewer, step) => childOf(viewer, step)?.remove(),
    'to the end': (viewer, step) => viewer.append(childOf(viewer, step) ?? ''),
    'to the front': (viewer, step) => viewer.prepend(childOf(viewer, step) ?? ''),
    'to another': (viewer, step) => other(step).append(childOf(viewer, step) ?? ''),
    clone: (viewer, step) => other(step).append(childOf(viewer, step)?.cloneNode() ?? ''),
    children: (viewer, { value }) => void (viewer.innerHTML = value),
    style: (viewer, { key, value }) => viewer.style.setProperty(key, value),
    scroll: (_, { value }) => scrollTo(0, Number(value)),
    'to another parent': (viewer, { child }) => place(child).append(viewer),
    'take away': (viewer) => {
      away.push(viewer);
      viewer.remove();
    },
    'bring back': (_, { child }) => {
      if (viewers().length < MOST_VIEWERS) place(child).append(away.shift() ?? '');
    },
    'another viewer': (_, { child, value }) => {
      if (viewers().length < MOST_VIEWERS) place(child).insertAdjacentHTML('beforeend', value);
    },
    'clone viewer': (viewer) => {
      if (viewers().length < MOST_VIEWERS) viewer.after(viewer.cloneNode(true));
    },
    'no viewer': (viewer) => {
      if (viewers().length > 1) viewer.remove();
    },
    'reset camera': (viewer) => {
      viewer.resetCamera();
      handled.delete(viewer);
    },
    picture: (viewer, { value }) => {
      const [width = 1, height = 1] = value.split(' ').map(Number);
      // While the context is lost there is none.
      pending.push(
        viewer.toBlob({ width, height }).catch((error: unknown) => lost ?? Promise.reject(error as Error)),
      );
    },
    explain: (viewer, { value }) => {
      const [x = 0, y = 0] = value.split(' ').map(Number);
      pending.push(viewer.shadeAt(x, y));
    },
    'draw again': (viewer) => viewer.requestRender(),
    'an own object': (viewer, { value }) => addOwn(viewer, value),
    'own object away': (viewer) => {
      for (const ball of ownOf(viewer).values()) viewer.scene.remove(ball);
      ownOf(viewer).clear();
      viewer.requestRender();
    },
    print: () => void dispatchEvent(new Event('beforeprint')),
    lose,
    restore,
    'move lights': (viewer, { value }) =>
      frames(Number(value), () => {
        for (const light of viewer.lights as readonly PhongLight[]) {
          const [x, y, z, w] = light.position;
          light.position = [x + 0.02 * z, y, z - 0.02 * x, w];
        }
      }),
    'move a mesh': (viewer, step) =>
      frames(Number(step.value), () => {
        const mesh = childOf(viewer, { ...step, tag: 'phong-mesh' }) as PhongMesh | undefined;
        if (mesh !== undefined)
          mesh.position = [mesh.position[0] + 0.01, mesh.position[1], mesh.position[2] - 0.02];
      }),
    'draw on': (_, { value }) =>
      frames(Number(value), () => viewers().forEach((viewer) => viewer.requestRender())),
    turn: async (viewer, { value }) => {
      viewer.autoRotate = Number(value);
      await frames(5, () => undefined);
      viewer.autoRotate = 0;
    },
  };

  async function take(steps: readonly Step[]): Promise<void> {
    for (const step of steps) {
      const viewer = round(viewers(), step.viewer);
      const anywhere = ['bring back', 'another viewer', 'scroll', 'restore'].includes(step.what);
      if (viewer === undefined && !anywhere) continue;
      const done = DEEDS[step.what]?.(viewer!, step);
      if (done !== undefined) await done;
    }
  }

  /** Milliseconds after which a promise counts as never kept. */
  const LATE = 15_000;
  async function settle(): Promise<string> {
    if (lost !== null) await restore();
    if (viewers().length === 0) place(0).append(away.shift() ?? ''); // there is always something to look at
    const late = new Promise<string>((resolve) => setTimeout(resolve, LATE, 'never ready'));
    const ready = Promise.all([...pending.splice(0), ...viewers().map((viewer) => viewer.ready)]).then(
      () => '',
    );
    const outcome = await Promise.race([late, ready]);
    if (outcome !== '') return outcome;
    // What observers tell comes after a frame, and may ask for another.
    for (let i = 0; i < 4; i++) await frame();
    await Promise.all(viewers().map((viewer) => viewer.ready));
    await frame();
    happened = [];
    for (let i = 0; i < 2; i++) await frame();
    const notice = viewers().find(({ shadowRoot }) => shadowRoot?.querySelector('[part=notice]'));
    if (notice !== undefined) return 'a notice of failure';
    return happened.length === 0 ? '' : `still busy: ${happened.join()}`;
  }

  const numbers = ({ camera }: PhongViewer): number[] => {
    const { eye, target, up, theta, phi, radius } = camera;
    return [...eye, ...target, ...up, theta, phi, radius];
  };
  const pixelsOf = (viewer: PhongViewer): [number, number] => {
    const { clientWidth, clientHeight } = viewer;
    const whole = (side: number): number => Math.round(side * devicePixelRatio);
    return [whole(clientWidth), whole(clientHeight)];
  };
  const declared = (viewer: PhongViewer, html: string): string => {
    const { radius, target } = viewer as unknown as Record<string, string | number | readonly number[]>;
    return html
      .replace(/ radius="[^"]*"/, ` radius="${String(radius)}"`)
      .replace(/ target="[^"]*"/, ` target="${Array.isArray(target) ? target.join(' ') : String(target)}"`);
  };
  async function rest(): Promise<Rest[]> {
    const all = viewers().map((viewer) => ({ viewer, seen: seenOf(viewer) })); // before any other picture is asked for
    const rests: Rest[] = [];
    for (const { viewer, seen } of all) {
      const pixels = pixelsOf(viewer);
      const shown = pixels[0] > 0 && pixels[1] > 0;
      const size = shown ? pixels : ([40, 30] as const);
      const blob = await blobOf(viewer, size);
      const html = viewer.toHTML();
      const { lights, clientWidth, clientHeight } = viewer;
      rests.push({
        ...{ seen, blob, html, pixels },
        asDeclared: handled.has(viewer) || !shown ? null : declared(viewer, html),
        css: shown ? [clientWidth, clientHeight] : [40, 30],
        camera: numbers(viewer),
        stats: { ...viewer.stats },
        active: lights.length === 0 ? 1 : lights.filter(({ active }) => active).length,
        own: [...ownOf(viewer).keys()],
      });
    }
    return rests;
  }

  async function begin(rests: readonly Pick<Rest, 'html' | 'css' | 'pixels' | 'own'>[]): Promise<Began[]> {
    await customElements.whenDefined('phong-viewer');
    // Those before go afterwards: the context and programs that are needed again stay.
    const before = viewers();
    document.body.insertAdjacentHTML('afterbegin', rests.map(({ html }) => html).join(''));
    const all = viewers()
      .slice(0, rests.length)
      .map((viewer, i) => ({ viewer, ...rests[i]! }));
    for (const { viewer, css } of all) {
      viewer.removeAttribute('gui');
      viewer.style.width = `${css[0]}px`;
      viewer.style.height = `${css[1]}px`;
    }
    for (const { viewer, own } of all) for (const where of own) await addOwn(viewer, where);
    await Promise.all(all.map(({ viewer }) => viewer.ready));
    const began: Began[] = [];
    for (const { viewer, pixels } of all) {
      const size = pixels[0] > 0 && pixels[1] > 0 ? pixels : ([40, 30] as const);
      const blob = await blobOf(viewer, size);
      began.push({ blob, camera: numbers(viewer), stats: { ...viewer.stats } });
    }
    for (const viewer of before) viewer.remove();
    return began;
  }

  window.walk = { take, settle, rest, begin };
}
