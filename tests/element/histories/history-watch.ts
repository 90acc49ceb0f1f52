// Records what happens on the page of a history: each viewer's last picture, the programs that drew
// it, cameras moved by the user, and whether anything happens at all.

import type { PhongViewer } from '../support/viewer.js';

export interface Drawn {
  readonly width: number;
  readonly height: number;
  /** RGBA in base64. */
  readonly data: string;
  /** The programs that drew it, as sorted hashes of their text. */
  readonly programs: string;
  /** Its place on the shared canvas. Interpolation rounds differently at other places. */
  readonly place: string;
}

/** In the page. */
interface Watch {
  /** The first few things that happened since this was emptied. */
  happened: string[];
  /** Waits for a frame without recording it. */
  frame(): Promise<number>;
  viewers(): PhongViewer[];
  /** Loses or restores the context that all viewers share. */
  lose(): Promise<void>;
  restore(): Promise<void>;
  readonly lost: boolean;
  /** The picture on the page; null if it is not visible. */
  seenOf(viewer: PhongViewer): Drawn | null;
  /** The picture by `toBlob`. */
  blobOf(viewer: PhongViewer, size: readonly [width: number, height: number]): Promise<Drawn>;
  /** Viewers whose camera the user has moved. */
  readonly handled: WeakSet<object>;
}

declare global {
  interface Window {
    walkWatch: Watch;
  }
}

/** Runs in the page, before any other script. */
export function installWatch(): void {
  type DrawnBy = Pick<Drawn, 'programs' | 'place'>;
  type Call = (this: unknown, ...given: unknown[]) => unknown;
  const nextFrame = window.requestAnimationFrame.bind(window);
  const viewers = () => [...document.querySelectorAll<PhongViewer>('phong-viewer')];

  // Which programs draw, and whether anything happens.
  const gl = WebGL2RenderingContext.prototype;
  const texts = new WeakMap<object, string>();
  const current = new WeakMap<object, string>();
  let drawnBy = new Set<string>();
  let happened: string[] = [];
  const wrap = (owner: object, name: string, before: (self: object, given: unknown[]) => void) => {
    const real = Object.getOwnPropertyDescriptor(owner, name)?.value as Call | undefined;
    if (typeof real !== 'function') return;
    Reflect.set(owner, name, function (this: object, ...given: unknown[]) {
      before(this, given);
      return Reflect.apply(real, this, given);
    });
  };
  /** A hash of the text, by which programs are compared. */
  const numbered = (text: string) => {
    let sum = 0;
    for (let i = 0; i < text.length; i++) {
      sum = (Math.imul(sum, 31) + text.charCodeAt(i)) | 0;
    }
    return `${/#define (?:LIGHT_STATEMENTS|HAS_LIGHT_GRID)/.test(text) ? 'specialised' : 'general'}${sum >>> 0}`;
  };
  const names = new WeakMap<object, string>();
  const nameOf = (program: object) => {
    const name = names.get(program) ?? numbered(texts.get(program) ?? '');
    names.set(program, name);
    return name;
  };
  const add = (self: object, text: string): void =>
    void texts.set(self, (texts.get(self) ?? '') + text);
  wrap(gl, 'shaderSource', (_, [shader, text]) => add(shader as object, String(text)));
  wrap(gl, 'attachShader', (_, [program, shader]) =>
    add(program as object, texts.get(shader as object) ?? ''),
  );
  wrap(gl, 'useProgram', (self, [program]) => {
    if (program !== null) {
      current.set(self, nameOf(program as object));
    }
  });
  for (const name of ['drawElements', 'drawArrays']) {
    wrap(gl, name, (self) => {
      drawnBy.add(current.get(self) ?? '');
      queueMicrotask(copyLone);
    });
  }
  const note = (what: string) => {
    if (happened.length < 8) {
      happened.push(what);
    }
  };
  for (const name of Object.getOwnPropertyNames(gl)) {
    wrap(gl, name, () => note(name));
  }
  wrap(window, 'requestAnimationFrame', () => note('requestAnimationFrame'));
  let place = '';
  wrap(gl, 'viewport', (_, [x, y]) => (place = `${String(x)}, ${String(y)}`));
  const takeDrawn = (): DrawnBy => {
    const programs = [...drawnBy].sort().join();
    drawnBy = new Set();
    return { programs, place };
  };

  // The shared context.
  let context: WebGL2RenderingContext | null = null;
  let lost: WEBGL_lose_context | null = null;
  const realContext = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...given: unknown[]) {
    const made = Reflect.apply(realContext, this, given) as unknown;
    if (made instanceof WebGL2RenderingContext) {
      context = made;
    }
    return made;
  } as typeof realContext;
  /** Context events arrive in tasks of their own. */
  const soon = () => new Promise<void>((resolve) => setTimeout(resolve, 20));
  async function lose() {
    if (lost !== null || context === null || context.isContextLost()) return;
    lost = context.getExtension('WEBGL_lose_context');
    lost?.loseContext();
    await soon();
  }
  async function restore() {
    lost?.restoreContext();
    lost = null;
    await soon();
  }

  // Copies of pictures drawn directly on the WebGL canvas, which is empty once the browser has
  // shown it.
  const copies = new WeakMap<object, OffscreenCanvas>();
  const seenBy = new WeakMap<object, DrawnBy>();
  /** Camera moved by the user. */
  const handled = new WeakSet();
  const canvasOf = (viewer: PhongViewer) => viewer.shadowRoot?.querySelector('canvas') ?? null;
  function copied(source: CanvasImageSource, width: number, height: number) {
    const canvas = new OffscreenCanvas(width, height);
    // Read once and dropped, hundreds of them in a release run: the browser would advise so.
    canvas.getContext('2d', { willReadFrequently: true })!.drawImage(source, 0, 0);
    return canvas;
  }
  const listen = (type: string, heard: (viewer: PhongViewer, event: Event) => void) => {
    addEventListener(type, (event) => heard(event.target as PhongViewer, event), true); // capturing, because the events do not bubble
  };
  const copy = (viewer: PhongViewer) => {
    seenBy.set(viewer, takeDrawn());
    const canvas = canvasOf(viewer);
    if (canvas === null || viewers().length > 1) return;
    copies.set(viewer, copied(canvas, canvas.width, canvas.height));
  };
  /**
   * A viewer that is alone from now on is drawn on another canvas, without an event: its picture is
   * the same.
   */
  function copyLone() {
    const [viewer] = viewers();
    if (drawnBy.size > 0 && viewer !== undefined && viewers().length === 1) {
      copy(viewer);
    }
  }
  listen('render', (viewer) => {
    copy(viewer);
    note('render');
  });
  listen('camera-change', (viewer, event) => {
    const { source } = (event as CustomEvent<{ source: string }>).detail;
    if (['pointer', 'wheel', 'key'].includes(source)) {
      handled.add(viewer);
    }
  });

  function dataOf(canvas: OffscreenCanvas) {
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
    let text = '';
    for (let i = 0; i < data.length; i += 4096) {
      text += String.fromCharCode(...data.subarray(i, i + 4096));
    }
    return btoa(text);
  }
  function seenOf(viewer: PhongViewer): Drawn | null {
    const { left, top, right, bottom } = viewer.getBoundingClientRect();
    const inside =
      right > left &&
      bottom > top &&
      bottom > 0 &&
      right > 0 &&
      top < innerHeight &&
      left < innerWidth;
    if (!inside || !viewer.checkVisibility({ visibilityProperty: true })) return null;
    const canvas = canvasOf(viewer);
    const by = seenBy.get(viewer) ?? { programs: '', place: '' };
    if (canvas === null) return { width: 0, height: 0, data: '', ...by };
    const flat = canvas.getContext('2d') !== null;
    // Without a copy it is alone since its last picture, of an empty scene: no draw call copied it.
    const { width, height } = canvas;
    const copy = flat
      ? copied(canvas, width, height)
      : (copies.get(viewer) ?? new OffscreenCanvas(width, height));
    return { width: copy.width, height: copy.height, data: dataOf(copy), ...by };
  }
  async function blobOf(
    viewer: PhongViewer,
    [width, height]: readonly [number, number],
  ): Promise<Drawn> {
    takeDrawn();
    // One page shows the mean of the samples already, another one may not show the viewer at all.
    const { antialias, samples } = viewer;
    const coming = viewer.toBlob({ width, height, ...(antialias === 'full' ? { samples } : {}) });
    const taken = takeDrawn();
    const by = taken.programs === '' ? (seenBy.get(viewer) ?? taken) : taken; // a lone viewer may reuse what it shows
    const bitmap = await createImageBitmap(await coming);
    return { width, height, data: dataOf(copied(bitmap, width, height)), ...by };
  }

  window.walkWatch = {
    viewers,
    lose,
    restore,
    seenOf,
    blobOf,
    handled,
    frame: () => new Promise((resolve) => nextFrame(resolve)),
    get lost() {
      return lost !== null;
    },
    get happened() {
      return happened;
    },
    set happened(list) {
      happened = list;
    },
  };
}
