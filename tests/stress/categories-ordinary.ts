// Scenes as people write them, and the same pushed to the ends of what their attributes can hold.
import { LARGEST_MILD_POWER } from '../../src/light/precision.js';
import type { LightValues } from '../../src/light/light-state.js';
import { add, normalize, scale, subtract, type Vec3 } from '../../src/math/vector.js';
import { lightWith, type StressCase, type Variant } from './case.js';
import { categories, type Category, LINEAR } from './category.js';
import { BOUNDS } from './contract.js';
import {
  anyLight,
  chordAngle,
  colors,
  direction,
  highlight,
  moved,
  place,
  scaled,
  seen,
  stressCase,
  surface,
  white,
  WHITE,
} from './fragments.js';
import type { Random } from './random.js';

/** One to three lights of any kind, a surface of any kind. */
function generic(random: Random): StressCase {
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
const mildExponent = (random: Random, most: number): number =>
  random.chance(0.5) ? random.from(1, most) : Math.ceil(random.from(0, most));

/** In and around a highlight, under a spot near its axis: the errors of both powers add up. */
function mildPowers(random: Random, variant: Variant): StressCase {
  const stress = highlight(random, mildExponent(random, random.pick([64, LARGEST_MILD_POWER])), variant);
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
function grazing(random: Random): StressCase {
  const fragment = seen(random);
  const off = random.sign() * random.magnitude(1e-6, 1e-2);
  const L = random.around(fragment.N, Math.PI / 2 - off);
  const light = { ambient: random.color(50), diffuse: WHITE, specular: random.color() };
  const position = random.chance(0.5) ? direction(L) : place(add(fragment.p, scale(L, random.from(0.5, 4))));
  return stressCase(fragment, white(random.pick([1, 2, 32])), [lightWith({ ...light, position })]);
}

/** The light is behind the surface, and perhaps its back is turned as well. */
function behind(random: Random): StressCase {
  const fragment = seen(random);
  const L = scale(random.around(fragment.N, random.from(0, 1.56)), -1);
  const light = { ...colors(random, 512), position: place(add(fragment.p, scale(L, random.from(0.1, 6)))) };
  const axis = random.around(L, random.from(0, 1));
  const spot = random.chance(0.5) ? { axis, cutoff: random.from(0, 20) } : {};
  return stressCase(fragment, surface(random, random.from(0, 64)), [lightWith({ ...light, ...spot })]);
}

/** A light so near that its and the fragment's coordinates have few digits left between them. */
function near(random: Random): StressCase {
  const fragment = seen(random);
  const L = random.around(fragment.N, random.from(0, 1.57));
  const position = place(add(fragment.p, scale(L, random.magnitude(0.03, 0.3))));
  const light = lightWith({ ...colors(random), position, attenuation: random.vector(0, 2) });
  return stressCase(fragment, surface(random, random.pick([1, 8, 32])), [light]);
}

/** Attenuation from nothing to its largest, at distances from near to far. */
function attenuated(random: Random): StressCase {
  const fragment = seen(random);
  const constant = random.pick([0, 1, random.magnitude(1e-3, 1e6), 1e6]);
  const falling = (): number => random.pick([0, random.magnitude(1e-6, 1e6), random.from(0, 1), 1e6]);
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

const shininessTo = (most: '1e4' | '1e5' | '1e6'): Pick<Category, 'title' | 'bound' | 'make'> => ({
  title: `shininess to ${most}, in and around the highlight`,
  bound: BOUNDS[`shininess${most}`],
  make: (random, variant) => highlight(random, random.magnitude(Number(most) / 10, Number(most)), variant),
});

export const ordinaryCategories = categories({
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
      highlight(random, random.pick([0, 1e-7, 1e-6, random.magnitude(1e-6, 1), random.from(0, 1)]), variant),
  },
  'shininess-1e3': {
    title: 'shininess from 1 to 1,000, in and around the highlight',
    bound: BOUNDS.mildPower,
    make: (random, variant) => highlight(random, random.magnitude(1, 1e3), variant),
  },
  'shininess-1e4': shininessTo('1e4'),
  'shininess-1e5': shininessTo('1e5'),
  'shininess-1e6': shininessTo('1e6'),
  'mild-powers': {
    title: 'shininess to 200 and cutoff to 64 at once, in and around the highlight, near the axis',
    bound: BOUNDS.mildPower,
    make: mildPowers,
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
});
