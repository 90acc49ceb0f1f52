// Fills the listings with the markup of viewers on this page, read from the live elements, with its
// lights as they are now. `<div class="listing" data-of="selector" data-title="…">` lists the first
// viewer that matches, then the one that the user touched last. Figures get a collapsed listing of
// their own. A comparison is listed whole.
import { COLUMNS, markupOf } from './markup.js';

export function showListings(root: ParentNode): void {
  for (const figure of root.querySelectorAll('.aside, .wide:not(.live)')) {
    const shown = figure.querySelectorAll('phong-compare, :not(phong-compare) > phong-viewer');
    if (shown.length > 0) {
      figure.append(folded([...shown]));
    }
  }
  for (const place of root.querySelectorAll<HTMLElement>('.listing[data-of]')) {
    const viewers = [...root.querySelectorAll(place.dataset['of'] ?? '')];
    place.replaceChildren();
    follow(viewers, listing(place, place.dataset['title'] ?? 'The markup of this picture'));
  }
  // A text that is there already gets a caption and a button.
  for (const place of root.querySelectorAll<HTMLElement>('.listing[data-title]:not([data-of])')) {
    const text = place.textContent.trim();
    place.replaceChildren();
    listing(place, place.dataset['title'] ?? '').textContent = text;
  }
}

/** Fills `place` with a caption, a copy button and a `<pre>`, which is returned. */
export function listing(place: HTMLElement, title: string): HTMLPreElement {
  const text = document.createElement('pre');
  text.translate = false;
  if (place.matches('.tall, .whole')) {
    text.tabIndex = 0;
    text.setAttribute('role', 'region');
    text.setAttribute('aria-label', title);
  }
  const caption = document.createElement('div');
  caption.className = 'caption';
  const words = document.createElement('span');
  words.textContent = title;
  caption.append(words, copyButton(text, title));
  place.append(caption, text);
  return text;
}

function folded(viewers: readonly Element[]): HTMLElement {
  const details = document.createElement('details');
  details.className = 'source';
  const summary = document.createElement('summary');
  summary.textContent = 'markup';
  const place = document.createElement('div');
  place.className = 'listing';
  details.append(summary, place);
  const title = viewers.length > 1 ? 'The picture last touched' : 'This picture';
  follow(viewers, listing(place, title));
  return details;
}

/** Keeps `text` equal to the markup of one of the viewers or comparisons. */
function follow(viewers: readonly Element[], text: HTMLElement): void {
  let [shown] = viewers;
  const caption = text.previousElementSibling;
  const title = caption?.firstElementChild?.textContent ?? '';
  caption?.append(
    pressable('Edit', `Edit in the playground: ${title}`, () => {
      if (shown !== undefined) {
        void edit(current(shown));
      }
    }),
  );
  const write = (): void => {
    if (shown !== undefined) {
      text.replaceChildren(...markupOf(current(shown), lineLength(text)).map(span));
    }
  };
  const observer = new MutationObserver(write);
  for (const viewer of viewers) {
    observer.observe(viewer, { attributes: true, childList: true, subtree: true });
    viewer.addEventListener('focusin', () => {
      shown = viewer;
      write();
    });
    viewer.addEventListener('light-change', write);
  }
  write();
}

const LIGHT_ATTRIBUTES =
  'active ambient diffuse specular position space axis aperture cutoff attenuation'.split(' ');

/**
 * The element with its lights as the user has left them. Handles and panel set properties, which
 * attributes do not show.
 */
function current(element: Element): Element {
  const copy = document.implementation.createHTMLDocument('').importNode(element, true);
  const copies = copy.querySelectorAll('phong-light');
  element.querySelectorAll('phong-light').forEach((light, i) => {
    const declared = light.cloneNode();
    for (const name of LIGHT_ATTRIBUTES) {
      const text = written(light, name);
      if (text !== written(declared, name)) {
        copies[i]?.setAttribute(name, text);
      }
    }
  });
  return copy;
}

function written(light: Node, name: string): string {
  const value: unknown = Reflect.get(light, name);
  return Array.isArray(value) ? value.join(' ') : String(value);
}

/** Opens the playground with this viewer's markup. */
export async function edit(viewer: Element): Promise<void> {
  const { fragmentOf } = await import('../playground/address.js');
  const root = document.querySelector<HTMLAnchorElement>('.mark')?.href ?? document.baseURI;
  const markup = markupOf(viewer, COLUMNS).map((piece) => piece.text);
  // Models are in this site's folder; the playground is in another folder than this page.
  const text = markup.join('').replaceAll(/ src="([^"]*)"/g, (_, source: string) => {
    return ` src="${new URL(source, document.baseURI).href.replace(root, '../')}"`;
  });
  location.assign(new URL(`playground/${await fragmentOf(text)}`, root));
}

function pressable(words: string, label: string, press: () => void): HTMLButtonElement {
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = words;
  button.setAttribute('aria-label', label);
  button.addEventListener('click', press);
  return button;
}

/** Pixels around the text of a listing, and of a character. */
const [MARGIN, CHARACTER] = [4, 7.9];

/**
 * Characters that fit into a listing, at most {@link COLUMNS}. One that is folded away will be as wide as the
 * page allows.
 */
const lineLength = ({ clientWidth }: Element): number =>
  Math.min(
    COLUMNS,
    Math.floor(((clientWidth || document.documentElement.clientWidth - 60) - MARGIN) / CHARACTER),
  );

function span({ kind, text }: { readonly kind: string; readonly text: string }): Node {
  if (kind === 'plain') return document.createTextNode(text);
  const element = document.createElement('span');
  element.className = kind;
  element.textContent = text;
  return element;
}

function copyButton(text: HTMLElement, title: string): HTMLButtonElement {
  const button = pressable('Copy', `Copy: ${title}`, () => {
    void copy(text.textContent, text).then((done) => {
      button.textContent = done ? 'Copied' : 'Selected';
      setTimeout(() => (button.textContent = 'Copy'), 1500);
    });
  });
  return button;
}

/** If there is no clipboard (a page without HTTPS), the text is selected instead. */
export async function copy(words: string, text: HTMLElement): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(words);
    return true;
  } catch {
    getSelection()?.selectAllChildren(text);
    return false;
  }
}
