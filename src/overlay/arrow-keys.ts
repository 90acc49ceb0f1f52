// The direction on the screen that an arrow key points in. For everything in a layer that arrow keys move.

/** Steps to the right and down by `KeyboardEvent.key`; other keys have no entry. */
export const ARROWS: Readonly<Record<string, readonly [right: number, down: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
