// Which words does a viewer itself show or announce, and how does a page replace them? English by default. Knows no place
// where a text is shown.
import type { ViewerErrorCode } from '../viewer/loading.js';

/**
 * Texts in place of the element's own, by key. All are optional. A text for a code of `error` takes the place of the message, which
 * names the file and the cause.
 */
export interface ViewerTexts extends Readonly<Partial<Record<ViewerErrorCode, string | undefined>>> {
  /** Name of the progress bar. Default "Loading". */
  readonly loading?: string | undefined;
  /** The button that loads again what failed. Default "Try again". */
  readonly retry?: string | undefined;
  /** Title of the control panel. Default "Controls". */
  readonly controls?: string | undefined;
  /** Name of the button that shows the viewer in full screen. Default "Full screen". */
  readonly fullScreen?: string | undefined;
  /** Name of the button that leaves full screen. Default "Leave full screen". */
  readonly exitFullScreen?: string | undefined;
}

/** A frozen copy; null for no texts. Throws TypeError for anything but an object of strings. */
export function checkedTexts(value: unknown): ViewerTexts | null {
  if (value === null || value === undefined) return null;
  const texts = Object.entries(value);
  const isText = (text: unknown): boolean => typeof text === 'string' || text === undefined;
  if (typeof value !== 'object' || Array.isArray(value) || !texts.every(([, text]) => isText(text)))
    throw new TypeError('<phong-viewer>.texts: expected an object of texts by key');
  return Object.freeze(Object.fromEntries(texts) as ViewerTexts);
}

/** Texts assigned before the upgrade are an own property, which hides the accessor. Wrong ones are warned of and dropped. */
export function upgradeTexts(element: { texts: ViewerTexts | null }): void {
  if (!Object.hasOwn(element, 'texts')) return;
  const { texts } = element;
  Reflect.deleteProperty(element, 'texts');
  try {
    element.texts = texts;
  } catch (error) {
    console.warn((error as Error).message);
  }
}
