// Ways to write the light loop, each as GLSL with the rows that it reads: a plain one, what others
// do to make it fast, and the shipped ones. Text and data; nothing is drawn here.
import {
  declaredFeatures,
  emptyPack,
  LIGHT_LOOP_GLSL,
  type LightValues,
  packLights,
} from 'phong-viewer/core';
import { isIntegerPower, isMildPower } from '../../../src/phong/light/precision.js';
import { TERMS } from '../../../src/phong/light/light-state.js';
import { PLAIN_LOOK } from '../../../src/phong/material/file-surface.js';
import { DEFAULT_STYLE } from '../../../src/phong/material/material-values.js';
import { specialisedVariant } from '../../../src/phong/material/program/special-variant.js';
import { generalVariant } from '../../../src/phong/material/program/variant.js';
import type { WayName } from '../accuracy-words.mjs';
import hoistedGlsl from './hoisted.glsl?raw';
import { IDENTITY } from '../../support/matrices.js';

/**
 * A loop and the rows of four floats that it reads through `vec4 row(int)`. It provides `vec3
 * shadeHere(vec3 p, vec3 normal)`.
 */
export interface Variant {
  readonly glsl: string;
  readonly rows: Float32Array;
}

/** The power of a cosine t. */
const POW = 'pow(t, uShininess)';

/** From the least bit of the exponent to the highest; a whole exponent is all that it can do. */
const SQUARING = `float squared(float t, int n) {
  float power = 1.0;
  for (; n > 0; n >>= 1, t *= t) if ((n & 1) == 1) power *= t;
  return power;
}
`;

/**
 * @param software a CPU draws: the viewer then reads lights from a texture at first, and writes their
 * numbers into the program that takes over
 */
export function variantsOf(
  lights: readonly LightValues[],
  shininess: number,
  software: boolean,
): Readonly<Record<WayName, Variant>> {
  return {
    plain: plain(lights, POW),
    first: shipped(lights, shininess, software, false),
    settled: shipped(lights, shininess, software, true),
    // Christophe Schlick, "A fast alternative to Phong's specular model", Graphics Gems IV, 1994.
    schlick: plain(lights, '((t) / (uShininess - uShininess * (t) + (t)))'),
    squaring: plain(lights, 'squared(t, int(uShininess))', SQUARING),
    mediump: plain(lights, POW, 'precision mediump float;\n', 'precision highp float;\n'),
  };
}

const definesText = (values: Readonly<Record<string, string | number>>) =>
  Object.entries(values)
    .map(([name, value]) => `#define ${name} ${value}\n`)
    .join('');

type Triple = readonly [number, number, number];
const full = ([r, g, b]: Triple): Triple => [r / 255, g / 255, b / 255];

/** @param lobe the highlight as an expression of `t` @param before text in front @param after behind */
function plain(lights: readonly LightValues[], lobe: string, before = '', after = ''): Variant {
  const unit = (v: Triple): Triple => {
    const length = Math.hypot(...v);
    return [v[0] / length, v[1] / length, v[2] / length];
  };
  const isSpot = ({ aperture, cutoff }: LightValues) => aperture < 180 || cutoff > 0;
  const directional = lights.filter(({ position }) => position[3] === 0);
  const points = lights.filter((light) => light.position[3] === 1 && !isSpot(light));
  const spots = lights.filter((light) => light.position[3] === 1 && isSpot(light));
  const ambient = [...directional, ...points].reduce<Triple>(
    (sum, light) => full(light.ambient).map((channel, k) => channel + sum[k]!) as unknown as Triple,
    [0, 0, 0],
  );
  const positional = ({
    position: [x, y, z],
    diffuse,
    specular,
    attenuation: [kc, kl, kq],
  }: LightValues) => [x, y, z, kc, ...full(diffuse), kl, ...full(specular), kq];
  const rows = [
    ...directional.flatMap(({ position: [x, y, z], diffuse, specular }) =>
      [unit([x, y, z]), full(diffuse), full(specular)].flatMap((v) => [...v, 0]),
    ),
    ...points.flatMap(positional),
    ...spots.flatMap((light) => [
      ...positional(light),
      ...unit(light.axis),
      Math.cos((light.aperture * Math.PI) / 180),
      ...full(light.ambient),
      light.cutoff,
    ]),
  ];
  return {
    glsl:
      before +
      definesText({
        DIRECTIONALS: directional.length,
        POINTS: points.length,
        SPOTS: spots.length,
        AMBIENT: `vec3(${ambient.map((channel) => channel.toExponential()).join()})`,
        'LOBE(t)': lobe,
      }) +
      hoistedGlsl +
      after,
    rows: Float32Array.from(rows),
  };
}

/** The viewer's own: of its first frames for any number of lights, or the one that takes over. */
function shipped(
  lights: readonly LightValues[],
  shininess: number,
  software: boolean,
  settled: boolean,
): Variant {
  const packed = emptyPack();
  packLights(
    lights,
    { worldToShading: IDENTITY, cameraToShading: IDENTITY, linear: false },
    packed,
  );
  const material = {
    look: PLAIN_LOOK,
    style: DEFAULT_STYLE,
    linear: false,
    mildShininess: isMildPower(shininess),
  };
  const general = generalVariant(material, declaredFeatures(lights), 0);
  const integerShininess = isIntegerPower(shininess) ? shininess : null;
  const form = software ? 'inlined' : 'counted';
  const variant = settled
    ? specialisedVariant(general, { terms: TERMS, integerShininess }, form, packed)
    : general;
  // A GPU reads rows of uniforms, which the other loops have too.
  const storage = software ? {} : { LIGHT_STORAGE: 'STORAGE_OWN' };
  return {
    glsl: `${definesText({ ...variant.defines, ...storage })}
${software ? '' : 'vec4 lightRow(int i) { return row(i); }'}
${LIGHT_LOOP_GLSL}
vec3 shadeHere(vec3 p, vec3 normal) {
  return surfaceColor(p, normal, uEye, uKa, uKd, uKs, uShininess);
}`,
    rows: packed.data.slice(0, packed.rows * 4),
  };
}
