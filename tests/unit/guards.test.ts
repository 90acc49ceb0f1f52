// Does every guard of tests/mutation name a module and a test that exist? Guards run in release tests only.

import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import { GUARDS } from '../mutation/guards.js';

it.each(GUARDS)('"$behaviour" guards a module by a test, and both exist', ({ module, test }) => {
  for (const path of [module, test])
    expect(existsSync(fileURLToPath(new URL(`../../${path}`, import.meta.url))), path).toBe(true);
});
