// How do decoders become files of the package? Each `new Worker(new URL('./x-worker.ts',
// import.meta.url), …)` of the source is built to one file, and stays in that form, which users'
// bundlers know. Vite's own way would inline the file or give an address that other bundlers do not
// see. One file each, without imports: most bundlers build workers as classic scripts, and a second
// file would be a second trip to the server. The same decoders for the main thread are built in the
// same way, so the package has them once: the ES modules and the standalone file use the same files.

import { createHash } from 'node:crypto';
import { basename, dirname, join, relative } from 'node:path';
import { build, type Plugin, type Rolldown } from 'vite';

const WORKER = /(?<=new Worker\(\s*new URL\()'\.\/([\w-]+-worker)\.ts'/g;

/** The decoders' code for the main thread. */
const MAIN_THREAD = /(?<=import\()'\.\/(draco|ktx2-worker)\.js'/g;

/** In the place of a file's name until that is known. No bundler takes the text for an address. */
const placeholder = (name: string): string => `decoder-file:${name}:`;

/** Beside the chunks of the standalone file: its users may copy no other folder. */
export const DECODER_FOLDER = 'chunks';

export interface WorkerOptions {
  /** Plugins that the decoders' own code needs. */
  readonly plugins: () => readonly Plugin[];
  /**
   * false: no file is built, and the code that starts a worker gets null. For scripts that are no
   * modules. Default true.
   */
  readonly files?: boolean;
}

export function decoderWorkers({ plugins, files = true }: WorkerOptions): Plugin {
  /** By name, the source. */
  const sources = new Map<string, string>();
  return {
    name: 'decoder-workers',
    enforce: 'pre',
    resolveId: (id) => (id.startsWith('decoder-file:') ? { id, external: true } : null),
    transform(code, id) {
      if (!id.includes('/src/') || !code.includes('new Worker(')) return null;
      if (!files) return { code: code.replace(/new Worker\([^;]*?\}\)/g, 'null'), map: null };
      const named = (name: string): string => {
        sources.set(name, join(dirname(id), `${name}.ts`));
        return placeholder(name);
      };
      return {
        code: code
          // The sum hides it from Vite, and is one text after minification.
          .replace(WORKER, (_, name: string) => `'' + '${named(name)}'`)
          .replace(MAIN_THREAD, (_, name: string) => `'${named(name)}'`),
        map: null,
      };
    },
    async generateBundle(_options, bundle) {
      for (const [name, source] of sources) {
        const code = await codeInOneFile(source, plugins());
        const hash = createHash('sha256').update(code).digest('base64url').slice(0, 8);
        const fileName = `${DECODER_FOLDER}/${name}-${hash}.js`;
        const users = Object.values(bundle).filter(
          (chunk) => chunk.type === 'chunk' && chunk.code.includes(placeholder(name)),
        );
        if (users.length === 0) {
          this.error(`No chunk uses the decoder ${basename(source)}.`);
        }
        for (const chunk of users as Rolldown.OutputChunk[]) {
          chunk.code = chunk.code.replaceAll(
            placeholder(name),
            fromChunk(chunk.fileName, fileName),
          );
        }
        this.emitFile({ type: 'asset', fileName, source: code });
      }
    },
  };
}

/** The address of a file of dist/ as a chunk writes it. */
export function fromChunk(chunk: string, file: string): string {
  const path = relative(dirname(chunk), file);
  return path.startsWith('.') ? path : `./${path}`;
}

async function codeInOneFile(entry: string, plugins: readonly Plugin[]): Promise<string> {
  const built = (await build({
    configFile: false,
    publicDir: false,
    logLevel: 'warn',
    plugins: [...plugins],
    build: {
      write: false,
      target: 'es2022',
      lib: { entry, formats: ['es'], fileName: 'decoder' },
      rolldownOptions: { output: { minify: true, codeSplitting: false } },
    },
  })) as Rolldown.RolldownOutput[];
  const [chunk, ...others] = built[0]?.output ?? [];
  if (chunk === undefined || others.length > 0 || chunk.imports.length > 0) {
    throw new Error(`${entry} is more than one file.`);
  }
  return chunk.code;
}
