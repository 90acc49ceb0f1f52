// Do the shapes of the README's and the site's scenes stand on the floors that they are drawn with?

import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { teapot } from '../../src/phong/model/shapes/teapot.js';

const files = execFileSync('git', ['ls-files', 'README.md', 'demo/*.md', 'demo/*.html'], {
  encoding: 'utf8',
});

const pot = teapot(8, false);
pot.computeBoundingBox();
/** Half of each shape's height; shapes that are not here may lean, or hang in the air. */
const HALF: Readonly<Record<string, number>> = {
  plane: 0,
  box: 0.5,
  cylinder: 0.5,
  cone: 0.5,
  pyramid: 0.5,
  sphere: 0.5,
  teapot: pot.boundingBox!.max.y,
};

interface Shape {
  readonly geometry: string;
  readonly bottom: number;
  readonly top: number;
}

/** The upright shapes of a scene's markup. */
function shapesOf(scene: string) {
  return Array.from(scene.matchAll(/<phong-mesh\b([^>]*)>/g), ([, text = '']) => {
    const of = (name: string) => new RegExp(`\\s${name}="([^"]*)"`).exec(text)?.[1] ?? '';
    const numbers = (name: string) => of(name).trim().split(/\s+/).map(Number);
    const geometry = of('rotation') === '' ? of('geometry') : '';
    const [, y = 0] = numbers('position');
    const [all, up = all] = numbers('scale');
    const half = (HALF[geometry] ?? NaN) * (of('scale') === '' ? 1 : up!);
    return { geometry, bottom: y - half, top: y + half };
  }).filter(({ top }) => !Number.isNaN(top));
}

const isFloor = ({ top, bottom }: Shape) => top - bottom < 0.1;

const scenes = files
  .trim()
  .split('\n')
  .flatMap((path) =>
    Array.from(
      readFileSync(path, 'utf8').matchAll(/<phong-viewer[^]*?<\/phong-viewer\s*>/g),
      ([scene]) => ({ path, shapes: shapesOf(scene), floors: shapesOf(scene).filter(isFloor) }),
    ),
  )
  .filter(({ shapes, floors }) => floors.length > 0 && shapes.length > floors.length);

it('there are scenes with floors', () => {
  expect(scenes.length).toBeGreaterThan(8);
});

it.each(scenes)('$path: what has a floor stands on it', ({ shapes, floors }) => {
  const ground = Math.max(...floors.map(({ top }) => top));
  for (const shape of shapes.filter((one) => !isFloor(one))) {
    expect(Math.abs(shape.bottom - ground), shape.geometry).toBeLessThan(0.005);
  }
});
