// A page within the page: what has to be alone in its document, such as an element that is to have the page's one context for
// itself. Same origin, so its objects can be used from outside.
import type { Size } from './stand.js';

/** Opens `path` with `query` and waits for the promise that its window has under `name`. */
export async function openFrame<T>(
  holder: HTMLElement,
  path: string,
  query: Readonly<Record<string, string | number>>,
  [width, height]: Size,
  name: string,
): Promise<T> {
  const frame = document.createElement('iframe');
  frame.width = String(width);
  frame.height = String(height);
  frame.src = `${path}?${new URLSearchParams(Object.entries(query).map(([k, v]) => [k, String(v)])).toString()}`;
  const loaded = new Promise((resolve, reject) => {
    frame.addEventListener('load', resolve, { once: true });
    frame.addEventListener('error', reject, { once: true });
  });
  holder.append(frame);
  await loaded;
  const window = frame.contentWindow as unknown as Record<string, Promise<T> | undefined>;
  const opened = window[name];
  if (opened === undefined) throw new Error(`${path} offers no ${name}`);
  return opened;
}
