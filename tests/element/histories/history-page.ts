// Reads the state of all viewers once the page of a history is at rest. In an iframe it starts new
// viewers with the same scenes and reads theirs.

import type { Page } from '@playwright/test';
import { installDeeds } from './history-deeds.js';
import { installTrees } from './history-trees.js';
import { type Drawn, installWatch } from './history-watch.js';
import type { PhongViewer } from '../support/viewer.js';

/** The state of one viewer at rest. */
export interface Rest {
  /** The picture on the page; null if it is not visible. */
  readonly seen: Drawn | null;
  readonly blob: Drawn;
  /**
   * The result of `toHTML`. `asDeclared` has the declared radius and target instead; null if the
   * user moved the camera.
   */
  readonly html: string;
  readonly asDeclared: string | null;
  readonly css: readonly [width: number, height: number];
  /** Device pixels that the picture should have. */
  readonly pixels: readonly [width: number, height: number];
  readonly camera: readonly number[];
  readonly stats: Readonly<Record<string, unknown>>;
  /** Number of lights declared active. */
  readonly active: number;
  /** Samples per pixel that the picture should have. */
  readonly samples: number;
  /** Places of the page's own objects in the scene. */
  readonly own: readonly string[];
}

export type Began = Pick<Rest, 'blob' | 'camera' | 'stats'>;

declare global {
  interface Window {
    walk: {
      /** Waits until nothing happens any more. Returns what still happened, or ''. */
      settle(): Promise<string>;
      rest(): Promise<Rest[]>;
      /** Creates new viewers with these scenes in place of all others. */
      begin(rests: readonly Pick<Rest, 'html' | 'css' | 'pixels' | 'own'>[]): Promise<Began[]>;
    };
  }
}

/** For all pages of this context that are opened later. */
export async function walkOn(page: Page): Promise<void> {
  for (const install of [installWatch, installTrees, installDeeds, installWalk]) {
    await page.addInitScript(install);
  }
}

/** Runs in the page, after the others. */
function installWalk() {
  const { walkWatch: watch, walkDeeds: deeds } = window;
  const { viewers, frame, seenOf, blobOf, handled } = watch;

  /** Milliseconds after which a promise counts as never settled. */
  const LATE = 15_000;
  const allReady = () => Promise.all(viewers().map((viewer) => viewer.ready));
  /** Observers report after a frame, and may cause another one. */
  const FEW = 4;
  const fewFrames = async (count = FEW) => {
    for (let i = 0; i < count; i++) {
      await frame();
    }
  };
  const loaded = () => performance.getEntriesByType('resource').length;
  const isWhole = (viewer: PhongViewer) =>
    [undefined, pixelsOf(viewer)[0]].includes(seenOf(viewer)?.width);
  async function rests() {
    await Promise.all(deeds.pending.splice(0));
    for (let round = 0; round < 5; round++) {
      const before = loaded();
      await fewFrames();
      watch.happened = [];
      await allReady(); // resolves at once unless something is still being fetched
      await fewFrames(2);
      if (watch.happened.length === 0) return '';
      if (round > 0 && loaded() === before && document.querySelector('[src]') === null) break;
    }
    return `still busy: ${watch.happened.join()}`;
  }
  async function settle() {
    if (watch.lost) {
      await watch.restore();
    }
    deeds.bringBack();
    const late = new Promise<string>((resolve) => setTimeout(resolve, LATE, 'never ready'));
    const outcome = await Promise.race([late, rests()]);
    // A picture that has moved gets all pixels when it stands still, which may take some frames.
    while (!viewers().every(isWhole)) {
      await frame();
    }
    const failed = viewers().some(({ shadowRoot }) => shadowRoot?.querySelector('[part=notice]'));
    return failed ? `${outcome} a notice of failure` : outcome;
  }

  const numbers = ({ camera: { eye, target, up, theta, phi, radius } }: PhongViewer) => [
    ...eye,
    ...target,
    ...up,
    theta,
    phi,
    radius,
  ];
  const pixelsOf = ({ clientWidth, clientHeight }: PhongViewer) =>
    [clientWidth, clientHeight].map((side) => Math.round(side * devicePixelRatio)) as [
      number,
      number,
    ];
  const declared = (viewer: PhongViewer, html: string) => {
    const { radius, target } = viewer as unknown as Record<
      string,
      string | number | readonly number[]
    >;
    return html
      .replace(/ radius="[^"]*"/, ` radius="${String(radius)}"`)
      .replace(/ target="[^"]*"/, ` target="${[target].flat().join(' ')}"`);
  };
  async function rest() {
    const all = viewers().map((viewer) => ({ viewer, seen: seenOf(viewer) })); // before `toBlob` draws
    const rests: Rest[] = [];
    for (const { viewer, seen } of all) {
      const pixels = pixelsOf(viewer);
      const shown = pixels[0] > 0 && pixels[1] > 0;
      const size = shown ? pixels : ([40, 30] as const);
      const blob = await blobOf(viewer, size);
      // `begin` sets the size of the new viewer, which is always displayed.
      const markup = viewer.toHTML().replace(/ (gui|style)(="[^"]*")?(?=[^>]*>)/g, '');
      // `auto` depends on the size, which a hidden viewer does not have.
      const { radius, target } = viewer.camera;
      const html = shown
        ? markup
        : markup
            .replace(/ radius="auto"/, ` radius="${String(radius)}"`)
            .replace(/ target="auto"/, ` target="${target.join(' ')}"`);
      const { lights, clientWidth, clientHeight } = viewer;
      rests.push({
        seen,
        blob,
        html,
        pixels,
        asDeclared: handled.has(viewer) || !shown ? null : declared(viewer, html),
        css: shown ? [clientWidth, clientHeight] : [40, 30],
        camera: numbers(viewer),
        stats: { ...viewer.stats },
        active: lights.length === 0 ? 1 : lights.filter(({ active }) => active).length,
        samples: viewer.antialias === 'full' && seen !== null ? viewer.samples : 0,
        own: deeds.ownOf(viewer),
      });
    }
    return rests;
  }

  async function begin(rests: readonly Pick<Rest, 'html' | 'css' | 'pixels' | 'own'>[]) {
    await customElements.whenDefined('phong-viewer');
    // Old viewers are removed at the end, so that the context and its programs stay.
    const before = viewers();
    document.body.insertAdjacentHTML('afterbegin', rests.map(({ html }) => html).join(''));
    const all = viewers()
      .slice(0, rests.length)
      .map((viewer, i) => ({ viewer, ...rests[i]! }));
    for (const { viewer, css } of all) {
      viewer.style.width = `${css[0]}px`;
      viewer.style.height = `${css[1]}px`;
    }
    for (const { viewer, own } of all) {
      for (const where of own) {
        await deeds.addOwn(viewer, where);
      }
    }
    await allReady();
    const began: Began[] = [];
    for (const { viewer, pixels } of all) {
      const size = pixels[0] > 0 && pixels[1] > 0 ? pixels : ([40, 30] as const);
      const blob = await blobOf(viewer, size);
      began.push({ blob, camera: numbers(viewer), stats: { ...viewer.stats } });
    }
    for (const viewer of before) {
      viewer.remove();
    }
    return began;
  }

  window.walk = { settle, rest, begin };
}
