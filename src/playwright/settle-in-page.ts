// When does a viewer's picture stand still? Runs inside the page: the function is sent there as text, so it must not use anything
// outside itself. Reads public properties only.
import type { PhongViewer } from '../index.js';

/**
 * Resolves once everything requested is drawn, the faster programs have taken over, and nothing moves. Rejects after `timeout`
 * milliseconds and says what still happens. A viewer that cannot be drawn, because it is hidden or off screen, only has to be ready.
 */
export async function settleInPage(viewer: PhongViewer, timeout: number): Promise<void> {
  // A specialised program is requested after 20 equal frames and compiles in the background; 10 more let it take over.
  const QUIET_FRAMES = 30;
  // Upper bound of the wait for a program that is being compiled, in frames: five seconds. A driver may refuse it.
  const COMPILING_FRAMES = 300;
  const start = performance.now();
  await customElements.whenDefined('phong-viewer');
  const within = async <T>(what: string, promise: Promise<T>): Promise<T> => {
    let timer = 0;
    const late = new Promise<never>((_, reject) => {
      const left = Math.max(timeout - (performance.now() - start), 0);
      timer = window.setTimeout(() => {
        reject(new Error(`the viewer is not settled after ${String(timeout)} ms: ${what}`));
      }, left);
    });
    try {
      return await Promise.race([promise, late]);
    } finally {
      clearTimeout(timer);
    }
  };
  const frame = (what: string): Promise<number> => within(what, new Promise(requestAnimationFrame));
  /** Number of times that materials have changed, programs included. */
  const versions = (): number => {
    let sum = 0;
    viewer.scene.traverse((object) => {
      const { material } = object as { material?: { version: number } | { version: number }[] };
      for (const one of material === undefined ? [] : [material].flat()) sum += one.version;
    });
    return sum;
  };
  const look = () => ({
    camera: JSON.stringify(viewer.camera),
    programs: viewer.stats.programs,
    versions: versions(),
  });

  await within(viewer.loaded ? 'it is not drawn' : 'it is still loading', viewer.ready);
  let last = look();
  let compiling = false;
  let quiet = 0;
  let what = 'programs are still compiled';
  for (;;) {
    const { frames } = viewer.stats;
    if (quiet < (compiling ? COMPILING_FRAMES : QUIET_FRAMES)) {
      viewer.requestRender();
      await frame(what);
      // Requests reach only viewers that can be seen. Two frames more: observers report a new place after a frame.
      for (let i = 0; i < 2 && viewer.stats.frames === frames; i++) await frame(what);
      if (viewer.stats.frames === frames) return within('it is not drawn', viewer.ready);
    } else {
      // Nothing is requested here, so a frame means motion.
      for (let i = 0; i < 3; i++) await frame(what);
      if (viewer.stats.frames === frames) return within('it is not drawn', viewer.ready);
      what = 'it draws frames by itself';
      quiet = 0;
    }
    const now = look();
    if (now.versions !== last.versions) compiling = false;
    else if (now.programs > last.programs) compiling = true;
    const same =
      now.camera === last.camera && now.versions === last.versions && now.programs === last.programs;
    if (now.camera !== last.camera)
      what = viewer.autoRotate === 0 ? 'the camera moves' : `auto-rotate is ${String(viewer.autoRotate)}`;
    quiet = same ? quiet + 1 : 0;
    last = now;
  }
}
