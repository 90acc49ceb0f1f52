// Which licences hold for a bundle? Reads them from node_modules for the packages that are really
// in it, puts a notice at the head of each file after minification, and writes all texts to
// THIRD-PARTY-LICENSES.txt beside the files.

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

interface Manifest {
  readonly name: string;
  readonly version: string;
  readonly license: string;
}

/** Something with a licence of its own. */
interface Part {
  readonly name: string;
  readonly licence: string;
  readonly text: string;
}

/**
 * three ships libraries of others, without their licences. By the beginning of their files' names.
 */
const LIBRARIES: ReadonlyMap<
  string,
  { readonly name: string; readonly licence: string; readonly file: string }
> = new Map([
  ['basis', { name: 'Basis Universal transcoder', licence: 'Apache-2.0', file: 'basis.txt' }],
  ['draco', { name: 'Draco decoder', licence: 'Apache-2.0', file: 'draco.txt' }],
  ['meshopt_decoder', { name: 'meshoptimizer decoder', licence: 'MIT', file: 'meshopt.txt' }],
]);

const ownFolder = fileURLToPath(new URL('../..', import.meta.url));

const manifestIn = (folder: string): Manifest =>
  JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')) as Manifest;

/** The part that a module belongs to; undefined for our own source. */
function partOf(moduleId: string): Part | undefined {
  const start = moduleId.lastIndexOf('/node_modules/');
  if (moduleId.startsWith('\0') || start < 0) return undefined;
  const inside = moduleId.slice(start + '/node_modules/'.length);
  const [package_ = ''] = /^(@[^/]+\/)?[^/]+/.exec(inside) ?? [];
  const folder = join(moduleId.slice(0, start), 'node_modules', package_);
  const { name, version, license } = manifestIn(folder);
  const [, library] = /^three\/examples\/jsm\/libs\/([^/.]+)/.exec(inside) ?? [];
  if (library === undefined) {
    return { name: `${name} ${version}`, licence: license, text: licenceText(folder) };
  }
  const known = LIBRARIES.get(library);
  if (known === undefined) {
    throw new Error(`The licence of ${inside} is not known: add it to .ci/licences/.`);
  }
  const text = readFileSync(new URL(known.file, import.meta.url), 'utf8').trim();
  return { name: `${known.name} (in ${name} ${version})`, licence: known.licence, text };
}

function licenceText(folder: string): string {
  const file = readdirSync(folder).find((name) => /^licen[cs]e(\.\w+)?$/i.test(name));
  if (file === undefined) throw new Error(`${folder} has no licence file.`);
  return readFileSync(join(folder, file), 'utf8').trim();
}

/** The parts that these modules belong to, each once, by name. */
function partsOf(moduleIds: Iterable<string>): readonly Part[] {
  const parts = new Map<string, Part>();
  for (const id of moduleIds) {
    const part = partOf(id);
    if (part !== undefined) {
      parts.set(part.name, part);
    }
  }
  return [...parts.values()].sort((a, b) => (a.name < b.name ? -1 : 1));
}

const copyright = ({ text }: Part): string =>
  /^.*copyright.*$/im.exec(text)?.[0].replace(/\.? all rights reserved\.?/i, '') ?? '';

function notice(isEntry: boolean, parts: readonly Part[]): string {
  const { name, version, license } = manifestIn(ownFolder);
  const own = isEntry ? [`${name} ${version}, ${license}`] : [];
  const others = parts.map((part) => `${part.name}: ${copyright(part)}, ${part.licence}`);
  if (others.length > 0) {
    others.push('Licences: THIRD-PARTY-LICENSES.txt');
  }
  const lines = [...own, ...others];
  return lines.length === 0 ? '' : `/*!\n${lines.map((line) => ` * ${line}\n`).join('')} */`;
}

const introduction =
  'The files beside this one contain code of these packages, under the licences given here.';

/** The modules of all builds so far that one config made: the decoders are builds of their own. */
const built = new Set<string>();

/**
 * @param options.listed whether to write THIRD-PARTY-LICENSES.txt too; default true.
 */
export function licences({ listed = true } = {}): Plugin {
  return {
    name: 'licences',
    apply: 'build',
    config: () => ({
      build: {
        rolldownOptions: {
          // `banner` would come before minification, which drops it.
          output: {
            postBanner: ({ isEntry, modules }) => notice(isEntry, partsOf(Object.keys(modules))),
          },
        },
      },
    }),
    generateBundle() {
      for (const id of this.getModuleIds()) {
        built.add(id);
      }
      if (!listed) return;
      const line = '-'.repeat(80);
      const sections = partsOf(built).map(({ name, text }) => `${line}\n${name}\n\n${text}\n`);
      const source = `${introduction}\n\n${sections.join('\n')}`;
      this.emitFile({ type: 'asset', fileName: 'THIRD-PARTY-LICENSES.txt', source });
    },
  };
}
