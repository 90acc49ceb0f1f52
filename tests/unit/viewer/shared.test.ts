// Do users of a key share one value, for as long as one of them has it?

import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { expect, it } from 'vitest';
import { Shared } from '../../../src/viewer/model/shared.js';

const make = () => ({});

it('a forgotten value keeps its users, and takes nothing from the one after it', () => {
  const shared = new Shared<object>();
  const failed = shared.acquire('model', make);
  shared.forget(failed);
  const next = shared.acquire('model', make);
  expect(next).not.toBe(failed);
  expect(shared.release(failed)).toBe(true);
  shared.forget(failed);
  expect(shared.get('model')).toBe(next);
});

it('a value gets another key only from its one user, and only a free one', () => {
  const shared = new Shared<object>();
  const red = shared.acquire('red', make);
  const blue = shared.acquire('blue', make);
  expect(shared.move(red, 'blue')).toBe(false);
  expect(shared.move(red, 'green')).toBe(true);
  expect([shared.get('red'), shared.get('green')]).toEqual([undefined, red]);
  shared.acquire('blue', make);
  expect(shared.move(blue, 'red')).toBe(false);
  expect(shared.release(red)).toBe(true);
});

it('a value whose users are gone without a release is collected', async () => {
  setFlagsFromString('--expose-gc');
  const collect = runInNewContext('gc') as () => void;
  const shared = new Shared<object>();
  shared.acquire('kept', make);
  const kept = shared.acquire('kept', make);
  shared.acquire('gone', make);
  await new Promise((resolve) => setTimeout(resolve));
  collect();
  expect(shared.get('gone')).toBeUndefined();
  expect(shared.get('kept')).toBe(kept);
});
