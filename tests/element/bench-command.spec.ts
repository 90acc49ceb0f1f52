// `npm run bench` itself, in its shortest form: it runs, and what it writes holds what it promises. Asserts no time. Of two axes;
// others are tried by the demo's page, beside this, and all of these before a release.
import { execFile } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import type { BenchResult } from '../bench/result-file.mjs';
import { expect, test } from '../support/test.js';

const BENCH = fileURLToPath(new URL('../bench/bench.mjs', import.meta.url));

async function bench(...options: string[]): Promise<string> {
  const { stdout } = await promisify(execFile)(process.execPath, [BENCH, ...options]);
  return stdout;
}

/** So small and short that only the ways are tried. */
const SHORT = '--launches 1 --rounds 1 --width 48 --height 32 --evaluations 1 --sample 1'.split(' ');

for (const [release, axes] of [
  ['', ['loops', 'antialias']],
  ['@release ', ['shading', 'loops', 'antialias', 'scale']],
] as const) {
  test(`${release}npm run bench writes what it has measured of ${axes.join(', ')}, and tells two files apart only where something moved`, async ({}, info) => {
    test.setTimeout(120_000);
    const file = info.outputPath('bench.json');
    const scenes = ['--scenes', '1 directional,shininess 1e3,shininess 1e4'];
    const said = await bench('--only', axes.join(), ...scenes, ...SHORT, '--out', file);
    const result = JSON.parse(readFileSync(file, 'utf8')) as BenchResult;
    expect(result.machine['renderer']).toMatch(/SwiftShader|llvmpipe/);
    expect(result.machine['three']).toMatch(/^0\.\d+/);
    expect(result.seed).toBe(1);
    expect([...new Set(result.fronts.map(({ axis }) => axis))]).toEqual(axes);
    const charts = readdirSync(info.outputPath('bench-charts'));
    expect(charts).toHaveLength(result.fronts.length);
    for (const { title, points, base, shipped } of result.fronts) {
      expect(said).toContain(title);
      const ids = points.map(({ id }) => id);
      expect(new Set(ids).size).toBe(ids.length);
      expect(ids).toEqual(expect.arrayContaining([base, shipped]));
      for (const { error } of points)
        for (const [name, value] of Object.entries(error)) expect(value, name).toEqual(expect.any(Number));
    }
    // What the shipped loop is worth does not depend on how long it was looked at.
    const loops = result.fronts.find(({ axis }) => axis === 'loops');
    const shipped = loops?.points.find(({ id }) => id === 'shipped');
    expect(shipped?.error.max).toBeLessThan(0.02);
    expect(loops?.points.find(({ id }) => id === 'schlick')?.error.max).toBeGreaterThan(1);

    expect(await bench('--compare', file, file)).toMatch(/^0 of \d+ moved/m);
  });
}
