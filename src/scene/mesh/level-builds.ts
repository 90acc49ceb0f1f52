// Builds fine levels of round shapes in slices, one after the other for the whole page. Fetched with the first one.
import { Slices } from '../../model/slices.js';
import { beginGeometry } from './shapes/shapes.js';
import { isBuilt, offerLevel, type ShapeKey } from './shapes/shared-shapes.js';

let last: Promise<void> = Promise.resolve();

/** Resolves when the level is built, or is no longer wanted before it has begun. */
export function buildLevel(key: ShapeKey, wanted: () => boolean): Promise<void> {
  last = last.then(() => (isBuilt(key) || !wanted() ? undefined : build(key)));
  return last;
}

async function build(key: ShapeKey): Promise<void> {
  const slices = new Slices(new AbortController().signal);
  // The frame that ordered it comes first.
  await slices.pause();
  const steps = await beginGeometry(key.name, key.segments, key.isLevel);
  for (;;) {
    const { done, value } = steps.next();
    if (done === true) {
      offerLevel(key, value);
      return;
    }
    await slices.pauseIfDue();
  }
}
