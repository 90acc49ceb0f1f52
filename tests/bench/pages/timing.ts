// Times frames of one context: by the clock, closed by reading a pixel back, or by the GPU's own
// timer. Milliseconds for all frames together.

export { rendererName } from '../../glsl/float-pass.js';

/**
 * Changes the scene and draws one frame. Asynchronous, because elements gather changes until the
 * task's microtasks.
 */
type Frame = () => Promise<void>;

interface TimerQuery {
  readonly TIME_ELAPSED_EXT: number;
  readonly GPU_DISJOINT_EXT: number;
}

const timerOf = (gl: WebGL2RenderingContext) =>
  gl.getExtension('EXT_disjoint_timer_query_webgl2') as TimerQuery | null;

export const hasTimer = (gl: WebGL2RenderingContext): boolean => timerOf(gl) !== null;

export const pause = (ms: number): Promise<void> =>
  new Promise((resolve) => setTimeout(resolve, ms));

/** Waits until everything is drawn: a pixel can be read back only then. */
export function finish(gl: WebGL2RenderingContext): void {
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
}

export async function clockFrames(
  gl: WebGL2RenderingContext,
  frame: Frame,
  frames: number,
): Promise<number> {
  finish(gl);
  const start = performance.now();
  for (let i = 0; i < frames; i++) {
    await frame();
  }
  finish(gl);
  return performance.now() - start;
}

/**
 * Tries of a GPU timer before the clock is used: a change of clock speed or another program makes a
 * result disjoint.
 */
const TRIES = 5;

/** GPU time; by the clock where the browser has no timer. */
export async function timeFrames(
  gl: WebGL2RenderingContext,
  frame: Frame,
  frames: number,
): Promise<number> {
  const timer = timerOf(gl);
  if (timer === null) return clockFrames(gl, frame, frames);
  for (let i = 0; i < TRIES; i++) {
    finish(gl);
    const query = gl.createQuery();
    gl.beginQuery(timer.TIME_ELAPSED_EXT, query);
    for (let k = 0; k < frames; k++) {
      await frame();
    }
    gl.endQuery(timer.TIME_ELAPSED_EXT);
    gl.flush();
    while (gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE) !== true) {
      await pause(1);
    }
    const nanoseconds = gl.getQueryParameter(query, gl.QUERY_RESULT) as number;
    gl.deleteQuery(query);
    if (gl.getParameter(timer.GPU_DISJOINT_EXT) !== true) return nanoseconds / 1e6;
  }
  throw new Error('the GPU timer was disjoint in every try');
}
