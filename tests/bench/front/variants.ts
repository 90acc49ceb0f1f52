// Ways to write the light loop: as in the specification, with constants hoisted, with approximate
// lobes, and the shipped one as `phong-viewer/core` documents it for any program. Text and data;
// nothing is drawn here.
import {
  declaredFeatures,
  emptyPack,
  LIGHT_LOOP_GLSL,
  type LightValues,
  packLights,
} from 'phong-viewer/core';
import hoistedGlsl from './hoisted.glsl?raw';
import literalGlsl from './literal.glsl?raw';

/**
 * A loop and the rows of four floats that it reads through `vec4 row(int)`. It provides `vec3
 * shadeHere(vec3 p, vec3 normal)`.
 */
export interface Variant {
  readonly label: string;
  readonly glsl: string;
  readonly rows: Float32Array;
}

/** The variant that the others' times are compared with. */
export const BASE = 'as specified';

const LOBES = {
  'constants hoisted': 'pow(t, uShininess)',
  // Christophe Schlick, "A fast alternative to Phong's specular model", Graphics Gems IV, 1994.
  'Schlick’s lobe': '((t) / (uShininess - uShininess * (t) + (t)))',
  // What cos^n is near its centre.
  'Gaussian lobe': '((t) > 0.0 ? exp(uShininess * ((t) - 1.0)) : 0.0)',
} as const;

export function variantsOf(lights: readonly LightValues[]): Variant[] {
  return [
    literal(lights),
    ...Object.entries(LOBES).map(([label, lobe]) => hoisted(label, lobe, lights)),
    shipped(lights),
  ];
}

const defines = (values: Readonly<Record<string, string | number>>): string =>
  Object.entries(values)
    .map(([name, value]) => `#define ${name} ${value}\n`)
    .join('');

type Triple = readonly [number, number, number];
const full = ([r, g, b]: Triple): Triple => [r / 255, g / 255, b / 255];

function literal(lights: readonly LightValues[]): Variant {
  const rows = lights.flatMap(
    ({ position, axis, aperture, ambient, diffuse, cutoff, specular, attenuation }) => [
      ...position,
      ...axis,
      aperture,
      ...full(ambient),
      0,
      ...full(diffuse),
      cutoff,
      ...full(specular),
      0,
      ...attenuation,
      0,
    ],
  );
  return {
    label: BASE,
    glsl: defines({ COUNT: lights.length }) + literalGlsl,
    rows: Float32Array.from(rows),
  };
}

function hoisted(label: string, lobe: string, lights: readonly LightValues[]): Variant {
  const unit = (v: Triple): Triple => {
    const length = Math.hypot(...v);
    return [v[0] / length, v[1] / length, v[2] / length];
  };
  const isSpot = ({ aperture, cutoff }: LightValues): boolean => aperture < 180 || cutoff > 0;
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
    label,
    glsl:
      defines({
        DIRECTIONALS: directional.length,
        POINTS: points.length,
        SPOTS: spots.length,
        AMBIENT: `vec3(${ambient.map((channel) => channel.toExponential()).join()})`,
        'LOBE(t)': lobe,
      }) + hoistedGlsl,
    rows: Float32Array.from(rows),
  };
}

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

function shipped(lights: readonly LightValues[]): Variant {
  const packed = emptyPack();
  packLights(
    lights,
    { worldToShading: IDENTITY, cameraToShading: IDENTITY, linear: false },
    packed,
  );
  return {
    label: 'shipped',
    glsl: `${defines({ LIGHT_STORAGE: 'STORAGE_OWN', DECLARED_FEATURES: String(declaredFeatures(lights)) })}
vec4 lightRow(int i) { return row(i); }
${LIGHT_LOOP_GLSL}
vec3 shadeHere(vec3 p, vec3 normal) {
  return surfaceColor(p, normal, uEye, uKa, uKd, uKs, uShininess);
}`,
    rows: packed.data.slice(0, packed.rows * 4),
  };
}
