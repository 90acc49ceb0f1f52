// What a file is called in messages: its own name, or the end of its address.

import { expect, it } from 'vitest';
import { fileName, isDataUri, nameOf } from '../../../src/phong/fields/file-names.js';

it('a file is called by its name, a blob or a file without one "model"', () => {
  expect(fileName(new File([], 'bunny.glb'))).toBe('bunny.glb');
  expect(fileName(new File([], ''))).toBe('model');
  expect(fileName(new Blob())).toBe('model');
});

it.each([
  ['https://a.test/models/red%20bunny.glb?v=2#top', 'red bunny.glb'],
  ['https://a.test/100%.glb', '100%.glb'],
  ['https://a.test/models/', 'a.test'],
  ['https://a.test:8080', 'a.test:8080'],
  ['file:///', 'the file'],
  ['data:model/stl;base64,AAAA/b', 'the data: URI'],
])('%s is called %s', (address, name) => {
  expect(nameOf(new URL(address))).toBe(name);
});

it('a data: URI is known by its beginning, in capitals too', () => {
  expect(['data:,a', 'DATA:,a', 'a data:,a', 'data.bin'].map(isDataUri)).toEqual([
    true,
    true,
    false,
    false,
  ]);
});
