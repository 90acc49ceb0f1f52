// @ts-check
// What the commands of this repository have in common: --help, one line for an option that does not
// exist and for a file that cannot be read, and progress with the time left. Needs nothing but
// Node.

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { parseArgs } from 'node:util';

/**
 * The options and names that a command was given. Prints `usage` and ends where --help is among
 * them; prints one line and ends with status 2 where an option or a name is unknown.
 * @template {NonNullable<import('node:util').ParseArgsConfig['options']>} T
 * @param {string} usage
 * @param {T} options as parseArgs takes them
 * @param {readonly string[]} [names] that may stand without dashes
 */
export function readCommandLine(usage, options, names = []) {
  if (process.argv.includes('--help') || process.argv.includes('-h')) {
    console.log(usage.trim());
    process.exit(0);
  }
  try {
    const read = parseArgs({ options, allowPositionals: true });
    const unknown = read.positionals.find((name) => !names.includes(name));
    if (unknown !== undefined) throw new Error(`Unknown argument '${unknown}'.`);
    return read;
  } catch (error) {
    return refuse(/** @type {Error} */ (error).message);
  }
}

/**
 * Ends the command with one line and status 2.
 * @param {string} message its first sentence is printed
 * @returns {never}
 */
export function refuse(message) {
  const [sentence = message] = message.split(/\.(?: |$)|\n/);
  console.error(`${sentence}. See --help.`);
  process.exit(2);
}

/**
 * A number from an option, finite and at least `least`; anything else is refused.
 * @param {string} name
 * @param {string} text
 * @param {number} least
 */
export function numberOption(name, text, least = 0) {
  const value = Number(text);
  if (text.trim() === '' || !Number.isFinite(value) || value < least) {
    refuse(`--${name} takes a number of at least ${least}, not '${text}'`);
  }
  return value;
}

/** What a JSON file holds; a file that cannot be read is refused. @param {string} file */
export function readJson(file) {
  try {
    return JSON.parse(readFileSync(file, 'utf8'));
  } catch {
    return refuse(existsSync(file) ? `${file} is no JSON that can be read` : `${file} is missing`);
  }
}

/**
 * What the JSON files of a folder hold, sorted by name; none at all is refused.
 * @param {string} folder
 * @param {string} command that writes them
 */
export function readResultFiles(folder, command) {
  const files = existsSync(folder)
    ? readdirSync(folder).filter((file) => file.endsWith('.json'))
    : [];
  if (files.length === 0) {
    refuse(`There are no results in ${folder}: run \`${command}\` first`);
  }
  return files
    .sort()
    .map((file) => ({ name: basename(file, '.json'), content: readJson(join(folder, file)) }));
}

/** A span of time for people: "40 s", "3 min", "1 h 20 min". @param {number} seconds */
export function timeText(seconds) {
  if (seconds < 90) return `${Math.max(1, Math.round(seconds))} s`;
  const minutes = Math.round(seconds / 60);
  return minutes < 90 ? `${minutes} min` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

/**
 * Prints how much of a long run is done and the time left: on a terminal one line that changes,
 * else a line every 15 s.
 */
export class Progress {
  #start = performance.now();
  #printed = -Infinity;
  #oneLine;

  /**
   * @param {{ oneLine?: boolean }} [options] oneLine: a line that changes; on a terminal where
   * nothing else is said
   */
  constructor({ oneLine = process.stdout.isTTY } = {}) {
    this.#oneLine = oneLine;
  }

  /**
   * @param {number} done @param {number} total in the same unit @param {string} what is being done,
   * in a few words
   */
  show(done, total, what) {
    const now = performance.now();
    if (now - this.#printed < (this.#oneLine ? 200 : 15_000) && done < total) return;
    this.#printed = now;
    const elapsed = (now - this.#start) / 1000;
    const left =
      done > 0 && done < total ? `, about ${timeText((elapsed / done) * (total - done))} left` : '';
    const line = `${((100 * done) / total).toFixed(0)} % after ${timeText(elapsed)}${left}: ${what}`;
    if (this.#oneLine) {
      process.stdout.write(`\r\x1b[K${line.slice(0, (process.stdout.columns ?? 80) - 1)}`);
    } else {
      console.log(line);
    }
  }

  /** Ends the line that changes, so that others can follow. */
  clear() {
    if (this.#oneLine) {
      process.stdout.write('\r\x1b[K');
    }
  }
}
