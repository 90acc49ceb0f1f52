// The programs' text: the chunks of shaders/ joined in one explicit order, after the constants that TypeScript and
// GLSL share. Knows nothing of uniforms' values.
import attenuation from '../../shaders/attenuation.glsl?raw';
import diffuseLobe from '../../shaders/diffuse_lobe.glsl?raw';
import guard from '../../shaders/guard.glsl?raw';
import loop from '../../shaders/light_loop.glsl?raw';
import lightRows from '../../shaders/light_rows.glsl?raw';
import nearestCode from '../../shaders/nearest_code.glsl?raw';
import phongFragment from '../../shaders/phong.frag.glsl?raw';
import phongVertex from '../../shaders/phong.vert.glsl?raw';
import power from '../../shaders/power.glsl?raw';
import specularBlinnPhong from '../../shaders/specular_blinn_phong.glsl?raw';
import specularPhong from '../../shaders/specular_phong.glsl?raw';
import spot from '../../shaders/spot.glsl?raw';
import srgb from '../../shaders/srgb.glsl?raw';
import surfaceColor from '../../shaders/surface_color.glsl?raw';
import { layoutDefines } from '../light/light-layout.js';
import { SRGB } from '../math/color.js';

const float = (n: number): string => n.toExponential();

/** Numbers that GLSL and TypeScript share, written once in TypeScript. */
const constants = `${layoutDefines()}
#define STORAGE_BLOCK 0
#define STORAGE_TEXTURE 1
#define STORAGE_OWN 2
#define SRGB_ENCODED_KNEE ${float(SRGB.encodedKnee)}
#define SRGB_LINEAR_KNEE ${float(SRGB.linearKnee)}
#define SRGB_SLOPE ${float(SRGB.slope)}
#define SRGB_OFFSET ${float(SRGB.offset)}
#define SRGB_EXPONENT ${float(SRGB.exponent)}
`;

/** The light loop, with the text of `more` before it: what FILTER_HIGHLIGHTS or lights in EXACT_LIGHTS ask for. */
export const lightLoop = (more = ''): string =>
  [
    constants,
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
    more,
    loop,
    surfaceColor,
  ].join('\n');

/** The sRGB curve, and what an 8-bit picture keeps of a colour: the last steps of a fragment, after the constants. */
export const ENCODING_GLSL = [srgb, nearestCode].join('\n');

export interface Shaders {
  readonly vertexShader: string;
  readonly fragmentShader: string;
}

let averages = '';

/** Whether FILTER_HIGHLIGHTS may be defined: {@link bringAverages} has been called. */
export const hasAverages = (): boolean => averages !== '';

/** Brings the text of FILTER_HIGHLIGHTS, for which few pictures ask: elements fetch it then, `phong-viewer/core` has it. */
export function bringAverages(glsl: string): void {
  averages = glsl;
}

const made = new Map<string, Shaders>();

/**
 * The two stages of a program, to stand after these defines. Gouraud sums the lights at the vertices, everything else at the fragments;
 * the other stage is spared the loop's text, which compilers would read only to leave it out. `more` as for {@link lightLoop}.
 */
export function shadersOf(defines: Readonly<Record<string, string>>, more = ''): Shaders {
  const gouraud = 'SHADING_GOURAUD' in defines;
  const asked = `${'FILTER_HIGHLIGHTS' in defines ? averages : ''}\n${more}`;
  const key = `${String(gouraud)} ${asked}`;
  const known = made.get(key);
  if (known !== undefined) return known;
  const without = [constants, guard];
  const shaders = {
    vertexShader: [
      '#undef USUAL_LENGTHS', // a model's own normals may have any length
      ...(gouraud ? [lightLoop(asked)] : without),
      phongVertex,
    ].join('\n'),
    fragmentShader: [...(gouraud ? without : [lightLoop(asked)]), ENCODING_GLSL, phongFragment].join('\n'),
  };
  made.set(key, shaders);
  return shaders;
}
