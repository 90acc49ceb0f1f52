// Faults of the graphics context: a `getContext` that fails, contexts that are lost at any call.
// Also counts open contexts and programs. Wraps the browser's functions before any script runs.
// Knows no test.

import type { Page } from '@playwright/test';

/** What `getContext('webgl2')` does. `lost`: it returns a context that is lost at once. */
export type Opening = 'works' | 'null' | 'throws' | 'lost';

interface Faults {
  opening: Opening;
  /** Calls of WebGL functions after which the context is lost; Infinity: never. Counts down. */
  callsLeft: number;
  /** Contexts that are open and not lost. */
  readonly open: number;
  /** Calls of `getContext('webgl2')` so far, with any outcome. */
  readonly asked: number;
  /** Programs that were created and neither deleted nor lost. */
  readonly programs: number;
  /** Loses the newest open context. */
  lose(): void;
  /** Restores the lost contexts whose `webglcontextlost` was prevented. Browsers refuse others. */
  restore(): void;
}

declare global {
  interface Window {
    faults: Faults;
  }
}

/** For all pages of this context that are opened later. */
export async function installFaults(page: Page): Promise<void> {
  await page.addInitScript(wrapContexts);
}

/** Runs in the page. */
function wrapContexts() {
  type Call = (this: unknown, ...given: unknown[]) => unknown;
  const gl = WebGL2RenderingContext.prototype;
  const isLost = gl.isContextLost;
  const getExtension = gl.getExtension;
  /** All contexts ever opened, by the package or to read a texture. */
  const contexts: { context: WebGL2RenderingContext; loss: WEBGL_lose_context | null }[] = [];
  /** Lost contexts that may be restored, because the page prevented the event's default. */
  const restorable = new Set<WEBGL_lose_context>();
  const programs = new Map<WeakRef<object>, WeakRef<WebGL2RenderingContext>>();
  const isOpen = (weak: WeakRef<WebGL2RenderingContext> | undefined) => {
    const context = weak?.deref();
    return context !== undefined && !isLost.call(context);
  };

  const faults: Faults = {
    opening: 'works',
    callsLeft: Infinity,
    asked: 0,
    get open() {
      return contexts.filter(({ context }) => !isLost.call(context)).length;
    },
    get programs() {
      return [...programs.values()].filter(isOpen).length;
    },
    lose: () => contexts.findLast(({ context }) => !isLost.call(context))?.loss?.loseContext(),
    restore: () => {
      for (const loss of restorable) {
        loss.restoreContext();
      }
      restorable.clear();
    },
  };
  window.faults = faults;

  for (const name of Object.getOwnPropertyNames(gl)) {
    const real = Object.getOwnPropertyDescriptor(gl, name)?.value as Call | undefined;
    if (typeof real !== 'function' || name === 'isContextLost') continue;
    Reflect.set(gl, name, function (this: WebGL2RenderingContext, ...given: unknown[]) {
      faults.callsLeft -= 1;
      if (faults.callsLeft < 0) {
        faults.callsLeft = Infinity;
        faults.lose();
      }
      const result = Reflect.apply(real, this, given);
      if (name === 'createProgram' && result !== null && !isLost.call(this)) {
        programs.set(new WeakRef(result as object), new WeakRef(this));
      }
      if (name === 'deleteProgram') {
        for (const weak of programs.keys()) {
          if (weak.deref() === given[0]) {
            programs.delete(weak);
          }
        }
      }
      return result;
    });
  }

  const getContext = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...given: unknown[]) {
    if (given[0] !== 'webgl2') return Reflect.apply(getContext, this, given) as unknown;
    // A canvas that has a context gives it again, whatever happens to new ones.
    const before = contexts.find(({ context }) => context.canvas === this);
    if (before !== undefined) return before.context;
    (faults as { asked: number }).asked += 1;
    if (faults.opening === 'null') return null;
    if (faults.opening === 'throws') throw new Error('getContext is not allowed here');
    const context = Reflect.apply(getContext, this, given) as WebGL2RenderingContext | null;
    if (context === null) return null;
    const loss = Reflect.apply(getExtension, context, [
      'WEBGL_lose_context',
    ]) as WEBGL_lose_context | null;
    contexts.push({ context, loss });
    this.addEventListener('webglcontextlost', (event) =>
      setTimeout(() => {
        if (event.defaultPrevented && loss !== null) {
          restorable.add(loss);
        }
      }),
    );
    if (faults.opening === 'lost') {
      faults.lose();
    }
    return context;
  } as typeof getContext;
}
