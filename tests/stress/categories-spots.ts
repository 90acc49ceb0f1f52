// Spots where cones and decays are weakest: on the axis, straight behind, at the edge, with no width, with no axis.
import type { LightValues } from '../../src/light/light-state.js';
import { radians } from '../../src/math/angle.js';
import { add, scale, type Vec3 } from '../../src/math/vector.js';
import { lightWith, type StressCase } from './case.js';
import { BOTH, categories, PHONG } from './category.js';
import { BOUNDS } from './contract.js';
import { chordAngle, colors, place, seen, spotOver, stressCase, surface, white, WHITE } from './fragments.js';
import type { Random } from './random.js';

/** A white spot at this angle off its axis to the fragment: ambient light shows its cone and decay alone. */
function spot(random: Random, angle: number, values: Partial<LightValues>): StressCase {
  const fragment = seen(random);
  return stressCase(fragment, white(1), [spotOver(random, fragment.p, angle, values)]);
}

/** cutoff·(1 - c)/2 from 1e-3, where the decay begins, to 30, where it has ended. */
function nearAxis(random: Random, least: number, largest: number): StressCase {
  const cutoff = random.magnitude(least, largest);
  return spot(random, chordAngle((2 * random.magnitude(1e-3, 30)) / cutoff), { cutoff });
}

/** Straight behind the spot, or up to 0.1 rad from there. */
function antipode(random: Random): StressCase {
  const off = random.chance(0.1) ? 0 : random.magnitude(1e-9, 0.1);
  const aperture = random.chance(0.5) ? 180 : random.from(175, 180);
  return spot(random, Math.PI - off, { aperture, cutoff: random.pick([0, 1, 2, random.from(1, 100)]) });
}

/** Without a cone everything passes, wherever it lies. */
function open(random: Random): StressCase {
  const angle = random.pick([0, Math.PI, random.from(0, Math.PI), random.magnitude(1e-9, 1)]);
  return spot(random, angle, { aperture: 180, cutoff: random.pick([0, 1e-7, random.from(1, 8)]) });
}

const AXES: readonly Vec3[] = [
  [1, 0, 0],
  [-1, 0, 0],
  [0, 1, 0],
  [0, -1, 0],
  [0, 0, 1],
  [0, 0, -1],
];

/** A cone of no width: fragments exactly on the axis, along the world's axes where doubles are exact, or beside it. */
function widthless(random: Random): StressCase {
  if (random.chance(0.5)) {
    const off = random.magnitude(1e-5, Math.PI);
    return spot(random, off, { aperture: 0, cutoff: random.pick([0, 2]) });
  }
  const fragment = seen(random);
  const p: Vec3 = [Math.round(fragment.p[0]), Math.round(fragment.p[1]), Math.round(fragment.p[2])];
  const axis = random.pick(AXES);
  const light = lightWith({
    ...colors(random),
    position: place(add(p, scale(axis, -random.pick([0.5, 1, 2, 8])))),
    axis: scale(axis, random.magnitude(0.1, 10)),
    aperture: 0,
  });
  return stressCase({ ...fragment, p }, surface(random, 4), [light]);
}

/** A cone at most half a degree wide, inside and outside of it. */
function narrow(random: Random): StressCase {
  const aperture = random.magnitude(1e-3, 0.5);
  const angle = radians(aperture) * random.pick([random.from(0, 1), random.from(1, 2), random.from(0, 20)]);
  return spot(random, angle, { aperture, cutoff: random.pick([0, 100]) });
}

/** To either side of the edge of a cone of any width, from 1e-8 to 1e-2 rad. */
function edge(random: Random): StressCase {
  const aperture = random.chance(0.3) ? random.from(0.01, 2) : random.from(0.01, 179.9);
  const off = random.sign() * random.magnitude(1e-8, 1e-2);
  const angle = Math.min(Math.max(radians(aperture) + off, 0), Math.PI);
  return spot(random, angle, { aperture });
}

/** No axis: neither cone nor decay, whatever they say. */
function axisless(random: Random): StressCase {
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
function axisOfAnyLength(random: Random): StressCase {
  const fragment = seen(random);
  const light = spotOver(random, fragment.p, random.from(0, 1), { aperture: 90, cutoff: 4, diffuse: WHITE });
  const size = random.pick([1e-300, 5e-324, 1e-40, 1e-20, 1e15 / 11]);
  return stressCase(fragment, white(8), [{ ...light, axis: scale(light.axis, size) }]);
}

export const spotCategories = categories(
  {
    'cutoff-0-1': {
      title: 'cutoff from 0 to 1, exponents below 1e-6 included',
      bound: BOUNDS.smallExponent,
      make: (random) => {
        const cutoff = random.pick([0, 1e-7, 1e-6, random.magnitude(1e-6, 1), random.from(0, 1)]);
        // From where the contract begins, 1e-3 rad from straight behind: there the base is all but gone.
        const back = Math.PI - random.magnitude(1e-3, 0.1);
        return spot(random, random.pick([random.from(0, Math.PI), random.magnitude(1e-6, 1), back]), {
          cutoff,
        });
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
