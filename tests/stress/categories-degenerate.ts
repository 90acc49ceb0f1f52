// Input that has no direction, no size or no number: lights at the fragment, vectors of zero, normals of any length,
// and whatever can be written into an attribute.
import { SURFACE_FIELDS, type SurfaceValues } from '../../src/material/material-values.js';
import { LIGHT_FIELDS, type LightValues } from '../../src/light/light-state.js';
import type { Field } from '../../src/fields/field.js';
import { parseText } from '../../src/element/fields/attribute-text.js';
import { add, scale, type Vec3 } from '../../src/math/vector.js';
import { lightWith, ORIGIN, type StressCase } from './case.js';
import { categories } from './category.js';
import { BOUNDS } from './contract.js';
import { anyLight, colors, direction, place, seen, shortNormal, stressCase, surface } from './fragments.js';
import { float32, type Random } from './random.js';

/** A light, perhaps a spot, at the fragment or no farther than float32 tells apart from it. */
function atFragment(random: Random): StressCase {
  const fragment = seen(random);
  // At the origin float32 holds 1e-15 and less; elsewhere such a distance rounds to nothing.
  const p = random.chance(0.5) ? ORIGIN : fragment.p;
  const off = random.chance(0.3) ? 0 : random.magnitude(1e-30, 0.9e-15);
  const position = place(add(p, scale(random.unit(), off)));
  const spot = random.chance(0.5) ? { axis: random.unit(), aperture: random.from(0, 180), cutoff: 1e6 } : {};
  const light = lightWith({ ...colors(random), position, attenuation: random.vector(0, 2), ...spot });
  return stressCase({ ...fragment, p }, surface(random, random.from(0, 64)), [light]);
}

/** A directional light that points nowhere, beside one that does. */
function directionless(random: Random): StressCase {
  const fragment = seen(random);
  const nowhere = lightWith({ ...colors(random), position: [0, 0, 0, 0], aperture: random.from(0, 180) });
  return stressCase(fragment, surface(random, random.from(0, 64)), [
    nowhere,
    anyLight(random, fragment.p, colors(random)),
  ]);
}

/** A directional light of any length, down to the smallest double. */
function directionOfAnyLength(random: Random): StressCase {
  const fragment = seen(random);
  const size = random.pick([5e-324, 1e-300, 1e-40, 1e-15, 1e15 / 2]);
  const position = direction(scale(random.around(fragment.N, random.from(0, 1.5)), size));
  return stressCase(fragment, surface(random, random.from(1, 64)), [lightWith({ ...colors(random), position })]);
}

/**
 * The eye looks straight into the light from behind the fragment: L + V is zero, and Blinn's half vector has no
 * direction.
 */
function opposite(random: Random): StressCase {
  const L = random.pick(AXES.slice(0, 3));
  const normal = shortNormal(random, random.around(L, random.from(0, 1.5)));
  const p: Vec3 = [random.pick([-1, 0, 2]), random.pick([-2, 0, 1]), random.pick([-1, 0, 1])];
  const eye = add(p, scale(L, -random.pick([0.5, 1, 3, 4])));
  const light = lightWith({ ...colors(random), position: direction(scale(L, random.magnitude(0.1, 10))) });
  return stressCase({ p, normal, eye }, surface(random, random.from(0, 64)), [light]);
}

const SMALLEST = 2 ** -149;

/** Interpolated normals that cancel, vanish or overflow. */
function normals(random: Random): StressCase {
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
const NUMBERS = [NaN, Infinity, -Infinity, -0, 5e-324, 1e-310, 1e15, 1.0000001e15, 1e6, 180, -1, 0, 1];

/** What stands after this was written into the attribute, or into the property: the value, or the default. */
function written<T>(random: Random, field: Field<T>): T {
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
function anything(random: Random): StressCase {
  const fragment = seen(random);
  const values: Partial<Record<keyof LightValues, unknown>> = colors(random);
  for (const key of LIGHT_KEYS) if (random.chance(0.5)) values[key] = written<unknown>(random, LIGHT_FIELDS[key]);
  const worn: Partial<Record<keyof SurfaceValues, unknown>> = { ...surface(random, random.from(0, 64)) };
  for (const key of ['ka', 'kd', 'ks', 'shininess'] as const)
    if (random.chance(0.3)) worn[key] = written<unknown>(random, SURFACE_FIELDS[key]);
  return stressCase(fragment, worn as SurfaceValues, [lightWith(values as Partial<LightValues>)]);
}

export const degenerateCategories = categories({
  'light-at-fragment': { title: 'a light at the fragment, or within 1e-15 of it', make: atFragment },
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
