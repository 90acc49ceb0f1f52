// The usual mistakes in Phong's equation, one entry each: the steps that are written wrongly, in
// the forms in which people make them, and the sentence that says what is wrong. A sentence fits
// all forms of its mistake: up or down, one factor or all.
import { falloff, type Term, TERMS } from '../light/light-state.js';
import { radians } from '../math/angle.js';
import {
  add,
  clamp,
  dot,
  length,
  negate,
  normalize,
  scale,
  subtract,
  type Vec3,
} from '../math/vector.js';
import {
  angleOf,
  BLACK,
  eachTerm,
  type Given,
  isPositional,
  NoH,
  placeOf,
  power,
  RIGHT,
  RoV,
  type Steps,
  type Values,
} from './steps.js';

/** Steps in place of the right ones. */
export type Form = Partial<Steps>;

export interface Mistake<Sentence extends string = string> {
  /** A key of `texts`. */
  readonly sentence: Sentence;
  readonly forms: readonly Form[];
}

/** The attenuation with another sum in its denominator. */
const attenuated = (
  denominator: (so: Readonly<Values>, given: Given) => number,
): Pick<Steps, 'att'> => ({
  att: (so, given) => (isPositional(given) ? 1 / denominator(so, given) : 1),
});

/** kc + kl·d + kq·d, or with 2d for d². */
const unsquared = ({ d }: Readonly<Values>, { light: { attenuation: k } }: Given, by = 1) =>
  k[0] + (k[1] + by * k[2]) * d;

/** The cone with its edge at another angle, in radians, found by the angle or by its cosine. */
const coned = (
  edgeOf: (aperture: number) => number,
  // 180 degrees are no cone, or an edge like others.
  withoutCone: readonly number[] = [180, Infinity],
): readonly Form[] =>
  [true, false].flatMap((isCosine) =>
    withoutCone.map((none): Form => ({
      isInside: ({ L }, { light }) => {
        const angle = angleOf({ L, A: normalize(light.axis) });
        const edge = edgeOf(light.aperture);
        return (
          light.aperture >= none || (isCosine ? Math.cos(angle) >= Math.cos(edge) : angle <= edge)
        );
      },
    })),
  );

/**
 * The cone by the cosine of two vectors, which their lengths change. 180 degrees are no cone, or an
 * edge like others.
 */
const byCosine = (
  vectors: (so: Readonly<Values>, given: Given) => readonly [toLight: Vec3, axis: Vec3],
): readonly Form[] =>
  [180, Infinity].map((none): Form => ({
    isInside: (so, given) => {
      const { aperture } = given.light;
      const [toLight, axis] = vectors(so, given);
      return aperture >= none || dot(toLight, negate(axis)) >= Math.cos(radians(aperture));
    },
  }));

/** What cone and decay leave of each term. */
const shared = (of: (term: Term, so: Readonly<Values>) => number): Pick<Steps, 'shares'> => ({
  shares: (so) => eachTerm((term) => of(term, so)),
});

/** Terms that cone or decay may be left out of, besides the ambient one alone. */
const SOME_TERMS: readonly (readonly Term[])[] = [
  ['diffuse'],
  ['specular'],
  ['ambient', 'diffuse'],
  ['ambient', 'specular'],
  ['diffuse', 'specular'],
];

/** Each alone, and both at once. */
const alsoTogether = (a: Form, b: Form): readonly Form[] => [a, b, { ...a, ...b }];

/** Cosines may be kept below 1: some cosines of long vectors are above it. */
const capped: readonly Form[] = [
  {},
  ...alsoTogether(
    { lambert: ({ NoL }) => clamp(NoL, 0, 1) },
    { lobe: ({ cosine }, { material }) => power(clamp(cosine, 0, 1), material.shininess) },
  ),
];

const absoluteLambert: Form = { lambert: ({ NoL }) => Math.abs(NoL) };
const ungated: Form = { spec: ({ lobe }) => lobe };
const halved = (NoL: number) => 0.5 * NoL + 0.5;
const raisedLambert: Form = { lambert: ({ NoL }, { material }) => power(NoL, material.shininess) };

const longLightCones = byCosine(({ toLight }, { light }) => [toLight, normalize(light.axis)]);
const longAxisCones = byCosine(({ L }, { light }) => [L, light.axis]);

const reversedLambert: Form = { lambert: ({ NoL }) => Math.max(-NoL, 0) };

/**
 * Every position is a direction. These are few, and do not tell one edge of a cone from another: as
 * the cone stands here, no pair has another one.
 */
const allDirections: Form = {
  toLight: (_, given) => placeOf(given),
  isInside: RIGHT.isInside,
};
/** The attenuation does not ask whether the light is a place. */
const attenuatedAtAll: Form = { att: ({ d }, { light }) => 1 / Math.max(falloff(light, d), 1) };

/** L as long as the way to the light, under some lights. */
const longUnder = (isMeant: (given: Given) => boolean): Form => ({
  L: (so, given) => (isMeant(given) ? so.toLight : RIGHT.L(so, given)),
});

/** With the exponent that makes the highlight about as large as with the other cosine. */
const asLarge = (asked: Given['reflection'], by: number): Form => ({
  lobe: ({ cosine }, { material, reflection }) =>
    power(cosine, material.shininess * (reflection === asked ? by : 1)),
});

/** One term times a number. */
export const termScaled = (term: Term, by: number): Form => ({
  [term]: (so: Readonly<Values>, given: Given) => scale(RIGHT[term](so, given), by),
});

type Colors = Given['material'] & Given['light'];

/** Each term of the equation with other colours. */
const withColors = (othersOf: (own: Colors) => Partial<Colors>): readonly Form[] =>
  TERMS.map((term): Form => ({
    [term]: (so: Readonly<Values>, given: Given) => {
      const { material, light } = given;
      const others = othersOf({ ...material, ...light });
      return RIGHT[term](so, {
        ...given,
        material: { ...material, ...others },
        light: { ...light, ...others },
      });
    },
  }));

/** In all terms. */
const together = (terms: readonly Form[]) => Object.assign({}, ...terms) as Form;

const WHITE: Vec3 = [1, 1, 1];
const WHITE_MATERIAL = { ka: WHITE, kd: WHITE, ks: WHITE };

export const WITHOUT_MATERIAL = withColors(() => WHITE_MATERIAL);

export const WITHOUT_LIGHT = withColors(() => eachTerm(() => WHITE));

const COLORS_ADDED = withColors(({ ka, kd, ks, ambient, diffuse, specular }) => ({
  ...WHITE_MATERIAL,
  ambient: add(ka, ambient),
  diffuse: add(kd, diffuse),
  specular: add(ks, specular),
}));

/** Colours of another term. */
const EXCHANGED = [
  ...withColors(({ kd, ks }) => ({ ka: kd, kd: ks, ks: kd })),
  ...withColors(({ diffuse, specular }) => ({
    ambient: diffuse,
    diffuse: specular,
    specular: diffuse,
  })),
];

/** The cosine itself in place of its power. */
export const unraised: Form = { lobe: ({ cosine }) => Math.max(cosine, 0) };

/** A table's type without its functions: the package's types would repeat each of them. */
export const mistakeTable = <Id extends string, Sentence extends string>(
  mistakes: Readonly<Record<Id, Mistake<Sentence>>>,
) => mistakes;

export const MISTAKES = mistakeTable({
  'no-clamp': {
    sentence: 'N·L is not clamped at 0: negative light is subtracted on the far side.',
    forms: [{ lambert: ({ NoL }) => NoL }],
  },
  'no-gate': {
    sentence: 'The highlight does not ask whether N·L is above 0: it shows on the far side too.',
    forms: [ungated],
  },
  'abs-for-max': {
    sentence: 'abs(…) is not max(…, 0): the side away from the light is lit as well.',
    forms: [
      ...alsoTogether(absoluteLambert, {
        lobe: ({ cosine }, { material }) => power(Math.abs(cosine), material.shininess),
      }),
      { ...absoluteLambert, ...ungated },
    ],
  },
  'half-lambert': {
    sentence: 'N·L is moved from −1…1 to 0…1 (half Lambert) in place of max(N·L, 0).',
    forms: [
      { lambert: ({ NoL }) => halved(NoL) },
      { lambert: ({ NoL }) => halved(NoL) ** 2 },
      { lambert: ({ NoL }) => halved(NoL), ...ungated },
      // On the lit side only.
      { lambert: ({ NoL }) => (NoL > 0 ? halved(NoL) : 0) },
    ],
  },
  'normal-not-unit': {
    sentence: 'The normal is not normalized: an interpolated normal is shorter than 1.',
    forms: [
      { N: (_, { normal }) => normal },
      { lambert: ({ L }, { normal }) => Math.max(dot(normal, L), 0) },
      {
        cosine: ({ L, V }, { normal, reflection }) =>
          reflection === 'phong'
            ? dot(subtract(scale(normal, 2 * dot(normal, L)), L), V)
            : dot(normal, normalize(add(L, V))),
      },
    ],
  },
  'light-not-unit': {
    sentence: 'L is not normalized: its length counts in the cosine.',
    forms: [
      ...capped.flatMap((cap) => [
        // All lights, or places only.
        ...[() => true, isPositional].map(longUnder).flatMap((long) => [
          { ...long, ...cap },
          ...longLightCones.map((cone) => ({ ...long, ...cone, ...cap })),
          // All but the cosine of the spot.
          {
            ...long,
            c: ({ toLight, A }: Readonly<Values>) => dot(normalize(toLight), negate(A)),
            ...cap,
          },
        ]),
        // Directions only.
        { ...longUnder((given) => !isPositional(given)), ...cap },
      ]),
      { lambert: ({ N, toLight }) => Math.max(dot(N, toLight), 0) },
      {
        cosine: ({ N, V, toLight }, { reflection }) =>
          reflection === 'phong'
            ? dot(subtract(scale(N, 2 * dot(N, toLight)), toLight), V)
            : dot(N, normalize(add(toLight, V))),
      },
      ...longLightCones.flatMap((cone) =>
        alsoTogether({ c: ({ toLight, A }) => dot(toLight, negate(A)) }, cone),
      ),
    ],
  },
  'view-not-unit': {
    sentence: 'V is not normalized: the distance of the eye counts in the highlight.',
    forms: capped.map((cap) => ({
      V: (_: Readonly<Values>, { eye, p }: Given) => subtract(eye, p),
      ...cap,
    })),
  },
  'half-not-unit': {
    sentence: 'H is not normalized: its length counts in the cosine.',
    forms: [
      ...[1, 0.5].map((by): Form => ({ cosine: ({ N, L, V }) => by * dot(N, add(L, V)) })),
      { cosine: ({ N, L, V }) => clamp(dot(N, add(L, V)), 0, 1) },
    ],
  },
  'axis-not-unit': {
    sentence: "The spot's axis is not normalized: its length counts in the cosine.",
    forms: longAxisCones.flatMap((cone) =>
      // Some clamp the cosine.
      [1, Infinity].flatMap((most) =>
        alsoTogether(
          { c: ({ L }, { light }) => clamp(dot(L, negate(light.axis)), -most, most) },
          cone,
        ),
      ),
    ),
  },
  'view-reversed': {
    sentence:
      'V or R points the wrong way: the highlight is on the opposite side. reflect() takes −L.',
    forms: [{ cosine: (so, given) => RIGHT.cosine({ ...so, V: negate(so.V) }, given) }],
  },
  'light-reversed': {
    sentence: 'L, N or the axis points the wrong way: L goes from the point to the light.',
    forms: [
      ...alsoTogether(
        { L: (so, given) => negate(RIGHT.L(so, given)) },
        { A: (so, given) => negate(RIGHT.A(so, given)) },
      ),
      reversedLambert,
      { ...reversedLambert, spec: ({ NoL, lobe }) => (NoL < 0 ? lobe : 0) },
      // Places only, or directions only.
      ...[1, -1].map((sign): Form => ({
        L: (so, given) => scale(RIGHT.L(so, given), isPositional(given) ? -sign : sign),
      })),
      // The cone or the decay only.
      ...byCosine(({ L, A }) => [L, negate(A)]),
      { c: ({ L, A }) => dot(L, A) },
    ],
  },
  'eye-at-origin': {
    sentence: 'V lacks the eye, or p: V = eye − p.',
    forms: [{ V: (_, { p }) => normalize(negate(p)) }, { V: (_, { eye }) => normalize(eye) }],
  },
  'blinn-for-phong': {
    sentence: 'The highlight is N·H (Blinn–Phong) where R·V (Phong) is asked for.',
    forms: [{ cosine: NoH }, { cosine: NoH, ...asLarge('phong', 4) }],
  },
  'phong-for-blinn': {
    sentence: 'The highlight is R·V (Phong) where N·H (Blinn–Phong) is asked for.',
    forms: [{ cosine: RoV }, { cosine: RoV, ...asLarge('blinn-phong', 1 / 4) }],
  },
  'times-for-power': {
    sentence: 'The exponent is multiplied by, or missing: the cosine is raised to it.',
    forms: [
      { lobe: ({ cosine }, { material }) => Math.max(cosine, 0) * material.shininess },
      unraised,
    ],
  },
  'exponent-on-diffuse': {
    sentence: 'The diffuse term is raised to the exponent: only the highlight has one.',
    forms: [
      raisedLambert,
      // In the place of the highlight.
      { ...raisedLambert, ...unraised },
    ],
  },
  'specular-times-cosine': {
    sentence: 'The highlight is multiplied by N·L: only the diffuse term is.',
    forms: [
      { spec: ({ NoL, lobe }) => (NoL > 0 ? lobe * NoL : 0) },
      { spec: ({ NoL, lobe }) => lobe * NoL },
    ],
  },
  'ambient-attenuated': {
    sentence:
      'The attenuation is applied to the ambient term too: it belongs to diffuse and specular.',
    forms: [{ ambient: (so, given) => scale(RIGHT.ambient(so, given), so.att) }],
  },
  'no-ambient': {
    sentence: 'The ambient term is missing: Ka · Ia.',
    forms: [
      { ambient: () => BLACK },
      // Where the surface turns away.
      { ambient: (so, given) => (so.NoL > 0 ? RIGHT.ambient(so, given) : BLACK) },
    ],
  },
  'no-diffuse': {
    sentence: 'The diffuse term is missing: Kd · Id · max(N·L, 0).',
    forms: [{ diffuse: () => BLACK }],
  },
  'no-specular': {
    sentence: 'The specular term is missing: Ks · Is · spec.',
    forms: [{ specular: () => BLACK }],
  },
  'no-attenuation': {
    sentence: 'The attenuation, or the distance in it, is missing: 1 / max(kc + kl·d + kq·d², 1).',
    forms: [
      { att: () => 1 },
      // With the length of L, which is 1.
      attenuated((_, { light }) => Math.max(falloff(light, 1), 1)),
      attenuated((_, { light }) => falloff(light, 1)),
      { diffuse: (so, given) => RIGHT.diffuse({ ...so, att: 1 }, given) },
      { specular: (so, given) => RIGHT.specular({ ...so, att: 1 }, given) },
    ],
  },
  'distance-not-squared': {
    sentence: 'kq is not multiplied by the square of the distance.',
    forms: [
      attenuated((so, given) => Math.max(unsquared(so, given), 1)),
      attenuated(unsquared),
      attenuated((so, given) => Math.max(unsquared(so, given, 2), 1)),
    ],
  },
  'attenuation-not-clamped': {
    sentence: 'The attenuation may be above 1: its denominator lacks max(…, 1).',
    forms: [attenuated(({ d }, { light }) => falloff(light, d))],
  },
  'w-ignored': {
    sentence: 'position.w is ignored: 0 is a direction, 1 is a place.',
    forms: [
      // Every position is a place.
      ...alsoTogether(
        { toLight: (_, given) => subtract(placeOf(given), given.p) },
        attenuatedAtAll,
      ),
      allDirections,
      { ...allDirections, att: () => 1 },
      { L: (_, given) => normalize(placeOf(given)), isInside: RIGHT.isInside },
      {
        att: (_, given) =>
          1 / Math.max(falloff(given.light, length(subtract(placeOf(given), given.p))), 1),
      },
    ],
  },
  'ambient-outside-cone': {
    sentence: 'The ambient term is added outside the cone: there the light adds nothing at all.',
    forms: [
      shared((term, { isInside, decay }) => (isInside || term === 'ambient' ? decay : 0)),
      shared((term, { isInside, decay }) => (term === 'ambient' ? 1 : isInside ? decay : 0)),
      shared((term, { isInside, decay }) => (isInside ? decay : term === 'ambient' ? 1 : 0)),
    ],
  },
  'no-cone': {
    sentence: 'The cone is missing: outside of it the light adds nothing.',
    forms: [
      { isInside: () => true },
      // The ambient term alone is a mistake of its own.
      ...SOME_TERMS.map((without) =>
        shared((term, { isInside, decay }) => (isInside || without.includes(term) ? decay : 0)),
      ),
    ],
  },
  'aperture-in-radians': {
    sentence: 'The aperture is used as radians: it is in degrees.',
    forms: coned((aperture) => aperture),
  },
  'whole-aperture': {
    sentence:
      'The aperture is taken for the whole angle of the cone, or doubled: it is the angle from the axis to the edge.',
    forms: [
      ...coned((aperture) => radians(aperture) / 2),
      // The double of 180 would be black under a plain lamp, like much else.
      ...coned((aperture) => 2 * radians(aperture), [180]),
    ],
  },
  'cutoff-not-shifted': {
    sentence: 'The decay is c raised to the cutoff: it is (c + 1) / 2 that is raised.',
    forms: [{ decay: ({ c, A }, { light }) => (dot(A, A) > 0 ? power(c, light.cutoff) : 1) }],
  },
  'no-decay': {
    sentence: 'The decay away from the axis is missing, or not applied to every term.',
    forms: [
      { decay: () => 1 },
      ...[['ambient' as Term], ...SOME_TERMS].map((without) =>
        shared((term, { isInside, decay }) =>
          isInside ? (without.includes(term) ? 1 : decay) : 0,
        ),
      ),
    ],
  },
  'colours-added': {
    sentence: 'Material and light are added: their colours are multiplied.',
    forms: [together(COLORS_ADDED), ...COLORS_ADDED, together(COLORS_ADDED.slice(1))],
  },
  'colour-missing': {
    sentence: "A colour is missing, or another term's: each term is its material times its light.",
    // In one term, or in all.
    forms: [
      ...[WITHOUT_MATERIAL, WITHOUT_LIGHT].flatMap((terms) => [...terms, together(terms)]),
      ...EXCHANGED,
    ],
  },
  'scale-255': {
    sentence: 'A colour is multiplied or divided by 255: here 1 is full.',
    forms: [
      ...[255, 1 / 255, 1 / 255 ** 2].map((full): Form => ({ full: () => full })),
      ...TERMS.flatMap((term) => [255, 1 / 255].map((by) => termScaled(term, by))),
    ],
  },
});

/** Said where there is none. */
export const NO_MISTAKE = 'Right.';

export type MistakeId = keyof typeof MISTAKES;

/**
 * In the order of the table. Where a task shows no difference between two, the first is named: the
 * one whose sentence is true of both.
 */
export const MISTAKE_IDS = Object.keys(MISTAKES) as readonly MistakeId[];

export const formsOf = (id: MistakeId): readonly Form[] => MISTAKES[id].forms;

/** Two mistakes in one function; undefined where both replace the same step. */
export const both = (a: Form, b: Form): Form | undefined =>
  Object.keys(a).some((step) => step in b) ? undefined : { ...a, ...b };
