// The motion of a glTF model. Keyframes, evaluated in float64, set its nodes, its nodes move parts
// and joints, and joints and weights deform geometries.
import { sinDegrees } from '../../../phong/math/angle.js';
import { acos } from '../../../phong/math/elementary.js';
import { BufferGeometry, Matrix4, Mesh, type Object3D } from 'three';
import { LIMITS } from '../../../phong/model/limits.js';
import type { Content, ContentPart } from '../../../phong/model/model.js';
import { clip, listed } from '../../../phong/fields/clip.js';
import { playable } from '../mesh-animation.js';
import { Slices } from '../slices.js';
import type { Accessor } from './accessors.js';
import type { ChannelPath, GltfAnimation, Interpolation } from './animations.js';
import { type Attribute, gathered } from './attributes.js';
import type { Deformation, JointPose } from './deformation.js';
import { keysWithin, Reach } from './reach.js';
import { type GeometrySize, sizeOfVertices } from '../../../phong/geometry/geometry-size.js';

type Motion = NonNullable<Content['motion']>;

/** The parts of a model that can move. */
export interface Movable {
  readonly scene: Object3D;
  /** Parts that follow a node, in the model's order. */
  readonly rigid: readonly RigidPart[];
  readonly joints: readonly JointPose[];
  readonly deformations: readonly Deformation[];
  /**
   * The weights of each node with morph targets, by the node's index; overwritten when it moves.
   */
  readonly weights: ReadonlyMap<number, Float64Array>;
}

export interface RigidPart {
  readonly part: ContentPart;
  readonly mesh: Mesh;
  /** The place of an instance within its node; null for the node's own. */
  readonly within: Matrix4 | null;
}

/**
 * Null if nothing can be animated.
 * @param file its name, for warnings.
 * @param dropped receives the animations with times or values that are not numbers.
 */
export async function readMotion(
  file: string,
  animations: readonly GltfAnimation[],
  source: {
    readonly node: (index: number) => Promise<Object3D>;
    readonly accessor: (accessor: Accessor) => Promise<Attribute>;
  },
  movable: Movable,
  parts: readonly ContentPart[],
  { dropped, slices }: { readonly dropped: Set<string>; readonly slices: Slices },
): Promise<Motion | null> {
  const clips: Clip[] = [];
  const weighted = new Map<Float64Array, Uint8Array>();
  const numbers = new Map<Attribute, Promise<Numbers>>();
  const numbersOf = async (accessor: Accessor): Promise<Numbers> => {
    const attribute = await source.accessor(accessor);
    const reading = numbers.get(attribute) ?? readNumbers(attribute, slices);
    numbers.set(attribute, reading);
    return reading;
  };
  for (const [i, { name, channels }] of animations.entries()) {
    const tracks: Track[] = [];
    for (const channel of channels) {
      await slices.pauseIfDue();
      const { path, width, interpolation } = channel;
      const times = await numbersOf(channel.input);
      const values = await numbersOf(channel.output);
      if (!times.ordered || !values.finite) break;
      const rotation = path === 'rotation';
      const keyframes = {
        times: times.array,
        values: values.array,
        width,
        interpolation,
        rotation,
      };
      const node = await source.node(channel.node);
      const weights = movable.weights.get(channel.node) ?? new Float64Array(width);
      if (path === 'weights') {
        const flags = weighted.get(weights) ?? new Uint8Array(width);
        weighted.set(weights, flags);
        (await weightedBy(values, width, slices)).forEach((flag, i) => (flags[i]! |= flag));
      }
      const target = targetOf(node, path, weights);
      tracks.push({ keyframes, ...target, value: target.rest.slice() });
    }
    const duration = tracks.reduce(
      (end, { keyframes }) => Math.max(end, keyframes.times.at(-1) ?? 0),
      0,
    );
    if (tracks.length === channels.length) {
      clips.push({ name, tracks, duration });
    } else {
      dropped.add(`animations[${String(i)}] (its times or values are not in order or no numbers)`);
    }
  }
  if (clips.length === 0) return null;
  const work = workOf(clips, movable, weighted);
  if (work <= LIMITS.pose) return motionOf(file, clips, movable, parts, work);
  const [taken, most] = [work, LIMITS.pose].map((steps) => steps.toLocaleString('en'));
  dropped.add(`its animations (a pose takes ${taken!} steps; at most ${most!} are computed)`);
  return null;
}

/** Steps of a joint, a track and a part: they take some times as long as a vertex. */
const JOINT = 8;

/** See {@link Motion.work}. @param weighted by the weights of a node. */
function workOf(
  clips: readonly Clip[],
  { rigid, joints, deformations }: Movable,
  weighted: ReadonlyMap<Float64Array, Uint8Array>,
): number {
  const tracks = clips.map((own) =>
    own.tracks.reduce((sum, { value }) => sum + JOINT + value.length, 0),
  );
  return [
    tracks.reduce((most, steps) => Math.max(most, steps), 0),
    JOINT * rigid.length,
    ...joints.map(({ matrices }) => (JOINT * matrices.length) / 16),
    ...deformations.map((one) => one.workOf(weighted.get(one.weights) ?? null)),
  ].reduce((sum, steps) => sum + steps, 0);
}

/** The clip of a name; the first one for an empty name, and for an unknown one, which warns once. */
function clipFinder(file: string, clips: readonly Clip[]): (wanted: string) => Clip {
  const unknown = new Set<string>();
  const quoted = (name: string) => JSON.stringify(clip(name));
  return (wanted) => {
    const found = clips.find(({ name }) => wanted === '' || name === wanted);
    if (found === undefined && !unknown.has(wanted)) {
      const names = listed(clips.map(({ name }) => quoted(name)));
      console.warn(
        `${file} has no animation ${quoted(wanted)}, so its first one is shown. It has: ${names}`,
      );
      unknown.add(wanted);
    }
    return found ?? clips[0]!;
  };
}

/** Sets all that moves to the pose of a clip at a time; to that of the file for null. */
function poserOf(clips: readonly Clip[], { scene, rigid, joints, deformations }: Movable) {
  // Their vertices are in the parts' geometries by now.
  scene.traverse((object) => {
    if (object instanceof Mesh) {
      object.geometry = EMPTY;
    }
  });
  for (const deformation of deformations) {
    deformation.keep();
  }
  const tracks = clips.flatMap(({ tracks: own }) => own);
  // Some have got a parent since: an animation that names one shows what is below it.
  const roots = new Set(
    joints.flatMap((pose) => [...pose.roots].filter(({ parent }) => parent === null)),
  );
  const matrix = new Matrix4();
  let posed: Clip | null = null;
  return (next: Clip | null, time: number): void => {
    if (next !== posed) {
      for (const { rest, set } of tracks) {
        set(rest);
      }
    }
    posed = next;
    if (next !== null) {
      for (const { keyframes, value, set } of next.tracks) {
        sampleTrack(keyframes, time, value);
        set(value);
      }
    }
    scene.updateMatrixWorld();
    for (const root of roots) {
      root.updateWorldMatrix(false, true);
    }
    for (const { part, mesh, within } of rigid) {
      if (within === null) {
        matrix.copy(mesh.matrixWorld);
      } else {
        matrix.multiplyMatrices(mesh.matrixWorld, within);
      }
      // Scales inside scales can leave the range of numbers. The part then stays where it was.
      if (matrix.elements.every(Number.isFinite)) {
        part.matrix.copy(matrix);
      }
    }
    for (const pose of joints) {
      pose.update();
    }
    for (const deformation of deformations) {
      deformation.update();
    }
  };
}

function motionOf(
  file: string,
  clips: readonly Clip[],
  movable: Movable,
  parts: readonly ContentPart[],
  work: number,
): Motion {
  const pose = poserOf(clips, movable);
  const clipOf = clipFinder(file, clips);
  const reaches = new Map<Clip, GeometrySize | null>();
  const read = async (one: Clip, slices: Slices): Promise<GeometrySize | null> => {
    const geometries = new Set(parts.map(({ geometry }) => geometry));
    let steps = work;
    for (const geometry of geometries) {
      steps += geometry.getAttribute('position').count;
    }
    const keys = await keysOf(one, slices);
    const reach = new Reach();
    for (const time of keysWithin(keys, steps)) {
      pose(one, time);
      await reach.add(parts, slices);
    }
    return sizeOfVertices(reach.vertices);
  };
  return playable({
    names: clips.map(({ name }) => name),
    work,
    durationOf: (name) => clipOf(name).duration,
    pose: (name, seconds) => {
      const next = name === null ? null : clipOf(name);
      pose(next, next !== null && next.duration > 0 ? seconds % next.duration : 0);
    },
    reach: async (name, signal) => {
      const one = clipOf(name);
      const present = reaches.get(one);
      const size = present === undefined ? await read(one, new Slices(signal)) : present;
      reaches.set(one, size);
      return size;
    },
    knownReach: (name) => reaches.get(clipOf(name)),
  });
}

/** The times of the keyframes of all tracks, in order. */
async function keysOf({ tracks }: Clip, slices: Slices): Promise<readonly number[]> {
  const keys = new Set<number>();
  for (const times of new Set(tracks.map(({ keyframes }) => keyframes.times))) {
    await slices.over(times.length, (from, to) => {
      for (let i = from; i < to; i += 1) {
        keys.add(times[i]!);
      }
    });
  }
  return [...keys].sort((a, b) => a - b);
}

const EMPTY = /* @__PURE__ */ new BufferGeometry();

interface Track {
  readonly keyframes: Keyframes;
  /** Without animation. */
  readonly rest: Float64Array;
  /** At the time that was set last. */
  readonly value: Float64Array;
  readonly set: (value: Float64Array) => void;
}

interface Clip {
  readonly name: string;
  readonly tracks: readonly Track[];
  readonly duration: number;
}

function targetOf(
  node: Object3D,
  path: ChannelPath,
  weights: Float64Array,
): Pick<Track, 'rest' | 'set'> {
  if (path === 'weights') return { rest: weights.slice(), set: (value) => weights.set(value) };
  const property = { translation: node.position, rotation: node.quaternion, scale: node.scale }[
    path
  ];
  return { rest: Float64Array.from(property.toArray()), set: (value) => property.fromArray(value) };
}

/** The numbers of an accessor as plain floats. */
interface Numbers {
  readonly array: Float32Array;
  readonly finite: boolean;
  /** Finite, at least 0, and none smaller than the one before. */
  readonly ordered: boolean;
  /** By a number of targets: see {@link weightedBy}. */
  readonly weighted: Map<number, Promise<Uint8Array>>;
}

async function readNumbers(source: Attribute, slices: Slices): Promise<Numbers> {
  const array = (await gathered(source, null, slices)).array as Float32Array;
  const numbers = { array, finite: true, ordered: true, weighted: new Map() };
  await slices.over(array.length, (from, to) => {
    for (let i = from; i < to; i += 1) {
      const isFinite = Number.isFinite(array[i]);
      numbers.finite &&= isFinite;
      numbers.ordered &&= isFinite && array[i]! >= (i === 0 ? 0 : array[i - 1]!);
    }
  });
  return numbers;
}

/** 1 for each of `width` targets that a key gives a weight. Counted once for each such width. */
function weightedBy(
  { array, weighted }: Numbers,
  width: number,
  slices: Slices,
): Promise<Uint8Array> {
  const count = async (): Promise<Uint8Array> => {
    const flags = new Uint8Array(width);
    await slices.over(array.length, (from, to) => {
      for (let i = from; i < to; i += 1) {
        if (array[i] !== 0) {
          flags[i % width] = 1;
        }
      }
    });
    return flags;
  };
  const flags = weighted.get(width) ?? count();
  weighted.set(width, flags);
  return flags;
}

interface Keyframes {
  /** Seconds, none smaller than the one before; at least one. */
  readonly times: Float32Array;
  /**
   * `width` numbers per keyframe; with `CUBICSPLINE` in-tangent, value and out-tangent, `width`
   * numbers each.
   */
  readonly values: Float32Array;
  readonly width: number;
  readonly interpolation: Interpolation;
  /** Values are unit quaternions. */
  readonly rotation: boolean;
}

/** Writes the value at `seconds` to `out`. Before the first and after the last keyframe, theirs. */
function sampleTrack(keyframes: Keyframes, seconds: number, out: Float64Array) {
  const { times, values, width, interpolation, rotation } = keyframes;
  const cubic = interpolation === 'CUBICSPLINE';
  const stride = cubic ? 3 * width : width;
  const first = cubic ? width : 0;
  const from = lastAtOrBefore(times, seconds);
  const to = from + 1;
  if (from < 0 || to >= times.length || interpolation === 'STEP') {
    const at = first + Math.max(from, 0) * stride;
    for (let c = 0; c < width; c += 1) {
      out[c] = values[at + c]!;
    }
  } else {
    const step = times[to]! - times[from]!;
    const t = (seconds - times[from]!) / step;
    const a = first + from * stride;
    const b = first + to * stride;
    const [p, q, m = 0, n = 0] = cubic
      ? hermite(t, step)
      : rotation
        ? slerp(values, a, b, t)
        : [1 - t, t];
    for (let c = 0; c < width; c += 1) {
      out[c] = p * values[a + c]! + q * values[b + c]!;
      if (cubic) {
        out[c]! += m * values[a + width + c]! + n * values[b - width + c]!;
      }
    }
  }
  if (rotation) {
    normalize(out);
  }
}

/** The index of the last time that is not after `seconds`; −1 if all are. */
function lastAtOrBefore(times: Float32Array, seconds: number): number {
  let low = -1;
  let high = times.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= seconds) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

/** Factors of value, next value, out-tangent and the next in-tangent (glTF 2.0, appendix C.5). */
function hermite(t: number, step: number): readonly [number, number, number, number] {
  const t2 = t * t;
  const t3 = t2 * t;
  return [2 * t3 - 3 * t2 + 1, 3 * t2 - 2 * t3, step * (t3 - 2 * t2 + t), step * (t3 - t2)];
}

/**
 * Rotations closer than this, as the sine of half the angle between them, are blended linearly:
 * equal to 1e-12.
 */
const NEARLY_EQUAL = 1e-6;

/** Factors of two quaternions for the shorter way between them (glTF 2.0, appendix C.4). */
function slerp(values: Float32Array, a: number, b: number, t: number): readonly [number, number] {
  let dot = 0;
  for (let c = 0; c < 4; c += 1) {
    dot += values[a + c]! * values[b + c]!;
  }
  const sign = dot < 0 ? -1 : 1;
  const angle = (acos(Math.min(Math.abs(dot), 1)) * 180) / Math.PI;
  const sine = sinDegrees(angle);
  if (sine < NEARLY_EQUAL) return [1 - t, sign * t];
  return [sinDegrees((1 - t) * angle) / sine, (sign * sinDegrees(t * angle)) / sine];
}

/** A quaternion without length becomes no rotation. */
function normalize(q: Float64Array) {
  const length = Math.sqrt(q[0]! * q[0]! + q[1]! * q[1]! + q[2]! * q[2]! + q[3]! * q[3]!);
  if (!(length > 0)) {
    q.set([0, 0, 0, 1]);
  } else {
    for (let c = 0; c < 4; c += 1) {
      q[c]! /= length;
    }
  }
}
