/**
 * `phong-viewer/playwright`: visual tests of pages with `<phong-viewer>`, for `@playwright/test`.
 * Compares pictures with the equation rather than with files. Runs in Node; knows the elements by
 * their public API only.
 */
import { errors, expect as playwrightExpect, type Locator, test } from '@playwright/test';
import type { PhongViewer } from '../../viewer/index.js';
import { changeByCss, judgeInPage, otherElement, settleInPage, whyIncomplete } from './in-page.js';
import type { Judgement } from './judge-in-page.js';
import { verdictOf } from './verdict.js';

export interface SettledOptions {
  /** Milliseconds, default 20,000. */
  readonly timeout?: number;
}

export interface EquationOptions extends SettledOptions {
  /**
   * Largest difference of a channel from the equation, in 8-bit codes. Whole, 0–255, default 1:
   * what the element promises.
   */
  readonly codes?: number;
  /**
   * Least share of the surfaces' pixels that can be judged, 0–1, default 0.25. Fewer fail the test,
   * because it would say little: make the viewer larger or move the camera closer.
   */
  readonly share?: number;
  /**
   * Pixels that are judged at least, where the picture has them: whole, at least 1, default 10,000,
   * spread over the picture; or `'all'`. Each takes five calls of `shadeAt`.
   */
  readonly pixels?: number | 'all';
  /** Chooses the pixels: the same number, the same pixels. Whole, default 1. */
  readonly seed?: number;
}

export interface SnapshotOptions extends SettledOptions {
  /**
   * Pixels, whole, at least 1. Default: the viewer's size in CSS pixels, so that dense screens give
   * the same picture.
   */
  readonly width?: number;
  readonly height?: number;
}

/** Node's Buffer, as Playwright's own screenshots are. */
type Png = Awaited<ReturnType<Locator['screenshot']>>;

/** The package is built without Node's types, because all other entries run in browsers. */
const { Buffer } = globalThis as unknown as {
  Buffer: { from(text: string, encoding: 'base64'): Png };
};

/** Wrong pixels that a message lists. */
const LISTED = 5;

/** Pixels judged by default: about half of what an object covers at 300 × 200. */
const PIXELS = 10_000;

/**
 * Waits until a viewer's picture stands still: everything requested is loaded and drawn, faster
 * programs have taken over, nothing moves. Scrolls it into view. Throws after the timeout and says
 * why, for example because of `auto-rotate`: set it to 0, or emulate reduced motion.
 */
export async function settled(
  viewer: Locator,
  { timeout = 20_000 }: SettledOptions = {},
): Promise<void> {
  await isViewer(viewer, timeout);
  await viewer.scrollIntoViewIfNeeded({ timeout });
  await viewer.evaluate(settleInPage, timeout);
}

/** Throws, and says what there is instead, unless it is a locator of a viewer. */
async function isViewer(viewer: Locator, timeout: number): Promise<void> {
  const expected = "expected a locator of a <phong-viewer>, such as page.locator('phong-viewer')";
  const { waitFor } = (viewer as Partial<Locator> | null | undefined) ?? {};
  if (waitFor === undefined) throw new TypeError(`${expected}, got ${kindOf(viewer)}`);
  try {
    await viewer.waitFor({ state: 'attached', timeout });
  } catch (error) {
    // Playwright's own message names several matches.
    if (!(error instanceof errors.TimeoutError)) throw error;
    throw new Error(
      `${expected}: no element matches ${String(viewer)} after ${String(timeout)} ms`,
    );
  }
  const other = await viewer.evaluate(otherElement);
  if (other !== null) throw new TypeError(`${expected}: ${String(viewer)} is ${other}`);
}

/** Playwright's build adds an underscore to some classes. */
const kindOf = (value: unknown): string =>
  typeof value === 'object' && value !== null
    ? `a ${value.constructor.name.replace(/^_/, '')}`
    : String(value);

/**
 * The settled picture as a PNG of exactly this size, without page, panel or background: the same
 * bytes wherever browser and GPU are the same, whatever the screen. For `expect(await
 * snapshot(viewer)).toMatchSnapshot('lamp.png')`.
 */
export async function snapshot(
  viewer: Locator,
  { width, height, timeout = 20_000 }: SnapshotOptions = {},
): Promise<Png> {
  await settled(viewer, { timeout });
  const base64 = await viewer.evaluate(
    async (element: PhongViewer, size) => {
      const blob = await element.toBlob({
        width: size.width ?? Math.max(element.clientWidth, 1),
        height: size.height ?? Math.max(element.clientHeight, 1),
        type: 'image/png',
      });
      const bytes = new Uint8Array(await blob.arrayBuffer());
      // In parts: the number of arguments of a call is limited.
      let text = '';
      for (let i = 0; i < bytes.length; i += 4096) {
        text += String.fromCharCode(...bytes.subarray(i, i + 4096));
      }
      return btoa(text);
    },
    { width, height },
  );
  return Buffer.from(base64, 'base64');
}

/**
 * Playwright's `expect` with the matcher of this package. `mergeExpects` combines it with others.
 */
export const expect = playwrightExpect.extend({
  /**
   * The viewer's picture is the shading equation's, in float64, at every pixel in which a single
   * smooth surface shows and its colour hardly changes: what is drawn lies between the least and
   * the greatest that the equation takes at the pixel's centre and corners, give or take `codes`.
   * Judges a sample unless `pixels` is `'all'`. Never judged: outlines, creases, translucent
   * surfaces, textures drawn smaller than they are, and own objects in `scene`. The message and an
   * annotation of the test report how many pixels were judged. What CSS makes of the picture is not
   * judged: a `filter` or an `opacity` gets a warning. Throws for a viewer that is empty or shows
   * an error.
   */
  async toShowTheEquation(viewer: Locator, options: EquationOptions = {}) {
    const { codes = 1, share = 0.25, pixels = PIXELS, seed = 1, timeout = 20_000 } = options;
    const isWhole = Number.isInteger;
    requires(
      isWhole(codes) && codes >= 0 && codes <= 255,
      { codes },
      'a whole number from 0 to 255',
    );
    requires(share >= 0 && share <= 1, { share }, 'from 0 to 1');
    const isCount = pixels === 'all' || (isWhole(pixels) && pixels >= 1);
    requires(isCount, { pixels }, "a whole number from 1 on, or 'all'");
    requires(isWhole(seed), { seed }, 'a whole number');
    await settled(viewer, { timeout });
    const fault = await viewer.evaluate(whyIncomplete);
    if (fault !== null) throw new Error(`toShowTheEquation: ${fault}`);
    const change = await viewer.evaluate(changeByCss);
    if (change !== null) {
      warn(`toShowTheEquation: ${change}`);
    }
    const judgement: Judgement = await viewer.evaluate(judgeInPage, {
      codes,
      pixels: pixels === 'all' ? null : pixels,
      seed,
      most: LISTED,
    });
    const { pass, summary, message } = verdictOf(judgement, { codes, share }, seed);
    test.info().annotations.push({ type: 'equation', description: summary });
    return { name: 'toShowTheEquation', pass, message: () => message };
  },
});

function requires(isRight: boolean, option: EquationOptions, expected: string): void {
  const [[name, value] = []] = Object.entries(option);
  if (!isRight) {
    throw new RangeError(
      `toShowTheEquation: ${String(name)} must be ${expected}, got ${String(value)}`,
    );
  }
}

/** In the console, and in the test's report. */
function warn(description: string): void {
  test.info().annotations.push({ type: 'warning', description });
  console.warn(description);
}
