// @ts-check
// How many frames make a sample, and which renderers are no GPU: what a run from outside and the demo's page have in common.

/** Drawn by a processor, where a GPU's timer tells nothing. @param {string} renderer what the driver calls itself */
export const isSoftware = (renderer) => /SwiftShader|llvmpipe|Software|Basic Render/i.test(renderer);

/**
 * So many frames that a sample takes at least `enough` milliseconds, or `most`: ways to draw differ by a hundred times.
 * @param {(frames: number) => Promise<number>} sample milliseconds that so many frames take
 * @param {number} enough @param {number} most
 */
export async function framesFor(sample, enough, most) {
  await sample(1); // compiled by now
  let [count, ms] = [1, await sample(1)];
  while (ms < enough && count < most) {
    count = Math.min(Math.ceil(count * Math.min(8, (1.3 * enough) / Math.max(ms, 0.1))), most);
    ms = await sample(count);
  }
  return count;
}
