// The ways to sum lights that are held against each other: the equation as it is written, hoisted, the shipped loop, the
// shipped one without each thing that it skips, at lower precision, with approximate lobes. Text and data; nothing is drawn here.
import { divide } from '../../../src/light/light-grid.js';
import { gatherFacts, isSpot, kindOf, noFacts } from '../../../src/light/light-features.js';
import { BLOCK_ROWS, SHAPE } from '../../../src/light/light-layout.js';
import type { LightValues } from '../../../src/light/light-state.js';
import { emptyPack, type PackedLights, packLights } from '../../../src/light/pack-lights.js';
import { isMildPower, isWholePower } from '../../../src/light/steady-light.js';
import { constantRows, MOST_CONSTANT, MOST_PARTLY } from '../../../src/material/exact-lights.js';
import { CHUNKS, type ExactForm, exactText, readsBlock } from '../../../src/material/exact-material.js';
import { LIGHT_LOOP_GLSL } from '../../../src/material/light-loop-glsl.js';
import { lightLoop } from '../../../src/material/program/source.js';
import { TERMS, type Variant, variantDefines } from '../../../src/material/program/variant.js';
import { radians } from '../../../src/math/angle.js';
import { add, normalize, scale, type Vec3 } from '../../../src/math/vector.js';
import { BEND, type FloorScene } from './floor-scenes.js';
import hoistedGlsl from './loops/hoisted.glsl?raw';
import literalGlsl from './loops/literal.glsl?raw';

/** A loop and the light data that it reads. */
export interface LoopText {
  readonly id: string;
  readonly label: string;
  /** Before the text. */
  readonly defines: readonly string[];
  /** Provides `vec3 shadeHere(vec3 p, vec3 normal)`. */
  readonly glsl: string;
  /** Rows of four floats. */
  readonly rows: Float32Array;
  /** How the rows are read. `array`: `row(i)` from uniforms or, where they are too many, from the texture. */
  readonly storage: 'array' | 'block' | 'texture';
  readonly precision?: 'mediump';
}

export const SURFACE = { ka: 1, kd: 1, ks: 0.5 } as const;

/** Rows that WebGL 2 promises room for, less those of eye, material and window. */
export const ARRAY_ROWS = 210;

/** Lights with numbers in the program, in software, and in loops of literal length; see exact-form. */
const MOST = { software: MOST_PARTLY, gpu: 1024 } as const;

const SHADE = `
vec3 shadeHere(vec3 p, vec3 normal) {
  return surfaceColor(p, normal, uEye, uKa, uKd, uKs, uShininess);
}`;

export function loopsOf(scene: FloorScene, software: boolean): LoopText[] {
  const { lights, shininess } = scene;
  const active = lights.filter((light) => light.active);
  const packed = packedOf(lights);
  const cells = dividedOf(packed, scene);
  const few = active.length <= (software ? MOST.software : MOST.gpu) && packed.rows <= BLOCK_ROWS;
  const own = software ? 'constant' : 'counted';
  const form: ExactForm = cells !== null ? 'cells' : few ? own : 'loops';
  const exact = (id: string, label: string, more: Partial<ExactOptions> = {}): LoopText =>
    exactLoop(id, label, {
      ...{ form, packed: cells ?? packed, shininess, skips: ALL_SKIPS },
      ...more,
    });
  const power = isMildPower(shininess);
  return [
    literalLoop(lights),
    hoistedLoop(active),
    generalLoop('general', 'shipped, drawn at once', lights, factsOf(lights)),
    exact('shipped', 'shipped, once settled'),
    ...(form === own && active.length <= MOST_CONSTANT
      ? [exact('written', 'shipped with each light written out', { form: 'written' })]
      : []),
    ...(form === own ? [exact('loops', 'shipped without writing lights out', { form: 'loops' })] : []),
    ...(form === 'cells' ? [exact('undivided', 'shipped without cells', { form: 'loops', packed })] : []),
    ...(power ? [exact('series', 'shipped without short powers', { skips: without('powers') })] : []),
    exact('guarded', 'shipped without knowing lengths', { skips: without('guards') }),
    generalLoop('all-code', 'shipped with code for everything', lights, EVERY_FACT),
    ...(active.length < lights.length
      ? [generalLoop('inactive', 'shipped with inactive lights kept', lights.map(awake), factsOf(lights))]
      : []),
    { ...exact('mediump', 'shipped at mediump'), precision: 'mediump' },
    withLobe(exact('pow', 'shipped with pow'), 'return pow(max(dot(L, W), 0.0), n);'),
    withLobe(exact('schlick', 'shipped with Schlick’s lobe'), SCHLICK),
    withLobe(exact('gaussian', 'shipped with a Gaussian lobe'), GAUSSIAN),
  ];
}

/** Christophe Schlick, "A fast alternative to Phong's specular model", Graphics Gems IV, 1994: t/(n - nt + t). */
const SCHLICK = 'float t = max(dot(L, W), 0.0); return t / (n - n * t + t);';
/** exp(-n (1 - cos)): what cos^n is near its centre. */
const GAUSSIAN = 'float t = dot(L, W); return t > 0.0 ? exp(n * (t - 1.0)) : 0.0;';

type Skip = 'powers' | 'guards';
const ALL_SKIPS: readonly Skip[] = ['powers', 'guards'];
const without = (skip: Skip): Skip[] => ALL_SKIPS.filter((each) => each !== skip);

interface ExactOptions {
  readonly form: ExactForm;
  readonly packed: PackedLights;
  readonly shininess: number;
  readonly skips: readonly Skip[];
}

/** As ExactMaterial makes it. */
function exactLoop(id: string, label: string, { form, packed, shininess, skips }: ExactOptions): LoopText {
  const terms = SHAPE.ambient | SHAPE.diffuse | SHAPE.specular;
  const defines = ['HAS_DIFFUSE', 'HAS_SPECULAR'];
  if (skips.includes('powers')) {
    if (isWholePower(shininess)) defines.push(`WHOLE_SHININESS ${String(shininess)}`);
    else if (isMildPower(shininess)) defines.push('MILD_SHININESS');
  }
  if (skips.includes('guards')) defines.push('LIGHTS_APART', 'USUAL_LENGTHS');
  defines.push(`EXACT_LIGHTS ${exactText(form, packed, terms)}`);
  if (form === 'constant') defines.push(`LIGHT_CONSTANTS ${constantRows(packed)}`);
  else defines.push('HAS_AMBIENT');
  const storage = readsBlock(form) ? 'block' : 'texture';
  const glsl = lightLoop(CHUNKS[form]) + SHADE;
  return { id, label, defines, glsl, rows: rowsOf(packed), storage };
}

type Facts = ReturnType<typeof noFacts>;

const EVERY_FACT = Object.fromEntries(Object.keys(noFacts()).map((fact) => [fact, true])) as unknown as Facts;

function factsOf(lights: readonly LightValues[]): Facts {
  const facts = noFacts();
  for (const light of lights) gatherFacts(light, facts);
  return facts;
}

function generalLoop(id: string, label: string, lights: readonly LightValues[], facts: Facts): LoopText {
  const variant: Variant = {
    shading: 'phong',
    reflection: 'phong',
    terms: TERMS,
    ...{ linear: false, map: false, vertexColors: false, alphaMode: 'opaque', antialias: 'edges' },
  };
  const defines = Object.keys(variantDefines(variant, facts)).filter((name) => name !== 'LIGHT_STORAGE');
  return {
    ...{ id, label, defines, glsl: LIGHT_LOOP_GLSL + SHADE },
    ...{ rows: rowsOf(packedOf(lights)), storage: 'texture' },
  };
}

/** An inactive light as one that no eye sees, but that is summed. */
const awake = (light: LightValues): LightValues =>
  light.active ? light : { ...light, active: true, ambient: UNSEEN, diffuse: UNSEEN, specular: UNSEEN };
const UNSEEN: Vec3 = [1e-30, 1e-30, 1e-30];

/** The same with another lobe; `W` is what the shipped one calls the eye's mirrored direction. */
function withLobe(loop: LoopText, body: string): LoopText {
  const head = /float\s+specularLobe\s*\(([^)]*)\)\s*\{/g; // Phong's and Blinn's, of which one is compiled
  if (!head.test(loop.glsl)) throw new Error('the shipped loop has no specularLobe');
  const glsl = loop.glsl.replace(
    head,
    (_, parameters: string) =>
      `float specularLobe(${parameters}) {\n${body}\n}\nfloat shippedLobe(${parameters}) {`,
  );
  return { ...loop, glsl };
}

function literalLoop(lights: readonly LightValues[]): LoopText {
  const rows = lights.flatMap((light) => {
    const { position, axis, aperture, cutoff, attenuation, active } = light;
    const [ia, id, is] = [light.ambient, light.diffuse, light.specular].map(full) as [Vec3, Vec3, Vec3];
    return [
      position,
      [...axis, aperture],
      [...ia, active ? 1 : 0],
      [...id, cutoff],
      [...is, 0],
      [...attenuation, 0],
    ];
  });
  return {
    ...{ id: 'literal', label: 'as the equation is written', glsl: literalGlsl, storage: 'array' },
    ...{ defines: [`COUNT ${String(lights.length)}`], rows: Float32Array.from(rows.flat()) },
  };
}

function hoistedLoop(lights: readonly LightValues[]): LoopText {
  const of = (kind: string): LightValues[] => lights.filter((light) => kindOf(light) === kind);
  const [directional, points, spots] = ['directional', 'point', 'spot'].map(of) as [
    LightValues[],
    LightValues[],
    LightValues[],
  ];
  let ambient: Vec3 = [0, 0, 0];
  for (const light of lights) if (!isSpot(light)) ambient = add(ambient, full(light.ambient));
  const positional = ({ position, diffuse, specular, attenuation: [kc, kl, kq] }: LightValues) => [
    ...[...position.slice(0, 3), kc],
    ...[...full(diffuse), kl],
    ...[...full(specular), kq],
  ];
  const rows = [
    ...directional.flatMap(({ position: [x, y, z], diffuse, specular }) =>
      [normalize([x, y, z]), full(diffuse), full(specular)].flatMap((v) => [...v, 0]),
    ),
    ...points.flatMap(positional),
    ...spots.flatMap((light) => [
      ...positional(light),
      ...[...normalize(light.axis), Math.cos(radians(light.aperture))],
      ...[...full(light.ambient), light.cutoff],
    ]),
  ];
  return {
    ...{ id: 'hoisted', label: 'constants hoisted out', storage: 'array', rows: Float32Array.from(rows) },
    defines: [
      `DIRECTIONALS ${String(directional.length)}`,
      `POINTS ${String(points.length)}`,
      `SPOTS ${String(spots.length)}`,
      `uAmbient vec3(${ambient.map((x) => x.toExponential()).join()})`,
    ],
    glsl: hoistedGlsl,
  };
}

const full = (color: Vec3): Vec3 => scale(color, 1 / 255);

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

function packedOf(lights: readonly LightValues[]): PackedLights {
  const packed = emptyPack();
  packLights(lights, { worldToShading: IDENTITY, cameraToShading: IDENTITY, linear: false }, packed);
  return packed;
}

const rowsOf = ({ data, rows }: PackedLights): Float32Array => data.slice(0, rows * 4);

/** In cells over twice the floor that the picture shows, as far as any picture's aspect goes; null where cells are not worth it. */
function dividedOf(packed: PackedLights, { half }: FloorScene): PackedLights | null {
  const into = emptyPack();
  const [wide, high] = [2 * half, half];
  const box = [-wide, -high, -BEND * (wide ** 2 + high ** 2), wide, high, 0] as const;
  const { ka, kd, ks } = SURFACE;
  const reflectance = { ka: [ka, ka, ka], kd: [kd, kd, kd], ks: [ks, ks, ks] };
  return divide(packed, box, reflectance, 0, into) ? into : null;
}
