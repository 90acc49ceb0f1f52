// What rids small shiny shapes of undersampled highlights and edges: spheres of 40 pixels, one sample a pixel, more samples,
// filtered highlights.
import { Object3D, SphereGeometry } from 'three';
import type { LightValues } from 'phong-viewer/core';
import type { ColorPicture } from '../error/error-figures.js';
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
/** Spheres along each side of the part that errors are taken of: each has its highlight elsewhere in its pixels. */
const PART = 6;
/** For which pixels are whole: the mean of this many pictures a side. */
const WHOLE = 4;

interface SmallShapes {
  readonly shininess: number;
  /** Edges, where shape and background mix, are left out. */
  readonly inside: boolean;
}

const SCENES: Readonly<Record<string, SmallShapes>> = {
  'shininess 32': { shininess: 32, inside: false },
  'shininess 1e4': { shininess: 1e4, inside: false },
  'inside at shininess 1e3': { shininess: 1e3, inside: true },
  'inside at shininess 1e4': { shininess: 1e4, inside: true },
  'inside at shininess 1e5': { shininess: 1e5, inside: true },
};

/** Ambient light alone: white wherever a sphere is. */
const WHITE: Partial<LightValues> = {
  position: [0, 0, 1, 0],
  ambient: [255, 255, 255],
  diffuse: [0, 0, 0],
  specular: [0, 0, 0],
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
    const { shininess, inside } = SCENES[name]!;
    const samples = quick ? QUICK_CONVERGED : CONVERGED;
    const size: Size = quick ? [width, height] : [width >> 1, height >> 1]; // 64 samples a pixel are many
    const single = new CoreView(holder, [LIGHT], false);
    const multi = new CoreView(holder, [LIGHT], true);
    const geometry = new SphereGeometry(0.5, SEGMENTS, SEGMENTS / 2);
    const places = spheres(size);
    // In the middle: away from the picture's borders, over several spheres.
    const part: Size = [Math.min(PART * PITCH, size[0]), Math.min(PART * PITCH, size[1])];
    const [x, y] = [(size[0] - part[0]) >> 1, (size[1] - part[1]) >> 1];
    const plain: Look = { shininess };
    const filtered: Look = { shininess, style: { antialias: 'highlights' } };
    let whole: readonly boolean[] | null = null;
    const masked = (picture: ColorPicture): ColorPicture => {
      whole?.forEach((is, k) => {
        if (!is) picture.data.fill(0, 3 * k, 3 * k + 3);
      });
      return picture;
    };
    const read = (view: CoreView): ColorPicture => masked(view.read(part, x, y));
    const seen = (view: CoreView, id: string, label: string, look: Look): Subject => {
      const scene = view.scene(geometry, look, places);
      const draw = (): void => {
        view.draw(scene, size);
      };
      return { id, label, gl: view.gl, draw, picture: () => (draw(), read(view)) };
    };
    const supersampled = (side: number): Subject => {
      const scene = single.scene(geometry, plain, places);
      const larger = new Supersampled(single, side);
      const draw = (): void => {
        larger.draw(scene, size);
      };
      const [id, label] = [`supersampled ${String(side ** 2)}`, `${String(side ** 2)} samples a pixel`];
      return { id, label, gl: single.gl, draw, picture: () => (draw(), read(single)) };
    };
    const subjects = [
      seen(single, 'none', 'one sample a pixel', plain),
      seen(multi, 'edges', `edges by ${String(multi.samples)} samples`, plain),
      seen(single, 'filtered', 'one sample, highlights filtered', filtered),
      seen(multi, 'highlights', `edges by ${String(multi.samples)} samples, highlights filtered`, filtered),
      ...[2, 4, 8].map(supersampled),
    ];
    const stand: Stand = {
      title: `Antialiasing of 40-pixel spheres${inside ? ', edges left out' : ''}: shininess ${shininess.toLocaleString('en')}`,
      truth: `the mean of ${String(samples ** 2)} pictures of the same mesh, moved by parts of a pixel`,
      ...{ base: 'edges', shipped: 'edges', size, errorSize: part, subjects },
      async reference(pace) {
        const view = { size, part, x, y };
        if (inside) {
          const white = new CoreView(holder, [WHITE], false);
          const scene = white.scene(geometry, plain, places);
          const { data } = await converged(white, scene, { ...view, side: WHOLE }, pace);
          white.close();
          whole = Array.from({ length: part[0] * part[1] }, (_, k) => data[3 * k] === 255);
        }
        const scene = single.scene(geometry, plain, places);
        return masked(await converged(single, scene, { ...view, side: samples }, pace));
      },
      close() {
        single.close();
        multi.close();
      },
    };
    return Promise.resolve(stand);
  },
};
