// @ts-check
// Lights in cells and lights that stand apart: how a box is divided, what its lists hold and how the shader finds them.

import { mutantsOf } from './mutants-of.mjs';

export const gridMutants = [
  ...mutantsOf('src/light/light-grid.ts', [
    ['4,096 cells: twice as many', 'const MOST_CELLS = 4096;', 'const MOST_CELLS = 8192;'],
    ['4,096 cells: a quarter', 'const MOST_CELLS = 4096;', 'const MOST_CELLS = 1024;'],
    ['few lights are not divided', 'if (positional < LEAST_DIVIDED) return false;', ''],
    [
      'few lights: suns do not count',
      'const positional = packed.counts.point + packed.counts.spot;',
      'const positional = packed.sent;',
    ],
    [
      'lamps may be listed where something is given up',
      '(budget > 0 ? 0 : packed.counts.point)',
      'packed.counts.point',
    ],
    [
      'what surely reaches half is not divided',
      'if (surely > packed.sent / 2) return false;',
      'if (surely > 0) return false;',
    ],
    ['a point is not divided', 'if (count < 2) return false;', ''],
    ['each light’s part of the budget', 'budget / positional', 'budget'],
    ['lists that do not halve the work', 'everywhere + listed / count > packed.sent / 2', 'false'],
    [
      'lists that do not halve the work: those of everywhere',
      'everywhere + listed / count',
      'listed / count',
    ],
    ['lists that do not halve the work: their lengths', 'everywhere + listed / count', 'everywhere'],
    [
      'lists that do not halve the work: in the end',
      '  if (tooMany()) return false;\n  writeLights',
      '  writeLights',
    ],
    ['suns are in no list', "kind === 'directional' ? null : reachedCells", 'reachedCells'],
    ['cells are cubes: the edge grows until they fit', 'while (!fits()) edge *= 1.02;', 'edge *= 64;'],
    ['a flat box has one cell across', 'Math.max(1, Math.floor(length / edge))', 'Math.floor(length / edge)'],
    ['cells are taken a little larger', 'PADDING.cell * edge + PADDING.place * coordinate', '0'],
    ['cells are taken a little larger: by their edge', 'PADDING.cell * edge + ', ''],
    [
      'lamps have no cone',
      "kind === 'spot' ? new Cone().take(packed, row) : null",
      'new Cone().take(packed, row)',
    ],
    [
      'a visit ends where cells are too many',
      'if (count > scratch.length) return;',
      'if (count > 0) return;',
    ],
    [
      'the low side along x is padded',
      'const x0 = box[0] + i0 * step[0] - pad;',
      'const x0 = box[0] + i0 * step[0];',
    ],
    [
      'the low side along y is padded',
      'const y0 = box[1] + j0 * step[1] - pad;',
      'const y0 = box[1] + j0 * step[1];',
    ],
    [
      'the low side along z is padded',
      'const z0 = box[2] + k0 * step[2] - pad;',
      'const z0 = box[2] + k0 * step[2];',
    ],
    [
      'the high side along x is padded',
      'const x1 = box[0] + i1 * step[0] + pad;',
      'const x1 = box[0] + i1 * step[0];',
    ],
    [
      'the high side along y is padded',
      'const y1 = box[1] + j1 * step[1] + pad;',
      'const y1 = box[1] + j1 * step[1];',
    ],
    [
      'the high side along z is padded',
      'const z1 = box[2] + k1 * step[2] + pad;',
      'const z1 = box[2] + k1 * step[2];',
    ],
    ['cells that a cone misses', 'if (cone?.reaches(x0, y0, z0, x1, y1, z1, 0) === false) return;', ''],
    ['cells where a light brings too little', '<= share\n    )\n      return;', '< 0\n    )\n      return;'],
    ['a cell’s number: its row', 'i0 + size[0] * (j0 + size[1] * k0)', 'i0 + size[1] * (j0 + size[0] * k0)'],
    [
      'a light of too many cells is everywhere',
      'return count > scratch.length ? null : scratch.slice(0, count);',
      'return scratch.slice(0, count);',
    ],
    ['the longest side is halved: x', 'visit(i0 + (i >> 1), j0, k0, i1, j1, k1);', ''],
    ['the longest side is halved: y', 'visit(i0, j0 + (j >> 1), k0, i1, j1, k1);', ''],
    ['the longest side is halved: z', 'visit(i0, j0, k0 + (k >> 1), i1, j1, k1);', ''],
    ['lights of everywhere come first', '(cells === null ? 0 : 1)', '(cells === null ? 1 : 0)'],
    ['kinds stay in order', '2 * KINDS.indexOf(kind)', '0'],
    ['the header is kept', 'into.data.set(packed.data.subarray(0, HEADER.rows * 4));', ''],
    [
      'shapes follow their lights',
      'into.shapes[i] = packed.shapes[reach.light] ?? 0;',
      'into.shapes[i] = packed.shapes[i] ?? 0;',
    ],
    ['a list has the rows that its lights have now', 'reaches[i] = { ...reach, row: into.rows };', ''],
    ['the counts are kept', 'Object.assign(into.counts, packed.counts);', ''],
    ['lists begin empty', 'data.fill(0, grid * 4, into.rows * 4);', ''],
    [
      'the header tells of the grid',
      'data[HEADER.counts * 4 + 3] = grid;',
      'data[HEADER.counts * 4 + 3] = 0;',
    ],
    ['the box’s low corner', '[box[0], box[1], box[2], firstCell]', '[0, 0, 0, firstCell]'],
    ['a side of no length has one place', '(s > 0 ? 1 / s : 0)', '1 / s'],
    ['those of everywhere are counted', 'one.kind === kind && one.cells === null', 'one.kind === kind'],
    [
      'points come before spots',
      "const at = kind === 'point' ? 1 : 2;",
      "const at = kind === 'point' ? 2 : 1;",
    ],
    [
      'each list begins where the last ends',
      'place += data[cell(i) + 1]! + data[cell(i) + 2]!;',
      'place += data[cell(i) + 2]!;',
    ],
    ['each place of a list holds one light', 'next[i]! += 1;', ''],
  ]),
  ...mutantsOf('shaders/cell_list.glsl', [
    [
      'the grid’s place',
      'CellList cellList(vec3 p) {\n  int grid = int(lightRow(HEADER_COUNTS).w);',
      'CellList cellList(vec3 p) {\n  int grid = HEADER_ROWS;',
    ],
    ['the box’s low corner', '(p - low.xyz) * scale.xyz', 'p * scale.xyz'],
    ['their size', '(p - low.xyz) * scale.xyz', 'p - low.xyz'],
    [
      'points below the box are in its first',
      'clamp(floor((p - low.xyz) * scale.xyz), vec3(0.0), size - 1.0)',
      'min(floor((p - low.xyz) * scale.xyz), size - 1.0)',
    ],
    [
      'points above the box are in its last',
      'clamp(floor((p - low.xyz) * scale.xyz), vec3(0.0), size - 1.0)',
      'max(floor((p - low.xyz) * scale.xyz), vec3(0.0))',
    ],
    ['whole places', 'floor((p - low.xyz) * scale.xyz)', '((p - low.xyz) * scale.xyz)'],
    [
      'their rows',
      'cell.x + size.x * (cell.y + size.y * cell.z)',
      'cell.x + size.y * (cell.y + size.x * cell.z)',
    ],
    ['their layers', 'size.x * (cell.y + size.y * cell.z)', 'size.x * cell.y'],
    ['where the first is', 'lightRow(int(low.w) + int(cell.x', 'lightRow(grid + GRID_ROWS + 1 + int(cell.x'],
    [
      'points before spots',
      'CellList(int(list.x), int(list.y), int(list.z))',
      'CellList(int(list.x), int(list.z), int(list.y))',
    ],
    ['where a list begins', 'CellList(int(list.x), int', 'CellList(0, int'],
    ['four places a row', '(place >> 2)', 'place'],
    ['a place’s own number', 'int(four[place & 3])', 'int(four.x)'],
    ['where lists are', 'int(lightRow(grid + GRID_SCALE).w)', 'int(lightRow(grid + GRID_LOW).w)'],
  ]),
  ...mutantsOf('shaders/light_loop.glsl', [
    [
      'lights apart: the distance',
      '#ifdef LIGHTS_APART\n  float inverse = inversesqrt(squared);',
      '#ifdef LIGHTS_APART\n  float inverse = 1.0;',
    ],
    [
      'lights apart: what the rest have',
      '  float inverse = inversesqrt(squared);\n#else',
      '  float inverse = 0.0;\n#else',
    ],
    [
      'lights that may be near have the guard',
      '#ifdef LIGHTS_APART\n  float inverse',
      '#ifndef NEVER\n  float inverse',
    ],
  ]),
  ...mutantsOf('src/material/exact-lights.ts', [
    [
      'cells: those of everywhere alone are in loops',
      'counts=ivec3(lightRow(int(lightRow(HEADER_COUNTS).w)+GRID_EVERYWHERE).xyz);',
      '',
    ],
    [
      'cells: what is listed is skipped',
      '`row+=(all.${COUNT[kind]}-counts.${COUNT[kind]})*${String(ROWS[kind].rows)};`',
      "''",
    ],
    ['cells: listed points', 'if (point !== undefined)', 'if (false)'],
    ['cells: listed spots', 'if (spot !== undefined)', 'if (false)'],
    ['cells: spots follow points', 'i<listed.spots;i++,place++', 'i<listed.spots;i++'],
  ]),
  ...mutantsOf('src/light/light-apart.ts', [
    [
      'suns stand nowhere',
      'for (let i = counts.directional; i < sent; i++) {\n    const widest',
      'for (let i = 0; i < sent; i++) {\n    const widest',
    ],
    [
      'outside on any side',
      'Math.max(gap(0, data[at]!), gap(1, data[at + 1]!), gap(2, data[at + 2]!))',
      'Math.min(gap(0, data[at]!), gap(1, data[at + 1]!), gap(2, data[at + 2]!))',
    ],
    ['by more than nothing', 'if (!(widest > NEAREST)) return false;', 'if (!(widest > -1)) return false;'],
    ['every light', 'if (!(widest > NEAREST)) return false;', 'return widest > NEAREST;'],
    ['the low side', 'Math.max(box[i] - place, place - box[i + 3]!) - slack', 'place - box[i + 3]! - slack'],
    ['the high side', 'Math.max(box[i] - place, place - box[i + 3]!) - slack', 'box[i] - place - slack'],
    ['by more than rounding', 'place - box[i + 3]!) - slack;', 'place - box[i + 3]!);'],
    [
      'spots’ own rows',
      'at += (i < counts.directional + counts.point ? ROWS.point.rows : ROWS.spot.rows) * 4;',
      'at += ROWS.point.rows * 4;',
    ],
    [
      'lamps’ own rows',
      'at += (i < counts.directional + counts.point ? ROWS.point.rows : ROWS.spot.rows) * 4;',
      'at += ROWS.spot.rows * 4;',
    ],
  ]),
];
