// @ts-check
// What every section of a report asks of the stacks that were measured: names, units, charts side by side.

import { plain, slug, table } from './markdown.mjs';

/** @typedef {import('./result-file.mjs').BenchResult & { stack: string }} Stack a result with its file's name */

/** @param {Stack} stack @param {readonly string[]} parts */
export const chartName = ({ stack }, ...parts) => `${[stack, ...parts].map(slug).join('-')}.svg`;

/** @param {Stack} stack */
export const nameOf = ({ stack }) => stack.replaceAll('-', ' ');

/** @template T @param {readonly T[]} list */
export const unique = (list) => [...new Set(list)];

/** @param {readonly Stack[]} stacks */
export const unitsOf = (stacks) => unique(stacks.flatMap(({ growth: list }) => list.map(({ unit }) => unit)));

/** Side by side, each leading to itself at full size. @param {readonly { stack: Stack, name: string, of: string }[]} list */
export const images = (list) =>
  table(
    list.map(({ stack }) => plain(nameOf(stack))),
    [
      list.map(
        ({ stack, name, of }) => `[![${plain(`${of}, ${nameOf(stack)}`)}](charts/${name})](charts/${name})`,
      ),
    ],
  );
