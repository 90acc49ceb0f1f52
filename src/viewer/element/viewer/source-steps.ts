// Changes of a source as steps of undo: a drop, and its end. Fetched with the first of them. A file
// of its own, because a part that others import cannot be fetched again after a failure.
import type { PhongMesh, PhongViewer } from '../elements.js';
import { historyOf, valuesOf } from './history.js';

/** Shows a dropped model. */
export const showDropped = (viewer: PhongViewer, model: Blob): void =>
  historyOf(viewer).edit(valuesOf(viewer), () => (viewer.src = model), model);

/** Takes the step back that set `src`, or else sets the source before it. */
export function takeBackSource(
  viewer: PhongViewer,
  element: PhongMesh | PhongViewer,
  src: string | Blob,
  before: string | Blob,
): void {
  if (element.src !== src) return;
  historyOf(viewer).takeBack(src);
  if (element.src !== before) {
    element.src = before || null;
  }
}
