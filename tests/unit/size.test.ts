// How large may the project be? Who adds lines takes others away, or raises a number here with the reason.

import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';

const repository = fileURLToPath(new URL('../..', import.meta.url));

/** Lines of all files with one of these ends, below a folder. */
const linesOf = (folder: string, ends: RegExp): number =>
  readdirSync(repository + folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && ends.test(entry.name) && !/node_modules/.test(entry.parentPath))
    .reduce((sum, { parentPath, name }) => {
      const text = readFileSync(`${parentPath}/${name}`, 'utf8');
      return sum + text.split('\n').length - 1;
    }, 0);

it.each([
  ['src', /\.ts$/, 32_293],
  ['shaders', /\.glsl$/, 788],
  ['tests', /\.(ts|tsx|mjs|js|py)$/, 45_971],
])('%s has no more lines than it needs', (folder, ends, most) => {
  const lines = linesOf(folder, ends);
  expect(lines).toBeLessThanOrEqual(most);
  // Far above the size, the number would let it grow unseen.
  expect(lines).toBeGreaterThan(0.98 * most);
});
