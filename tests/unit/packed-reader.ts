// Packed lights read back as the GLSL reads them: rows by the layout, and the loop over them in
// float64. Shading space, radians nowhere, colours where 1 is full. Knows the layout, not how rows
// came about.

import { HEADER, ROWS } from '../../src/phong/light/light-layout.js';
import {
  emptyPack,
  type PackedLights,
  packLights,
  type PackSpace,
} from '../../src/phong/light/pack-lights.js';
import type { LightValues } from '../../src/phong/light/light-state.js';
import { add, dot, normalize, scale, subtract, type Vec3 } from '../../src/phong/math/vector.js';
import { IDENTITY } from '../support/matrices.js';

export const WORLD: PackSpace = {
  worldToShading: IDENTITY,
  cameraToShading: IDENTITY,
  linear: false,
};

type PackedLight = Readonly<Record<string, { readonly xyz: Vec3; readonly w: number }>>;

export const pack = (lights: readonly LightValues[], space: PackSpace = WORLD): PackedLights => {
  const into = emptyPack();
  packLights(lights, space, into);
  return into;
};

export function read({ data, rows }: PackedLights) {
  const row = (i: number): PackedLight[string] => {
    if (i >= rows) throw new RangeError(`row ${i} is beyond ${rows}`);
    const [x = 0, y = 0, z = 0, w = 0] = data.subarray(4 * i);
    return { xyz: [x, y, z], w };
  };
  const counts = row(HEADER.counts).xyz;
  let next: number = HEADER.rows;
  const lights = (kind: keyof typeof ROWS, count: number): PackedLight[] =>
    Array.from({ length: count }, () => {
      const { rows: size, ...offsets } = ROWS[kind];
      const light = Object.fromEntries(
        Object.entries(offsets).map(([name, i]) => [name, row(next + i)]),
      );
      next += size;
      return light;
    });
  const result = {
    counts,
    ambient: row(HEADER.ambient).xyz,
    directional: lights('directional', counts[0]),
    point: lights('point', counts[1]),
    spot: lights('spot', counts[2]),
  };
  if (next !== rows) throw new RangeError(`${rows} rows, but the lights end at ${next}`);
  return result;
}

const quarter = (v: Vec3) => dot(v, v) / 4;

/** The loop of the GLSL over packed lights, in float64: p and eye in shading space, N unit. */
export function loop(
  lights: ReturnType<typeof read>,
  p: Vec3,
  N: Vec3,
  eye: Vec3,
  shininess: number,
) {
  const V = normalize(subtract(eye, p));
  let { ambient } = lights;
  let diffuse: Vec3 = [0, 0, 0];
  let specular: Vec3 = [0, 0, 0];
  const addLobes = (L: Vec3, light: PackedLight, factor: number): void => {
    const NoL = dot(N, L);
    if (!(NoL > 0)) return;
    const RoV = dot(subtract(scale(N, 2 * NoL), L), V);
    diffuse = add(diffuse, scale(light['diffuse']!.xyz, factor * NoL));
    specular = add(specular, scale(light['specular']!.xyz, factor * Math.max(RoV, 0) ** shininess));
  };
  for (const light of lights.directional) {
    addLobes(light['direction']!.xyz, light, 1);
  }
  for (const light of [...lights.point, ...lights.spot]) {
    const toLight = subtract(light['position']!.xyz, p);
    const d = Math.hypot(...toLight);
    const L = normalize(toLight);
    const [kc, kl, kq] = [light['position']!.w, light['diffuse']!.w, light['specular']!.w];
    let factor = 1 / Math.max(kc + kl * d + kq * d * d, 1);
    if (light['axis'] !== undefined) {
      const toAxis = quarter(add(L, light['axis'].xyz));
      const toBack = quarter(subtract(L, light['axis'].xyz));
      const limit = light['ambient']!.w;
      if (!(limit < 0 ? toBack >= -limit : toAxis <= limit)) continue;
      const decay = toBack ** light['axis'].w;
      ambient = add(ambient, scale(light['ambient']!.xyz, decay));
      factor *= decay;
    }
    addLobes(L, light, factor);
  }
  return { ambient, diffuse, specular };
}
