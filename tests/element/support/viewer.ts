// What the element's browser tests share: the viewer as it is typed inside the page, its camera and
// events read from outside, and input by mouse and fingers. Positions are CSS pixels of the page.

import type { CDPSession, Locator, Page } from '@playwright/test';
import type { CameraState, PhongLight, PhongMesh, PhongViewer } from '../../../src/viewer/index.js';
import { type ViewerLocator, pixels, type Picture } from '../../support/test.js';

export type { CameraState, PhongLight, PhongMesh, PhongViewer };

/** The viewer's current camera. */
export const cameraOf = (viewer: ViewerLocator): Promise<CameraState> =>
  viewer.evaluate((element) => element.camera);

export const statsOf = (viewer: ViewerLocator): Promise<PhongViewer['stats']> =>
  viewer.evaluate((element) => element.stats);

/** The frames that the viewer has drawn. */
export const framesOf = async (viewer: ViewerLocator): Promise<number> =>
  (await statsOf(viewer)).frames;

/** The samples of the picture that is shown. */
export const samplesOf = async (viewer: ViewerLocator): Promise<number> =>
  (await statsOf(viewer)).samples;

export const htmlOf = (viewer: ViewerLocator): Promise<string> =>
  viewer.evaluate((element) => element.toHTML());

/** The triangles of all meshes that are drawn and have an index. */
export const trianglesOf = (viewer: ViewerLocator): Promise<number> =>
  viewer.evaluate((element) => {
    let corners = 0;
    element.scene.traverse((object) => {
      const { geometry } = object as { geometry?: { index: { count: number } | null } };
      corners += geometry?.index?.count ?? 0;
    });
    return corners / 3;
  });

/** Width and height in device pixels; -1 without a canvas. */
export const canvasSize = (
  viewer: ViewerLocator,
): Promise<readonly [width: number, height: number]> =>
  viewer.evaluate((element) => {
    const canvas = element.shadowRoot?.querySelector('canvas');
    return [canvas?.width ?? -1, canvas?.height ?? -1] as const;
  });

/** Assigns properties of any type in one task, in the given order. */
export async function assign(
  element: Locator,
  values: Readonly<Record<string, unknown>>,
): Promise<void> {
  await element.evaluate((target, given) => {
    for (const [key, value] of Object.entries(given)) {
      Reflect.set(target, key, value);
    }
  }, values);
}

/**
 * The picture of this viewer's markup, drawn by a second viewer on the same page, which is removed
 * again.
 */
export async function shownBy(
  page: Page,
  markup: string,
  size: { readonly width: number; readonly height: number },
): Promise<Picture> {
  await page.evaluate((html) => {
    const place = document.createElement('section');
    place.innerHTML = html;
    document.body.append(place);
    return place.querySelector('phong-viewer')?.ready;
  }, markup);
  const picture = await pixels(page.locator('section:last-of-type > phong-viewer'), size);
  await page.evaluate(() => document.querySelector('section:last-of-type')?.remove());
  return picture;
}

interface Heard {
  readonly type: string;
  readonly detail: unknown;
}

interface Recording {
  /** The events since the last call. */
  take(): Promise<Heard[]>;
}

/**
 * Records the element's events of these types. Elements and other objects in a detail become their
 * tag or type.
 */
export async function record(element: Locator, ...types: string[]): Promise<Recording> {
  const heard = await element.evaluateHandle((target, names) => {
    const list: Heard[] = [];
    const plain = (value: unknown): unknown => {
      if (value instanceof Element) return `<${value.localName}>`;
      if (Array.isArray(value)) return value.map(plain);
      if (typeof value !== 'object' || value === null) return value;
      return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, plain(inner)]));
    };
    for (const type of names) {
      target.addEventListener(type, (event) =>
        list.push({ type, detail: plain((event as CustomEvent<unknown>).detail) }),
      );
    }
    return list;
  }, types);
  return { take: () => heard.evaluate((list) => list.splice(0)) };
}

/** Waits until the page has shown all changes so far. */
export async function nextFrame(page: Page): Promise<void> {
  await page.evaluate(
    () =>
      new Promise<void>((resolve) =>
        requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(resolve))),
      ),
  );
}

/** Keeps what is requested at these addresses from the page until the returned function is called. */
export async function holdBack(page: Page, addresses: string | RegExp): Promise<() => void> {
  let send = (): void => undefined;
  const held = new Promise<void>((resolve) => (send = resolve));
  await page.route(addresses, async (route) => {
    await held;
    await route.continue();
  });
  return send;
}

/** Waits for the viewer's `ready`. */
export const settled = (viewer: ViewerLocator): Promise<void> =>
  viewer.evaluate((element) => element.ready);

/** Assigns the viewer's properties in one task, and waits for its `ready`. */
export async function set(
  viewer: ViewerLocator,
  values: Readonly<Record<string, unknown>>,
): Promise<void> {
  await assign(viewer, values);
  await settled(viewer);
}

/** Loses the WebGL context of a viewer that is alone on its page. Returns what restores it. */
export async function loseContext(viewer: ViewerLocator): Promise<() => Promise<void>> {
  const loss = await viewer.evaluateHandle((element) => {
    const context = element.shadowRoot!.querySelector('canvas')!.getContext('webgl2')!;
    const extension = context.getExtension('WEBGL_lose_context')!;
    extension.loseContext();
    return extension;
  });
  return () => loss.evaluate((extension) => extension.restoreContext());
}

/**
 * Moves the pointer off the viewers. A headless shell moves it to the corner of each page that has
 * loaded.
 */
export const pointerAway = (page: Page): Promise<void> => page.mouse.move(900, 650);

interface DragOptions {
  readonly button?: 'left' | 'right' | 'middle';
  readonly steps?: number;
  /** false: the button stays down. */
  readonly release?: boolean;
}

/** Presses at `from` and travels by `by`, both in CSS pixels. */
export async function drag(
  page: Page,
  from: readonly [number, number],
  by: readonly [number, number],
  { button = 'left', steps = 4, release = true }: DragOptions = {},
): Promise<void> {
  await page.mouse.move(...from);
  await page.mouse.down({ button });
  await page.mouse.move(from[0] + by[0], from[1] + by[1], { steps });
  if (release) {
    await page.mouse.up({ button });
  }
}

type Place = readonly [x: number, y: number];

/** Touch input by Chromium's own events; each call lists all fingers that are down. */
export class Fingers {
  readonly #session: CDPSession;

  constructor(session: CDPSession) {
    this.#session = session;
  }

  static async on(page: Page): Promise<Fingers> {
    return new Fingers(await page.context().newCDPSession(page));
  }

  down = (...places: readonly Place[]) => this.#send('touchStart', places);
  move = (...places: readonly Place[]) => this.#send('touchMove', places);
  up = () => this.#send('touchEnd', []);

  /** Lifts one finger, counted from 0, from where it is; the others stay. */
  lift = (id: number, place: Place) => this.#send('touchEnd', [place], id);

  async #send(
    type: 'touchStart' | 'touchMove' | 'touchEnd',
    places: readonly Place[],
    firstId = 0,
  ) {
    const touchPoints = places.map(([x, y], i) => ({ x, y, id: firstId + i }));
    await this.#session.send('Input.dispatchTouchEvent', { type, touchPoints });
  }
}
