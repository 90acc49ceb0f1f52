// The bench's counters of what a page does: a count of 0 says something only where work of the same kind is seen. Without the
// element.
import { watchContexts, watchWork } from '../bench/figures/watch.mjs';
import { expect, test } from '../support/test.js';

test('sees contexts, frames, timers and draws of a page that never rests, and none of one that does', async ({
  page,
  consoleGuard,
}) => {
  consoleGuard.allow(/^warning: .*no valid shader program in use/, 3); // a draw asked for is counted, whatever comes of it
  await page.addInitScript(watchContexts);
  await page.addInitScript(watchWork);
  await page.goto('about:blank');
  expect(await page.evaluate(() => window.work)).toEqual({ frames: 0, draws: 0, timers: 0 });
  expect(await page.evaluate(() => window.contextsMade?.length)).toBe(0);

  const { work, given, contexts, lost } = await page.evaluate(async () => {
    document.createElement('canvas').getContext('2d');
    const canvas = document.createElement('canvas');
    const gl = canvas.getContext('webgl2')!;
    canvas.getContext('webgl2'); // the same once more
    const older = new OffscreenCanvas(1, 1).getContext('webgl')!;
    await new Promise(requestAnimationFrame);
    const given = await new Promise((resolve) => setTimeout(resolve, 1, 'given'));
    let ticks = 0;
    await new Promise<void>((resolve) => {
      const interval = setInterval(() => {
        ticks += 1;
        if (ticks < 3) return;
        clearInterval(interval);
        resolve();
      }, 1);
    });
    gl.drawArrays(gl.POINTS, 0, 0);
    gl.drawArraysInstanced(gl.POINTS, 0, 0, 0);
    older.drawArrays(older.POINTS, 0, 0);
    cancelAnimationFrame(requestAnimationFrame(() => undefined));
    clearTimeout(setTimeout(() => undefined, 1));
    await new Promise((resolve) => setTimeout(resolve, 50));
    const contexts = window.contextsMade!.map((context) => context.deref()?.isContextLost());
    const { work, contextsLost: before } = window;
    const gone = new Promise((resolve) => canvas.addEventListener('webglcontextlost', resolve));
    gl.getExtension('WEBGL_lose_context')!.loseContext();
    await gone;
    return { work: { ...work }, given, contexts, lost: [before, window.contextsLost] };
  });
  expect(given).toBe('given');
  // One frame; a timeout, three ticks and the wait at the end; what was taken back never ran.
  expect(work).toEqual({ frames: 1, draws: 3, timers: 5 });
  expect(contexts).toEqual([false, false]);
  expect(lost).toEqual([0, 1]);
});
