// The animations of a glTF document that can be played, and what they cost: channels of shown
// nodes, with samplers that fit their properties. An animation with a mistake is left out, and the
// model is shown without it. Knows the JSON only.
import type { ModelBudget } from '../../../phong/model/model-budget.js';
import type { Slices } from '../slices.js';
import type { Accessor, Accessors } from './accessors.js';
import { leftOutOf } from './extensions.js';
import { indexAt, objectAt, objectsAt, textAt, type JsonObject } from './json.js';

export type ChannelPath = 'translation' | 'rotation' | 'scale' | 'weights';

interface Channel {
  readonly node: number;
  readonly path: ChannelPath;
  /** Accessors of times and values. */
  readonly input: Accessor;
  readonly output: Accessor;
  /** Numbers per value. */
  readonly width: number;
  readonly interpolation: Interpolation;
}

export interface GltfAnimation {
  /** As in the file; may be empty. */
  readonly name: string;
  readonly channels: readonly Channel[];
}

/** Numbers per value; weights have one for each morph target. */
const WIDTHS: Readonly<Record<ChannelPath, number>> = {
  translation: 3,
  rotation: 4,
  scale: 3,
  weights: 0,
};
const INTERPOLATIONS = ['STEP', 'LINEAR', 'CUBICSPLINE'] as const;
export type Interpolation = (typeof INTERPOLATIONS)[number];

interface AnimationContext {
  readonly accessors: Accessors;
  /** Morph targets of each node's mesh; undefined for nodes that are not shown. */
  readonly targets: readonly (number | undefined)[];
  readonly budget: ModelBudget;
  /** Gets the animations with mistakes. */
  readonly dropped: Set<string>;
  readonly slices: Slices;
}

export async function readAnimations(
  json: JsonObject,
  context: AnimationContext,
): Promise<readonly GltfAnimation[]> {
  const { accessors, budget, dropped, slices } = context;
  const counted = new Set<Accessor>();
  const animations: GltfAnimation[] = [];
  for (const [i, animation] of objectsAt(json['animations'], 'animations').entries()) {
    await slices.pauseIfDue();
    try {
      const channels = await readChannels(animation, context);
      if (channels.length === 0) continue;
      for (const { input, output, width } of channels) {
        await slices.pauseIfDue();
        // In float64: the value without animation, and the present one.
        budget.add({ values: 4 * width });
        for (const accessor of [input, output]) {
          accessors.read(accessor);
          if (counted.has(accessor)) continue;
          counted.add(accessor);
          // Once as in the file and once as floats.
          budget.add({ values: 2 * accessor.count * accessor.components });
        }
      }
      animations.push({ name: textAt(animation['name']), channels });
    } catch (error) {
      if (!(error instanceof Error) || error.name !== 'Error') throw error; // too large
      dropped.add(`animations[${String(i)}] (${error.message})`);
    }
  }
  return animations;
}

async function readChannels(
  animation: JsonObject,
  context: AnimationContext,
): Promise<readonly Channel[]> {
  const { accessors, targets, dropped, slices } = context;
  const samplers = objectsAt(animation['samplers'], 'samplers');
  const channels = await slices.map(
    objectsAt(animation['channels'], 'channels'),
    (channel, i): Channel[] => {
      const what = `channels[${String(i)}]`;
      const target = objectAt(channel['target'], `${what}.target`);
      const path = textAt(target['path']);
      // Extensions can animate other properties, which are not named by a node.
      for (const name of leftOutOf(target)) {
        dropped.add(name);
      }
      if (target['node'] === undefined || !isPath(path)) return [];
      const node = indexAt(target['node'], targets.length, `${what}.target.node`);
      const sampler =
        samplers[indexAt(channel['sampler'], samplers.length, `${what}.sampler`)] ?? {};
      const width = path === 'weights' ? targets[node] : WIDTHS[path];
      if (targets[node] === undefined || width === undefined || width === 0) return [];
      const written = textAt(sampler['interpolation']) || 'LINEAR';
      const interpolation = INTERPOLATIONS.find((one) => one === written);
      if (interpolation === undefined) throw new Error(`${what} has an unknown interpolation`);
      const input = accessors.at(sampler['input'], `${what}.input`);
      const output = accessors.at(sampler['output'], `${what}.output`);
      const numbers = input.count * width * (interpolation === 'CUBICSPLINE' ? 3 : 1);
      if (input.components !== 1 || input.count === 0) throw new Error(`${what} has no times`);
      if (output.count * output.components < numbers) {
        throw new Error(`${what} has fewer values than times`);
      }
      if (output.components !== (path === 'weights' ? 1 : width)) {
        throw new Error(`${what} has values of another type`);
      }
      return [{ node, path, input, output, width, interpolation }];
    },
  );
  return channels.flat();
}

const isPath = (path: string): path is ChannelPath => Object.hasOwn(WIDTHS, path);
