// A whole picture by the element: the plain one, with averaged highlights, or the mean of many
// samples.
import { onlyContext, runFrame } from './page-hooks.js';
import { createGeometry, roundOf } from '../../../src/phong/model/shapes/shapes.js';
import { trianglesOf } from '../../visual/ray-cast.js';
import { castSceneOf } from './cast-scene.js';
import { drawUntilReady, type Viewer } from './element-side.js';
import type { OpenPicture } from './picture.js';
import type { PictureScene } from './picture-scenes.js';
import { finish, pause } from './timing.js';

/**
 * Frames and rest until specialised programs are used: 20 frames, then a compilation in the
 * background.
 */
const SETTLING = { frames: 30, betweenMs: 4, restMs: 400 } as const;
/** What a change turns the camera by and back, in degrees: the levels of round shapes stay. */
const NUDGE = 0.01;

/** Enough to compile, and to build the levels that samples show. */
export const WARM: Mode = { antialias: 'full', samples: 16 };

export interface Mode {
  readonly antialias: 'edges' | 'full';
  /** Samples per pixel of `full`; 0 otherwise. */
  readonly samples: number;
}

/** Puts the scene's viewers into the holder's cells and draws them until all are ready. */
export async function showViewers(
  holder: HTMLElement,
  { viewers }: PictureScene,
): Promise<Viewer[]> {
  holder.innerHTML = viewers.join('');
  const shown = Array.from(holder.querySelectorAll('phong-viewer'));
  for (const viewer of shown) {
    Object.assign(viewer.style, { display: 'block', width: '100%', height: '100%' });
  }
  await drawUntilReady(...shown);
  return shown;
}

/** Antialiases all viewers in this way, and draws until they are ready. */
export async function antialiasAll(
  viewers: readonly Viewer[],
  { antialias, samples }: Mode,
): Promise<void> {
  for (const viewer of viewers) {
    viewer.antialias = antialias;
    viewer.samples = samples === 0 ? null : samples;
  }
  await drawUntilReady(...viewers);
}

const channel = new MessageChannel();
/** The page's next task, without a timer's least delay: fences are signalled between tasks. */
const nextTask = (): Promise<void> =>
  new Promise((resolve) => {
    channel.port1.onmessage = () => resolve();
    channel.port2.postMessage(null);
  });

/** Its one method is called `element`. */
export const openElement =
  (mode: Mode): OpenPicture =>
  async (holder, scene, { width, height }) => {
    const viewers = await showViewers(holder, scene);
    const thetas = viewers.map(({ theta }) => theta);
    const gl = onlyContext();
    let isNudged = false;

    const turn = (by: number) => viewers.forEach((viewer, i) => (viewer.theta = thetas[i]! + by));
    /**
     * Changes the picture and draws until it has so many samples. Ends in the task that drew it.
     */
    const draw = async (wanted: number) => {
      const before = viewers.map(({ stats }) => stats.frames);
      isNudged = !isNudged;
      turn(isNudged ? NUDGE : 0);
      await Promise.resolve(); // the element gathers changes until here
      const isShown = (viewer: Viewer, i: number) => {
        const { frames, samples } = viewer.stats;
        return frames > before[i]! && samples === wanted;
      };
      for (;;) {
        runFrame();
        if (viewers.every(isShown)) return;
        await nextTask();
      }
    };

    for (let i = 0; i < SETTLING.frames; i++) {
      await draw(0);
      await pause(SETTLING.betweenMs);
    }
    await pause(SETTLING.restMs);
    await draw(0);
    if (mode.antialias === 'full') {
      await antialiasAll(viewers, WARM);
      for (const viewer of viewers) {
        viewer.samples = mode.samples;
      }
    }

    const shapes = await Promise.all(
      viewers.map(async ({ geometry }) =>
        geometry === null || !roundOf(geometry)
          ? null
          : trianglesOf(await createGeometry(geometry, 512)),
      ),
    );
    return {
      methods: { element: { steps: 1 } },
      scenes: (round) => viewers.map((viewer, i) => castSceneOf(viewer, round ? shapes[i]! : null)),
      async time() {
        finish(gl);
        const start = performance.now();
        await draw(mode.samples);
        finish(gl);
        return [performance.now() - start];
      },
      async codes() {
        isNudged = true; // so that drawing turns back
        turn(NUDGE);
        await draw(mode.samples);
        if (viewers.length > 1) {
          await nextTask(); // copies are made at a task's end
        }
        const target = new OffscreenCanvas(width, height).getContext('2d', {
          willReadFrequently: true,
        })!;
        const all = new Uint8Array(3 * width * height * viewers.length);
        viewers.forEach((viewer, i) => {
          target.fillRect(0, 0, width, height);
          target.drawImage(viewer.shadowRoot!.querySelector('canvas')!, 0, 0);
          const { data } = target.getImageData(0, 0, width, height);
          const start = 3 * width * height * i;
          for (let pixel = 0; pixel < width * height; pixel++) {
            all.set(data.subarray(4 * pixel, 4 * pixel + 3), start + 3 * pixel);
          }
        });
        return all;
      },
    };
  };
