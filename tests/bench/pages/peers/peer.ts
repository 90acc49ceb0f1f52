// What a bench page asks of whatever draws on it, and how one is timed. Times are milliseconds, sizes CSS pixels at a device
// pixel ratio of one.
import type { SceneQuery } from '../scenes.js';

export interface Peer {
  readonly gl: WebGL2RenderingContext;
  /** Draws one frame, at once. */
  draw(): void;
  /** What counts as a program of its own, to see when faster ones have taken over. */
  programs(): number;
  /** The size changes, and by the promise's end the next frame has it. */
  resize(width: number, height: number): Promise<void>;
}

/** What frames are timed of. */
export type Drawing = Pick<Peer, 'gl' | 'draw'>;

export type PeerMaker = (holder: HTMLElement, scene: SceneQuery) => Promise<Peer>;

/** Waits until everything that was drawn is there: reading a pixel back needs it. */
export function finish(gl: WebGL2RenderingContext): void {
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
}

export const pause = (ms: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));

/** Faster programs may take over from the background: so many frames and so long without a new one, and it is settled. */
const SETTLED = { frames: 200, ms: 1000, atMost: 20_000 };

/** At the size that is timed, where frames may be so slow that a program is worth its compiling that was not before. */
export const SETTLED_AT_SIZE: typeof SETTLED = { frames: 5, ms: 6000, atMost: 60_000 };

export async function settle(
  peer: Peer,
  { frames: enough, ms, atMost } = SETTLED,
): Promise<{ frames: number; programs: number; most: number }> {
  const begin = performance.now();
  let frames = 0;
  let most = 0;
  let seen = { program: null as unknown, since: begin };
  while (performance.now() - begin < atMost) {
    for (let i = 0; i < 5; i++) peer.draw();
    const program: unknown = peer.gl.getParameter(peer.gl.CURRENT_PROGRAM);
    finish(peer.gl);
    frames += 5;
    most = Math.max(most, peer.programs());
    if (program !== seen.program) seen = { program, since: performance.now() };
    if (frames >= enough && performance.now() - seen.since > ms) break;
    await pause(10);
  }
  return { frames, programs: peer.programs(), most };
}

/** Share of the picture's pixels that are lit at all. */
export function litShare(peer: Peer): number {
  const { gl } = peer;
  peer.draw();
  const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
  const pixels = new Uint8Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let lit = 0;
  for (let i = 0; i < pixels.length; i += 4) if (pixels[i]! + pixels[i + 1]! + pixels[i + 2]! > 0) lit += 1;
  return lit / (width * height);
}

interface TimerQuery {
  readonly TIME_ELAPSED_EXT: number;
  readonly GPU_DISJOINT_EXT: number;
}

/** Milliseconds of GPU time that `frames` frames take; by the clock where the browser has no timer for it. */
export async function timeFrames(peer: Drawing, frames: number): Promise<number> {
  const { gl } = peer;
  const timer = gl.getExtension('EXT_disjoint_timer_query_webgl2') as TimerQuery | null;
  if (timer === null) return clockFrames(peer, frames);
  for (let attempt = 0; attempt < 5; attempt++) {
    const query = gl.createQuery();
    gl.beginQuery(timer.TIME_ELAPSED_EXT, query);
    for (let i = 0; i < frames; i++) peer.draw();
    gl.endQuery(timer.TIME_ELAPSED_EXT);
    gl.flush();
    while (gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE) !== true) await pause(1);
    const nanoseconds = gl.getQueryParameter(query, gl.QUERY_RESULT) as number;
    gl.deleteQuery(query);
    // Disjoint: something (a change of clock, another program) broke the count.
    if (gl.getParameter(timer.GPU_DISJOINT_EXT) !== true) return nanoseconds / 1e6;
  }
  throw new Error('the GPU timer is disjoint every time');
}

/** Milliseconds by the clock, closed by reading a pixel back. */
export function clockFrames(peer: Drawing, frames: number): number {
  finish(peer.gl);
  const start = performance.now();
  for (let i = 0; i < frames; i++) peer.draw();
  finish(peer.gl);
  return performance.now() - start;
}
