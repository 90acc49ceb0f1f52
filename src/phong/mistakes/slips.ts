// Slips in an answer that is a number: what somebody types who leaves a factor out, stops early, or
// takes an angle for its cosine. The same entries as usual mistakes, with steps of the same equation;
// a picture shows none of them, so the check of a learner's function leaves them out.
import { radians } from '../math/angle.js';
import { TERMS } from '../light/light-state.js';
import { clamp, scale, type Vec3 } from '../math/vector.js';
import {
  type Form,
  mistakeTable,
  termScaled,
  unraised,
  WITHOUT_LIGHT,
  WITHOUT_MATERIAL,
} from './mistakes.js';
import { eachTerm, type Given, power, RIGHT, type Values } from './steps.js';

const degreesOf = (cosine: number) => Math.acos(clamp(cosine, -1, 1)) / radians(1);

const sineOf = (cosine: number) => Math.sqrt(Math.max(1 - cosine * cosine, 0));

const grey = (x: number): Vec3 => [x, x, x];

/** The cosine of each term replaced by a function of the right one. */
const cosines = (wrong: (cosine: number) => number): readonly Form[] => [
  { lambert: ({ NoL }) => wrong(NoL) },
  { lobe: ({ cosine }, { material }) => power(wrong(cosine), material.shininess) },
];

/** Without cone and decay: the number that is typed is only a part of the term. */
const alone = (form: Form): Form => ({
  ...form,
  shares: () => eachTerm(() => 1),
});

const LEFT_OUT = 'That is the value without {factor}.';
const INSTEAD = 'That is the value with {wrong} in place of {right}.';
const ALONE = 'That is {factor} alone.';

export const SLIPS = mistakeTable({
  'without-coefficient': {
    sentence: LEFT_OUT,
    forms: WITHOUT_MATERIAL,
  },
  'without-intensity': {
    sentence: LEFT_OUT,
    forms: WITHOUT_LIGHT,
  },
  'without-att': { sentence: LEFT_OUT, forms: [{ att: () => 1 }] },
  'without-decay': { sentence: LEFT_OUT, forms: [{ decay: () => 1 }] },
  'without-cosine': { sentence: LEFT_OUT, forms: [{ lambert: () => 1 }, { spec: () => 1 }] },
  'without-exponent': {
    sentence: 'That is the value without the exponent {n}.',
    forms: [unraised],
  },
  angle: {
    sentence: '{cosine} is a cosine: the angle is {angle}.',
    forms: [
      ...cosines(degreesOf),
      ...cosines((cosine) => radians(degreesOf(cosine))),
      alone({ diffuse: ({ NoL }) => grey(degreesOf(NoL)) }),
      alone({ specular: ({ cosine }) => grey(degreesOf(cosine)) }),
    ],
  },
  radians: {
    sentence: 'That is the cosine of {angle} radians; the angle is in degrees.',
    forms: [
      { lambert: ({ NoL }) => Math.cos(degreesOf(NoL)) },
      {
        // A negative cosine keeps its sign where the exponent is whole.
        lobe: ({ cosine }, { material: { shininess } }) =>
          shininess === 0 ? 1 : Math.cos(degreesOf(cosine)) ** shininess,
      },
    ],
  },
  sine: { sentence: INSTEAD, forms: cosines(sineOf) },
  'lambert-for-lobe': {
    sentence: INSTEAD,
    forms: [{ lobe: ({ NoL }, { material }) => power(NoL, material.shininess) }],
  },
  'att-inverted': {
    sentence: INSTEAD,
    forms: [{ att: (so, given) => 1 / RIGHT.att(so, given) }],
  },
  'cosine-alone': {
    sentence: ALONE,
    forms: [
      alone({ diffuse: ({ lambert }) => grey(lambert) }),
      alone({ specular: ({ spec }) => grey(spec) }),
    ],
  },
  'coefficient-alone': {
    sentence: ALONE,
    forms: [
      alone({ ambient: (_, { material }) => material.ka }),
      alone({ diffuse: (_, { material }) => material.kd }),
      alone({ specular: (_, { material }) => material.ks }),
    ],
  },
  'code-for-number': {
    sentence: 'Here 1 is full, not {number}.',
    forms: [
      ...TERMS.map((term) =>
        alone({ [term]: (_: Values, { light }: Given) => scale(light[term], 255) }),
      ),
      ...TERMS.map((term) => termScaled(term, 255)),
      { full: () => 255 * 255 },
    ],
  },
});

export type SlipId = keyof typeof SLIPS;

/** A factor or a term is left out: likelier than any other mistake. */
export const isLeftOut = (id: string): boolean => id === 'left-out' || id.startsWith('without-');
