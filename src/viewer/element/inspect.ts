// Finds elements that may hold a mistake of their author that nothing else reports. Each is tested
// once, after the task or the parsing that connected it, and after the page's first picture. The
// tests are cheap and coarse; the code that knows the mistakes and their cures is fetched only if
// one fails. The page's own texts are looked for before that picture, whose label may be one.
import type { LightValues } from '../../phong/light/light-state.js';
import type { Vec3 } from '../../phong/math/vector.js';
import { registryAround } from './child-registry.js';
import type { ElementClass, PhongViewer } from './elements.js';
import { diagnosisCode, type MistakeTests } from './extra-code.js';
import { bindingOf } from './fields/field-binding.js';
import { lookForTexts } from './page/page-texts.js';
import { isCollapsed, isPainted } from './page/visibility.js';
import { isNamed } from './viewer/description.js';

const waiting = new Set<Element>();
const tested = new WeakSet<Element>();
let searched = false;

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
 * theirs; or with a curly quote around or in its value.
 */
function strayAttributes(element: Element): string[] {
  const { observedAttributes: own } = element.constructor as unknown as ElementClass<HTMLElement>;
  return element
    .getAttributeNames()
    .filter((name) =>
      own.includes(name) ? CURLY.test(element.getAttribute(name)!) : !FOREIGN.test(name),
    );
}

/** A word after a curly quote: HTML ends a value without straight quotes at white space. */
const CURLY = /^[\p{Pi}\p{Pf}\u201a\u201e]\S*$/u;

/**
 * Values that are valid and nearly black, as those of another unit are: the colours of a light or a
 * material if all that are given are at most 1 and one is above 0; a cone narrower than half a
 * degree.
 */
function dimValues(element: Element): readonly string[] {
  const { store } = bindingOf<Record<string, unknown>>(element as HTMLElement);
  const colors = COLORS.filter((key) => key in store.fields && store.given(key));
  const largest = Math.max(...colors.flatMap((key) => store.values[key] as Vec3));
  const { aperture } = store.values as Partial<LightValues>;
  return [
    ...(largest > 0 && largest <= 1 ? colors : []),
    ...(aperture !== undefined && aperture > 0 && aperture < 0.5 ? ['aperture'] : []),
  ];
}

const COLORS = ['ambient', 'diffuse', 'specular', 'ka', 'kd', 'ks'];

/** A viewer in a <phong-compare> that is not its child. */
const wrappedViewer = (compare: Element): Element | null =>
  compare.querySelector(':scope > :not(phong-viewer) phong-viewer');

/** Prefixes of one or two letters are those of frameworks, `ar-` is <model-viewer>'s. */
const FOREIGN =
  /^(class|id|style|slot|hidden|title|lang|dir|role|tabindex)$|^(on|_|data-|aria-|(?!ar)\w\w?-)|[^\p{L}\d\p{Pi}\p{Pf}-]/u;

/** The page's first search waits for the frame of its first picture. One not shown has no frames. */
function inspectSoon() {
  setTimeout(() => {
    lookForTexts();
    if (searched || document.hidden) {
      inspectAll();
    } else {
      requestAnimationFrame(() => setTimeout(inspectAll));
    }
  });
}

function inspectAll() {
  searched = true;
  const elements = [...waiting];
  waiting.clear();
  lookForTexts();
  const boxes = elements.filter(
    (element) => !tested.has(element) && BOXES.includes(element.localName) && element.isConnected,
  );
  report(elements.filter(isSuspect));
  // A name changes no picture, so the report must not compete with the first one. By then the
  // page is laid out.
  const viewer = boxes.find(isViewer);
  void viewer?.ready.then(() =>
    report(boxes.filter((box) => (isViewer(box) && !isNamed(box)) || isFlat(box))),
  );
}

function report(suspects: readonly Element[]) {
  if (suspects.length === 0) return;
  // Without this code nothing is reported, and nothing else fails.
  void diagnosisCode()
    .then(({ diagnose }) => diagnose(suspects, TESTS))
    .catch(() => undefined);
}

const BOXES = ['phong-viewer', 'phong-compare'];

const isViewer = (element: Element): element is PhongViewer => element.localName === 'phong-viewer';

/** Displayed, without width or height. Asks for no layout of what the browser skips. */
const isFlat = (element: Element) =>
  isPainted(element.parentElement ?? element) &&
  element.clientWidth * element.clientHeight === 0 &&
  (element.getClientRects().length > 0 || getComputedStyle(element).display === 'contents');

const TESTS: MistakeTests = {
  strayAttributes,
  dimValues,
  wrappedViewer,
  isFlat,
  isCollapsed,
  isNamed,
  registryAround,
};

function isSuspect(element: Element): boolean {
  if (!element.isConnected) return false; // it is tested when it comes back
  if (tested.has(element)) return element.querySelector(':not(:defined)') !== null;
  tested.add(element);
  if (strayAttributes(element).length > 0 || dimValues(element).length > 0) return true;
  if (element.localName === 'phong-compare') return wrappedViewer(element) !== null;
  if (!isViewer(element)) return registryAround(element) === null;
  return (
    element.querySelector(':not(phong-light, phong-mesh, :scope > [slot], :scope > [slot] *)') !==
      null ||
    Array.from(element.childNodes).some(
      (node) => node.nodeType === Node.TEXT_NODE && node.nodeValue?.trim() !== '',
    )
  );
}
