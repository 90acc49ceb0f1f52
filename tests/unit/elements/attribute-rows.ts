// Every attribute of the elements: what it gives where it is absent, valid, malformed or out of its
// domain, and what its property refuses. Values in HTML's units; a table to be read beside the one
// for users.

export interface Row {
  readonly attribute: string;
  /** Unless it is the attribute in camel case. */
  readonly property?: string;
  /** The property if the attribute is absent, malformed or out of its domain. */
  readonly fallback: unknown;
  /** The properties by attribute texts. */
  readonly valid: Readonly<Record<string, unknown>>;
  /** Texts that are malformed or outside the domain. */
  readonly bad: readonly string[];
  /** Values that the property refuses, by the kind of error. */
  readonly refused: Readonly<Partial<Record<'TypeError' | 'RangeError', readonly unknown[]>>>;
}

/** Texts that are no number for any attribute. unit/attribute-text.test.ts has more. */
const noNumbers = ['', 'abc', 'NaN', '1 2 3 4 5', '1e999', '-1e999'];

const number = (attribute: string, fallback: number | string, low: number, high: number): Row => ({
  attribute,
  fallback,
  valid: {
    [String(high)]: high,
    [` ${low} `]: low,
    '70e-1': 7,
    ...(low <= 0 && { '-0': 0, '1e-320': 1e-320, '.5': 0.5 }),
  },
  bad: [...noNumbers, String(high * 1.1), '-1e9'],
  refused: { RangeError: [NaN, Infinity, high * 1.1], TypeError: ['abc', {}, [1], true] },
});

const vector = (attribute: string, fallback: unknown, limit: number, low = -limit): Row => ({
  attribute,
  fallback,
  valid: {
    '1 2 3': [1, 2, 3],
    ' 1,2 , 3 ': [1, 2, 3],
    '-0 1e-320 .5': [0, 1e-320, 0.5],
    [`${limit} ${low} 0`]: [limit, low, 0],
  },
  bad: [
    '',
    '1 2',
    '1 2 3 4 5',
    '1 2 x',
    'NaN 1 2',
    '1e999 0 0',
    `0 ${limit * 1.1} 0`,
    `0 0 ${low === 0 ? -1 : low * 1.1}`,
  ],
  refused: {
    RangeError: [[1, 2, NaN], [limit * 1.1, 0, 0]], // oxfmt-ignore
    TypeError: [[1, 2], ['1', '2', '3'], { x: 1 }, '1 2'],
  },
});

/** By numbers: only a browser reads CSS colours (element/attributes). */
const color = (attribute: string, fallback: unknown): Row => ({
  attribute,
  fallback,
  valid: {
    '1 2 3': [1, 2, 3],
    '12.5': [12.5, 12.5, 12.5],
    '300, 0, 1e6': [300, 0, 1e6],
  },
  bad: ['', '1 2', '-1 0 0', '1e7', '0 0 1e999', 'nocolor'],
  refused: {
    RangeError: [[1, 2, -1], [1, 2, 2e6]], // oxfmt-ignore
    TypeError: [[1, 2], 'nocolor', {}],
  },
});

const choice = (
  attribute: string,
  fallback: string | null,
  ...choices: readonly string[]
): Row => ({
  attribute,
  fallback,
  valid: Object.fromEntries(choices.flatMap((name) => [[name, name], [` ${name.toUpperCase()} `, name]])), // oxfmt-ignore
  bad: ['', 'nothing', `${choices[0] ?? ''}x`, '1'],
  refused: { RangeError: ['nothing'], TypeError: [1, [choices[0]]] },
});

const flag = (attribute: string): Row => ({
  attribute,
  fallback: true,
  valid: { true: true, '': true, false: false, FALSE: false, ' true ': true },
  bad: ['no', '0', '1', attribute],
  refused: { TypeError: [1, 'no', []] },
});

const presence = (attribute: string): Row => ({
  attribute,
  fallback: false,
  valid: { false: false, FALSE: false, '': true, [attribute]: true, true: true },
  bad: [],
  refused: { TypeError: [1] },
});

const text = (attribute: string, fallback: string): Row => ({
  attribute,
  fallback,
  valid: { ' Any <b>text</b> ': ' Any <b>text</b> ', '': fallback },
  bad: [],
  refused: { TypeError: [1, ['a']] },
});

const orAuto = (row: Row): Row => ({
  ...row,
  fallback: 'auto',
  valid: { ...row.valid, auto: 'auto', ' AUTO ': 'auto' },
});

const position: Row = {
  ...vector('position', [1, 2, 3, 0], 1e15),
  valid: {
    '1 2 3': [1, 2, 3, 1],
    '3,2,1,0': [3, 2, 1, 0],
    '1 2 3 1': [1, 2, 3, 1],
    '-0 1e-320 1e15 -0': [0, 1e-320, 1e15, 0],
  },
  bad: [
    '',
    '1 2',
    '1 2 x',
    '1 2 3 4 5',
    '1 2 3 0.5',
    '1 2 3 2',
    '1e16 0 0',
    '0 0 0 -1',
    '1e999 0 0 0',
  ],
  refused: { RangeError: [[1, 2, 3, 4]], TypeError: [[1, 2], '1 2 x'] },
};

const terms: Row = {
  attribute: 'terms',
  fallback: ['ambient', 'diffuse', 'specular'],
  valid: {
    '': [],
    'specular ambient': ['ambient', 'specular'],
    'Diffuse, DIFFUSE': ['diffuse'],
    ',diffuse,,ambient ,\n specular': ['ambient', 'diffuse', 'specular'],
    'ambient diffuse specular': ['ambient', 'diffuse', 'specular'],
  },
  bad: ['all', 'ambient+diffuse', 'ambient emissive'],
  refused: { RangeError: [['emissive'], 'emissive'], TypeError: [7] },
};

const helpers: Row = {
  ...terms,
  attribute: 'helpers',
  fallback: [],
  valid: {
    '': ['lights'],
    'grid lights': ['lights', 'grid'],
    'Axes, AXES': ['axes'],
    'lights axes grid normals bounds': ['lights', 'axes', 'grid', 'normals', 'bounds'],
  },
  bad: ['all', 'light', 'lights cameras'],
};

const panelList: Row = {
  attribute: 'gui',
  fallback: false,
  valid: {
    '': true,
    gui: true,
    true: true,
    false: false,
    'camera lights': ['camera', 'lights'],
    'Cutoff, theta': ['cutoff', 'theta'],
  },
  bad: ['lights cutoff', 'source', 'x'],
  refused: { RangeError: [['lights', 'cutoff'], ['x'], [1]], TypeError: [1] },
};

const dividers: Row = {
  attribute: 'at',
  fallback: 'auto',
  valid: { '30': [30], ' 0,12.5 100 ': [0, 12.5, 100], '50 50': [50, 50], AUTO: 'auto' },
  bad: ['', 'half', '50%', '1 x', '-1', '100.1', '60 40', '1e999'],
  refused: { RangeError: [101, [60, 40], [NaN]], TypeError: [[], ['1'], true, {}] },
};

const geometries = [
  'box',
  'sphere',
  'cylinder',
  'cone',
  'pyramid',
  'torus',
  'torus-knot',
  'teapot',
  'plane',
];
const shape: readonly Row[] = [
  text('src', ''),
  choice('type', null, 'obj', 'glb', 'model/stl'),
  choice('geometry', null, ...geometries),
  {
    ...number('segments', 'auto', 1, 512),
    bad: [...noNumbers, '0', '513', '1.5', '-3'],
    valid: { '1': 1, '512': 512, '7.0': 7, auto: 'auto', ' AUTO ': 'auto' },
  },
  presence('autoplay'),
  text('animation-name', ''),
  color('ka', [200, 200, 200]),
  color('kd', [200, 200, 200]),
  color('ks', [128, 128, 128]),
  number('shininess', 32, 0, 1e6),
];

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
    {
      ...vector('scale', [1, 1, 1], 1e12),
      valid: { '2': [2, 2, 2], '1 -2 0': [1, -2, 0] },
      bad: ['', '1 2', 'big', '1 2 3 4', '1e999 0 0', '0 1.1e12 0', '0 0 -1.1e12'],
    },
    choice('shading', null, 'phong', 'gouraud', 'flat'),
    choice('reflection', null, 'phong', 'blinn-phong'),
  ],
  'phong-viewer': [
    text('alt', ''),
    text('poster', ''),
    choice('loading', 'auto', 'auto', 'eager', 'lazy'),
    presence('droppable'),
    {
      ...choice('crossorigin', null, 'anonymous', 'use-credentials'),
      property: 'crossOrigin',
      valid: { '': 'anonymous', Anonymous: 'anonymous', 'use-credentials': 'use-credentials' },
      bad: ['nothing', 'anonymousx', '1'],
    },
    ...shape,
    {
      ...number('theta', 30, -1e300, 1e300),
      bad: noNumbers,
      refused: { RangeError: [NaN], TypeError: ['x'] },
    },
    number('phi', 70, 0, 180),
    { ...orAuto(number('radius', 'auto', 1e-3, 1e15)), bad: [...noNumbers, '0', '-1', '2e15'] },
    orAuto(vector('target', 'auto', 1e15)),
    number('fov', 45, 1, 170),
    flag('orbit'),
    flag('zoom'),
    number('auto-rotate', 0, -1e6, 1e6),
    choice('shading', 'phong', 'phong', 'gouraud', 'flat'),
    choice('reflection', 'phong', 'phong', 'blinn-phong'),
    terms,
    choice('color-interpolation', 'srgb', 'srgb', 'linear'),
    choice('antialias', 'edges', 'edges', 'full'),
    {
      ...number('samples', 64, 16, 1024),
      bad: [...noNumbers, '15', '1025', '64.5'],
      valid: { '16': 16, '1024': 1024, '100.0': 100, '1e2': 100 },
    },
    { ...orAuto(number('pixel-ratio', 'auto', 1e-3, 1e6)), bad: [...noNumbers, '0', '-1', '2e6'] },
    helpers,
    choice('view', 'shaded', 'shaded', 'diffuse', 'n-dot-l', 'triangles'),
    text('view-light', ''),
    presence('probe'),
    vector('probe-at', null, 1e15),
    text('camera-group', ''),
    panelList,
  ],
  'phong-compare': [
    choice('layout', 'split', 'split', 'side'),
    choice('direction', 'horizontal', 'horizontal', 'vertical'),
    dividers,
    {
      ...text('labels', ''),
      fallback: null,
      valid: { 'Gouraud, Phong': 'Gouraud, Phong', '': '' },
      refused: { TypeError: [1, ['a', 1], ['a, b']] },
    },
  ],
};
