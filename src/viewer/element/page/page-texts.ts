// The texts of a whole page: by `PhongViewer.texts`, and in scripts of JSON in the markup, which a
// chunk reads.
import { lazyCode } from '../../../phong/lazy-code.js';
import { reportMissing } from '../../model/provided-code.js';
import { checkedTexts, type ViewerTexts } from '../fields/texts.js';

const TEXT_SCRIPTS = 'script[data-phong-viewer-texts]';

const markup = /* @__PURE__ */ lazyCode(() => import('./markup-texts.js'), 'texts in the markup');

interface TextUser {
  requestUpdate(name: 'texts', old: unknown): void;
}

const users = new Set<TextUser>();

let declared: ViewerTexts | null = null;
let assigned: ViewerTexts | null = null;
let texts: ViewerTexts | null = null;

export const pageTexts = (): ViewerTexts | null => texts;

/** `PhongViewer.texts`. Throws TypeError for anything but an object of strings. */
export function assignTexts(value: unknown): void {
  assigned = checkedTexts(value);
  combine();
}

/** `first`, and the texts of `last` that it does not have. */
export const textsOver = (
  first: ViewerTexts | null,
  last: ViewerTexts | null,
): ViewerTexts | null =>
  first === null || last === null ? (first ?? last) : Object.freeze({ ...last, ...first });

function combine() {
  texts = textsOver(assigned, declared);
  for (const user of users) {
    // Lit updates only where the old value differs from the present one. `users` is no element's
    // texts, not even those of an element without texts, which are undefined.
    user.requestUpdate('texts', users);
  }
}

/** The element is on the page: it is updated when the page's texts change. */
export const useTexts = (user: TextUser): unknown => users.add(user);

export const leaveTexts = (user: TextUser): unknown => users.delete(user);

/**
 * Reads the page's scripts of texts, if there are any. Call it when elements have come, and the
 * page is parsed.
 */
export function lookForTexts(): void {
  if (document.querySelector(TEXT_SCRIPTS) === null) return;
  markup().then(({ readTexts }) => {
    const found = readTexts(document.querySelectorAll(TEXT_SCRIPTS));
    if (found !== declared) {
      declared = found;
      combine();
    }
  }, reportMissing);
}
