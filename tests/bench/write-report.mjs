// @ts-check
// `npm run bench:report`: REPORT.md and its charts, from what tests/bench/results holds of each stack and, where there is one,
// from FINDINGS.md. Charts of results that are gone go too.

import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { reportOf } from './report-text.mjs';
import { readResults } from './result-file.mjs';

/** @param {string} folder with results/, FINDINGS.md; gets REPORT.md, charts/ */
export function writeReport(folder) {
  const results = readResults(join(folder, 'results'));
  if (results.length === 0) throw new Error(`no results in ${join(folder, 'results')}: npm run bench`);
  const findings = join(folder, 'FINDINGS.md');
  const { report, charts } = reportOf(
    results,
    existsSync(findings) ? readFileSync(findings, 'utf8') : undefined,
  );
  const drawn = join(folder, 'charts');
  mkdirSync(drawn, { recursive: true });
  for (const file of readdirSync(drawn).filter((name) => name.endsWith('.svg') && !charts.has(name)))
    rmSync(join(drawn, file));
  for (const [name, chart] of charts) writeFileSync(join(drawn, name), `${chart}\n`);
  writeFileSync(join(folder, 'REPORT.md'), report);
  return { stacks: results.length, charts: charts.size };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { stacks, charts } = writeReport(fileURLToPath(new URL('.', import.meta.url)));
  console.log(`REPORT.md of ${stacks} stacks, ${charts} charts`);
}
