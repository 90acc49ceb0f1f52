// Takes over what a bench page needs before any scene code runs: animation frames are run by the
// bench, and the page's WebGL 2 contexts are recorded, so that every side is driven and timed in
// the same way. Import it first.

let waiting = new Map<number, FrameRequestCallback>();
let last = 0;
const contexts: WebGL2RenderingContext[] = [];

window.requestAnimationFrame = (callback) => {
  last += 1;
  waiting.set(last, callback);
  return last;
};
window.cancelAnimationFrame = (id) => waiting.delete(id);

/** Runs one animation frame. Returns how many callbacks it had. */
export function runFrame(): number {
  const callbacks = waiting;
  waiting = new Map();
  const now = performance.now();
  for (const callback of callbacks.values()) {
    callback(now);
  }
  return callbacks.size;
}

const getContext = Object.getOwnPropertyDescriptor(HTMLCanvasElement.prototype, 'getContext')
  ?.value as (this: HTMLCanvasElement, ...args: unknown[]) => unknown;

Object.defineProperty(HTMLCanvasElement.prototype, 'getContext', {
  configurable: true,
  writable: true,
  value(this: HTMLCanvasElement, ...args: unknown[]) {
    const context = getContext.apply(this, args);
    if (context instanceof WebGL2RenderingContext && !contexts.includes(context)) {
      contexts.push(context);
    }
    return context;
  },
});

/** The page's WebGL 2 context. Throws unless there is exactly one that is not lost. */
export function onlyContext(): WebGL2RenderingContext {
  const open = contexts.filter((context) => !context.isContextLost());
  const [first] = open;
  if (first === undefined || open.length > 1) {
    throw new Error(`the page has ${open.length} WebGL 2 contexts instead of one`);
  }
  return first;
}
