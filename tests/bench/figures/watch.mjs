// @ts-check
// What a page does, counted from outside by scripts that run in it before its own: contexts made, and work while nothing
// changes. Each function is sent to the page as it is and knows nothing of this file.

/** Notes the page's WebGL contexts, without keeping any of them, and how many of them were lost. */
export function watchContexts() {
  /** @type {WeakRef<WebGLRenderingContext | WebGL2RenderingContext>[]} */
  const made = [];
  const seen = new WeakSet();
  window.contextsMade = made;
  window.contextsLost = 0;
  for (const { prototype } of [HTMLCanvasElement, OffscreenCanvas]) {
    const getContext = prototype.getContext;
    Object.defineProperty(prototype, 'getContext', {
      ...Object.getOwnPropertyDescriptor(prototype, 'getContext'),
      /** @this {HTMLCanvasElement & OffscreenCanvas} @param {unknown[]} args */
      value(...args) {
        const context = Reflect.apply(getContext, this, args);
        const ours = context instanceof WebGL2RenderingContext || context instanceof WebGLRenderingContext;
        if (ours && !seen.has(context)) {
          seen.add(context);
          made.push(new WeakRef(context));
          this.addEventListener('webglcontextlost', () => {
            window.contextsLost += 1;
          });
        }
        return context;
      },
    });
  }
}

/** Counts, in window.work, callbacks of animation frames and of timers that run, and draws that WebGL is asked for. */
export function watchWork() {
  const work = { frames: 0, draws: 0, timers: 0 };
  window.work = work;
  const { requestAnimationFrame, setTimeout, setInterval } = window;
  window.requestAnimationFrame = (callback) =>
    requestAnimationFrame((time) => {
      work.frames += 1;
      callback(time);
    });
  /** @param {(handler: TimerHandler, ms?: number, ...args: unknown[]) => number} start */
  const counted =
    (start) =>
    (
      /** @type {TimerHandler} */ handler,
      /** @type {number | undefined} */ ms,
      /** @type {unknown[]} */ ...args
    ) =>
      start(
        (/** @type {unknown[]} */ ...given) => {
          work.timers += 1;
          if (typeof handler === 'function') handler(...given);
        },
        ms,
        ...args,
      );
  Object.assign(window, {
    setTimeout: counted((...args) => setTimeout(...args)),
    setInterval: counted((...args) => setInterval(...args)),
  });
  for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext]) {
    const methods = /** @type {Record<string, unknown>} */ (/** @type {unknown} */ (prototype));
    const names = Object.getOwnPropertyNames(prototype).filter((name) =>
      /^draw(Arrays|Elements|RangeElements)/.test(name),
    );
    for (const name of names) {
      const draw = methods[name];
      if (typeof draw !== 'function') continue;
      methods[name] = /** @this {unknown} @param {unknown[]} args */ function (...args) {
        work.draws += 1;
        return Reflect.apply(draw, this, args);
      };
    }
  }
}
