// Takes over the page's animation frames, so that a picture is drawn when the bench says and never else: import it before
// what draws. Only `requestAnimationFrame` is replaced; observers, promises and timers go on as always.

let waiting = new Map<number, FrameRequestCallback>();
let last = 0;

window.requestAnimationFrame = (callback) => {
  last += 1;
  waiting.set(last, callback);
  return last;
};
window.cancelAnimationFrame = (id) => {
  waiting.delete(id);
};

/** One animation frame: whatever has asked for it runs now. Returns how many there were. */
export function runFrame(): number {
  const callbacks = waiting;
  waiting = new Map();
  const now = performance.now();
  for (const callback of callbacks.values()) callback(now);
  return callbacks.size;
}
