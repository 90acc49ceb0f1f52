// @ts-check
// The command line of `npm run bench`. An option that it does not know is refused in one line.

import { parseArgs } from 'node:util';

export const HELP = `npm run bench -- [options]

Measures the built package in Chromium and writes tests/bench/results/STACK.json.

  --quick             one launch of each subject; prints, and writes only with --out
  --only TEXT         subjects whose name contains TEXT; separate several by semicolons
  --list              prints the subjects' names
  --launches N        fresh browsers for each subject (default 5)
  --minutes N         stops after the subject that reaches N minutes, with what it has
  --browser PATH      another Chromium
  --flags "A B"       its flags, separated by spaces (default: software rendering)
  --stack NAME        name of the result (default software): software, h200-vulkan, h200-opengl
  --size WxH          pixels of a picture (default: 480x360 in software, 1920x1080 on a GPU)
  --out FILE          result file
  --build DIR         only builds the pages into DIR
  --built DIR         uses pages built before; needs only Node, playwright-core and a browser
  --help              prints this

npm run bench:report writes tests/bench/REPORT.md and its charts from all results.
`;

/**
 * @typedef {object} Options
 * @property {boolean} quick @property {boolean} list @property {boolean} help
 * @property {string[]} only @property {number} launches @property {number} minutes
 * @property {string} browser @property {string[]} flags @property {string} stack
 * @property {readonly [number, number] | null} size
 * @property {string} out @property {string} build @property {string} built
 */

/** Throws an error of one line where the arguments cannot be understood. @param {string[]} args @returns {Options} */
export function parseOptions(args) {
  /** @type {Record<string, string | boolean | undefined>} */
  let values;
  try {
    ({ values } = parseArgs({
      args: joined(args),
      options: {
        quick: { type: 'boolean', default: false },
        list: { type: 'boolean', default: false },
        help: { type: 'boolean', default: false },
        only: { type: 'string', default: '' },
        launches: { type: 'string' },
        minutes: { type: 'string', default: '' },
        browser: { type: 'string', default: '' },
        flags: { type: 'string', default: '' },
        stack: { type: 'string', default: 'software' },
        size: { type: 'string', default: '' },
        out: { type: 'string', default: '' },
        build: { type: 'string', default: '' },
        built: { type: 'string', default: '' },
      },
    }));
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    throw new Error(`${message.split(/\.\s|\n/)[0]}. Try --help.`);
  }
  const text = (/** @type {string} */ name) => String(values[name] ?? '');
  const split = (/** @type {string} */ name, /** @type {string} */ separator) =>
    text(name)
      .split(separator)
      .map((part) => part.trim())
      .filter((part) => part !== '');
  /** @param {string} name @param {number} otherwise */
  const count = (name, otherwise) => {
    if (text(name) === '') return otherwise;
    const number = Number(text(name));
    if (!(number > 0)) throw new Error(`--${name} takes a number above 0, not "${text(name)}". Try --help.`);
    return number;
  };
  const size = /^(\d+)x(\d+)$/.exec(text('size'));
  if (text('size') !== '' && size === null)
    throw new Error(`--size takes pixels such as 480x360, not "${text('size')}". Try --help.`);
  const quick = values['quick'] === true;
  return {
    quick,
    list: values['list'] === true,
    help: values['help'] === true,
    only: split('only', ';'),
    launches: count('launches', quick ? 1 : 5),
    minutes: count('minutes', Infinity),
    browser: text('browser'),
    flags: split('flags', ' '),
    stack: text('stack'),
    size: size === null ? null : [Number(size[1]), Number(size[2])],
    out: text('out'),
    build: text('build'),
    built: text('built'),
  };
}

/** Flags begin with a dash, which parseArgs takes for an option unless an equals sign is before it. @param {string[]} args */
function joined(args) {
  const at = args.indexOf('--flags');
  if (at < 0 || at === args.length - 1) return args;
  return [...args.slice(0, at), `--flags=${args[at + 1]}`, ...args.slice(at + 2)];
}
