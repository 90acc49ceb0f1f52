// Builds dist/embed.js, the script of dist/embed.html: one scene of an address, for an `<iframe>`.
// The elements are those of the standalone file beside it. Runs after standalone.config.ts.

import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { outputFolder } from '../output-folder.mjs';
import { elementData } from '../site/plugin.js';

export default defineConfig({
  publicDir: false,
  plugins: [
    elementData(),
    {
      name: 'beside-the-standalone-file',
      enforce: 'pre',
      resolveId: (specifier) =>
        specifier === 'phong-viewer'
          ? { id: './phong-viewer.standalone.js', external: 'relative' }
          : null,
    },
  ],
  build: {
    outDir: outputFolder('dist'),
    emptyOutDir: false,
    target: 'es2022',
    minify: true,
    lib: {
      entry: { embed: fileURLToPath(new URL('../../demo/embed/embed.ts', import.meta.url)) },
      formats: ['es'],
      fileName: (_format, name) => `${name}.js`,
    },
    rolldownOptions: { output: { minify: true } },
  },
});
