// How far are the outlines of a level from those of the round shape, in pixels, at the default view of a picture of
// 100, 400 and 1,600 pixels? The torus's hole and the teapot's handle and spout included, before the body too. Fewer
// sizes and lines than in a release run, which has them all.
import { describe, expect, it } from 'vitest';
import { fitRadius } from '../../src/camera/fit.js';
import { basisOf } from '../../src/camera/orbit.js';
import { scale } from '../../src/math/vector.js';
import { levelIn } from '../../src/scene/mesh/levels.js';
import { createGeometry, roundOf } from '../../src/scene/mesh/shapes/shapes.js';
import { outlineErrors } from '../support/caster/outlines.js';
import { firstOf, fullOr } from '../support/repeats.js';
import type { CastMaterial, CastShape } from '../support/caster/scene.js';
import { Tracer } from '../support/caster/tracer.js';

const FOV = 45;
const LINES = fullOr(60, 12);
/** The second one for small pictures of few triangles. */
const POSES = [
  { theta: 30, phi: 70 },
  { theta: 250, phi: 50 },
];
const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const MATERIAL: CastMaterial = { ka: [0, 0, 0], kd: [0, 0, 0], ks: [0, 0, 0], shininess: 1 };

async function built(
  name: 'sphere' | 'torus' | 'teapot',
  segments: number,
  isLevel: boolean,
): Promise<CastShape> {
  const geometry = await createGeometry(name, segments, isLevel);
  return {
    kind: 'triangles',
    positions: geometry.getAttribute('position').array,
    normals: geometry.getAttribute('normal').array,
    index: geometry.index!.array,
  };
}

describe.each(['sphere', 'torus', 'teapot'] as const)('the outlines of a %s', (name) => {
  it.each(name === 'teapot' ? firstOf([100, 400, 1600], 1) : firstOf([400, 100, 1600], 1))(
    'of %i pixels are within 1/4 of a pixel of the round ones',
    async (size) => {
      const distance = fitRadius(roundOf(name)!.radius, FOV, 1);
      const slope = Math.tan((FOV * Math.PI) / 360);
      let level = 0;
      const found = [];
      for (const pose of POSES.slice(0, name === 'teapot' || size === 1600 ? 1 : 2)) {
        const basis = basisOf(pose);
        const eye = scale(basis.back, distance);
        const frame = { origin: [0, 0, 0] as const, eye, ...basis };
        const view = { frame, slopeX: slope, slopeY: slope, radius: distance };
        // In a picture that may have as many triangles as the outline needs.
        level = levelIn(view, size, false, name, IDENTITY, Infinity)!;
        const tracer = (shape: CastShape): Tracer =>
          new Tracer(
            { camera: { ...basis, eye, fov: FOV }, lights: [], objects: [{ shape, material: MATERIAL }] },
            size,
            size,
          );
        // The teapot by triangles that are 1/9 as far off it as its level's.
        const round: CastShape = name === 'teapot' ? await built(name, 3 * level, false) : { kind: name };
        found.push(outlineErrors(tracer(round), tracer(await built(name, level, true)), LINES));
      }
      const worst = Math.max(...found.map((errors) => errors.worst));
      const compared = found.reduce((sum, errors) => sum + errors.compared, 0);
      const missed = found.reduce((sum, errors) => sum + errors.missed, 0);
      const text = `${name}, ${String(size)} pixels: ${String(level)} segments, ${worst.toFixed(3)} of a pixel`;
      console.log(`${text} in ${String(compared)} places, ${String(missed)} without a counterpart`);
      expect(compared).toBeGreaterThan(LINES);
      expect(worst).toBeLessThan(0.25);
    },
  );
});
