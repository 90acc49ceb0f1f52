// Puts a text on the clipboard for the user. Only code of extras imports it: the first file does
// without.
import type { ViewerText } from '../fields/texts.js';

/** How long a button shows the result, ms. */
const RESULT_MS = 2000;

/**
 * Copies a text, or shows it selected in `field`. `show` writes on the button which of the two it
 * was, and after a while its label again.
 */
export async function copyText(
  text: string,
  field: HTMLTextAreaElement,
  label: ViewerText,
  show: (words: ViewerText) => void,
): Promise<void> {
  field.hidden = true;
  try {
    await navigator.clipboard.writeText(text);
    show('copied ✓');
  } catch {
    // Pages without TLS have no clipboard; a frame without the permission rejects.
    field.value = text;
    field.hidden = false;
    field.select();
    field.scrollIntoView({ block: 'nearest' });
    show('select and copy below');
  }
  // A second press within that time does not lengthen it.
  setTimeout(show, RESULT_MS, label);
}
