// Random histories of a page, as data: the first viewers, and what happens to them, task by task.
// The same seed gives the same history. Any part of a history is a history too.

import { Dice } from '../../visual/random-scene.js';
import type { Step } from './history-deeds.js';
import { treeStep } from './history-trees.js';

/** The steps of one task, and what follows. `look` compares the page with a new one. */
export interface Task {
  readonly steps: readonly Step[];
  readonly then: 'at once' | 'a frame' | 'rest' | 'look';
}

export interface Scenario {
  /** Markup of the first viewers. */
  readonly begins: readonly string[];
  readonly tasks: readonly Task[];
}

export type Mix =
  | 'all'
  | 'lights'
  | 'many lights'
  | 'meshes'
  | 'page'
  | 'motion'
  | 'trees'
  | 'still';

/** Random values of an attribute, covering every code path, and bad ones. */
type Values = (dice: Dice) => string;
const of =
  (...values: readonly string[]): Values =>
  (dice) =>
    dice.pick(values);
const numbers =
  (count: number, low: number, high: number): Values =>
  (dice) =>
    Array.from({ length: count }, () => dice.from(low, high)).join(' ');
const either =
  (...values: readonly Values[]): Values =>
  (dice) =>
    dice.pick(values)(dice);

const color = either(
  numbers(3, 0, 200),
  numbers(3, 0, 200),
  numbers(1, 0, 255),
  of('0', '0 0 0', '255', '#fc8', 'rebeccapurple', '300 20 500', '90 90 90'),
);
const dim = either(numbers(3, 0, 30), of('0', '20 20 20', '0 0 9'));
const place = numbers(3, -2, 2);
const bad = of('nonsense', '', '1 2', '-3', 'NaN', '1e99', '1 2 3 4 5', 'currentColor');

const LIGHT: Readonly<Record<string, Values>> = {
  active: of('true', 'false', 'false', ''),
  ambient: dim,
  diffuse: color,
  specular: color,
  position: either(
    place,
    (dice) => `${place(dice)} 0`,
    (dice) => `${place(dice)} 1`,
    of('0 0 0 0', '0 0 0 1', '0 3 0 1'),
  ),
  axis: either(place, place, of('0 -1 0', '0 0 0', '0 0 -1')),
  aperture: either(numbers(1, 0, 180), of('0', '3', '20', '60', '120', '180')),
  cutoff: either(numbers(1, 0, 40), of('0', '0.5', '1', '7', '64', '300')),
  attenuation: either(numbers(3, 0, 1), of('1 0 0', '0 0 0', '0.5 0 0', '1 0.2 0.1', '0 0 4')),
  space: of('camera', 'world'),
};

const SURFACE: Readonly<Record<string, Values>> = {
  ka: color,
  kd: color,
  ks: color,
  shininess: either(numbers(1, 0, 90), of('0', '1', '32', '33.5', '1000')),
};
const SHAPE: Readonly<Record<string, Values>> = {
  geometry: of(
    'box',
    'sphere',
    'plane',
    'box',
    'sphere',
    'plane',
    'cylinder',
    'cone',
    'pyramid',
    'torus',
    'teapot',
  ),
  segments: of('1', '3', '8', '16', '24'),
  src: of(
    '',
    '',
    '/fixtures/models/textured.glb',
    '/fixtures/models/vertex-colours.glb',
    '/fixtures/models/mask.glb',
  ),
};
const SHADING: Readonly<Record<string, Values>> = {
  shading: of('phong', 'gouraud', 'flat'),
  reflection: of('phong', 'blinn-phong'),
};
const MESH: Readonly<Record<string, Values>> = {
  ...SURFACE,
  ...SHAPE,
  ...SHADING,
  position: either(place, place, of('0 0 0')),
  rotation: either(numbers(3, -180, 180), of('0 0 0', '0 90 0')),
  scale: either(
    numbers(3, 0.2, 2),
    numbers(1, 0.2, 2),
    of('1', '-1 1 1', '0', '1 0 1', '-2', '3 0.2 3'),
  ),
};
const VIEWER: Readonly<Record<string, Values>> = {
  ...SURFACE,
  ...SHAPE,
  ...SHADING,
  theta: numbers(1, -400, 400),
  phi: either(numbers(1, 0, 180), of('0', '90', '180')),
  radius: either(numbers(1, 1, 6), of('auto')),
  target: either(numbers(3, -1, 1), of('auto', '0 0 0')),
  fov: either(numbers(1, 15, 100), of('45', '170')),
  terms: of('ambient diffuse specular', 'diffuse', 'ambient diffuse', 'specular', ''),
  'color-interpolation': of('linear', 'srgb'),
  antialias: of('edges', 'full'),
  samples: of('16', '64'),
  alt: of('a picture', ''),
  orbit: of('true', 'false', 'true', 'true'),
  zoom: of('true', 'false', 'true', 'true'),
};
const VALUES = { 'phong-light': LIGHT, 'phong-mesh': MESH, 'phong-viewer': VIEWER } as const;

type Tag = Step['tag'];

const property = (attribute: string) =>
  attribute.replace(/-([a-z])/g, (_, letter: string) => letter.toUpperCase());

function element(dice: Dice, tag: 'phong-light' | 'phong-mesh', share: number) {
  const attributes = Object.entries(VALUES[tag])
    .filter(
      ([key]) =>
        (tag === 'phong-mesh' && key === 'geometry') || dice.chance(key === 'src' ? 0.05 : share),
    )
    .map(([key, value]) => ` ${key}="${value(dice)}"`);
  return `<${tag}${attributes.join('')}></${tag}>`;
}

const light = (dice: Dice) => element(dice, 'phong-light', 0.5);
const lights = (dice: Dice, count: number, each: Values = light) =>
  Array.from({ length: count }, () => each(dice)).join('');

/** Small spots above a floor, for light grids. */
const smallSpot: Values = (dice) =>
  `<phong-light position="${dice.from(-2, 2)} ${dice.from(0.2, 0.6)} ${dice.from(-2, 2)} 1" axis="${dice.from(-0.2, 0.2)} -1 0" aperture="${dice.from(15, 40)}" diffuse="${color(dice)}" specular="40"></phong-light>`;

const faint: Values = (dice) =>
  light(dice)
    .replace(/ (diffuse|specular)="[^"]*"/g, '')
    .replace('>', ` diffuse="${dice.from(1, 9)} 5 4" specular="6">`);

const FLOOR = '<phong-mesh geometry="plane" scale="4"></phong-mesh>';

/** All lights are active, so that specialised programs come soon. */
const MOVING: readonly Values[] = [1, 3, 6].map(
  (count) => (dice) =>
    `<phong-viewer geometry="sphere" segments="24">${lights(dice, count, (d) => light(d).replace(/ active="[^"]*"/, ''))}</phong-viewer>`,
);
const SCENES: readonly Values[] = [
  (dice) => `<phong-viewer geometry="sphere" segments="24">${lights(dice, 3)}</phong-viewer>`,
  (dice) =>
    `<phong-viewer geometry="sphere" segments="24" radius="0.9" target="0 0 0">${lights(dice, 16, faint)}</phong-viewer>`,
  (dice) => `<phong-viewer geometry="box">${light(dice)}</phong-viewer>`,
  () => '<phong-viewer geometry="sphere" segments="16"></phong-viewer>',
  (dice) =>
    `<phong-viewer>${element(dice, 'phong-mesh', 0.4)}${element(dice, 'phong-mesh', 0.4)}${lights(dice, 5)}</phong-viewer>`,
  (dice) =>
    `<phong-viewer>${FLOOR}<phong-mesh geometry="box" position="${place(dice)}"></phong-mesh>${lights(dice, 4)}</phong-viewer>`,
];
const MANY: readonly Values[] = [
  (dice) => `<phong-viewer phi="40">${FLOOR}${lights(dice, 150, smallSpot)}</phong-viewer>`,
  (dice) =>
    `<phong-viewer geometry="sphere" segments="24">${lights(dice, 70, faint)}</phong-viewer>`,
  (dice) =>
    `<phong-viewer phi="50">${FLOOR}<phong-mesh geometry="box" scale="0.5"></phong-mesh>${lights(dice, 40, smallSpot)}</phong-viewer>`,
];

interface Maker {
  /** Relative frequency. */
  readonly weight: number;
  /** Factors of the frequency in some mixes. */
  readonly more?: Partial<Record<Mix, number>>;
  make(dice: Dice): Partial<Step>;
}

/** Attributes that select other programs. */
const STYLE = 'terms terms ks shininess shininess shading reflection color-interpolation'.split(
  ' ',
);

function styled(dice: Dice): Partial<Step> {
  const key = dice.pick(STYLE);
  const value =
    key === 'shininess' ? dice.pick(['1', '7', '32', '33.5', '1000']) : VIEWER[key]!(dice);
  return { what: 'set attribute', tag: 'phong-viewer', key, value };
}

function written(dice: Dice, tag: Tag): Partial<Step> {
  const [name, value] = dice.pick(
    Object.entries<Values>(VALUES[tag]).filter(([key]) => key !== 'src' || dice.chance(0.2)),
  );
  const what = dice.pick([
    'set attribute',
    'set property',
    'set property',
    'set attribute',
    'remove attribute',
    'clear property',
  ]);
  const key = what.endsWith('property') ? property(name) : name;
  const isBad = dice.chance(0.04) && !['src', 'alt', 'segments'].includes(name);
  const again = dice.chance(0.3) ? { child: -1 } : {};
  return { what, tag, key, value: isBad ? bad(dice) : value(dice), ...again };
}

const child = (dice: Dice): Tag => dice.pick(['phong-light', 'phong-light', 'phong-mesh'] as const);

const MAKERS: readonly Maker[] = [
  {
    weight: 14,
    more: { lights: 3, 'many lights': 3 },
    make: (dice) => written(dice, 'phong-light'),
  },
  { weight: 8, more: { meshes: 4, 'many lights': 2 }, make: (dice) => written(dice, 'phong-mesh') },
  { weight: 8, make: (dice) => written(dice, 'phong-viewer') },
  { weight: 1, more: { motion: 10 }, make: styled },
  { weight: 4, more: { lights: 2 }, make: (dice) => ({ what: 'add', value: light(dice) }) },
  { weight: 2, more: { meshes: 3 }, make: (dice) => ({ what: 'add', value: element(dice, 'phong-mesh', 0.3) }) }, // oxfmt-ignore
  { weight: 5, make: (dice) => ({ what: 'remove', tag: child(dice) }) },
  {
    weight: 4,
    make: (dice) => ({ what: dice.pick(['to the end', 'to the front']), tag: child(dice) }),
  },
  {
    weight: 4,
    more: { page: 2 },
    make: (dice) => ({ what: 'to another', tag: child(dice), value: '1' }),
  },
  {
    weight: 3,
    make: (dice) => ({ what: 'clone', tag: child(dice), value: dice.pick(['0', '1']) }),
  },
  { weight: 0.5, make: (dice) => ({ what: 'children', value: dice.pick(['', lights(dice, 2), lights(dice, 30, smallSpot)]) }) }, // oxfmt-ignore
  { weight: 6, more: { 'many lights': 2 }, make: (dice) => ({ what: 'move lights', value: dice.pick(['1', '1', '2', '3', '5', '25']) }) }, // oxfmt-ignore
  { weight: 2, more: { motion: 3, 'many lights': 3 }, make: (dice) => ({ what: 'move a mesh', value: dice.pick(['1', '4']) }) }, // oxfmt-ignore
  { weight: 4, make: (dice) => ({ what: 'draw on', value: dice.pick(['1', '5', '25', '25']) }) }, // oxfmt-ignore
  { weight: 1, make: (dice) => ({ what: 'turn', value: dice.pick(['50', '-300']) }) },
  {
    weight: 3,
    more: { motion: 2 },
    make: (dice) => ({ what: 'drag', value: numbers(2, -40, 40)(dice) }),
  },
  { weight: 2, make: (dice) => ({ what: 'wheel', value: String(dice.from(-300, 300)) }) },
  { weight: 1, make: () => ({ what: 'reset camera' }) },
  { weight: 3, more: { page: 4 }, make: (dice) => ({ what: 'style', key: dice.pick(['width', 'height']), value: `${Math.round(dice.from(20, 140))}px` }) }, // oxfmt-ignore
  { weight: 2, more: { page: 4 }, make: (dice) => ({ what: 'style', key: 'display', value: dice.pick(['none', '', 'block']) }) }, // oxfmt-ignore
  { weight: 1, more: { page: 2 }, make: (dice) => ({ what: 'style', key: 'visibility', value: dice.pick(['hidden', '']) }) }, // oxfmt-ignore
  { weight: 2, more: { page: 4 }, make: (dice) => ({ what: 'scroll', value: dice.pick(['0', '0', '60', '2000']) }) }, // oxfmt-ignore
  { weight: 2, more: { page: 4 }, make: () => ({ what: 'to another parent' }) },
  { weight: 1.5, more: { page: 4 }, make: () => ({ what: 'take away' }) },
  { weight: 2.5, more: { page: 4 }, make: () => ({ what: 'bring back' }) },
  { weight: 1.5, more: { page: 4 }, make: (dice) => ({ what: 'another viewer', value: dice.pick(SCENES)(dice) }) }, // oxfmt-ignore
  { weight: 1, more: { page: 2 }, make: () => ({ what: 'clone viewer' }) },
  { weight: 2, more: { page: 4 }, make: () => ({ what: 'no viewer' }) },
  { weight: 0.7, more: { page: 2, motion: 4 }, make: () => ({ what: 'lose' }) },
  { weight: 0.5, more: { page: 2 }, make: () => ({ what: 'restore' }) },
  {
    weight: 2,
    make: (dice) => ({ what: 'picture', value: dice.pick(['30 40', '200 20', '300 300']) }),
  },
  { weight: 2, make: (dice) => ({ what: 'explain', value: numbers(2, 0, 60)(dice) }) },
  { weight: 1, make: () => ({ what: 'draw again' }) },
  { weight: 0.7, make: (dice) => ({ what: 'an own object', value: place(dice) }) },
  { weight: 0.7, make: () => ({ what: 'own object away' }) },
  { weight: 0.7, make: (dice) => ({ what: 'set attribute', tag: 'phong-viewer', key: 'gui', value: dice.pick(['', 'false', 'false']) }) }, // oxfmt-ignore
  { weight: 0.3, more: { page: 2 }, make: () => ({ what: 'print' }) },
  { weight: 0.3, more: { page: 2 }, make: (dice) => ({ what: 'ratio', value: dice.pick(['1', '1.5', '2']) }) }, // oxfmt-ignore
];

const made = (dice: Dice): Step => ({
  what: '',
  tag: 'phong-light',
  key: '',
  value: '',
  viewer: Math.floor(dice.from(0, 5.999)),
  child: Math.floor(dice.from(0, 199)),
});

/** Attributes that may have any value. Excludes those that fetch or keep moving. */
const ANY_VALUE = Object.values(VALUES)
  .flatMap((values) => ['name', ...Object.keys(values)])
  .filter((key) => key !== 'src');

function step(dice: Dice, mix: Mix): Step {
  if (mix === 'trees' && dice.chance(0.75)) return { ...made(dice), ...treeStep(dice, ANY_VALUE) };
  // Long enough for some samples, or for all.
  if (mix === 'still' && dice.chance(0.4)) {
    return { ...made(dice), what: 'stand still', value: dice.pick(['5', '8', '20']) };
  }
  const frequent = mix === 'still' ? 'page' : mix;
  const maker = dice.weighted(MAKERS, ({ weight, more }) => weight * (more?.[frequent] ?? 1));
  return { ...made(dice), ...maker.make(dice) };
}

/** Chosen by the seed, unless a test names one. */
const MIXES: readonly Mix[] = ['all', 'lights', 'many lights', 'meshes', 'page', 'motion'];

const several = (dice: Dice, mix: Mix, counts: readonly number[]) =>
  Array.from({ length: dice.pick(counts) }, () => step(dice, mix));

function anything(dice: Dice, mix: Mix): Task[] {
  const count = Math.floor(dice.from(1, 6.999));
  return Array.from({ length: count }, (_, i): Task => {
    const then =
      i === count - 1 ? 'look' : dice.pick(['at once', 'a frame', 'a frame', 'rest'] as const);
    return { steps: several(dice, mix, mix === 'trees' ? [10, 20, 50] : [1, 1, 1, 2, 3, 5]), then };
  });
}

/** Motion until specialised programs have taken over, then changes, then perhaps more motion. */
function afterMotion(dice: Dice, mix: Mix): Task[] {
  const { viewer } = made(dice);
  const moving = (value: string): Step => ({
    ...made(dice),
    viewer,
    what: dice.pick(['draw on', 'move lights', 'move lights']),
    value,
  });
  const changes = dice.chance(0.5)
    ? [{ ...made(dice), ...styled(dice), viewer }]
    : several(dice, mix, [1, 1, 2]);
  return [
    { steps: [moving('45')], then: 'at once' },
    { steps: changes, then: dice.pick(['at once', 'a frame']) },
    { steps: dice.chance(0.5) ? [moving('3')] : [], then: 'look' },
  ];
}

const converging = (markup: string) =>
  markup.replace('<phong-viewer', '<phong-viewer antialias="full" samples="64"');

/** A history of one to three viewers with this many looks. */
export function randomHistory(
  seed: number,
  looks: number,
  mix: Mix = MIXES[seed % MIXES.length]!,
): Scenario {
  const dice = new Dice(seed);
  const scenes = mix === 'many lights' ? MANY : mix === 'motion' ? MOVING : SCENES;
  const viewers = dice.pick(mix === 'many lights' || mix === 'motion' ? [1, 1, 2] : [1, 1, 2, 3]);
  const cycle = mix === 'motion' ? afterMotion : anything;
  const tasks = Array.from({ length: looks }, () => cycle(dice, mix)).flat();
  const begins = Array.from({ length: viewers }, () => dice.pick(scenes)(dice));
  return { begins: mix === 'still' ? begins.map(converging) : begins, tasks };
}
