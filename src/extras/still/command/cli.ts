#!/usr/bin/env node
// `npx phong-viewer still FILES.html`: draws the posters of pages, and writes them into the pages.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import type { Size } from './page.js';
import { complain, type Settings, updatePage } from './update-page.js';

const HELP = `Usage: phong-viewer still FILES.html [options]
       phong-viewer check PAGE.html FILES.glsl [options]   (check --help says more)

Draws each <phong-viewer> of the pages, without a browser, into a PNG beside the page, and
writes it into the viewer as <img slot="poster">, which is shown without any script. Nothing
else of a page changes. What is up to date is left as it is.

A viewer needs a size in pixels: by its style, by a rule in <style> for its tag, classes or
id, or by its attributes width and height. Other style sheets are not read. The place of a
panel (gui, from 640 pixels on) is left out.

  --size 760x420    the size of viewers that say none
  --scale 2         pixels of the PNG for each pixel of the page, for dense screens
  --check           draws and writes nothing; ends with status 1 if something is not up to date
  --out scene.png   only draws the one viewer of the one page, into this file
  --help, --version

Status: 0 if all is well, 1 if a page or a viewer failed or is not up to date, 2 for wrong
options.`;

/** Ends the command with one line and status 2. */
class UsageError extends Error {}

/** The command of another extra, in a file of its own, which goes with that extra. */
async function runCheck(args: readonly string[]): Promise<number> {
  const file = new URL(/* @vite-ignore */ './check.js', import.meta.url);
  const { run: runIt } = (await import(/* @vite-ignore */ file.href)) as {
    readonly run: (rest: readonly string[]) => Promise<number>;
  };
  return runIt(args);
}

async function run(args: readonly string[]): Promise<number> {
  if (args[0] === 'check') return runCheck(args.slice(1));
  const { values, positionals } = readArguments(args);
  const manifest = fileURLToPath(new URL(/* @vite-ignore */ '../package.json', import.meta.url));
  const { version } = JSON.parse(readFileSync(manifest, 'utf8')) as { readonly version: string };
  if (values.help || values.version) {
    process.stdout.write(`${values.help ? HELP : version}\n`);
    return 0;
  }
  const [command, ...files] = positionals;
  if (command !== 'still') {
    throw new UsageError(
      command === undefined
        ? 'Say what to do: still or check.'
        : `There is no command ${JSON.stringify(command)}.`,
    );
  }
  if (files.length === 0) throw new UsageError('Name the pages: phong-viewer still index.html.');
  const settings: Settings = {
    size: values.size === undefined ? null : sizeFrom(values.size),
    scale: scaleFrom(values.scale),
    check: values.check,
    out: values.out ?? null,
    version,
  };
  if (settings.out !== null && (files.length > 1 || !settings.out.endsWith('.png'))) {
    throw new UsageError('--out is for one viewer of one page, and a file that ends with .png.');
  }
  let isWell = true;
  for (const file of files) {
    isWell = (await updatePage(file, settings)) && isWell;
  }
  return isWell ? 0 : 1;
}

function readArguments(args: readonly string[]) {
  try {
    return parseArgs({
      args: [...args],
      allowPositionals: true,
      options: {
        size: { type: 'string' },
        scale: { type: 'string', default: '1' },
        out: { type: 'string' },
        check: { type: 'boolean', default: false },
        help: { type: 'boolean', short: 'h', default: false },
        version: { type: 'boolean', default: false },
      },
    });
  } catch (error) {
    // Its first sentence says which option.
    throw new UsageError(`${(error as Error).message.split(/\. |\n/)[0]!.replace(/\.$/, '')}.`);
  }
}

function sizeFrom(text: string): Size {
  const [, width, height] = /^([1-9]\d{0,4})x([1-9]\d{0,4})$/i.exec(text) ?? [];
  if (height === undefined) {
    throw new UsageError(`--size takes pixels such as 760x420, not ${JSON.stringify(text)}.`);
  }
  return { width: Number(width), height: Number(height) };
}

function scaleFrom(text: string): number {
  const scale = Number(text);
  if (text.trim() !== '' && scale > 0 && scale <= 8) return scale;
  throw new UsageError(`--scale takes a number above 0, 8 at most, not ${JSON.stringify(text)}.`);
}

try {
  process.exitCode = await run(process.argv.slice(2));
} catch (error) {
  if (!(error instanceof UsageError)) throw error;
  complain(`${error.message} See phong-viewer --help.`);
  process.exitCode = 2;
}
