// Tests whether a pixel is right if the device has moved the face by one subpixel step. Evaluates the equation in
// float64 around the pixel's centre, from what shadeAt gives there and one pixel to the right and below. World space.
import { LightState } from '../light/light-state.js';
import { srgbDecode, srgbEncode } from '../math/color.js';
import { add, cross, dot, map, normalize, scale, subtract, type Vec3 } from '../math/vector.js';
import { shade } from '../reference/index.js';
import type { Judgement, Suspect } from './judge-in-page.js';

/** The light of a viewer without lights. */
const HEAD_LIGHT = new LightState({ space: 'camera', position: [0, 0, 1, 0] }).values;

/**
 * How many codes the pixel is from the range of colours within one step of the device's subpixel grid on each axis. 0
 * inside it. A pixel that is not opaque is 255 off.
 */
export function codesOff(suspect: Suspect, judgement: Judgement): number {
  const { drawn, expected } = suspect;
  if (drawn[3] !== 255) return 255;
  const step = 2 ** -judgement.subpixelBits;
  const around = [-step, 0, step].flatMap((dx) =>
    [-step, 0, step].map((dy) => colorAt(suspect, judgement, dx, dy)),
  );
  return Math.max(
    ...([0, 1, 2] as const).map((channel) => {
      const codes = [...around.map((color) => 255 * color[channel]), expected[channel]].map(Math.round);
      const actual = drawn[channel]!;
      return Math.max(Math.min(...codes) - actual, actual - Math.max(...codes), 0);
    }),
  );
}

/** The colour of the suspect's face `dx` pixels to the right and `dy` down. */
function colorAt(
  suspect: Suspect,
  { eye, target, up, terms, linear, lights }: Judgement,
  dx: number,
  dy: number,
): Vec3 {
  const { here, right, below, reflection, interpolated } = suspect;
  const back = normalize(subtract(eye, target));
  const [a, b] = weightsAt(suspect, eye, back, dx, dy);
  const mix = (of: (point: Suspect['here']) => Vec3): Vec3 => {
    const middle = of(here);
    return add(middle, add(scale(subtract(of(right), middle), a), scale(subtract(of(below), middle), b)));
  };
  if (interpolated) {
    const sum = mix((point) => (linear ? map(point.sum, srgbDecode) : point.sum));
    return map(linear ? map(sum, srgbEncode) : sum, (x) => Math.min(Math.max(x, 0), 1));
  }
  /** Back to what an author writes: shadeAt gives coefficients as the equation uses them. */
  const written = (k: Vec3): Vec3 => map(k, (x) => 255 * (linear ? srgbEncode(x) : x));
  const surface = {
    ka: written(mix((point) => point.ka)),
    kd: written(mix((point) => point.kd)),
    ks: written(mix((point) => point.ks)),
    shininess: Math.max(
      here.shininess + a * (right.shininess - here.shininess) + b * (below.shininess - here.shininess),
      0,
    ),
    emissive: mix((point) => point.emissive),
  };
  const fragment = { p: mix((point) => point.p), normal: mix((point) => point.N), eye };
  const camera = { right: cross(up, back), up, back };
  return shade(fragment, surface, lights.length === 0 ? [HEAD_LIGHT] : lights, {
    camera,
    reflection,
    terms,
    linear,
  }).color;
}

/**
 * Where the ray through that place meets the face, in steps to the points on the right and below: exact in perspective.
 */
function weightsAt(
  { here, right, below }: Suspect,
  eye: Vec3,
  back: Vec3,
  dx: number,
  dy: number,
): readonly [number, number] {
  /** From the eye to a plane at distance 1: linear in pixels. */
  const through = ({ p }: Suspect['here']): Vec3 => {
    const seen = subtract(p, eye);
    return scale(seen, -1 / dot(seen, back));
  };
  const [middle, e, f] = [through(here), subtract(right.p, here.p), subtract(below.p, here.p)];
  const ray = add(
    middle,
    add(scale(subtract(through(right), middle), dx), scale(subtract(through(below), middle), dy)),
  );
  const normal = cross(e, f);
  const t = dot(subtract(here.p, eye), normal) / dot(ray, normal);
  const step = subtract(add(eye, scale(ray, t)), here.p);
  const [ee, ef, ff, se, sf] = [dot(e, e), dot(e, f), dot(f, f), dot(step, e), dot(step, f)];
  const area = ee * ff - ef * ef;
  return [(ff * se - ef * sf) / area, (ee * sf - ef * se) / area];
}
