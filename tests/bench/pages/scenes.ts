// What the benches draw: lights of mixed kinds over a bent plane that fills the picture and that every light reaches. One
// description for all peers, in the element's units: lengths in scene units, angles in degrees, colours of 255.
import type { LightValues } from 'phong-viewer/core';
import { Random } from '../../stress/random.js';
import type { Triangles } from '../glb.mjs';

export type Light = Partial<LightValues> & Pick<LightValues, 'position' | 'diffuse' | 'specular'>;

const KINDS = ['directional', 'point', 'spot'] as const;
export type Kind = (typeof KINDS)[number];

export interface SceneQuery {
  /** Lights that are declared. */
  readonly lights: number;
  /** How many of them are active; spread evenly. */
  readonly active: number;
  /** All of one kind, or mixed: directional, point and spot in turn. */
  readonly kind: Kind | 'mixed';
  readonly seed: number;
}

/** Where all eyes are: on the z axis, looking at the origin. */
export const CAMERA = { radius: 3, fov: 45 } as const;

export const SURFACE = { ka: 255, kd: 255, ks: 128, shininess: 32 } as const;

/**
 * Lights in front of the plane and above all of its normals' horizons, so that no term is zero anywhere; cones hold all
 * that the picture shows. Together they are about as bright as one full light.
 */
export function lightsOf({ lights, active, kind, seed }: SceneQuery): Light[] {
  const random = new Random(seed);
  const grey = 255 / active;
  const list: Light[] = [];
  for (let i = 0; i < lights; i++) {
    const [x, y, z] = [random.from(-1.5, 1.5), random.from(-1.5, 1.5), random.from(3, 5)];
    const color = (): [number, number, number] => [
      grey * random.from(0.5, 1),
      grey * random.from(0.5, 1),
      grey * random.from(0.5, 1),
    ];
    const light = {
      diffuse: color(),
      specular: color(),
      ambient: color().map((c) => c / 10) as [number, number, number],
      active: Math.floor((i * active) / lights) !== Math.floor(((i - 1) * active) / lights),
    };
    const attenuation = [1, random.from(0, 0.1), random.from(0.01, 0.05)] as const;
    switch (kind === 'mixed' ? KINDS[i % KINDS.length]! : kind) {
      case 'directional':
        list.push({ ...light, position: [x, y, z, 0] });
        break;
      case 'point':
        list.push({ ...light, position: [x, y, z, 1], attenuation });
        break;
      case 'spot': {
        // 2.9 is farther than any place in the picture is from any light's foot, 3 the least height: under 50°.
        const spot = { axis: [-x / 4, -y / 4, -z] as const, aperture: random.from(60, 75) };
        list.push({ ...light, position: [x, y, z, 1], attenuation, ...spot, cutoff: random.from(4, 20) });
      }
    }
  }
  return list;
}

/** Cells along a side: so many that the plane bends, so few that vertices cost nothing beside fragments. */
const CELLS = 24;
/** Reaches beyond the picture's corners at any aspect to 2.5. */
const HALF = 4;
const BEND = 0.02;

/** z = -BEND (x² + y²): every pixel has a point and a normal of its own, tilted by 18° at the most. */
export function bentPlane(): Triangles {
  const row = CELLS + 1;
  const positions = new Float32Array(row * row * 3);
  const normals = new Float32Array(row * row * 3);
  const indices = new Uint16Array(CELLS * CELLS * 6);
  for (let j = 0; j < row; j++) {
    for (let i = 0; i < row; i++) {
      const [x, y] = [HALF * ((2 * i) / CELLS - 1), HALF * ((2 * j) / CELLS - 1)];
      const normal = [2 * BEND * x, 2 * BEND * y, 1];
      const length = Math.hypot(...normal);
      positions.set([x, y, -BEND * (x * x + y * y)], (j * row + i) * 3);
      normals.set(
        normal.map((n) => n / length),
        (j * row + i) * 3,
      );
    }
  }
  for (let j = 0; j < CELLS; j++) {
    for (let i = 0; i < CELLS; i++) {
      const a = j * row + i;
      indices.set([a, a + 1, a + row + 1, a, a + row + 1, a + row], (j * CELLS + i) * 6);
    }
  }
  return { positions, normals, indices };
}
