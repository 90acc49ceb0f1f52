// Finds elements that may hold a mistake of their author that nothing else reports. Each element is tested once, after
// the task or the parsing that connected it. The tests are cheap and coarse; the code that knows the mistakes and their
// cures is fetched only if one fails. The page's own texts are looked for at the same time.
import { registryAround } from '../child-registry.js';
import type { PhongViewer } from '../elements.js';
import { lookForTexts } from '../page/page-texts.js';
import { isNamed } from '../viewer/naming.js';

const waiting = new Set<Element>();
const inspected = new WeakSet<Element>();

/** Tests `element` at the end of the task, or once the document is parsed. Does nothing if it was tested before. */
export function inspect(element: Element): void {
  if (inspected.has(element)) return;
  inspected.add(element);
  waiting.add(element);
  if (waiting.size > 1) return;
  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', inspectSoon, { once: true });
  else inspectSoon();
}

/** Viewers whose content has changed in this task. */
const changed = new Set<Element>();

/**
 * Tests a viewer again after the task, if it contains an element that is not defined. Call it when its content changes.
 * Thousands of children may come one by one, and the search reads all of them: it runs once.
 */
export function inspectAgain(viewer: Element): void {
  if (changed.size === 0) setTimeout(inspectChanged);
  changed.add(viewer);
}

function inspectChanged(): void {
  for (const viewer of changed) {
    if (viewer.querySelector(':not(:defined)') === null) continue;
    inspected.delete(viewer);
    inspect(viewer);
  }
  changed.clear();
}

/** Attributes of `element` that could be a mistake: not its own, and not as HTML and frameworks name theirs. */
export function strayAttributes(element: Element): string[] {
  const { observedAttributes: own } = element.constructor as unknown as {
    readonly observedAttributes: readonly string[];
  };
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
    report(elements.filter(isSuspect));
    const nameless = elements.filter(isNameless);
    const [first] = nameless;
    if (first !== undefined) afterFirstPicture(first as PhongViewer, () => report(nameless));
  });
}

function report(suspects: readonly Element[]): void {
  if (suspects.length === 0) return;
  // Without this code nothing is reported, and nothing else fails.
  void import('./diagnose.js').then(({ diagnose }) => diagnose(suspects)).catch(() => undefined);
}

/**
 * A name changes no picture, so its check must not compete with the first one. Longest wait where no picture comes, ms.
 */
const LONGEST_WAIT = 2000;

function afterFirstPicture(viewer: PhongViewer, action: () => void): void {
  if (viewer.stats.frames > 0) {
    action();
    return;
  }
  const done = (): void => {
    clearTimeout(timer);
    viewer.removeEventListener('render', done);
    action();
  };
  const timer = setTimeout(done, LONGEST_WAIT);
  viewer.addEventListener('render', done);
}

const isNameless = (element: Element): boolean =>
  element.isConnected && element.localName === 'phong-viewer' && !isNamed(element as PhongViewer);

function isSuspect(element: Element): boolean {
  // It is tested when it comes back.
  if (!element.isConnected) return !inspected.delete(element);
  if (strayAttributes(element).length > 0) return true;
  if (element.localName === 'phong-compare') return wrappedViewer(element) !== null;
  if (element.localName !== 'phong-viewer') return registryAround(element) === null;
  return (
    element.querySelector(':not(phong-light, phong-mesh, :scope > [slot], :scope > [slot] *)') !== null ||
    Array.from(element.childNodes).some((node) => node.nodeType === Node.TEXT_NODE && node.nodeValue?.trim() !== '')
  );
}
