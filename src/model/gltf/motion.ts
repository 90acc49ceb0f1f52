// The motion of a glTF model. Keyframes set its nodes, its nodes move parts and joints, and joints and weights deform
// geometries.
import { BufferGeometry, Mesh, type Object3D } from 'three';
import type { ContentPart, Motion } from '../model.js';
import type { Accessor } from './accessors.js';
import type { Channel, ChannelPath, GltfAnimation } from './animations.js';
import type { Attribute } from './attributes.js';
import type { Deformation } from './deformation.js';
import type { JointPose } from './joint-pose.js';
import { type Keyframes, sample } from './tracks.js';

/** The parts of a model that can move. */
export interface Movable {
  readonly scene: Object3D;
  /** Parts that follow a node, in the model's order. */
  readonly rigid: readonly { readonly part: ContentPart; readonly mesh: Mesh }[];
  readonly joints: readonly JointPose[];
  readonly deformations: readonly Deformation[];
  /** The weights of each node with morph targets, by the node's index; overwritten when it moves. */
  readonly weights: ReadonlyMap<number, Float64Array>;
}

export interface MotionSource {
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
  dropped: Set<string>,
): Promise<Motion | null> {
  const clips: Clip[] = [];
  for (const [i, { name, channels }] of animations.entries()) {
    const tracks = await Promise.all(channels.map((channel) => readTrack(channel, source, movable)));
    const usable = tracks.flatMap((track) => track ?? []);
    if (tracks.length === usable.length) clips.push(new Clip(name, usable));
    else dropped.add(`animations[${String(i)}] (its times or values are not in order or no numbers)`);
  }
  return clips.length === 0 ? null : motionOf(file, clips, poser(clips, movable));
}

function motionOf(file: string, clips: readonly Clip[], pose: Pose): Motion {
  const unknown = new Set<string>();
  const clipOf = (wanted: string): Clip | undefined => {
    const found = wanted === '' ? clips[0] : clips.find(({ name }) => name === wanted);
    if (found === undefined && !unknown.has(wanted)) {
      const names = clips.map(({ name }) => JSON.stringify(name)).join(', ');
      console.warn(
        `${file} has no animation ${JSON.stringify(wanted)}, so its first one is shown. It has: ${names}`,
      );
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
  let posed: Clip | null = null;
  return (clip, seconds) => {
    if (clip !== posed) for (const { rest, set } of tracks) set(rest);
    posed = clip;
    clip?.set(seconds);
    scene.updateMatrixWorld();
    for (const { part, mesh } of rigid) {
      // Scales inside scales can leave the range of numbers. The part then stays where it was.
      if (mesh.matrixWorld.elements.every(Number.isFinite)) part.matrix.copy(mesh.matrixWorld);
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
      sample(keyframes, seconds, value);
      set(value);
    });
  }
}

/** Null if the keyframes are unusable. */
async function readTrack(channel: Channel, source: MotionSource, movable: Movable): Promise<Track | null> {
  const { path, width, interpolation } = channel;
  const [input, output] = await Promise.all([
    source.accessor(channel.input),
    source.accessor(channel.output),
  ]);
  const times = numbersOf(input);
  const values = numbersOf(output);
  const ordered = times.every((time, i) => time >= (i === 0 ? 0 : times[i - 1]!) && time < Infinity);
  if (!ordered || !values.every(Number.isFinite)) return null;
  const keyframes = { times, values, width, interpolation, rotation: path === 'rotation' };
  const node = await source.node(channel.node);
  return { keyframes, ...targetOf(node, path, movable.weights.get(channel.node) ?? new Float64Array(width)) };
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
        set: (value) => {
          weights.set(value);
        },
      };
  }
}

const known = new WeakMap<Attribute, Float32Array>();

/** Plain floats; the same array for the same accessor. */
function numbersOf(source: Attribute): Float32Array {
  const present = known.get(source);
  if (present) return present;
  const { count, itemSize } = source;
  const values = new Float32Array(count * itemSize);
  for (let i = 0; i < values.length; i += 1)
    values[i] = source.getComponent(Math.floor(i / itemSize), i % itemSize);
  known.set(source, values);
  return values;
}
