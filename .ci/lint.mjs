// @ts-check
// `npm run lint`: oxlint with .oxlintrc.jsonc, then the house rules. Options go to oxlint (`npm run
// lint -- --fix`).

import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { breachesInSrc } from './house-rules.mjs';

process.chdir(fileURLToPath(new URL('..', import.meta.url)));
const args = ['node_modules/oxlint/bin/oxlint', ...process.argv.slice(2)];
const { status } = spawnSync(process.execPath, args, { stdio: 'inherit' });
const found = breachesInSrc();
for (const line of found) {
  console.error(line);
}
process.exit(status === 0 && found.length === 0 ? 0 : 1);
