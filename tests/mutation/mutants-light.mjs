// @ts-check
// Kinds of lights, and where their numbers stand.

import { mutantsOf } from './mutants-of.mjs';

export const lightMutants = [
  ...mutantsOf('src/light/light-kind.ts', [
    ['an axis of zero makes no spot', '!isZero(light.axis) && (', '('],
    [
      'a cone makes a spot',
      'light.aperture < 180 || light.cutoff >= LEAST_EXPONENT',
      'light.cutoff >= LEAST_EXPONENT',
    ],
    [
      'a decay makes a spot',
      'light.aperture < 180 || light.cutoff >= LEAST_EXPONENT',
      'light.aperture < 180',
    ],
    ['a cutoff below 1e-6 is none', 'light.cutoff >= LEAST_EXPONENT', 'light.cutoff > 0'],
    ['a cutoff of 1e-6 is one', 'light.cutoff >= LEAST_EXPONENT', 'light.cutoff > LEAST_EXPONENT'],
    ['w = 0 is directional', "if (light.position[3] === 0) return 'directional';", ''],
    ['a light without cone and decay is a point light', "isSpot(light) ? 'spot' : 'point'", "'spot'"],
    ['only positional lights are attenuated', 'light.position[3] === 1 && (kc', '(kc'],
    ['kc above 1 attenuates', 'kc > 1 || kl > 0 || kq > 0', 'kl > 0 || kq > 0'],
    ['kc up to 1 does not attenuate', 'kc > 1', 'kc > 0'],
    ['kl attenuates', 'kc > 1 || kl > 0 || kq > 0', 'kc > 1 || kq > 0'],
    ['kq attenuates', 'kc > 1 || kl > 0 || kq > 0', 'kc > 1 || kl > 0'],
    ['the fact of a light’s kind', 'facts[kindOf(light)] = true;', ''],
    ['the fact of attenuation', 'facts.attenuation ||= isAttenuated(light);', ''],
    ['facts are kept: attenuation', 'facts.attenuation ||= ', 'facts.attenuation = '],
    ['the fact of ambient light', 'facts.ambient ||= !isZero(light.ambient);', ''],
    ['facts are kept: ambient light', 'facts.ambient ||= ', 'facts.ambient = '],
    ['the fact of diffuse light', 'facts.diffuse ||= !isZero(light.diffuse);', ''],
    ['facts are kept: diffuse light', 'facts.diffuse ||= ', 'facts.diffuse = '],
    ['the fact of specular light', 'facts.specular ||= !isZero(light.specular);', ''],
    ['facts are kept: specular light', 'facts.specular ||= ', 'facts.specular = '],
    [
      'black ambient light needs no code',
      'facts.ambient ||= !isZero(light.ambient);',
      'facts.ambient = true;',
    ],
    [
      'black diffuse light needs no code',
      'facts.diffuse ||= !isZero(light.diffuse);',
      'facts.diffuse = true;',
    ],
    [
      'black specular light needs no code',
      'facts.specular ||= !isZero(light.specular);',
      'facts.specular = true;',
    ],
    ['zero is all components', 'v.every((n) => n === 0)', 'v.some((n) => n === 0)'],
  ]),
  ...mutantsOf('src/light/light-layout.ts', [
    ['a row for ambient light', 'counts: 0, ambient: 1, rows: 2', 'counts: 0, ambient: 0, rows: 2'],
    ['rows of the header', 'counts: 0, ambient: 1, rows: 2', 'counts: 0, ambient: 1, rows: 1'],
    ['a row for directions', 'direction: 0,', 'direction: 1,'],
    ['a row for diffuse light', '/** Id; w = kl. */\n    diffuse: 1,', '/** Id; w = kl. */\n    diffuse: 2,'],
    ['a row for axes', 'axis: 3,', 'axis: 4,'],
    ['a row for spots’ ambient light', 'ambient: 4,', 'ambient: 2,'],
    ['rows of a spot', 'rows: 5,', 'rows: 4,'],
    ['the open limit is above any chord', 'LIMIT_OPEN = 4', 'LIMIT_OPEN = 0.5'],
    ['the block fits 16 KiB', 'BLOCK_ROWS = 1024', 'BLOCK_ROWS = 2048'],
    ['the texture’s width fits every device', 'TEXTURE_ROWS_LOG2 = 10', 'TEXTURE_ROWS_LOG2 = 14'],
    ['lights nearer than 1e-15 have no direction: than 1e-12', 'NEAREST = 1e-15', 'NEAREST = 1e-12'],
    ['lights nearer than 1e-15 have no direction: than 1e-25', 'NEAREST = 1e-15', 'NEAREST = 1e-25'],
    ['exponents below 1e-6 are 0: below 1e-3', 'LEAST_EXPONENT = 1e-6', 'LEAST_EXPONENT = 1e-3'],
    ['exponents below 1e-6 are 0: none is', 'LEAST_EXPONENT = 1e-6', 'LEAST_EXPONENT = 0'],
    ['what a device may flush counts as zero', 'TINY = 2 ** -120', 'TINY = 2 ** -140'],
    [
      'whole numbers are written as floats',
      'Number.isInteger(n) ? n.toFixed(1) : n.toExponential()',
      'String(n)',
    ],
    ['the nearest distance is squared for the shader', 'float(NEAREST * NEAREST)', 'float(NEAREST)'],
  ]),
];
