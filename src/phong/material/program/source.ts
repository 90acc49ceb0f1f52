// The programs' text: the chunks of shaders/ in one explicit order, after the constants shared with
// TypeScript.
import attenuation from '../../../../shaders/attenuation.glsl?raw';
import diffuseLobe from '../../../../shaders/diffuse_lobe.glsl?raw';
import fileSurface from '../../../../shaders/file_surface.glsl?raw';
import guard from '../../../../shaders/guard.glsl?raw';
import lightLoop from '../../../../shaders/light_loop.glsl?raw';
import lightRows from '../../../../shaders/light_rows.glsl?raw';
import nearestCode from '../../../../shaders/nearest_code.glsl?raw';
import phongFragment from '../../../../shaders/phong.frag.glsl?raw';
import phongVertex from '../../../../shaders/phong.vert.glsl?raw';
import power from '../../../../shaders/power.glsl?raw';
import specularBlinnPhong from '../../../../shaders/specular_blinn_phong.glsl?raw';
import specularPhong from '../../../../shaders/specular_phong.glsl?raw';
import spot from '../../../../shaders/spot.glsl?raw';
import srgb from '../../../../shaders/srgb.glsl?raw';
import surfaceColor from '../../../../shaders/surface_color.glsl?raw';
import { layoutDefines, lightStructs } from '../../light/light-layout.js';
import { SRGB } from '../../math/color.js';
import { FULL_LOBE, LEAST_FILE_EXPONENT, LEAST_ROUGHNESS } from '../file-surface.js';

const float = (n: number): string => n.toExponential();

/** Numbers that GLSL and TypeScript share, written once in TypeScript. */
const CONSTANTS = `${layoutDefines()}
#define STORAGE_UNIFORMS 0
#define STORAGE_TEXTURE 1
#define STORAGE_INLINED 2
#define STORAGE_OWN 3
#define SRGB_ENCODED_KNEE ${float(SRGB.encodedKnee)}
#define SRGB_LINEAR_KNEE ${float(SRGB.linearKnee)}
#define SRGB_SLOPE ${float(SRGB.slope)}
#define SRGB_OFFSET ${float(SRGB.offset)}
#define SRGB_EXPONENT ${float(SRGB.exponent)}
`;

const where = (condition: string, ...chunks: readonly string[]): string =>
  [`#if ${condition}`, ...chunks, '#endif'].join('\n');

/** The light loop, and what a fragment makes of it. */
const loopWith = (surface: string, grid = ''): string =>
  [
    CONSTANTS,
    guard,
    power,
    attenuation,
    spot,
    diffuseLobe,
    '#ifdef REFLECTION_BLINN_PHONG',
    specularBlinnPhong,
    '#else',
    specularPhong,
    '#endif',
    lightRows,
    lightStructs(),
    grid,
    lightLoop,
    surface,
  ].join('\n');

/**
 * The light loop alone, for any GLSL ES 3.00 program. Put it after `#version` and `precision highp
 * float; precision highp int;`. Define before it LIGHT_STORAGE (STORAGE_UNIFORMS with LIGHT_ROWS,
 * the size of the uniform array; STORAGE_TEXTURE; or STORAGE_OWN with a `vec4 lightRow(int)` of
 * your own) and DECLARED_FEATURES, by `declaredFeatures`. Then call `surfaceColor(p, normal, eye,
 * ka, kd, ks, shininess)` or, for the sums before the material, `lightSums(p, N, V, shininess)`,
 * with everything in the space that the lights were packed for.
 */
export const LIGHT_LOOP_GLSL = /* @__PURE__ */ loopWith(surfaceColor);

/** The sRGB curve and the rounding to 8 bits: the last steps of a fragment. Needs the constants. */
export const ENCODING_GLSL = [srgb, nearestCode].join('\n');

const FILE_SURFACE = `#define LEAST_ROUGHNESS ${float(LEAST_ROUGHNESS)}
#define LEAST_FILE_EXPONENT ${float(LEAST_FILE_EXPONENT)}
#define FULL_LOBE ${float(FULL_LOBE)}
${fileSurface}`;

const UNLIT = `${CONSTANTS}\n${guard}`;

export interface Shaders {
  readonly vertexShader: string;
  readonly fragmentShader: string;
}

const texts = new Map<string, Shaders>();

/**
 * The two stages of a program; defines choose the code. `lit` is the stage that sums the lights:
 * the other one leaves out the loop's text, which would only cost parsing. `surface` is a
 * text in place of surface_color, `grid` that of light_grid where the lights are in one.
 */
export function shadersOf(
  lit: 'vertex' | 'fragment' | null,
  surface = surfaceColor,
  grid = '',
): Shaders {
  const key = `${String(lit)} ${surface}${grid}`;
  let shaders = texts.get(key);
  if (shaders === undefined) {
    const head = (stage: 'vertex' | 'fragment'): string =>
      [
        'precision highp float;\nprecision highp int;',
        stage === lit ? loopWith(surface, grid) : UNLIT,
      ].join('\n');
    const isTextured = 'defined(HAS_METAL_ROUGH_MAP) || defined(HAS_NORMAL_MAP)';
    shaders = {
      vertexShader: [
        head('vertex'),
        where('defined(DECODES_VERTEX_COLOR)', srgb),
        phongVertex,
      ].join('\n'),
      fragmentShader: [
        head('fragment'),
        ENCODING_GLSL,
        where(isTextured, FILE_SURFACE),
        phongFragment,
      ].join('\n'),
    };
    texts.set(key, shaders);
  }
  return shaders;
}
