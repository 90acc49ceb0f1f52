// Random histories of faults: contexts that are refused or lost at any call, requests that fail,
// viewers that come and go, sizes from zero to far too large, hidden documents, printing. The same
// seed gives the same history.

import { Dice } from '../../visual/random-scene.js';
import type { Step } from '../histories/history-deeds.js';
import type { Scenario, Task } from '../histories/history-steps.js';

const light = '<phong-light position="1 2 3 0"></phong-light>';

/**
 * `teapot` and `torus-knot` are chunks of their own; the models need the reader, the bunny its
 * decoder as well.
 */
const VIEWERS = [
  `<phong-viewer geometry="box">${light}</phong-viewer>`,
  `<phong-viewer geometry="teapot" ks="0"></phong-viewer>`,
  `<phong-viewer src="/fixtures/models/textured.glb">${light}</phong-viewer>`,
  `<phong-viewer shading="flat"><phong-mesh geometry="torus-knot"></phong-mesh>${light}</phong-viewer>`,
  `<phong-viewer src="/assets/models/bunny.glb" color-interpolation="linear">${light}</phong-viewer>`,
] as const;

interface Choice {
  readonly weight: number;
  readonly what: string;
  readonly values: readonly string[];
  readonly key?: string;
}

const CHOICES: readonly Choice[] = [
  { weight: 5, what: 'lose', values: [''] },
  { weight: 4, what: 'restore', values: [''] },
  { weight: 3, what: 'lose after calls', values: ['0', '1', '5', '20', '60', '150', '400'] },
  { weight: 3, what: 'opening', values: ['null', 'throws', 'lost', 'works', 'works', 'works'] },
  { weight: 3, what: 'requests', values: ['models aborted', 'models missing', 'models cut', 'chunks aborted', 'answered', 'answered'] }, // oxfmt-ignore
  { weight: 4, what: 'take away', values: [''] },
  { weight: 4, what: 'bring back', values: [''] },
  { weight: 2, what: 'another viewer', values: VIEWERS },
  { weight: 2, what: 'hide', values: [''] },
  { weight: 2, what: 'show', values: [''] },
  { weight: 1, what: 'print', values: [''] },
  { weight: 3, what: 'size', values: ['0 0', '0 40', '30 200', '700 10', '', ''] },
  { weight: 0.5, what: 'size', values: ['20000 20', '2500 2500'] },
  { weight: 3, what: 'picture', values: ['30 40', '300 20', '4200 10'] },
  { weight: 2, what: 'explain', values: ['60 45', '1 1'] },
  { weight: 3, what: 'ready', values: [''] },
  { weight: 2, what: 'draw', values: [''] },
  { weight: 2, what: 'set', key: 'src', values: ['/fixtures/models/textured.glb', '/assets/models/bunny.glb', '/nowhere.glb', ''] }, // oxfmt-ignore
  { weight: 2, what: 'set', key: 'geometry', values: ['sphere', 'teapot', 'torus-knot', ''] },
  { weight: 2, what: 'set', key: 'shading', values: ['flat', 'gouraud', 'phong'] },
  { weight: 1, what: 'set', key: 'autoRotate', values: ['40', '0'] },
  { weight: 1, what: 'set', key: 'gui', values: ['true', 'false'] },
  { weight: 1, what: 'set', key: 'theta', values: ['0', '75'] },
];

const LARGEST: Choice = { weight: 0.3, what: 'size', values: ['9000 9000'] };

function step(dice: Dice, choices: readonly Choice[]): Step {
  const { what, values, key = '' } = dice.weighted(choices, ({ weight }) => weight);
  const viewer = Math.floor(dice.from(0, 5.999));
  return { what, viewer, child: 0, tag: 'phong-viewer', key, value: dice.pick(values) };
}

/** One to three viewers, `count` tasks of one to three steps, and a look at the end. */
export function randomFaults(seed: number, count: number, withLargest: boolean): Scenario {
  const dice = new Dice(seed);
  const choices = withLargest ? [...CHOICES, LARGEST] : CHOICES;
  const begins = Array.from({ length: dice.pick([1, 2, 3]) }, () => dice.pick(VIEWERS));
  const tasks = Array.from({ length: count }, (): Task => {
    const steps = Array.from({ length: dice.pick([1, 1, 2, 3]) }, () => step(dice, choices));
    return { steps, then: dice.pick(['at once', 'a frame', 'a frame', 'rest']) };
  });
  return { begins, tasks: [...tasks, { steps: [], then: 'look' }] };
}
