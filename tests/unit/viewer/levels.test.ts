// Do the levels of `segments="auto"` follow the shapes' measured constants, within the viewer's
// limit of triangles? That the constants are right: levels-picture.test.ts.
import { Euler, Matrix4, Mesh, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { scale, type Vec3 } from '../../../src/phong/math/vector.js';
import { basisOf } from '../../../src/phong/camera/orbit.js';
import {
  cutFor,
  isLargeFor,
  levelFor,
  levelIn,
  reducedLevelIn,
  segmentsIn,
} from '../../../src/phong/model/shapes/segments.js';
import {
  createGeometry,
  GEOMETRIES,
  type GeometryName,
  roundOf,
  trianglesOf,
} from '../../../src/phong/model/shapes/shapes.js';
import { FIXED, type Level } from '../../../src/viewer/scene/mesh/shared-shapes.js';
import type { Frame } from '../../../src/viewer/scene/frame.js';
import { Levels } from '../../../src/viewer/scene/mesh/levels.js';
import type { Frustum } from '../../../src/phong/geometry/frustum-clip.js';

type RoundName = Exclude<GeometryName, 'box' | 'plane' | 'pyramid'>;
const NAMES = GEOMETRIES.filter((name) => roundOf(name) !== undefined) as RoundName[];

describe('a level', () => {
  it.each(NAMES)(
    'of the %s is a multiple of 8, as fine as needed, at most a quarter finer, and has at most 131,072 triangles',
    (name) => {
      const { most } = roundOf(name)!;
      expect(trianglesOf(name, most)).toBeLessThanOrEqual(131_072);
      const least = name === 'torus-knot' ? 32 : 16;
      for (let segments = 0; segments < 2.5 * most; segments += 0.37) {
        const level = levelFor(segments, name);
        expect(level % 8).toBe(0);
        if (level < segments) {
          expect(level).toBe(most);
        }
        if (level > Math.max(1.25 * segments, segments + 8)) {
          expect(level).toBe(least);
        }
      }
      expect(levelFor(Infinity, name)).toBe(most);
      expect(levelFor(NaN, name)).toBe(least);
    },
  );

  it('is one of few, so that a camera that comes near builds few', () => {
    const levels = new Set(Array.from({ length: 4000 }, (_, i) => levelFor(i / 10, 'sphere')));
    expect([...levels]).toEqual([
      16, 24, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320, 360,
    ]);
  });

  it.each(NAMES)(
    'of the %s has its vertices as far outside it as the constants say, and true normals',
    async (name) => {
      const { out, half, radius } = roundOf(name)!;
      // A level of the teapot has more vertices.
      const plain = await createGeometry(name, 32, name === 'teapot');
      const level = await createGeometry(name, 32, true);
      const distance = out / 32 ** 2;
      const from = plain.getAttribute('position').array;
      const to = level.getAttribute('position').array;
      let most = 0;
      for (let i = 0; i < from.length; i += 3) {
        const moved = [0, 1, 2].map((k) => to[i + k]! - from[i + k]!);
        most = Math.max(most, Math.hypot(...moved));
      }
      expect(most).toBeCloseTo(distance, 6);
      expect(level.index!.array).toEqual(plain.index!.array);
      // What is drawn lies within the bounds that culling uses.
      for (let i = 0; i < to.length; i += 1) {
        expect(Math.abs(to[i]!)).toBeLessThanOrEqual(half[(i % 3) as 0] + distance + 1e-7);
      }
      expect(level.boundingSphere!.radius).toBeCloseTo(radius + distance, 12);
    },
  );
});

/** A view along −z from the origin's `distance`. */
function viewFrom(distance: number, fov = 45): Frustum {
  const slopeY = Math.tan((fov * Math.PI) / 360);
  const { right, up, back } = basisOf({ theta: 0, phi: 90 });
  return {
    frame: { origin: [0, 0, 0], eye: [0, 0, distance], right, up, back },
    slopeX: (slopeY * 4) / 3,
    slopeY,
    radius: distance,
  };
}

const at = (x: number, y: number, z: number) => new Matrix4().setPosition(x, y, z).elements;

describe('the number of segments that a shape needs', () => {
  const sphere = roundOf('sphere')!;

  it('is 0 for a sphere whose outline is outside the picture, and not where a corner shows it', () => {
    const corner = Math.hypot(1, 4 / 3) * Math.tan(Math.PI / 8);
    const filled = 0.5 / Math.sin(Math.atan(corner));
    const need = (share: number, x: number) =>
      segmentsIn(viewFrom(share * filled), 1000, sphere, at(x, 0, 0));
    expect([need(0.99, 0), need(0.9, 0)]).toEqual([0, 0]);
    for (const n of [need(1.01, 0), need(0.9, 0.2)]) {
      expect(n).toBeGreaterThan(30);
    }
  });

  interface Seen {
    readonly view: Frustum;
    readonly matrix: readonly number[];
    /**
     * Of the sphere's middle from the view's, at its depth, and of the picture's edge at depth 1.
     */
    readonly aside: number;
    readonly edge: number;
    readonly text: string;
  }

  /** Spheres between the middle of a view and its right edge, or its corner. */
  function* spheres(distances: readonly number[]) {
    for (const fov of [10, 45, 120, 150, 170]) {
      for (const distance of distances) {
        const view = viewFrom(distance, fov);
        for (const upward of [0, view.slopeY]) {
          const edge = Math.hypot(view.slopeX, upward);
          for (const share of [0, 0.1, 0.3, 0.6, 0.9]) {
            const aside = share * distance * edge;
            if (Math.hypot(aside, distance) <= 0.5) continue;
            const matrix = at(share * distance * view.slopeX, share * distance * upward, 0);
            const text = `${fov}° from ${distance} at ${share} of ${edge}`;
            yield { view, matrix, aside, edge, text };
          }
        }
      }
    }
  }

  /** In pixels of a picture 400 high: of the outline of `n` segments, as far as it is in view. */
  function outlineErrors({ view, aside, edge }: Seen, n: number) {
    const distance = view.frame.eye[2];
    // Rays that touch the sphere on both sides, and once with the radius that is drawn.
    return [-1, 1].flatMap((sign) => {
      const angle = (radius: number) =>
        Math.atan2(aside, distance) + sign * Math.asin(radius / Math.hypot(aside, distance));
      const place = Math.tan(angle(0.5));
      if (Math.abs(angle(0.5)) >= Math.PI / 2 || Math.abs(place) > edge) return [];
      const drawn = Math.tan(angle(0.5 - sphere.gap / n ** 2));
      return Math.abs(((drawn - place) * 400) / (2 * view.slopeY));
    });
  }

  it('keeps the outline of a sphere within the tolerance wherever it is in the picture', () => {
    for (const seen of spheres([0.4, 0.52, 0.7, 2, 30])) {
      const { view, matrix, text } = seen;
      const n = segmentsIn(view, (4 * 400) / (2 * view.slopeY), sphere, matrix);
      for (const error of n === null ? [] : outlineErrors(seen, n)) {
        expect(error, text).toBeLessThan(0.251);
      }
    }
  });

  it('is what a level has wherever a wide view stretches a sphere over many pixels', () => {
    let compared = 0;
    for (const seen of spheres([0.7, 2, 4])) {
      const level = levelIn(seen.view, 400, false, 'sphere', seen.matrix, 2 ** 14);
      for (const error of level === null ? [] : outlineErrors(seen, level)) {
        expect(error, seen.text).toBeLessThan(0.251);
        compared += 1;
      }
    }
    expect(compared).toBeGreaterThan(100);
  });

  it('is none out of view, and bounded where the eye is on the surface', () => {
    const view = viewFrom(3);
    for (const place of [at(0, 0, 4), at(9, 0, 0), at(0, 9, 0)]) {
      expect(segmentsIn(view, 1000, sphere, place)).toBeNull();
    }
    expect(segmentsIn(view, 1000, sphere, at(0, 0, 2.5))).toBeLessThan(250);
    expect(segmentsIn(view, 1000, roundOf('torus')!, at(0, 0, 2.9))).toBeLessThan(300);
    expect(segmentsIn(view, 1000, sphere, at(0, 0, 3))).toBeLessThan(200);
  });

  it('is a number in every direction, whatever is rounded', () => {
    for (let theta = 0; theta < 360; theta += 1.7) {
      const { right, up, back } = basisOf({ theta, phi: 70 });
      const eye = scale(back, 1.3719);
      const view = { ...viewFrom(1), frame: { origin: [0, 0, 0] as const, eye, right, up, back } };
      expect(segmentsIn(view, 1000, sphere, at(0, 0, 0)), String(theta)).toBeGreaterThan(40);
    }
  });

  it('follows the constants of each shape, and grows with the root of the resolution', () => {
    const view = viewFrom(3);
    const needed = (name: RoundName, finest = 1000) =>
      segmentsIn(view, finest, roundOf(name)!, at(0.1, 0, 0))!;
    for (const name of NAMES) {
      expect(needed(name, 4000) / needed(name)).toBeCloseTo(2, 9);
    }
    const rounded = NAMES.map((name) => `${name} ${needed(name).toFixed(1)}`).join(', ');
    expect(rounded).toBe(
      'sphere 29.5, cylinder 24.1, cone 24.1, torus 36.6, torus-knot 128.3, teapot 32.6',
    );
  });
});

describe('the level of a shape', () => {
  const level = (
    name: RoundName,
    distance: number,
    height: number,
    sampled = false,
    free = 2 ** 14,
  ) => levelIn(viewFrom(distance), height, sampled, name, at(0, 0, 0), free);

  it('is as fine as the shading of its faces needs where it is small, and as its outline where it is large', () => {
    expect(level('sphere', 1.37, 60)).toBe(64);
    expect(level('sphere', 1.37, 1080)).toBe(112);
    expect(level('sphere', 1.37, 60, true)).toBe(112);
    expect(level('cone', 2, 60)).toBe(48);
  });

  it('has at most one triangle for 16 pixels that it covers, but for those that are free', () => {
    for (const name of NAMES) {
      for (const height of [60, 200, 400, 1080, 2160]) {
        const distance = (1.05 * roundOf(name)!.radius) / Math.sin(Math.PI / 8);
        const covered = roundOf(name)!.cover * (Math.PI / 4) * height ** 2; // a little less than in the picture
        for (const free of [0, 2 ** 14]) {
          const shown = level(name, distance, height, false, free)!;
          const most = Math.max(free, covered / 16, trianglesOf(name, levelFor(0, name)));
          expect(trianglesOf(name, shown), `${name} ${height}`).toBeLessThanOrEqual(most);
        }
      }
    }
  });

  it('keeps the outline within a pixel where the picture moves with fewer', () => {
    for (const name of NAMES) {
      for (const height of [60, 200, 400, 1080]) {
        const view = viewFrom((1.05 * roundOf(name)!.radius) / Math.sin(Math.PI / 8));
        const shown = reducedLevelIn(view, height, name, at(0, 0, 0));
        const pixel = segmentsIn(view, height / (2 * view.slopeY), roundOf(name)!, at(0, 0, 0))!;
        expect((pixel / shown) ** 2, `${name} ${height}`).toBeLessThanOrEqual(1);
        expect(shown).toBeLessThanOrEqual(Math.max(1.25 * pixel + 8, levelFor(0, name)));
      }
    }
  });

  it('is the coarsest one for a dot, and the finest one that the picture can show for an eye at its surface', () => {
    expect(level('sphere', 100, 120)).toBe(16);
    expect(level('torus', 0.51, 1080)).toBe(256);
    expect(level('torus', 0.51, 1080, true)).toBe(360);
    expect(level('sphere', -3, 1080)).toBeNull();
  });
});

describe('a flat shape', () => {
  const isLarge = (name: 'plane' | 'box', size: Vec3, eye: Vec3) => {
    const turn = new Matrix4().makeRotationFromEuler(new Euler(1, 2, 3)).setPosition(5, 6, 7);
    const origin = new Vector3(1, 2, 3);
    const seen = new Vector3(...eye).applyMatrix4(turn).sub(origin);
    const view = viewFrom(1);
    const frame = { ...view.frame, origin: origin.toArray(), eye: seen.toArray() };
    return isLargeFor({ ...view, frame }, name, turn.scale(new Vector3(...size)).elements);
  };

  it('is large if its longest side is more than 8 times the distance of the eye', () => {
    for (const z of [80, -20]) {
      for (const side of [1, -1]) {
        expect(isLarge('plane', [80, 1, z], [5, side * 10.01, 5])).toBe(false);
        expect(isLarge('plane', [80, 1, z], [5, side * 9.99, 5])).toBe(true);
      }
    }
  });

  it('is not large from afar in its plane, and around an eye only where that is close to a wall', () => {
    expect(isLarge('box', [1, 1, 1], [4, 0.5, 0])).toBe(false);
    expect(isLarge('plane', [1, 1, 1], [4, 1e-9, 0])).toBe(false);
    expect(isLarge('box', [10, 6, 10], [0, 0, 0])).toBe(false);
    expect(isLarge('box', [10, 6, 10], [0, -2, 0])).toBe(true);
  });

  it('that is large is cut the same for an eye that moves a little, by cubes that reach its distance', () => {
    const cutFrom = (x: number, y: number) => {
      const view = viewFrom(1);
      const frame = { ...view.frame, origin: [0, 0, 0] as Vec3, eye: [x, y, 0] as Vec3 };
      const matrix = new Matrix4().makeScale(80, 1, 40).elements;
      return cutFor({ ...view, frame }, 'plane', matrix);
    };
    const cut = cutFrom(10, 1);
    expect(cut).toEqual({ center: [0.125, 1, 0], half: [2 / 80, 2, 2 / 40] });
    expect(cutFrom(10.2, 1.1)).toEqual(cut);
    expect(cutFrom(11, 1)).not.toEqual(cut);
    expect(cutFrom(10, 0.05).half[0]).toBeLessThan(0.002);
    for (const y of [0, 1e-30]) {
      const flat = cutFrom(10, y);
      expect(Math.min(...flat.half)).toBeGreaterThan(0);
      expect([...flat.center, ...flat.half].every(Number.isFinite)).toBe(true);
    }
  });

  it('is looked at only while it could be large, and once more to be whole again; once the time is over, one is cut at a time', () => {
    let passes = 0;
    const shown = { auto: 'box' as const, isFixed: false, level: FIXED as Level };
    const later = { ...shown };
    const levels = new Levels({
      style: { shading: 'phong' },
      budget: { limit: Infinity, used: 0 },
      get meshes() {
        passes += 1;
        return [shown, later].map((one) => ({
          shown: Object.assign(one, { parts: [{ mesh: new Mesh() }] }),
        }));
      },
    });
    const look = (z: number) => {
      passes = 0;
      const view = viewFrom(1);
      const frame = { ...view.frame, origin: [0, 0, 0] as Vec3, eye: [0, 0, z] as Vec3 };
      const bounds = { center: [0, 0, 0] as Vec3, radius: Math.sqrt(0.75) };
      levels.choose({ view: { ...view, frame } } as Frame, bounds, -1);
      const isCut = [shown, later].map(({ level }) => level !== FIXED);
      return [passes, ...isCut, levels.isPaused].join(' ');
    };
    expect(look(1.09)).toBe('1 false false false'); // counts the round shapes
    expect(look(0.6)).toBe('1 true false true');
    expect(look(1.08)).toBe('1 false false true');
    expect(look(1.09)).toBe('1 false false false');
    expect(look(1.09)).toBe('0 false false false');
    levels.changed();
    expect(look(1.09)).toBe('1 false false false');
  });
});
