// What rids small shiny shapes of undersampled highlights and edges: spheres of 40 pixels, one sample a pixel, more samples,
// filtered highlights.
import { Object3D, SphereGeometry } from 'three';
import type { LightValues } from 'phong-viewer/core';
import { CAMERA, CoreView, type Look } from './core-view.js';
import { type Axis, type Size, type Stand, type Subject } from './stand.js';
import { converged, Supersampled } from './supersampling.js';

const DIAMETER = 40;
const PITCH = 48;
/** As the element's sphere. */
const SEGMENTS = 64;
/** So bright that the highlight is as much lighter than what is round it as ks of one half allows. */
const LIGHT: Partial<LightValues> = {
  position: [-1, 1, 1.5, 0],
  ambient: [20, 20, 20],
  diffuse: [100, 100, 100],
  specular: [255, 255, 255],
};
/** Of the reference, along each side of a pixel; and where somebody waits. */
const CONVERGED = 16;
const QUICK_CONVERGED = 8;
/** Spheres along each side of the part that errors are taken of. */
const PART = 3;

const SCENES: Readonly<Record<string, number>> = {
  'shininess 32': 32,
  'shininess 1e3': 1e3,
  'shininess 1e4': 1e4,
  'shininess 1e5': 1e5,
};

/** Places of spheres of so many pixels, in rows that fill the picture; a little aside of the pixels' grid, each differently. */
function spheres([width, height]: Size): Object3D[] {
  const unit = height / (2 * CAMERA.radius * Math.tan((CAMERA.fov * Math.PI) / 360)); // pixels
  const [columns, rows] = [Math.floor(width / PITCH), Math.floor(height / PITCH)];
  return Array.from({ length: columns * rows }, (_, k) => {
    const [i, j] = [k % columns, Math.floor(k / columns)];
    const aside = [((k * 7) % 13) / 13, ((k * 5) % 11) / 11] as const;
    const sphere = new Object3D();
    sphere.position.set(
      ((i - (columns - 1) / 2) * PITCH + aside[0]) / unit,
      ((j - (rows - 1) / 2) * PITCH + aside[1]) / unit,
      0,
    );
    sphere.scale.setScalar(DIAMETER / unit);
    return sphere;
  });
}

export const antialias: Axis = {
  title: 'Antialiasing of small shiny shapes',
  scenes: Object.keys(SCENES),
  open(name, { size: [width, height], quick = false }, holder) {
    const samples = quick ? QUICK_CONVERGED : CONVERGED;
    const shininess = SCENES[name]!;
    const size: Size = [width >> 1, height >> 1]; // 64 samples a pixel are many
    const single = new CoreView(holder, [LIGHT], false);
    const multi = new CoreView(holder, [LIGHT], true);
    const geometry = new SphereGeometry(0.5, SEGMENTS, SEGMENTS / 2);
    const places = spheres(size);
    // In the middle: away from the picture's borders, over several spheres.
    const part: Size = [Math.min(PART * PITCH, size[0]), Math.min(PART * PITCH, size[1])];
    const [x, y] = [(size[0] - part[0]) >> 1, (size[1] - part[1]) >> 1];
    const plain: Look = { shininess };
    const filtered: Look = { shininess, style: { antialias: 'highlights' } };
    const seen = (view: CoreView, id: string, label: string, look: Look): Subject => {
      const scene = view.scene(geometry, look, places);
      const draw = (): void => {
        view.draw(scene, size);
      };
      return { id, label, gl: view.gl, draw, picture: () => (draw(), view.read(part, x, y)) };
    };
    const supersampled = (side: number): Subject => {
      const scene = single.scene(geometry, plain, places);
      const larger = new Supersampled(single, side);
      const draw = (): void => {
        larger.draw(scene, size);
      };
      const [id, label] = [`supersampled ${String(side ** 2)}`, `${String(side ** 2)} samples a pixel`];
      return { id, label, gl: single.gl, draw, picture: () => (draw(), single.read(part, x, y)) };
    };
    const subjects = [
      seen(single, 'none', 'one sample a pixel', plain),
      seen(multi, 'edges', `edges by ${String(multi.samples)} samples`, plain),
      seen(single, 'filtered', 'one sample, highlights filtered', filtered),
      seen(multi, 'highlights', `edges by ${String(multi.samples)} samples, highlights filtered`, filtered),
      ...[2, 4, 8].map(supersampled),
    ];
    const stand: Stand = {
      title: `Antialiasing: 40-pixel spheres, ${name.replace('1e5', '100,000').replace('1e4', '10,000').replace('1e3', '1,000')}`,
      truth: `the mean of ${String(samples ** 2)} pictures of the same mesh, moved by parts of a pixel`,
      ...{ base: 'edges', shipped: 'edges', size, errorSize: part, subjects },
      reference: (pace) =>
        converged(single, single.scene(geometry, plain, places), { size, part, x, y, side: samples }, pace),
      close() {
        single.close();
        multi.close();
      },
    };
    return Promise.resolve(stand);
  },
};
