// Finds elements that may hold a mistake of their author that nothing else reports. Each is tested
// once, after the task or the parsing that connected it. The tests are cheap and coarse; the code
// that knows the mistakes and their cures is fetched only if one fails. The page's own texts are
// looked for at the same time.
import { registryAround } from './child-registry.js';
import type { ElementClass, PhongViewer } from './elements.js';
import { lookForTexts } from './page/page-texts.js';
import { isNamed } from './viewer/description.js';

const waiting = new Set<Element>();
const tested = new WeakSet<Element>();

/**
 * Tests `element` once, at the end of the task, or once the document is parsed. `again`: tests a
 * viewer whose content has changed for elements that are not defined. Thousands of children may
 * come one by one, and the search reads all of them: it runs once a task.
 */
export function inspect(element: Element, again = false): void {
  if (tested.has(element) && !again) return;
  waiting.add(element);
  if (waiting.size > 1) return;
  if (document.readyState === 'loading') {
    document.addEventListener('DOMContentLoaded', inspectSoon, { once: true });
  } else {
    inspectSoon();
  }
}

/**
 * Attributes of `element` that could be a mistake: not its own, and not as HTML and frameworks name
 * theirs.
 */
export function strayAttributes(element: Element): string[] {
  const { observedAttributes: own } = element.constructor as unknown as ElementClass<HTMLElement>;
  return element.getAttributeNames().filter((name) => !own.includes(name) && !FOREIGN.test(name));
}

/** A viewer in a <phong-compare> that is not its child. */
export const wrappedViewer = (compare: Element): Element | null =>
  compare.querySelector(':scope > :not(phong-viewer) phong-viewer');

const FOREIGN = /^(class|id|style|slot|hidden|title|lang|dir|role|tabindex)$|^(on|_)|[^\p{L}\d]/u;

function inspectSoon(): void {
  setTimeout(() => {
    const elements = [...waiting];
    waiting.clear();
    lookForTexts();
    const nameless = elements.filter((element) => !tested.has(element) && isNameless(element));
    report(elements.filter(isSuspect));
    // A name changes no picture, so the report must not compete with the first one.
    void (nameless[0] as PhongViewer | undefined)?.ready.then(() => report(nameless));
  });
}

function report(suspects: readonly Element[]): void {
  if (suspects.length === 0) return;
  // Without this code nothing is reported, and nothing else fails.
  void import('../../extras/diagnosis/diagnose.js')
    .then(({ diagnose }) => diagnose(suspects))
    .catch(() => undefined);
}

const isNameless = (element: Element): boolean =>
  element.isConnected && element.localName === 'phong-viewer' && !isNamed(element as PhongViewer);

function isSuspect(element: Element): boolean {
  if (!element.isConnected) return false; // it is tested when it comes back
  if (tested.has(element)) return element.querySelector(':not(:defined)') !== null;
  tested.add(element);
  if (strayAttributes(element).length > 0) return true;
  if (element.localName === 'phong-compare') return wrappedViewer(element) !== null;
  if (element.localName !== 'phong-viewer') return registryAround(element) === null;
  return (
    element.querySelector(':not(phong-light, phong-mesh, :scope > [slot], :scope > [slot] *)') !==
      null ||
    Array.from(element.childNodes).some(
      (node) => node.nodeType === Node.TEXT_NODE && node.nodeValue?.trim() !== '',
    )
  );
}
