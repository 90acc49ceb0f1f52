// What the loops are measured on: a bent floor under an eye, its points and normals exact in float32, under lights of every
// kind. Lengths in scene units, colours of 255, as the element has them.
import { LightState, type LightValues } from '../../../src/light/light-state.js';
import type { Vec3 } from '../../../src/math/vector.js';
import { Random } from '../../stress/random.js';
import { lightsOf, type SceneQuery } from '../pages/scenes.js';

export interface FloorScene {
  readonly title: string;
  /** FieldStore: inactive ones too. */
  readonly lights: readonly LightValues[];
  readonly shininess: number;
  readonly eye: Vec3;
  /** Half of the picture's height in scene units: a power of two. */
  readonly half: number;
}

/** z = -BEND (x² + y²): a power of two, so that places on a grid of powers of two are exact. */
export const BEND = 2 ** -6;

const light = (values: Partial<LightValues>): LightValues => new LightState(values).values;

const spread = (query: Omit<SceneQuery, 'seed'>, seed: number): LightValues[] =>
  lightsOf({ ...query, seed }).map(light);

const all = (lights: number, kind: SceneQuery['kind'] = 'mixed') => ({ lights, active: lights, kind });

const ABOVE: Vec3 = [0, 0, 3];

/** Cones whose edges lie in the picture, with any cutoff. */
function spots(count: number, seed: number): LightValues[] {
  const random = new Random(seed);
  return spread(all(count, 'spot'), seed).map((each) => ({
    ...each,
    axis: [random.from(-0.3, 0.3) - each.position[0], random.from(-0.3, 0.3) - each.position[1], -4],
    aperture: random.from(8, 18),
    cutoff: random.from(0.5, 40),
  }));
}

/** Spots that look straight down, each on about a hundredth of what the picture shows. */
function smallSpots(count: number, seed: number): LightValues[] {
  const random = new Random(seed);
  const [half, height] = [4, 1.5];
  const radius = half * Math.sqrt((4 * 0.01) / Math.PI);
  const aperture = (Math.atan2(radius, height) * 180) / Math.PI;
  return Array.from({ length: count }, () => {
    const [x, y] = [random.from(-half, half), random.from(-half, half)];
    const color = (): Vec3 => [random.from(20, 90), random.from(20, 90), random.from(20, 90)];
    return light({
      ...{ position: [x, y, height, 1], axis: [0, 0, -1], aperture, cutoff: random.from(0.5, 40) },
      ...{ diffuse: color(), specular: color(), attenuation: [1, 0.1, 0.05] },
    });
  });
}

/** A light of each kind whose highlights all lie in the middle, within their own width of each other. */
function oneHighlight(shininess: number, seed: number): FloorScene {
  const random = new Random(seed);
  const width = 1 / Math.sqrt(shininess);
  const mirrored = (): Vec3 => {
    const off = (): number => random.from(-0.5, 0.5) * Math.min(width, 0.3);
    return [-1 + off(), off(), 3];
  };
  const grey: Vec3 = [100, 100, 100];
  const common = { diffuse: [40, 40, 40] as Vec3, specular: grey };
  const [a, b, c] = [mirrored(), mirrored(), mirrored()];
  return {
    title: `three lights, one highlight, shininess ${shininess.toLocaleString('en')}`,
    lights: [
      light({ ...common, position: [...a, 0] }),
      light({ ...common, position: [...b, 1], attenuation: [1, 0.05, 0.01] }),
      light({ ...common, position: [...c, 1], axis: [-c[0], -c[1], -c[2]], aperture: 40, cutoff: 12 }),
    ],
    shininess,
    eye: [1, 0, 3],
    // Six widths across: the highlight and its rim.
    half: Math.min(2 ** Math.round(Math.log2(6 * width)), 1),
  };
}

/** So many lights of mixed kinds over an ordinary floor. */
export const floorUnder = (count: number, seed: number): FloorScene => ({
  ...{ title: `${String(count)} lights of mixed kinds`, lights: spread(all(count), seed), shininess: 32 },
  ...{ eye: ABOVE, half: 1 },
});

export const FLOOR_SCENES: Readonly<Record<string, (seed: number) => FloorScene>> = {
  '1 directional': (seed) => ({
    ...{ title: '1 directional light', lights: spread(all(1, 'directional'), seed), shininess: 32 },
    ...{ eye: ABOVE, half: 1 },
  }),
  '8 mixed': (seed) => floorUnder(8, seed),
  '8 spots': (seed) => ({
    ...{ title: '8 spots with their edges in the picture', lights: spots(8, seed), shininess: 32 },
    ...{ eye: ABOVE, half: 1 },
  }),
  '32 mixed': (seed) => floorUnder(32, seed),
  '1 of 32 active': (seed) => ({
    title: '32 lights of which 1 is active',
    lights: spread({ lights: 32, active: 1, kind: 'mixed' }, seed),
    ...{ shininess: 32, eye: ABOVE, half: 1 },
  }),
  '500 small spots': (seed) => ({
    title: '500 small spots, each on a hundredth of the floor',
    lights: smallSpots(500, seed),
    ...{ shininess: 32, eye: [0, 0, 10], half: 4 },
  }),
  'shininess 1': (seed) => oneHighlight(1, seed),
  'shininess 32': (seed) => oneHighlight(32, seed),
  'shininess 1e3': (seed) => oneHighlight(1e3, seed),
  'shininess 1e5': (seed) => oneHighlight(1e5, seed),
};
