// Puts a text on the clipboard for the user. Only code of extras imports it: the first file does
// without.
import type { ViewerText } from '../fields/texts.js';

/** How long the result is shown, ms. */
export const RESULT_MS = 2000;

/** Copies a text, or shows it selected in `field`. Resolves to the words that say which. */
export async function copyText(text: string, field: HTMLTextAreaElement): Promise<ViewerText> {
  field.hidden = true;
  try {
    await navigator.clipboard.writeText(text);
    return 'copied ✓';
  } catch {
    // Pages without TLS have no clipboard; a frame without the permission rejects.
    field.value = text;
    field.hidden = false;
    field.select();
    field.scrollIntoView({ block: 'nearest' });
    return 'select and copy below';
  }
}
