// Every attribute of the elements: what it gives where it is absent, valid, malformed or out of its domain, and what
// its property refuses. Values in HTML's units; a table to be read beside the one for users.

/** How an attribute behaves that is shared by many. */
export interface Row {
  readonly attribute: string;
  readonly property?: string;
  /** The property if the attribute is absent, malformed or out of its domain. */
  readonly fallback: unknown;
  /** Attribute texts and the resulting properties. */
  readonly valid: readonly (readonly [text: string, value: unknown])[];
  /** Malformed texts. */
  readonly malformed: readonly string[];
  /** Well-formed texts outside the domain. */
  readonly outside: readonly string[];
  /** Values that the property refuses, with the kind of error. */
  readonly refused: readonly (readonly [value: unknown, error: 'TypeError' | 'RangeError'])[];
}

/** Texts that are no number for any attribute. */
const noNumbers = ['', 'abc', '1px', '0x10', '1e', '--1', 'NaN', 'Infinity', '1 2 3 4 5'];
const notFinite = ['1e999', '-1e999'];

const number = (
  attribute: string,
  fallback: number | null | string,
  low: number,
  high: number,
  property?: string,
): Row => ({
  attribute,
  ...(property === undefined ? {} : { property }),
  fallback,
  valid: [
    [String(high), high],
    [` ${low} `, low],
    ['+7', 7],
    ['7.', 7],
    ['70e-1', 7],
    ...(low <= 0 ? ([['-0', 0], ['1e-320', 1e-320], ['.5', 0.5]] as const) : []), // prettier-ignore
  ],
  malformed: noNumbers,
  outside: [...notFinite, ...(Number.isFinite(high) ? [String(high * 1.1), '-1e9'] : [])],
  refused: [
    [NaN, 'RangeError'],
    [Infinity, 'RangeError'],
    [high * 1.1, 'RangeError'],
    ['abc', 'TypeError'],
    [{}, 'TypeError'],
    [[1], 'TypeError'],
    [true, 'TypeError'],
  ],
});

const vector = (attribute: string, fallback: unknown, limit: number, low = -limit): Row => ({
  attribute,
  fallback,
  valid: [
    ['1 2 3', [1, 2, 3]],
    [' 1,2 , 3 ', [1, 2, 3]],
    ['1\n2\t3', [1, 2, 3]],
    ['-0 1e-320 .5', [0, 1e-320, 0.5]],
    [`${limit} ${low} 0`, [limit, low, 0]],
  ],
  malformed: ['', '1 2', '1 2 3 4 5', '1 2 x', '1,,2 3', '1;2;3', '(1,2,3)', 'NaN 1 2'],
  outside: ['1e999 0 0', `0 ${limit * 1.1} 0`, `0 0 ${low === 0 ? -1 : low * 1.1}`],
  refused: [
    [[1, 2], 'TypeError'],
    [[1, 2, NaN], 'RangeError'],
    [[limit * 1.1, 0, 0], 'RangeError'],
    [['1', '2', '3'], 'TypeError'],
    [{ x: 1 }, 'TypeError'],
    ['1 2', 'TypeError'],
  ],
});

const color = (attribute: string, fallback: unknown): Row => ({
  attribute,
  fallback,
  valid: [
    ['1 2 3', [1, 2, 3]],
    ['12.5', [12.5, 12.5, 12.5]],
    ['300, 0, 1e6', [300, 0, 1e6]],
    ['#fc8', [255, 204, 136]],
    ['#FFCC8880', [255, 204, 136]],
    ['RebeccaPurple', [102, 51, 153]],
    ['rgb(10 20 30 / 50%)', [10, 20, 30]],
    ['hsl(120 100% 50%)', [0, 255, 0]],
    ['hwb(0 0% 0%)', [255, 0, 0]],
    ['color(srgb 1 0.5 0)', [255, 127.5, 0]],
    ['oklch(0 0 0)', [0, 0, 0]],
    ['transparent', [0, 0, 0]],
  ],
  malformed: ['', 'currentColor', 'color-mix(in srgb, currentColor, red)', 'nocolor', '#12', '1 2', 'rgb(1,2', 'inherit', 'var(--x)', 'red; blue', 'url(x)'], // prettier-ignore
  outside: [
    '-1 0 0',
    '1e7',
    '0 0 1e999',
    'color(display-p3 1 0 0)',
    'oklch(0.7 0.4 140)',
    'color(srgb 1.5 0 0)',
  ],
  refused: [
    [[1, 2], 'TypeError'],
    [[1, 2, -1], 'RangeError'],
    [[1, 2, 2e6], 'RangeError'],
    ['nocolor', 'TypeError'],
    [{}, 'TypeError'],
  ],
});

const choice = (attribute: string, fallback: string | null, ...choices: readonly string[]): Row => ({
  attribute,
  fallback,
  valid: choices.flatMap((name) => [[name, name], [` ${name.toUpperCase()} `, name]] as const), // prettier-ignore
  malformed: ['nothing', `${choices[0] ?? ''}x`, '1'],
  outside: [''],
  refused: [
    ['nothing', 'RangeError'],
    [1, 'TypeError'],
    [[choices[0]], 'TypeError'],
  ],
});

const flag = (attribute: string): Row => ({
  attribute,
  fallback: true,
  valid: [['true', true], ['', true], ['false', false], ['FALSE', false], [' true ', true]], // prettier-ignore
  malformed: ['no', '0', '1', attribute],
  outside: [],
  refused: [
    [1, 'TypeError'],
    ['no', 'TypeError'],
    [[], 'TypeError'],
  ],
});

const text = (attribute: string, fallback: string): Row => ({
  attribute,
  fallback,
  valid: [[' Any <b>text</b> ', ' Any <b>text</b> '], ['', fallback]], // prettier-ignore
  malformed: [],
  outside: [],
  refused: [
    [1, 'TypeError'],
    [['a'], 'TypeError'],
  ],
});

const withWord = (row: Row, word: string): Row => ({
  ...row,
  fallback: word,
  valid: [...row.valid, [word, word], [` ${word.toUpperCase()} `, word]],
});

const position: Row = {
  ...vector('position', [1, 2, 3, 0], 1e15),
  valid: [
    ['1 2 3', [1, 2, 3, 1]],
    ['3,2,1,0', [3, 2, 1, 0]],
    ['1 2 3 1', [1, 2, 3, 1]],
    ['-0 1e-320 1e15 -0', [0, 1e-320, 1e15, 0]],
  ],
  outside: ['1 2 3 0.5', '1 2 3 2', '1e16 0 0', '0 0 0 -1', '1e999 0 0 0'],
  refused: [
    [[1, 2], 'TypeError'],
    [[1, 2, 3, 4], 'RangeError'],
    ['1 2 x', 'TypeError'],
  ],
};

const scale: Row = {
  ...vector('scale', [1, 1, 1], 1e12),
  valid: [
    ['2', [2, 2, 2]],
    ['1 -2 0', [1, -2, 0]],
  ],
  malformed: ['', '1 2', 'big', '1 2 3 4'],
};

const terms: Row = {
  attribute: 'terms',
  fallback: ['ambient', 'diffuse', 'specular'],
  valid: [
    ['', []],
    ['specular ambient', ['ambient', 'specular']],
    ['Diffuse, DIFFUSE', ['diffuse']],
    ['ambient diffuse specular', ['ambient', 'diffuse', 'specular']],
  ],
  malformed: ['all', 'ambient+diffuse'],
  outside: ['ambient emissive'],
  refused: [
    [['emissive'], 'RangeError'],
    ['emissive', 'RangeError'],
    [7, 'TypeError'],
  ],
};

const helpers: Row = {
  ...terms,
  attribute: 'helpers',
  fallback: [],
  valid: [
    ['', ['lights']],
    ['grid lights', ['lights', 'grid']],
    ['Axes, AXES', ['axes']],
    ['lights axes grid normals bounds', ['lights', 'axes', 'grid', 'normals', 'bounds']],
  ],
  malformed: ['all', 'light'],
  outside: ['lights cameras'],
};

const presence = (attribute: string): Row => ({
  attribute,
  fallback: false,
  valid: [['false', false], ['FALSE', false], ['', true], [attribute, true], ['true', true]], // prettier-ignore
  malformed: [],
  outside: [],
  refused: [[1, 'TypeError']],
});

const panelList: Row = {
  ...presence('gui'),
  valid: [['', true], ['gui', true], ['true', true], ['false', false], ['camera lights', ['camera', 'lights']], ['Cutoff, theta', ['cutoff', 'theta']]], // prettier-ignore
  outside: ['lights cutoff', 'source', 'x'],
  refused: [[['lights', 'cutoff'], 'RangeError'], [['x'], 'RangeError'], [1, 'TypeError'], [[1], 'RangeError']], // prettier-ignore
};

const crossOrigin: Row = {
  ...choice('crossorigin', null, 'anonymous', 'use-credentials'),
  property: 'crossOrigin',
  valid: [['', 'anonymous'], ['Anonymous', 'anonymous'], ['use-credentials', 'use-credentials']], // prettier-ignore
  outside: [],
};

const geometries = ['box', 'sphere', 'cylinder', 'cone', 'pyramid', 'torus', 'torus-knot', 'teapot', 'plane'];
const shape: readonly Row[] = [
  text('src', ''),
  choice('type', null, 'obj', 'glb', 'model/stl'),
  choice('geometry', null, ...geometries),
  {
    ...withWord(number('segments', 'auto', 1, 512), 'auto'),
    outside: [...notFinite, '0', '513', '1.5', '-3'],
    valid: [['1', 1], ['512', 512], ['7.0', 7], ['AUTO', 'auto']], // prettier-ignore
  },
  presence('autoplay'),
  { ...text('animation-name', ''), property: 'animationName' },
  color('ka', [200, 200, 200]),
  color('kd', [200, 200, 200]),
  color('ks', [128, 128, 128]),
  number('shininess', 32, 0, 1e6),
];

const dividers: Row = {
  attribute: 'at',
  fallback: 'auto',
  valid: [
    ['30', [30]],
    [' 0,12.5 100 ', [0, 12.5, 100]],
    ['50 50', [50, 50]],
    ['AUTO', 'auto'],
  ],
  malformed: ['', 'half', '50%', '1 x'],
  outside: ['-1', '100.1', '60 40', '1e999'],
  refused: [
    [101, 'RangeError'],
    [[60, 40], 'RangeError'],
    [[NaN], 'RangeError'],
    [[], 'TypeError'],
    [['1'], 'TypeError'],
    [true, 'TypeError'],
    [{}, 'TypeError'],
  ],
};

/** Every attribute, by element. */
export const tables: Readonly<Record<string, readonly Row[]>> = {
  'phong-light': [
    text('name', 'light 1'),
    flag('active'),
    color('ambient', [0, 0, 0]),
    color('diffuse', [255, 255, 255]),
    color('specular', [255, 255, 255]),
    position,
    vector('axis', [0, 0, -1], 1e15),
    number('aperture', 180, 0, 180),
    number('cutoff', 0, 0, 1e6),
    vector('attenuation', [1, 0, 0], 1e6, 0),
    choice('space', 'world', 'world', 'camera'),
  ],
  'phong-mesh': [
    text('name', ''),
    ...shape,
    vector('position', [0, 0, 0], 1e15),
    vector('rotation', [0, 0, 0], 1e15),
    scale,
    choice('shading', null, 'phong', 'gouraud', 'flat'),
    choice('reflection', null, 'phong', 'blinn-phong'),
  ],
  'phong-viewer': [
    text('alt', ''),
    text('poster', ''),
    choice('loading', 'auto', 'auto', 'eager', 'lazy'),
    presence('droppable'),
    crossOrigin,
    ...shape,
    { ...number('theta', 30, -1e300, 1e300), outside: notFinite, refused: [[NaN, 'RangeError'], ['x', 'TypeError']] }, // prettier-ignore
    number('phi', 70, 0, 180),
    {
      ...withWord(number('radius', 'auto', 1e-3, 1e15), 'auto'),
      outside: ['0', '-1', '1e999', '2e15'],
      refused: [[0, 'RangeError'], [[1], 'TypeError'], ['far', 'TypeError']], // prettier-ignore
    },
    withWord(vector('target', 'auto', 1e15), 'auto'),
    number('fov', 45, 1, 170),
    flag('orbit'),
    flag('zoom'),
    number('auto-rotate', 0, -1e6, 1e6, 'autoRotate'),
    choice('shading', 'phong', 'phong', 'gouraud', 'flat'),
    choice('reflection', 'phong', 'phong', 'blinn-phong'),
    terms,
    choice('color-interpolation', 'srgb', 'srgb', 'linear'),
    choice('antialias', 'edges', 'edges', 'full'),
    {
      ...number('samples', 64, 16, 1024),
      outside: [...notFinite, '15', '1025', '64.5'],
      valid: [['16', 16], ['1024', 1024], ['100.0', 100], ['1e2', 100]], // prettier-ignore
    },
    {
      ...withWord(number('pixel-ratio', 'auto', 1e-3, 1e6, 'pixelRatio'), 'auto'),
      outside: ['0', '-1', '1e999', '2e6'],
      refused: [[0, 'RangeError'], [NaN, 'RangeError'], [[1], 'TypeError'], ['sharp', 'TypeError']], // prettier-ignore
    },
    helpers,
    choice('view', 'shaded', 'shaded', 'diffuse', 'n-dot-l', 'triangles'),
    { ...text('view-light', ''), property: 'viewLight' },
    presence('probe'),
    { ...vector('probe-at', null, 1e15), property: 'probeAt' },
    { ...text('camera-group', ''), property: 'cameraGroup' },
    panelList,
  ],
  'phong-compare': [
    choice('layout', 'split', 'split', 'side'),
    choice('direction', 'horizontal', 'horizontal', 'vertical'),
    dividers,
    {
      ...text('labels', ''),
      fallback: null,
      valid: [['Gouraud, Phong', 'Gouraud, Phong'], ['', '']], // prettier-ignore
      refused: [[1, 'TypeError'], [['a', 1], 'TypeError'], [['a, b'], 'TypeError']], // prettier-ignore
    },
  ],
};
