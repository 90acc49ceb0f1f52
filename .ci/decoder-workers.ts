// How do workers become files of the package? Each `new Worker(new URL('./x-worker.ts',
// import.meta.url), …)` of the source is built to one file beside the chunk that starts it, and
// stays in that form, which users' bundlers know. Vite's own way would inline the file or give an
// address that other bundlers do not see. One file each, without imports: most bundlers build
// workers as classic scripts, and a second file would be a second trip to the server.

import { createHash } from 'node:crypto';
import { basename, dirname, join, relative } from 'node:path';
import { build, type Plugin, type Rolldown } from 'vite';

const WORKER = /new Worker\(\s*new URL\('\.\/([\w-]+)-worker\.ts', import\.meta\.url\),/g;

/** In the place of a file's name until that is known. No bundler takes the text for an address. */
const placeholder = (name: string): string => `decoder-worker:${name}:`;

export interface WorkerOptions {
  /** Plugins that the workers' own code needs. */
  readonly plugins: () => readonly Plugin[];
  /** Whether names of files have a hash of their content; default false. */
  readonly hashed?: boolean;
  /**
   * false: no worker is built, and the code that starts one gets null. For scripts that are no
   * modules. Default true.
   */
  readonly files?: boolean;
}

export function decoderWorkers({ plugins, hashed = false, files = true }: WorkerOptions): Plugin {
  /** By name, the source. */
  const sources = new Map<string, string>();
  return {
    name: 'decoder-workers',
    enforce: 'pre',
    transform(code, id) {
      if (!id.includes('/src/') || !code.includes('new Worker(')) return null;
      if (!files) return { code: code.replace(/new Worker\([^;]*?\}\)/g, 'null'), map: null };
      return {
        code: code.replace(WORKER, (_, name: string) => {
          sources.set(name, join(dirname(id), `${name}-worker.ts`));
          // The sum hides it from Vite, and is one text after minification.
          return `new Worker(new URL('' + '${placeholder(name)}', import.meta.url),`;
        }),
        map: null,
      };
    },
    async generateBundle(_options, bundle) {
      for (const [name, source] of sources) {
        const code = await workerCode(source, plugins());
        const hash = createHash('sha256').update(code).digest('base64url').slice(0, 8);
        for (const chunk of Object.values(bundle)) {
          if (chunk.type !== 'chunk' || !chunk.code.includes(placeholder(name))) continue;
          const fileName = join(
            dirname(chunk.fileName),
            `${name}-worker${hashed ? `-${hash}` : ''}.js`,
          );
          chunk.code = chunk.code.replace(
            placeholder(name),
            `./${relative(dirname(chunk.fileName), fileName)}`,
          );
          this.emitFile({ type: 'asset', fileName, source: code });
          sources.delete(name);
        }
        if (sources.has(name)) {
          this.error(`No chunk starts the worker ${basename(source)}.`);
        }
      }
    },
  };
}

async function workerCode(entry: string, plugins: readonly Plugin[]): Promise<string> {
  const built = (await build({
    configFile: false,
    publicDir: false,
    logLevel: 'warn',
    plugins: [...plugins],
    build: {
      write: false,
      target: 'es2022',
      lib: { entry, formats: ['es'], fileName: 'worker' },
      rolldownOptions: { output: { minify: true, codeSplitting: false } },
    },
  })) as Rolldown.RolldownOutput[];
  const [chunk, ...others] = built[0]?.output ?? [];
  if (chunk === undefined || others.length > 0 || chunk.imports.length > 0) {
    throw new Error(`${entry} is more than one file.`);
  }
  return chunk.code;
}
