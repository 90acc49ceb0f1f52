// Which tests run in Node? Fast ones always, those in tests/release only when PHONG_VIEWER_RELEASE
// is set. Playwright runs the browser tests (playwright.config.ts).

import { defineConfig } from 'vitest/config';
import { packageAliases } from './.ci/package-aliases.js';
import { basisTranscoder } from './.ci/basis-transcoder.js';
import { dracoDecoder } from './.ci/draco-decoder.js';

const release = process.env['PHONG_VIEWER_RELEASE'] !== undefined;

export default defineConfig({
  plugins: [dracoDecoder(), basisTranscoder()],
  resolve: { alias: packageAliases },
  test: {
    environment: 'node',
    include: [
      'tests/unit/**/*.test.ts',
      'tests/extras/**/*.test.ts',
      'tests/stress/**/*.test.ts',
      ...(release ? ['tests/release/**/*.test.ts'] : []),
    ],
    // The table of extras: as on a page, the viewer finds their code.
    setupFiles: ['tests/support/quiet-lit.ts', 'src/viewer/extras.ts'],
    passWithNoTests: true,
    pool: 'threads',
    maxWorkers: 2,
    // Long forms repeat a test twenty times.
    testTimeout: release ? 400_000 : 20_000,
    expect: { poll: { timeout: 10_000 } },
    server: { deps: { inline: [/draco_decoder/, /basis_transcoder/] } },
  },
});
