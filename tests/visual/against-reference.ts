// How far is a picture from the equation? Channel by channel in 8-bit codes, inside faces and away
// from cones' edges.
import type { Vec3 } from '../../src/phong/math/vector.js';
import type { Picture } from '../support/picture.js';
import { caster, type DeclaredScene, type Hit } from './ray-cast.js';

/**
 * Nearer to a cone's edge than this, in radians, a pixel may be on either side: the rasteriser
 * snaps vertices.
 */
export const CONE_EDGE = 3e-3;

/**
 * Vertices lie on a grid of sixteenths of a pixel at worst, so that a pixel shows what lies up to
 * half of one beside its ray.
 */
const SNAPPED = 1 / 32;

/** The hits at the four corners at this distance. */
export const around = <T>(reach: number, tell: (dx: number, dy: number) => T): T[] =>
  [-reach, reach].flatMap((dx) => [-reach, reach].map((dy) => tell(dx, dy)));

/** Distance of a code from the range of these codes; 0 within. */
const outside = (code: number, codes: readonly number[]) =>
  Math.max(Math.min(...codes) - code, code - Math.max(...codes), 0);

export interface Errors {
  /** Largest difference of a channel in 1/255, and where. */
  max: number;
  at: string;
  compared: number;
  exact: number;
}

/** A pixel inside one face, away from every cone's edge, with its hit. */
interface InnerPixel {
  readonly x: number;
  readonly y: number;
  readonly hit: Hit;
}

/**
 * A memoised `tell`, because several pictures of one scene are compared: results are kept as long
 * as the scene exists, keyed by the text of the other arguments.
 */
export function remembered<A extends readonly (number | string)[], T>(
  tell: (scene: DeclaredScene, ...more: A) => T,
): (scene: DeclaredScene, ...more: A) => T {
  const known = new WeakMap<DeclaredScene, Map<string, T>>();
  return (scene, ...more) => {
    const answers = known.get(scene) ?? new Map<string, T>();
    known.set(scene, answers);
    const key = more.join();
    const answer = answers.has(key) ? answers.get(key)! : tell(scene, ...more);
    answers.set(key, answer);
    return answer;
  };
}

/**
 * Pixels whose neighbours all hit the same face, so that multisampling mixes nothing: one of
 * `every`.
 */
export const innerPixels = remembered(
  (scene: DeclaredScene, width: number, height: number, every: number) => {
    const cast = caster(scene, width, height);
    const hits = Array.from({ length: width * height }, (_, i) =>
      cast(i % width, Math.floor(i / width)),
    );
    const inner: InnerPixel[] = [];
    for (let y = 2; y < height - 2; y++) {
      for (let x = 2; x < width - 2; x++) {
        const hit = hits[y * width + x];
        if ((y * width + x) % every > 0) continue;
        const inside = [-2, 0, 2].every((dy) =>
          [-2, 0, 2].every((dx) => hits[(y + dy) * width + x + dx]?.face === hit?.face),
        );
        if (hit && inside && !(hit.coneMargin < CONE_EDGE)) {
          inner.push({ x, y, hit });
        }
      }
    }
    return inner;
  },
);

/** `colorOf`: the expected colour of a hit, 0–1. Default: the shaded colour. */
export function compareWithReference(
  picture: Picture,
  scene: DeclaredScene,
  colorOf: (hit: Hit) => Vec3 = ({ shaded }) => shaded.color,
): Errors {
  const { width, height } = picture;
  const errors: Errors = { max: 0, at: '', compared: 0, exact: 0 };
  const cast = caster(scene, width, height);
  /**
   * Where highlights of small exponents begin, codes change by several within that: a code is right
   * that is seen right beside.
   */
  const beside = (x: number, y: number, channel: number) =>
    around(SNAPPED, (dx, dy) => {
      const hit = cast(x + dx, y + dy);
      return hit === null ? NaN : Math.round(colorOf(hit)[channel]! * 255);
    });
  for (const { x, y, hit } of innerPixels(scene, width, height, 1)) {
    const color = colorOf(hit);
    for (let channel = 0; channel < 3; channel++) {
      compareChannel(errors, picture, { x, y, channel }, 255 * color[channel]!, () =>
        beside(x, y, channel).filter(Number.isFinite),
      );
    }
  }
  return errors;
}

/**
 * Adds a channel of a picture to `errors`. One that is more than a code off `exact` may show any of
 * the codes between this and those `near` it.
 */
export function compareChannel(
  errors: Errors,
  { data, width }: Picture,
  { x, y, channel }: Readonly<Record<'x' | 'y' | 'channel', number>>,
  exact: number,
  near: () => readonly number[],
): void {
  const expected = Math.round(exact);
  const actual = data[4 * (y * width + x) + channel]!;
  let error = Math.abs(expected - actual);
  errors.compared += 1;
  if (error === 0) {
    errors.exact += 1;
  }
  if (error > 1) {
    error = outside(actual, [expected, ...near()]);
  }
  const max = Math.max(errors.max, error); // keeps NaN
  if (!Object.is(max, errors.max)) {
    errors.at = `pixel ${x}, ${y} channel ${channel}: ${actual} instead of ${exact}`;
  }
  errors.max = max;
}
