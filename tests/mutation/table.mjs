// @ts-check
// The results as the table that people read.

/** @param {readonly import('./run.mjs').Result[]} results */
export function table(results) {
  const cell = (/** @type {string} */ text) => text.replaceAll('|', '\\|');
  const lines = results.map(
    ({ file, removes, killedBy }) =>
      `| ${cell(file)} | ${cell(removes)} | ${killedBy === null ? '**lives**' : cell(killedBy)} |`,
  );
  const killed = results.filter(({ killedBy }) => killedBy !== null).length;
  return `# What fails when a guard goes

Written by \`npm run mutation\`: each guard and each hoisted term of the light loop, its packing and its reference, taken
away one at a time, and the first test that failed. ${killed} of ${results.length} are killed.

| file | what is removed or replaced | killed by |
| --- | --- | --- |
${lines.join('\n')}
`;
}
