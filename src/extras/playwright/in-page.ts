// The functions that run inside a test's page. Playwright sends a function's text without its
// imports, so the build replaces each function exported here by one that carries them
// (.ci/in-page.ts).
import type { PhongViewer } from '../../viewer/index.js';

export { judgeInPage } from './judge-in-page.js';

/**
 * A specialised program is requested after 20 equal frames, if its code is there, which is fetched
 * after 10. 20 more let the code arrive, and the program compile and take over.
 */
const QUIET_FRAMES = 40;

/**
 * Upper bound of the wait for a program that is being compiled, in frames: five seconds. A driver
 * may refuse it.
 */
const COMPILING_FRAMES = 300;

/** Rejects with the reason if the promise takes longer. */
type Within = <T>(what: string, promise: Promise<T>) => Promise<T>;

/**
 * Rejects after `timeout` milliseconds and says what still happens. One that cannot be drawn only
 * has to be ready.
 */
export async function settleInPage(viewer: PhongViewer, timeout: number): Promise<void> {
  const within = deadline(timeout);
  const defined = customElements.whenDefined('phong-viewer');
  await within('<phong-viewer> is not defined, is the script of the package loaded?', defined);
  await within(viewer.loaded ? 'it is not drawn' : 'it is still loading', viewer.ready);
  let last = appearanceOf(viewer);
  let compiling = false;
  let quiet = 0;
  let what = 'programs are still compiled';
  for (;;) {
    const requested = quiet < (compiling ? COMPILING_FRAMES : QUIET_FRAMES);
    const drawn = await drawsFrame(viewer, requested, what, within);
    if (!drawn) {
      return within(viewer.antialias === 'full' ? 'it converges' : 'it is not drawn', viewer.ready);
    }
    if (!requested) {
      what = 'it draws frames by itself';
      quiet = 0;
    }
    const now = appearanceOf(viewer);
    if (now.versions !== last.versions) {
      compiling = false;
    } else if (now.programs > last.programs) {
      compiling = true;
    }
    if (now.camera !== last.camera) {
      what =
        viewer.autoRotate === 0
          ? 'the camera moves'
          : `auto-rotate is ${String(viewer.autoRotate)}`;
    }
    quiet = JSON.stringify(now) === JSON.stringify(last) ? quiet + 1 : 0;
    last = now;
  }
}

function deadline(timeout: number): Within {
  const start = performance.now();
  return async (what, promise) => {
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
}

/**
 * Whether a frame is drawn, on request or by itself. Requests reach only viewers that can be seen.
 */
async function drawsFrame(
  viewer: PhongViewer,
  requested: boolean,
  what: string,
  within: Within,
): Promise<boolean> {
  const { frames } = viewer.stats;
  const frame = (): Promise<number> => within(what, new Promise(requestAnimationFrame));
  if (requested) {
    viewer.requestRender();
    await frame();
    // Two frames more: observers report a new place after a frame.
    for (let i = 0; i < 2 && viewer.stats.frames === frames; i++) {
      await frame();
    }
  } else {
    for (let i = 0; i < 3; i++) {
      await frame();
    }
  }
  return viewer.stats.frames !== frames;
}

const appearanceOf = (viewer: PhongViewer) => ({
  camera: JSON.stringify(viewer.camera),
  programs: viewer.stats.programs,
  versions: materialVersions(viewer),
});

function materialVersions(viewer: PhongViewer): number {
  let sum = 0;
  viewer.scene.traverse((object) => {
    const { material } = object as { material?: { version: number } | { version: number }[] };
    for (const one of material === undefined ? [] : [material].flat()) {
      sum += one.version;
    }
  });
  return sum;
}

/**
 * What the element is if it is no `<phong-viewer>`, and where the viewers are; null for a viewer.
 */
export function otherElement(element: Element): string | null {
  if (element.localName === 'phong-viewer') return null;
  const viewers = element.querySelectorAll('phong-viewer').length;
  const inside = viewers === 0 ? 'with no viewer inside' : `with ${String(viewers)} inside`;
  return `a <${element.localName}> ${inside}`;
}

/** Why a settled viewer does not show all that it declares; null if it does. */
export function whyIncomplete({ shadowRoot, scene }: PhongViewer): string | null {
  const notice = shadowRoot?.querySelector<HTMLElement>('[part=notice]');
  if (notice) {
    const { code, url } = notice.dataset;
    const file = url?.startsWith('data:') === false ? `${url.replace(/^.*\//, '')}: ` : '';
    return `${file}${String(code)} (${notice.textContent})`;
  }
  return scene.children.length > 0 ? null : 'the viewer is empty: no src, geometry or <phong-mesh>';
}

/**
 * CSS that changes how the picture looks on the page, on the element or around it, with its cure;
 * null for none.
 */
export function changeByCss(viewer: Element): string | null {
  let node: Element | null = viewer.shadowRoot?.querySelector('[part=surface]') ?? viewer;
  while (node !== null) {
    const { filter, opacity } = getComputedStyle(node);
    const change =
      filter !== 'none' ? `filter: ${filter}` : Number(opacity) < 1 ? `opacity: ${opacity}` : null;
    // Parts in the element's shadow root are the element's own for whoever reads the message.
    const name = node.getRootNode() === viewer.shadowRoot ? viewer.localName : node.localName;
    if (change !== null) {
      return `<${name}> has the style "${change}", so the page shows other colours than the picture that is judged`;
    }
    const root: Node = node.getRootNode();
    node =
      node.assignedSlot ?? node.parentElement ?? (root instanceof ShadowRoot ? root.host : null);
  }
  return null;
}
