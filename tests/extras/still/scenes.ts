// Scenes for comparisons of stills: the viewers of the site's pages, and models. Without textures.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

export interface Scene {
  /** The file, and the number of the viewer in it. */
  readonly name: string;
  readonly markup: string;
}

/** Relative to `demo/`. The first ones stand for the others. */
const PAGES = [
  'scenes/spot.html',
  'scenes/exponents.html',
  'scenes/room.html',
  'scenes/colours.html',
  'guide/see.md',
  'guide/light.md',
  'guide/camera.md',
  'guide/exercises.md',
  'guide/reference.md',
  'guide/scenes/attenuation.html',
  'guide/scenes/cone.html',
  'guide/scenes/decay.html',
  'guide/scenes/directions.html',
  'guide/scenes/gouraud.html',
  'guide/scenes/half-way.html',
  'guide/scenes/highlight.html',
  'guide/scenes/near-far.html',
  'guide/scenes/shapes.html',
  'guide/scenes/terms.html',
  'lesson/index.html',
  'scenes/camera-light.html',
  'scenes/compare.html',
  'scenes/lamp.html',
  'scenes/lesson.html',
  'scenes/many-lights.html',
  'scenes/product.html',
  'scenes/sun.html',
];

/** Addresses on the tests' server. */
const MODELS = [
  '/fixtures/models/vertex-colours.glb',
  '/fixtures/models/no-normals.glb',
  '/fixtures/models/coloured.ply',
  '/fixtures/models/coloured.stl',
  '/assets/models/real/nut.ply',
  '/assets/models/real/airplane.ply',
  '/assets/models/real/sphere-with-hole.stl',
  '/assets/models/real/toyplane.obj',
];

/** The viewers of the pages, at most `most` of each: those that show built-in shapes only. */
export const siteScenes = (pages = PAGES.length, most = Infinity): Scene[] =>
  PAGES.slice(0, pages).flatMap((path) => {
    const text = readFileSync(fileURLToPath(new URL(`../../../demo/${path}`, import.meta.url)));
    // Not those that a guide's sentence names.
    const viewers = /(?<=^ *|>)<phong-viewer\b(?:(?!<phong-viewer\b)[^])*?<\/phong-viewer>/gm;
    return (text.toString().match(viewers) ?? [])
      .filter((markup) => !/\ssrc=|<script|view="triangles"/.test(markup))
      .map((markup, i) => ({ name: `${path} ${i + 1}`, markup }))
      .slice(0, most);
  });

export const modelScenes = (models = MODELS): Scene[] =>
  models.map((src) => ({
    name: src,
    markup: `<phong-viewer src="${src}"><phong-light position="1 2 2"></phong-light></phong-viewer>`,
  }));
