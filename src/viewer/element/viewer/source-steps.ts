// Changes of a source as steps of undo: a drop, and its end. Fetched with the first of them. A file
// of its own, because a part that others import cannot be fetched again after a failure.
import type { PhongMesh, PhongViewer } from '../elements.js';
import { historyOf } from './history.js';

/** Shows a dropped model, or opens the scene of a picture. */
export function showDropped(
  viewer: PhongViewer,
  dropped: Blob | ((viewer: HTMLElement) => void),
): void {
  if (dropped instanceof Blob) {
    historyOf(viewer).edit(viewer, () => (viewer.src = dropped), dropped);
  } else {
    dropped(viewer);
  }
}

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
