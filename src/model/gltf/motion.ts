// The motion of a glTF model. Keyframes set its nodes, its nodes move parts and joints, and joints and weights deform
// geometries.
import { BufferGeometry, Matrix4, Mesh, type Object3D } from 'three';
import type { ContentPart, Motion } from '../model.js';
import { clip, listed } from '../../fields/clip.js';
import type { Slices } from '../slices.js';
import type { Accessor } from './accessors.js';
import type { Channel, ChannelPath, GltfAnimation } from './animations.js';
import type { Attribute } from './attributes.js';
import type { Deformation } from './deformation.js';
import type { JointPose } from './joint-pose.js';
import { type Keyframes, sampleTrack } from './tracks.js';

/** The parts of a model that can move. */
export interface Movable {
  readonly scene: Object3D;
  /** Parts that follow a node, in the model's order. */
  readonly rigid: readonly RigidPart[];
  readonly joints: readonly JointPose[];
  readonly deformations: readonly Deformation[];
  /** The weights of each node with morph targets, by the node's index; overwritten when it moves. */
  readonly weights: ReadonlyMap<number, Float64Array>;
}

export interface RigidPart {
  readonly part: ContentPart;
  readonly mesh: Mesh;
  /** The place of an instance within its node; null for the node's own. */
  readonly within: Matrix4 | null;
}

interface MotionSource {
  node(index: number): Promise<Object3D>;
  accessor(accessor: Accessor): Promise<Attribute>;
}

/**
 * Null if nothing can be animated.
 * @param file its name, for warnings.
 * @param dropped receives the animations with times or values that are not numbers.
 */
export async function readMotion(
  file: string,
  animations: readonly GltfAnimation[],
  source: MotionSource,
  movable: Movable,
  { dropped, slices }: { readonly dropped: Set<string>; readonly slices: Slices },
): Promise<Motion | null> {
  const clips: Clip[] = [];
  const numbers = new Map<Attribute, Promise<Numbers>>();
  const numbersOf = async (accessor: Accessor): Promise<Numbers> => {
    const attribute = await source.accessor(accessor);
    const known = numbers.get(attribute) ?? readNumbers(attribute, slices);
    numbers.set(attribute, known);
    return known;
  };
  for (const [i, { name, channels }] of animations.entries()) {
    const tracks: Track[] = [];
    for (const channel of channels) {
      const keyframes = await readKeyframes(channel, numbersOf);
      if (keyframes === null) break;
      const node = await source.node(channel.node);
      const weights = movable.weights.get(channel.node) ?? new Float64Array(channel.width);
      tracks.push({ keyframes, ...targetOf(node, channel.path, weights) });
      await slices.pauseIfDue();
    }
    if (tracks.length === channels.length) clips.push(new Clip(name, tracks));
    else dropped.add(`animations[${String(i)}] (its times or values are not in order or no numbers)`);
  }
  return clips.length === 0 ? null : motionOf(file, clips, poser(clips, movable));
}

function motionOf(file: string, clips: readonly Clip[], pose: Pose): Motion {
  const unknown = new Set<string>();
  const quoted = (name: string): string => JSON.stringify(clip(name));
  const clipOf = (wanted: string): Clip | undefined => {
    const found = wanted === '' ? clips[0] : clips.find(({ name }) => name === wanted);
    if (found === undefined && !unknown.has(wanted)) {
      const names = listed(clips.map(({ name }) => quoted(name)));
      console.warn(`${file} has no animation ${quoted(wanted)}, so its first one is shown. It has: ${names}`);
      unknown.add(wanted);
    }
    return found ?? clips[0];
  };
  return {
    names: clips.map(({ name }) => name),
    durationOf: (name) => clipOf(name)?.duration ?? 0,
    pose: (name, seconds) => {
      const clip = name === null ? null : (clipOf(name) ?? null);
      pose(clip, clip !== null && clip.duration > 0 ? seconds % clip.duration : 0);
    },
  };
}

/** Times outside a clip give its first or last pose. Null: without animation. */
type Pose = (clip: Clip | null, seconds: number) => void;

function poser(clips: readonly Clip[], movable: Movable): Pose {
  const { scene, rigid, joints, deformations } = movable;
  // Their vertices are in the parts' geometries by now.
  scene.traverse((object) => {
    if (object instanceof Mesh) object.geometry = EMPTY;
  });
  for (const deformation of deformations) deformation.keep();
  const tracks = clips.flatMap((clip) => clip.tracks);
  const matrix = new Matrix4();
  let posed: Clip | null = null;
  return (clip, seconds) => {
    if (clip !== posed) for (const { rest, set } of tracks) set(rest);
    posed = clip;
    clip?.set(seconds);
    scene.updateMatrixWorld();
    for (const { part, mesh, within } of rigid) {
      if (within === null) matrix.copy(mesh.matrixWorld);
      else matrix.multiplyMatrices(mesh.matrixWorld, within);
      // Scales inside scales can leave the range of numbers. The part then stays where it was.
      if (matrix.elements.every(Number.isFinite)) part.matrix.copy(matrix);
    }
    for (const pose of joints) pose.update();
    for (const deformation of deformations) deformation.update();
  };
}

const EMPTY = /* @__PURE__ */ new BufferGeometry();

interface Track {
  readonly keyframes: Keyframes;
  /** Without animation. */
  readonly rest: Float64Array;
  readonly set: (value: Float64Array) => void;
}

class Clip {
  readonly name: string;
  readonly tracks: readonly Track[];
  readonly duration: number;
  readonly #values: readonly Float64Array[];

  constructor(name: string, tracks: readonly Track[]) {
    this.name = name;
    this.tracks = tracks;
    this.duration = tracks.reduce((end, { keyframes }) => Math.max(end, keyframes.times.at(-1) ?? 0), 0);
    this.#values = tracks.map(({ rest }) => rest.slice());
  }

  set(seconds: number): void {
    this.tracks.forEach(({ keyframes, set }, i) => {
      const value = this.#values[i]!;
      sampleTrack(keyframes, seconds, value);
      set(value);
    });
  }
}

/** Null if they are unusable. */
async function readKeyframes(
  { path, width, interpolation, input, output }: Channel,
  numbersOf: (accessor: Accessor) => Promise<Numbers>,
): Promise<Keyframes | null> {
  const times = await numbersOf(input);
  const values = await numbersOf(output);
  if (!times.ordered || !values.finite) return null;
  return { times: times.array, values: values.array, width, interpolation, rotation: path === 'rotation' };
}

function targetOf(node: Object3D, path: ChannelPath, weights: Float64Array): Omit<Track, 'keyframes'> {
  const { position, quaternion, scale } = node;
  switch (path) {
    case 'translation':
      return { rest: Float64Array.from(position.toArray()), set: (value) => position.fromArray(value) };
    case 'rotation':
      return { rest: Float64Array.from(quaternion.toArray()), set: (value) => quaternion.fromArray(value) };
    case 'scale':
      return { rest: Float64Array.from(scale.toArray()), set: (value) => scale.fromArray(value) };
    case 'weights':
      return {
        rest: weights.slice(),
        set: (value) => weights.set(value),
      };
  }
}

/** The numbers of an accessor as plain floats. Read and checked once, however many channels use it. */
interface Numbers {
  readonly array: Float32Array;
  readonly finite: boolean;
  /** Finite, at least 0, and none smaller than the one before. */
  readonly ordered: boolean;
}

async function readNumbers(source: Attribute, slices: Slices): Promise<Numbers> {
  const { count, itemSize } = source;
  const array = new Float32Array(count * itemSize);
  const faults = { finite: 0, ordered: 0 };
  await slices.over(array.length, (from, to) => {
    for (let i = from; i < to; i += 1) {
      const value = source.getComponent(Math.floor(i / itemSize), i % itemSize);
      array[i] = value;
      if (!Number.isFinite(value)) faults.finite += 1;
      if (!(value >= (i === 0 ? 0 : array[i - 1]!))) faults.ordered += 1;
    }
  });
  const finite = faults.finite === 0;
  return { array, finite, ordered: finite && faults.ordered === 0 };
}
