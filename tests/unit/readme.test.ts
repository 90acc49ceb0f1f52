// Do the scripts of the page about the API compile under strict TypeScript? The compiler checks the copy beside this test.
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';

const read = (path: string): string => readFileSync(new URL(path, import.meta.url), 'utf8');

/** Without what a formatter may change. */
const words = (code: string): string => code.replace(/\s+/g, '').replace(/,\)/g, ')');

it('has the script about shadeAt as the compiler checks it', () => {
  const script = /## Ask why a pixel has its colour\n[^]*?```js\n([^]*?)```/.exec(read('../../src/API.md'))?.[1] ?? '';
  const [, copy = ''] = read('readme-shade-at.ts').split("import '../../src/index.js';");
  expect(script).toContain('shadeAt(');
  expect(words(script)).toBe(words(copy));
});
