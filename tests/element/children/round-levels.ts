// Round shapes with automatic segments, watched: what a page shows of them at each load, and a film
// of a zoom beside a viewer with a fine fixed number. The short and the long tests differ only in
// the numbers.

import type { Page } from '@playwright/test';
import { expect, type Mount } from '../../support/test.js';
import { type PhongViewer } from '../support/viewer.js';

/** Loads the same page so often: the shown pictures are the same bytes, of the same triangles. */
export async function loadAgain(mount: Mount, times: number): Promise<void> {
  const markup = `<phong-viewer target="0 0 0" radius="1.2" theta="20" phi="60"><phong-mesh geometry="sphere" position="-0.5 0 0"></phong-mesh
    ><phong-mesh geometry="torus" position="0.6 0 0"></phong-mesh><phong-mesh geometry="teapot" position="0 0 -4"></phong-mesh></phong-viewer>`;
  let first: unknown;
  for (let time = 0; time < times; time++) {
    const viewer = await mount(markup, { width: 80, height: 60 });
    const shown = await viewer.evaluate((element: PhongViewer) => {
      const counts: number[] = [];
      element.scene.traverse((object) => {
        const { geometry } = object as unknown as { geometry?: { index: { count: number } } };
        if (geometry !== undefined) {
          counts.push(geometry.index.count / 3);
        }
      });
      return { picture: element.shadowRoot!.querySelector('canvas')!.toDataURL(), counts };
    });
    first ??= shown;
    expect(shown.counts).toHaveLength(3);
    expect(shown, `load ${time}`).toEqual(first);
  }
}

/** Of two viewers. Codes 0 to 255, of premultiplied colour. */
type Film = Awaited<ReturnType<typeof filmZoom>>;

/**
 * Codes that frames may differ by, but for outlines and edges: what steps by more from pixel to
 * pixel is an edge.
 */
const MOST_INSIDE = 12;

/**
 * The film shows no jump: with automatic segments it is that of 256 in every frame, but for the
 * samples that an outline passes and small codes inside. Measured: 128 on outlines, two of four
 * samples; inside 4 for a cone, 2 for a sphere.
 */
export function expectSmooth(film: Film, name: string): void {
  for (const frame of film) {
    const { radius, covered, fineCovered } = frame;
    const at = `${name} from ${radius.toFixed(2)} away`;
    expect(covered, `${at} is there`).toBeGreaterThan(0);
    expect(Math.abs(covered - fineCovered), at).toBeLessThan(0.003);
    expect(frame.outline, `${at}, outline`).toBeLessThanOrEqual(129);
    expect(frame.inside, `${at}, inside`).toBeLessThanOrEqual(MOST_INSIDE);
    expect(frame.mean, `${at}, mean`).toBeLessThan(1.2);
    expect(frame.change, `${at}, change`).toBeLessThan(1.05 * frame.fineChange + 0.1);
  }
  expect(
    new Set(film.map(({ triangles }) => triangles)).size,
    `levels of the ${name}`,
  ).toBeGreaterThan(2);
}

/**
 * Moves two viewers, one with 256 segments, from afar to `near` in equal ratios, and reads each
 * frame as it is shown.
 */
export async function filmZoom(
  page: Page,
  mount: Mount,
  geometry: string,
  frames: number,
  size: { readonly width: number; readonly height: number },
) {
  const viewer = (segments: string): string =>
    `<phong-viewer geometry="${geometry}" target="0 0 0" radius="30" segments="${segments}"></phong-viewer>`;
  await mount(viewer('auto') + viewer('256'), { ...size, css: 'phong-viewer { float: left }' });
  const asked = { count: frames, most: MOST_INSIDE };
  return page.evaluate(async ({ count, most }) => {
    const viewers = [...document.querySelectorAll<PhongViewer>('phong-viewer')];
    const readers = viewers.map((viewer) => {
      const canvas = viewer.shadowRoot!.querySelector('canvas')!;
      const { width, height } = canvas;
      const context = new OffscreenCanvas(width, height).getContext('2d', {
        willReadFrequently: true,
      })!;
      return () => {
        context.clearRect(0, 0, width, height);
        context.drawImage(canvas, 0, 0);
        const { data } = context.getImageData(0, 0, width, height);
        return Float32Array.from(data, (code, i) =>
          i % 4 === 3 ? code : (code * data[i | 3]!) / 255,
        );
      };
    });
    const meanOf = (a: Float32Array, b: Float32Array): number =>
      a.reduce((sum, code, i) => sum + Math.abs(code - b[i]!), 0) / a.length;
    const covered = (data: Float32Array): number =>
      data.reduce((sum, code, i) => (i % 4 === 3 ? sum + code : sum), 0) /
      (255 * (data.length / 4));
    const row = 4 * viewers[0]!.shadowRoot!.querySelector('canvas')!.width;
    const around = [-row - 4, -row, 4 - row, -4, 0, 4, row - 4, row, row + 4];
    /** An outline, or an edge such as a cylinder's rim. */
    const isOutline = (data: Float32Array, i: number): boolean =>
      data[i | 3]! % 255 !== 0 ||
      around.some(
        (by) =>
          (data[(i | 3) + by] ?? data[i | 3]) !== data[i | 3] ||
          Math.abs((data[i + by] ?? data[i]!) - data[i]!) > most,
      );
    const film = [];
    let before: Float32Array[] | null = null;
    for (let frame = 0; frame < count; frame++) {
      const radius = 30 * 0.01 ** (frame / (count - 1));
      for (const viewer of viewers) {
        viewer.radius = radius;
      }
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      const now = readers.map((read) => read());
      const [auto, fine] = now as [Float32Array, Float32Array];
      let [inside, outline] = [0, 0];
      auto.forEach((code, i) => {
        const difference = Math.abs(code - fine[i]!);
        if (difference <= Math.min(inside, outline)) return;
        if (isOutline(fine, i)) {
          outline = Math.max(outline, difference);
        } else {
          inside = Math.max(inside, difference);
        }
      });
      const mesh = viewers[0]!.scene.children[0] as unknown as {
        geometry: { index: { count: number } };
      };
      film.push({
        radius,
        triangles: mesh.geometry.index.count / 3,
        // Largest difference between the films, away from outlines and on them; and its mean over
        // the picture.
        inside,
        outline,
        mean: meanOf(auto, fine),
        // Mean coverage, 0 to 1.
        covered: covered(auto),
        fineCovered: covered(fine),
        // Mean change since the frame before.
        change: before === null ? 0 : meanOf(auto, before[0]!),
        fineChange: before === null ? 0 : meanOf(fine, before[1]!),
      });
      before = now;
    }
    return film;
  }, asked);
}
