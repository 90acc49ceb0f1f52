// All adversarial categories: what each attacks, and the bound that the contract gives it.
import { Euler, Matrix3, Matrix4, Quaternion, Vector3 } from 'three';
import { parseText } from '../../src/phong/fields/attribute-text.js';
import type { Field } from '../../src/phong/fields/field.js';
import { LIGHT_FIELDS, type LightValues } from '../../src/phong/light/light-state.js';
import { LARGEST_MILD_POWER } from '../../src/phong/light/precision.js';
import { SURFACE_FIELDS, type SurfaceValues } from '../../src/phong/material/material-values.js';
import { normalMatrix } from '../../src/phong/material/normal-matrix.js';
import { radians } from '../../src/phong/math/angle.js';
import {
  add,
  cross,
  dot,
  normalize,
  scale,
  subtract,
  type Vec3,
} from '../../src/phong/math/vector.js';
import { lightWith, ORIGIN, type StressCase, type Variant } from './case.js';
import { BOUNDS } from './contract.js';
import {
  anyLight,
  chordAngle,
  colors,
  direction,
  highlight,
  moved,
  nearlyOpposite,
  openDistance,
  openPoint,
  place,
  scaled,
  seen,
  shortNormal,
  spotOver,
  straight,
  stressCase,
  surface,
  white,
  WHITE,
} from './fragments.js';
import { float32, type Random } from './random.js';

export interface Category {
  readonly id: string;
  /** What is drawn, as a noun phrase: it names the test, and the row of the published table. */
  readonly title: string;
  /** Largest error of the sum in 1/255, over max(1, the sum of intensities). */
  readonly bound: number;
  /** Programs that it runs through. */
  readonly variants: readonly Variant[];
  /** Lights that a fragment has, where they are many: such a category gets fewer fragments. */
  readonly lights?: number;
  readonly make: (random: Random, variant: Variant) => StressCase;
}

const PHONG: Variant = { reflection: 'phong', linear: false };
const BLINN: Variant = { reflection: 'blinn-phong', linear: false };
const BOTH: readonly Variant[] = [PHONG, BLINN];
const LINEAR: readonly Variant[] = BOTH.map(({ reflection }) => ({ reflection, linear: true }));

/**
 * Entries by id. Without a bound they have that of ordinary scenes, without programs they go
 * through `variants`.
 */
const categories = (
  entries: Readonly<Record<string, Partial<Category> & Pick<Category, 'title' | 'make'>>>,
  variants: readonly Variant[] = BOTH,
): readonly Category[] =>
  Object.entries(entries).map(([id, entry]) => ({ id, bound: BOUNDS.generic, variants, ...entry }));

// Scenes as people write them, and the same pushed to the ends of what their attributes can hold.

/** One to three lights of any kind, a surface of any kind. */
function generic(random: Random) {
  const fragment = seen(random);
  const count = random.pick([1, 2, 3]);
  const lights = Array.from({ length: count }, () => {
    const light = anyLight(random, fragment.p, colors(random, 255 / count));
    return random.chance(0.2) ? inCamera(light, fragment.eye) : light;
  });
  return stressCase(fragment, surface(random, random.pick([1, 2, 5, 32, 100])), lights);
}

/** The same light given in the eye's axes; the camera looks along −z from the eye. */
function inCamera(light: LightValues, eye: Vec3): LightValues {
  const [x, y, z, w] = light.position;
  const from: Vec3 = w === 1 ? subtract([x, y, z], eye) : [x, y, z];
  return { ...light, space: 'camera', position: [...from, w] };
}

/** Exponents as most scenes have them, whole ones among them. */
const mildExponent = (random: Random, most: number) =>
  random.chance(0.5) ? random.from(1, most) : Math.ceil(random.from(0, most));

/** In and around a highlight, under a spot near its axis: the errors of both powers add up. */
const mildPowers = (random: Random, variant: Variant) =>
  underSpot(
    random,
    highlight(random, mildExponent(random, random.pick([64, LARGEST_MILD_POWER])), variant),
  );

/** The same light as a spot, near its axis, where it is no direction. */
function underSpot(random: Random, stress: StressCase) {
  const light = stress.lights[0]!;
  if (light.position[3] === 0) return stress;
  const cutoff = mildExponent(random, 64);
  const [x, y, z] = light.position;
  const toFragment = normalize(subtract(stress.p, [x, y, z]));
  const axis = random.around(toFragment, chordAngle((2 * random.magnitude(1e-3, 30)) / cutoff));
  const aperture = random.chance(0.5) ? 180 : random.from(15, 165);
  return { ...stress, lights: [{ ...light, axis, aperture, cutoff }] };
}

/** Light that grazes the surface: NoL from −1e-2 to 1e-2. */
function grazing(random: Random) {
  const fragment = seen(random);
  const off = random.sign() * random.magnitude(1e-6, 1e-2);
  const L = random.around(fragment.N, Math.PI / 2 - off);
  const light = { ambient: random.color(50), diffuse: WHITE, specular: random.color() };
  const position = random.chance(0.5)
    ? direction(L)
    : place(add(fragment.p, scale(L, random.from(0.5, 4))));
  return stressCase(fragment, white(random.pick([1, 2, 32])), [lightWith({ ...light, position })]);
}

/** The light is behind the surface, and perhaps its back is turned as well. */
function behind(random: Random) {
  const fragment = seen(random);
  const L = scale(random.around(fragment.N, random.from(0, 1.56)), -1);
  const light = {
    ...colors(random, 512),
    position: place(add(fragment.p, scale(L, random.from(0.1, 6)))),
  };
  const axis = random.around(L, random.from(0, 1));
  const spot = random.chance(0.5) ? { axis, cutoff: random.from(0, 20) } : {};
  return stressCase(fragment, surface(random, random.from(0, 64)), [
    lightWith({ ...light, ...spot }),
  ]);
}

/** A light so near that its and the fragment's coordinates have few digits left between them. */
function near(random: Random) {
  const fragment = seen(random);
  const L = random.around(fragment.N, random.from(0, 1.57));
  const position = place(add(fragment.p, scale(L, random.magnitude(0.03, 0.3))));
  const light = lightWith({ ...colors(random), position, attenuation: random.vector(0, 2) });
  return stressCase(fragment, surface(random, random.pick([1, 8, 32])), [light]);
}

/** Attenuation from nothing to its largest, at distances from near to far. */
function attenuated(random: Random) {
  const fragment = seen(random);
  const constant = random.pick([0, 1, random.magnitude(1e-3, 1e6), 1e6]);
  const falling = () => random.pick([0, random.magnitude(1e-6, 1e6), random.from(0, 1), 1e6]);
  const attenuation: Vec3 = random.chance(0.2) ? [0, 0, 0] : [constant, falling(), falling()];
  const L = random.around(fragment.N, random.from(0, 1.5));
  const far = random.pick([0.1, 1, 10, 1e3, 1e6, 1e12]) * random.from(0.5, 2);
  const position = place(add(fragment.p, scale(L, far)));
  const light = lightWith({ ...colors(random, 510), position, attenuation });
  return stressCase(fragment, surface(random, random.from(1, 40)), [light]);
}

/** Lights far brighter than full, as far as colours go. */
function bright(random: Random): StressCase {
  const stress = generic(random);
  const factor = random.pick([40, 100, 1e4, 1e6]) / 255;
  const lights = stress.lights.map((light) => ({
    ...light,
    ambient: scale(light.ambient, factor),
    diffuse: scale(light.diffuse, factor),
    specular: scale(light.specular, factor),
  }));
  return { ...stress, lights };
}

/** Bright lights on bright materials; the fragment is anywhere about a spot, mostly behind it. */
function brightMaterial(random: Random) {
  const fragment = seen(random);
  const brightness = () => random.pick([255, 1e4, 1e6, random.magnitude(1, 1e6)]);
  const color = () => random.color(brightness());
  const angle = random.chance(0.7) ? Math.PI - random.magnitude(1e-6, 0.5) : random.from(0, 3);
  const light = spotOver(random, fragment.p, angle, {
    ambient: color(),
    diffuse: color(),
    specular: color(),
    cutoff: random.pick([1, 2, 4, random.from(1, 64)]),
  });
  const material = { ka: color(), kd: color(), ks: color(), shininess: random.from(1, 100) };
  return stressCase(fragment, material, [light]);
}

const shininessTo = (most: '1e4' | '1e5' | '1e6'): Pick<Category, 'title' | 'bound' | 'make'> => ({
  title: `shininess to ${most}, in and around the highlight`,
  bound: BOUNDS[`shininess${most}`],
  make: (random, variant) =>
    highlight(random, random.magnitude(Number(most) / 10, Number(most)), variant),
});

const ordinaryCategories = categories({
  generic: { title: 'any few lights on any surface', make: generic },
  linear: {
    title: 'the same in linear light',
    // The curve is 12.92 times as steep at black as the line, and so are errors there.
    variants: LINEAR,
    make: generic,
  },
  'shininess-0-1': {
    title: 'shininess from 0 to 1, exponents below 1e-6 included',
    bound: BOUNDS.smallExponent,
    make: (random, variant) =>
      highlight(
        random,
        random.pick([0, 1e-7, 1e-6, random.magnitude(1e-6, 1), random.from(0, 1)]),
        variant,
      ),
  },
  'shininess-1e3': {
    title: 'shininess from 1 to 1,000, in and around the highlight',
    bound: BOUNDS.mildPower,
    make: (random, variant) => highlight(random, random.magnitude(1, 1e3), variant),
  },
  'shininess-1e4': shininessTo('1e4'),
  'shininess-1e5': shininessTo('1e5'),
  'shininess-1e6': shininessTo('1e6'),
  ...Object.fromEntries(
    (['1e4', '1e5', '1e6'] as const).map((most) => [
      `half-${most}`,
      {
        title: `Blinn–Phong, shininess to ${most}, light and eye nearly opposite each other`,
        bound: BOUNDS[`shininess${most}`],
        variants: [BLINN],
        make: (random: Random) => nearlyOpposite(random, random.pick([1, 0.5]) * Number(most)),
      },
    ]),
  ),
  'mild-powers': {
    title: `shininess to ${LARGEST_MILD_POWER} and cutoff to 64 at once, in and around the highlight, near the axis`,
    bound: BOUNDS.mildPower,
    make: mildPowers,
  },
  straight: {
    title: `light, normal and eye in one line at their worst lengths, shininess to ${LARGEST_MILD_POWER}`,
    bound: BOUNDS.mildPower,
    make: (random) =>
      underSpot(
        random,
        straight(random, LARGEST_MILD_POWER * random.pick([1, random.from(0.5, 1)])),
      ),
  },
  grazing: { title: 'light that grazes the surface', make: grazing },
  behind: { title: 'fragments turned away from the light, and behind a spot', make: behind },
  'scene-scale': {
    title: 'scenes from 1e-6 to 1e8 of the usual size',
    make: (random) => scaled(generic(random), random.magnitude(1e-6, 1e8)),
  },
  'scene-offset': {
    title: 'scenes 1e4, 1e6 and 1e8 away from the origin',
    make: (random) => moved(random, generic(random), random.pick([1e4, 1e6, 1e8])),
  },
  near: { title: 'lights at a fiftieth of the distances that coordinates span', make: near },
  attenuation: { title: 'attenuation 0 0 0, huge, and at any distance', make: attenuated },
  bright: { title: 'lights up to 1e6 of 255', make: bright },
  'bright-material': {
    title: 'lights and materials up to 1e6 of 255, mostly behind a spot',
    make: brightMaterial,
  },
});

// Spots where cones and decays are weakest: on the axis, straight behind, at the edge, with no
// width, with no axis.

/**
 * A white spot at this angle off its axis to the fragment: ambient light shows its cone and decay
 * alone.
 */
function spot(random: Random, angle: number, values: Partial<LightValues>) {
  if (random.chance(0.3)) {
    const L = random.unit();
    const p = openPoint(random, L);
    const light = spotOver(random, p, angle, values, scale(L, openDistance(random)));
    return stressCase({ p, normal: p, eye: scale(p, 0.5) }, white(1), [light]);
  }
  const fragment = seen(random);
  return stressCase(fragment, white(1), [spotOver(random, fragment.p, angle, values)]);
}

/** cutoff·(1 - c)/2 from 1e-3, where the decay begins, to 30, where it has ended. */
function nearAxis(random: Random, least: number, largest: number) {
  const cutoff = random.magnitude(least, largest);
  return spot(random, chordAngle((2 * random.magnitude(1e-3, 30)) / cutoff), { cutoff });
}

/** Straight behind the spot, or up to 0.1 rad from there. */
function antipode(random: Random) {
  const off = random.chance(0.1) ? 0 : random.magnitude(1e-9, 0.1);
  const aperture = random.chance(0.5) ? 180 : random.from(175, 180);
  return spot(random, Math.PI - off, {
    aperture,
    cutoff: random.pick([0, 1, 2, random.from(1, 100)]),
  });
}

/** Without a cone everything passes, wherever it lies. */
function open(random: Random) {
  const angle = random.pick([0, Math.PI, random.from(0, Math.PI), random.magnitude(1e-9, 1)]);
  return spot(random, angle, { aperture: 180, cutoff: random.pick([0, 1e-7, random.from(1, 8)]) });
}

const WORLD_AXES: readonly Vec3[] = [
  [1, 0, 0],
  [-1, 0, 0],
  [0, 1, 0],
  [0, -1, 0],
  [0, 0, 1],
  [0, 0, -1],
];

/**
 * A cone of no width: fragments exactly on the axis, along the world's axes where doubles are
 * exact, or beside it.
 */
function widthless(random: Random) {
  if (random.chance(0.5)) {
    const off = random.magnitude(1e-5, Math.PI);
    return spot(random, off, { aperture: 0, cutoff: random.pick([0, 2]) });
  }
  const fragment = seen(random);
  const p: Vec3 = [Math.round(fragment.p[0]), Math.round(fragment.p[1]), Math.round(fragment.p[2])];
  const axis = random.pick(WORLD_AXES);
  const light = lightWith({
    ...colors(random),
    position: place(add(p, scale(axis, -random.pick([0.5, 1, 2, 8])))),
    axis: scale(axis, random.magnitude(0.1, 10)),
    aperture: 0,
  });
  return stressCase({ ...fragment, p }, surface(random, 4), [light]);
}

/** A cone at most half a degree wide, inside and outside of it. */
function narrow(random: Random) {
  const aperture = random.magnitude(1e-3, 0.5);
  const angle =
    radians(aperture) * random.pick([random.from(0, 1), random.from(1, 2), random.from(0, 20)]);
  return spot(random, angle, { aperture, cutoff: random.pick([0, 100]) });
}

/** To either side of the edge of a cone of any width, from 1e-8 to 1e-2 rad. */
function edge(random: Random) {
  const aperture = random.chance(0.3) ? random.from(0.01, 2) : random.from(0.01, 179.9);
  const off = random.sign() * random.magnitude(1e-8, 1e-2);
  const angle = Math.min(Math.max(radians(aperture) + off, 0), Math.PI);
  return spot(random, angle, { aperture });
}

/** No axis: neither cone nor decay, whatever they say. */
function axisless(random: Random) {
  const fragment = seen(random);
  const light = spotOver(random, fragment.p, 0, {
    ...colors(random),
    axis: [0, 0, 0],
    aperture: random.pick([0, 1, 90, 180]),
    cutoff: random.pick([0, 1, 1e6]),
  });
  return stressCase(fragment, surface(random, random.from(1, 100)), [light]);
}

/** An axis of any length from 1e-300 to 1e15. */
function axisOfAnyLength(random: Random) {
  const fragment = seen(random);
  const light = spotOver(random, fragment.p, random.from(0, 1), {
    aperture: 90,
    cutoff: 4,
    diffuse: WHITE,
  });
  const size = random.pick([1e-300, 5e-324, 1e-40, 1e-20, 1e15 / 11]);
  return stressCase(fragment, white(8), [{ ...light, axis: scale(light.axis, size) }]);
}

const spotCategories = categories(
  {
    'cutoff-0-1': {
      title: 'cutoff from 0 to 1, exponents below 1e-6 included',
      bound: BOUNDS.smallExponent,
      make: (random) => {
        const cutoff = random.pick([0, 1e-7, 1e-6, random.magnitude(1e-6, 1), random.from(0, 1)]);
        // From where the contract begins, 1e-3 rad from straight behind: there the base is all but
        // gone.
        const back = Math.PI - random.magnitude(1e-3, 0.1);
        return spot(
          random,
          random.pick([random.from(0, Math.PI), random.magnitude(1e-6, 1), back]),
          { cutoff },
        );
      },
    },
    'cutoff-1e4': {
      title: 'cutoff to 1e4, near the axis',
      bound: BOUNDS.cutoff1e4,
      make: (random) => nearAxis(random, 1, 1e4),
    },
    'cutoff-1e6': {
      title: 'cutoff to 1e6, near the axis',
      bound: BOUNDS.cutoff1e6,
      make: (random) => nearAxis(random, 1e4, 1e6),
    },
    antipode: { title: 'fragments straight behind a spot that shines all round', make: antipode },
    'aperture-180': { title: 'aperture 180, in every direction', make: open },
    'aperture-0': { title: 'aperture 0, on the axis and beside it', make: widthless },
    'aperture-narrow': { title: 'apertures below half a degree', make: narrow },
    'cone-edge': { title: 'the edge of a cone, from 5e-6 rad to either side', make: edge },
    'axis-zero': { title: 'a spot without an axis', variants: BOTH, make: axisless },
    'axis-length': { title: 'axes of any length from 5e-324 to 1e15', make: axisOfAnyLength },
  },
  [PHONG],
);

// Input that has no direction, no size or no number: lights at the fragment, vectors of zero,
// normals of any length, and whatever can be written into an attribute.

/** A light, perhaps a spot, at the fragment or no farther than float32 tells apart from it. */
function atFragment(random: Random) {
  const fragment = seen(random);
  // At the origin float32 holds 1e-15 and less; elsewhere such a distance rounds to nothing.
  const p = random.chance(0.5) ? ORIGIN : fragment.p;
  const off = random.chance(0.3) ? 0 : random.magnitude(1e-30, 0.9e-15);
  const position = place(add(p, scale(random.unit(), off)));
  const spot = random.chance(0.5)
    ? { axis: random.unit(), aperture: random.from(0, 180), cutoff: 1e6 }
    : {};
  const light = lightWith({
    ...colors(random),
    position,
    attenuation: random.vector(0, 2),
    ...spot,
  });
  return stressCase({ ...fragment, p }, surface(random, random.from(0, 64)), [light]);
}

/** A directional light that points nowhere, beside one that does. */
function directionless(random: Random) {
  const fragment = seen(random);
  const nowhere = lightWith({
    ...colors(random),
    position: [0, 0, 0, 0],
    aperture: random.from(0, 180),
  });
  return stressCase(fragment, surface(random, random.from(0, 64)), [
    nowhere,
    anyLight(random, fragment.p, colors(random)),
  ]);
}

/** A directional light of any length, down to the smallest double. */
function directionOfAnyLength(random: Random) {
  const fragment = seen(random);
  const size = random.pick([5e-324, 1e-300, 1e-40, 1e-15, 1e15 / 2]);
  const position = direction(scale(random.around(fragment.N, random.from(0, 1.5)), size));
  return stressCase(fragment, surface(random, random.from(1, 64)), [
    lightWith({ ...colors(random), position }),
  ]);
}

/**
 * The eye looks straight into the light from behind the fragment: L + V is zero, and Blinn's half
 * vector has no direction.
 */
function opposite(random: Random) {
  const L = random.pick(AXES.slice(0, 3));
  const normal = shortNormal(random, random.around(L, random.from(0, 1.5)));
  const p: Vec3 = [random.pick([-1, 0, 2]), random.pick([-2, 0, 1]), random.pick([-1, 0, 1])];
  const eye = add(p, scale(L, -random.pick([0.5, 1, 3, 4])));
  const light = lightWith({
    ...colors(random),
    position: direction(scale(L, random.magnitude(0.1, 10))),
  });
  return stressCase({ p, normal, eye }, surface(random, random.from(0, 64)), [light]);
}

const SMALLEST = 2 ** -149;

/** Interpolated normals that cancel, vanish or overflow. */
function normals(random: Random) {
  const fragment = seen(random);
  const size = random.pick([
    0,
    SMALLEST,
    random.magnitude(SMALLEST, 1.17e-38),
    random.magnitude(1.2e-38, 1e-30),
    random.magnitude(1e-30, 1e-3),
    random.magnitude(1e3, 1e30),
    random.magnitude(1e30, 3e38),
    // The ends of the ranges that the shader scales by.
    2 ** -40,
    2 ** 60,
  ]);
  const normal = float32(scale(random.pick([fragment.N, random.pick(AXES)]), size));
  return stressCase({ ...fragment, normal }, surface(random, random.from(1, 64)), [
    anyLight(random, fragment.p, colors(random)),
  ]);
}

const AXES: readonly Vec3[] = [
  [1, 0, 0],
  [0, -1, 0],
  [0, 0, 1],
  [1, 1e-30, 0],
];

const TEXTS = 'NaN Infinity -Infinity 1e999 -1e999 -0 5e-324 1e-310 1e15 1e6'.split(' ').concat('');
const NUMBERS = [
  NaN,
  Infinity,
  -Infinity,
  -0,
  5e-324,
  1e-310,
  1e15,
  1.0000001e15,
  1e6,
  180,
  -1,
  0,
  1,
];

/**
 * What stands after this was written into the attribute, or into the property: the value, or the
 * default.
 */
function written<T>(random: Random, field: Field<T>) {
  const size = Array.isArray(field.fallback) ? field.fallback.length : 1;
  const asText = random.chance(0.5);
  const numbers = Array.from({ length: size }, () =>
    asText && random.chance(0.5) ? random.pick(TEXTS) : random.pick(NUMBERS),
  );
  try {
    if (asText) return field.check(parseText(numbers.map(String).join(' '), field));
    return field.check(size === 1 ? numbers[0] : numbers);
  } catch {
    return field.fallback;
  }
}

const LIGHT_KEYS = [
  ...(['ambient', 'diffuse', 'specular', 'position'] as const),
  ...(['axis', 'aperture', 'cutoff', 'attenuation'] as const),
];

/** Anything at all in every attribute of a light and a surface. */
function anything(random: Random) {
  const fragment = seen(random);
  const values: Partial<Record<keyof LightValues, unknown>> = colors(random);
  for (const key of LIGHT_KEYS) {
    if (random.chance(0.5)) {
      values[key] = written<unknown>(random, LIGHT_FIELDS[key]);
    }
  }
  const worn: Partial<Record<keyof SurfaceValues, unknown>> = {
    ...surface(random, random.from(0, 64)),
  };
  for (const key of ['ka', 'kd', 'ks', 'shininess'] as const) {
    if (random.chance(0.3)) {
      worn[key] = written<unknown>(random, SURFACE_FIELDS[key]);
    }
  }
  return stressCase(fragment, worn as SurfaceValues, [lightWith(values as Partial<LightValues>)]);
}

const degenerateCategories = categories({
  'light-at-fragment': {
    title: 'a light at the fragment, or within 1e-15 of it',
    make: atFragment,
  },
  'direction-zero': { title: 'a directional light of zero length', make: directionless },
  'direction-length': {
    title: 'directional lights of any length from 5e-324 to 1e15',
    make: directionOfAnyLength,
  },
  opposite: { title: 'light and eye exactly opposite each other', make: opposite },
  normals: { title: 'zero, cancelling, denormal, tiny and huge normals', make: normals },
  anything: {
    title: 'NaN, infinities, −0, 1e999 and denormals written into attributes and properties',
    bound: BOUNDS.shininess1e6,
    make: anything,
  },
});

// Normals of meshes under any matrix: mirrored, flattened, sheared, scaled by 1e±12, through the
// shipped normal matrix.

const matrix3 = new Matrix3();

/** A mesh's matrix and a normal on it; `tangents` are two directions in the surface. */
function onMesh(random: Random, matrix: Matrix4): StressCase {
  const fragment = seen(random);
  const normal = float32(random.unit());
  const N = normalize(normal);
  const first = random.around(N, Math.PI / 2);
  normalMatrix(matrix, matrix3);
  return {
    ...stressCase({ ...fragment, normal }, surface(random, random.from(1, 64)), [
      anyLight(random, fragment.p, colors(random)),
    ]),
    normalMatrix: matrix3.elements.map(Math.fround),
    exactNormal: movedNormal(matrix, first, cross(N, first)),
  };
}

/**
 * The normal of a moved surface from what a normal is: across both moved tangents, which is the
 * cofactor matrix applied; a mirror turns the cross product round, and the determinant's sign turns
 * it back.
 */
function movedNormal(matrix: Matrix4, first: Vec3, second: Vec3): Vec3 {
  const e = matrix.elements;
  const largest = Math.max(...e.slice(0, 11).map(Math.abs));
  if (largest === 0) return [0, 0, 0];
  const column = (i: number): Vec3 => [e[i]! / largest, e[i + 1]! / largest, e[i + 2]! / largest];
  const [x, y, z] = [column(0), column(4), column(8)];
  const through = (v: Vec3): Vec3 =>
    [0, 1, 2].map((k) => x[k]! * v[0] + y[k]! * v[1] + z[k]! * v[2]) as never;
  const across = cross(through(first), through(second));
  return scale(normalize(across), dot(cross(x, y), z) < 0 ? -1 : 1);
}

function turned(random: Random, size: Vec3) {
  const turn = new Quaternion().setFromEuler(new Euler(...random.vector(-3, 3)));
  return new Matrix4().compose(new Vector3(), turn, new Vector3(...size));
}

const anySize = (random: Random) => random.sign() * random.magnitude(0.1, 10);

/** As a mesh element can place one: turned, and scaled by as much as attributes allow. */
function placed(random: Random): StressCase {
  const uniform = random.pick([1e-12, 1e12, 1, random.magnitude(1e-12, 1e12)]);
  const size: Vec3 = [
    uniform * anySize(random),
    uniform * anySize(random),
    uniform * anySize(random),
  ];
  return onMesh(random, turned(random, float32(size)));
}

/** Flattened along an axis, or nearly. */
function flattened(random: Random): StressCase {
  const size: [number, number, number] = [anySize(random), anySize(random), anySize(random)];
  size[random.pick([0, 1, 2])] = random.pick([0, 1e-12, -1e-12, 1e-6]);
  return onMesh(random, turned(random, size));
}

/**
 * One inside another, both scaled unevenly: the inner one's axes are no longer square to each
 * other.
 */
function sheared(random: Random): StressCase {
  const uneven = () => turned(random, [anySize(random), anySize(random), anySize(random)]);
  return onMesh(random, uneven().multiply(uneven()));
}

const meshCategories = categories({
  'mesh-scale': { title: 'meshes turned, mirrored and scaled, to 1e±12', make: placed },
  'mesh-flat': { title: 'meshes flattened along an axis', make: flattened },
  'mesh-shear': { title: 'meshes sheared by others that they are in', make: sheared },
});

// Many lights: fragments share a set of them, as those of a picture do.

/** Fragments that see the same lights. */
const SHARED_BY = 32;

function sum(count: number): Category['make'] {
  let lights: readonly LightValues[] = [];
  let left = 0;
  return (random: Random) => {
    const fragment = seen(random);
    if (left === 0) {
      left = SHARED_BY;
      // Together as bright as four full lights, so that a part of the fragments is not clamped.
      lights = Array.from({ length: count }, () =>
        anyLight(random, fragment.p, colors(random, 1020 / count)),
      );
    }
    left -= 1;
    return stressCase(fragment, surface(random, random.from(1, 100)), lights);
  };
}

const sumOf = (count: number) => ({
  title: `sums of ${count} lights`,
  lights: count,
  make: sum(count),
});

const sumCategories = categories(
  {
    'sum-1': { ...sumOf(1), title: 'one light' },
    'sum-8': sumOf(8),
    'sum-64': sumOf(64),
    'sum-512': sumOf(512),
    'sum-4096': sumOf(4096),
  },
  [PHONG],
);

export const CATEGORIES: readonly Category[] = [
  ...ordinaryCategories,
  ...spotCategories,
  ...degenerateCategories,
  ...meshCategories,
  ...sumCategories,
];
