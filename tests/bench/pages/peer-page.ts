// Viewers of one kind on a page, and when they have all shown something: ?count=64 makes so many small ones, all on screen
// at 1280×800; without it there is one. Nothing is known here of who draws: each peer's page says how it tells.

declare global {
  interface Window {
    /** WebGL contexts that the page has made, where the bench watches (figures/watch.mjs). */
    contextsMade?: readonly WeakRef<WebGLRenderingContext | WebGL2RenderingContext>[];
    /** How many of them were lost, there. */
    contextsLost: number;
    /** What it has done so far, where the bench watches for that too. */
    work: { frames: number; draws: number; timers: number };
    /** How many viewers have said that they are there. */
    loadedViewers: number;
  }
}

export interface PeerPage {
  /** One viewer: the markup that its authors would write. */
  readonly markup: string;
  /** What the markup's own element is called, for a look at whether it shows something. */
  readonly tag: string;
  /** Resolves when a viewer has said by its own event or property that its first frame is drawn or about to be. */
  readonly loaded: (viewer: HTMLElement) => Promise<unknown>;
  /** One viewer's size where it is not 400×300: 256×256. */
  readonly size?: 'square';
}

/** Milliseconds since navigation are in window.firstPicture once all have shown something. */
export async function openPeers({ markup, tag, loaded, size }: PeerPage): Promise<void> {
  const count = new URLSearchParams(location.search).get('count');
  document.body.dataset['size'] = count === null ? (size ?? 'large') : 'small';
  document.body.innerHTML = markup.repeat(Number(count ?? 1));
  window.loadedViewers = 0;
  await Promise.all(
    [...document.querySelectorAll<HTMLElement>(tag)].map(async (viewer) => {
      await loaded(viewer);
      window.loadedViewers += 1;
    }),
  );
  await nextFrame();
  await nextFrame();
  for (const context of window.contextsMade ?? []) finishUnseen(context.deref());
  window.firstPicture = performance.now();
}

/** Resolves with the next animation frame. */
export const nextFrame = (): Promise<number> => new Promise(requestAnimationFrame);

/** Resolves with the next event of that name. */
export const next = (target: EventTarget, name: string): Promise<Event> =>
  new Promise((resolve) => {
    target.addEventListener(name, resolve, { once: true });
  });

/** Waits for what a context was sent; its owner finds the framebuffer that it had bound. */
function finishUnseen(gl: WebGLRenderingContext | WebGL2RenderingContext | undefined): void {
  if (!gl || gl.isContextLost()) return;
  const target = gl instanceof WebGL2RenderingContext ? gl.READ_FRAMEBUFFER : gl.FRAMEBUFFER;
  const query = gl instanceof WebGL2RenderingContext ? gl.READ_FRAMEBUFFER_BINDING : gl.FRAMEBUFFER_BINDING;
  const bound = gl.getParameter(query) as WebGLFramebuffer | null;
  gl.bindFramebuffer(target, null);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  gl.bindFramebuffer(target, bound);
}
