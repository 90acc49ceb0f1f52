// @ts-check
// The command line of `npm run bench`: its options, their defaults and their help. Knows nothing
// about measuring.

import { numberOption, readCommandLine, refuse } from '../support/command-line.mjs';

const HELP = `
npm run bench -- [options]

Measures the built package in Chromium and writes tests/bench/results/STACK.json.

  --quick             one launch of each subject; prints, and writes only with --out
  --only TEXT         subjects whose name contains TEXT; may be given again
  --add               replaces these subjects in the stack's result and keeps the others
  --note TEXT         with --add: what the report has to say about that run
  --list              prints the subjects' names
  --launches N        fresh browsers for each subject (default 5)
  --minutes N         stops after the subject that reaches N minutes, with what it has
  --browser PATH      another Chromium
  --arg=FLAG          a flag of its own, such as --arg=--use-angle=vulkan; may be given again
                      (default: software rendering)
  --stack NAME        name of the result (default software), such as h200-vulkan
  --size WxH          pixels of a picture (default: 480x360 in software, 1920x1080 on a GPU;
                      whole pictures, whose error is measured: 400x300)
  --out FILE          result file
  --build DIR         only builds the pages into DIR
  --built DIR         uses pages built before; needs only Node, playwright-core and a browser
  --limits            fails if a limit of aims.mjs is missed
  --help              prints this

npm run bench:report writes tests/bench/REPORT.md and its charts from all results.
`;

/** @typedef {ReturnType<typeof readOptions>} Options */

/** Refuses what it cannot understand. */
export function readOptions() {
  const flag = /** @type {const} */ ({ type: 'boolean', default: false });
  const text = /** @type {const} */ ({ type: 'string', default: '' });
  const several = /** @type {const} */ ({ type: 'string', multiple: true });
  const options = {
    quick: flag,
    add: flag,
    list: flag,
    limits: flag,
    only: several,
    arg: several,
    launches: text,
    minutes: text,
    browser: text,
    size: text,
    out: text,
    note: text,
    build: text,
    built: text,
    stack: { ...text, default: 'software' },
  };
  const { values } = readCommandLine(HELP, options);
  const size = /^(\d+)x(\d+)$/.exec(values.size);
  if (values.size !== '' && size === null) {
    refuse(`--size takes pixels such as 480x360, not '${values.size}'`);
  }
  return {
    ...values,
    only: values.only ?? [],
    arg: values.arg ?? [],
    launches: numberOption('launches', values.launches || (values.quick ? '1' : '5'), 1),
    minutes: values.minutes === '' ? Infinity : numberOption('minutes', values.minutes, 1),
    size: size && /** @type {const} */ ([Number(size[1]), Number(size[2])]),
  };
}
