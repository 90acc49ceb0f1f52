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
    const shown = await viewer.evaluate((element) => {
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

type Film = Awaited<ReturnType<typeof filmZoom>>;

/**
 * The film shows no jump and no blank frame: with automatic segments it is that of 256 in every
 * frame, but for samples on outlines and small codes inside.
 */
export function expectSmooth(film: Film, name: string): void {
  for (const { radius, mean, covered, fineCovered } of film) {
    const at = `${name} from ${radius.toFixed(2)} away`;
    expect(covered, `${at} is there`).toBeGreaterThan(0);
    expect(Math.abs(covered - fineCovered), at).toBeLessThan(0.003);
    expect(mean, `${at}, mean`).toBeLessThan(1.2);
  }
  const levels = new Set(film.map(({ triangles }) => triangles));
  expect(levels.size, `levels of the ${name}`).toBeGreaterThan(2);
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
  // Slow drawing would take pixels, and triangles with them, but for a ratio that is written.
  const viewer = (segments: string) =>
    `<phong-viewer geometry="${geometry}" target="0 0 0" radius="30" pixel-ratio="1" segments="${segments}"></phong-viewer>`;
  await mount(viewer('auto') + viewer('256'), { ...size, css: 'phong-viewer { float: left }' });
  return page.evaluate(async (count) => {
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
    const covered = (data: Float32Array) =>
      data.reduce((sum, code, i) => (i % 4 === 3 ? sum + code : sum), 0) /
      (255 * (data.length / 4));
    const film = [];
    for (let frame = 0; frame < count; frame++) {
      const radius = 30 * 0.01 ** (frame / (count - 1));
      for (const viewer of viewers) {
        viewer.radius = radius;
      }
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      const [auto, fine] = readers.map((read) => read()) as [Float32Array, Float32Array];
      const mesh = viewers[0]!.scene.children[0] as unknown as {
        geometry: { index: { count: number } };
      };
      film.push({
        radius,
        triangles: mesh.geometry.index.count / 3,
        // Mean difference of the two, in codes of premultiplied colour.
        mean: auto.reduce((sum, code, i) => sum + Math.abs(code - fine[i]!), 0) / auto.length,
        // Mean coverage, 0 to 1.
        covered: covered(auto),
        fineCovered: covered(fine),
      });
    }
    return film;
  }, frames);
}
