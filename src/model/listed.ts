// Names from files in messages.
import { clip } from '../fields/clip.js';

/** Names beyond these are counted only. */
const MOST_LISTED = 10;

/** The first names, clipped, and how many more there are. */
export function listed(names: readonly string[]): string {
  const more = names.length - MOST_LISTED;
  const shown = names.slice(0, MOST_LISTED).map((name) => clip(name));
  return shown.join(', ') + (more > 0 ? ` and ${String(more)} more` : '');
}
