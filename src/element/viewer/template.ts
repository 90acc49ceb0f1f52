// The viewer's shadow tree: the surface with the picture, poster, message and panel over it, and the slots. Made by the DOM's
// own calls: a template library needs a Trusted Types policy, which a page under `trusted-types 'none'` refuses.

export interface ViewerLook {
  /** Address of an image over the picture; empty for none. */
  readonly poster: string;
  /** A drag does not rotate the picture. */
  readonly fixed: boolean;
  /** The message about what failed; null for none. */
  readonly notice: string | null;
}

export class ViewerTree {
  /** The picture, without the panel. */
  readonly surface = create('div', { part: 'surface' });
  /** The control panel's place. */
  readonly panel = create('div', { class: 'panel', part: 'panel' });
  readonly #poster = create('img', { class: 'poster', part: 'poster', alt: '' });
  readonly #message = create('div', { class: 'message', role: 'alert' });
  readonly #notice = create('p', { class: 'notice', part: 'notice' });

  /** `holder` is the element that holds the canvas. */
  constructor(root: Node, holder: HTMLElement) {
    this.surface.append(holder);
    const slot = create('slot', { name: 'error' });
    slot.append(this.#notice);
    this.#message.append(slot);
    for (const part of [this.surface, this.panel, create('slot', {})]) root.appendChild(part);
  }

  update({ poster, fixed, notice }: ViewerLook): void {
    set(this.surface, 'class', fixed ? 'surface fixed' : 'surface');
    set(this.#poster, 'src', poster === '' ? null : poster);
    if (poster === '') this.#poster.remove();
    else if (this.#poster.parentNode === null) this.surface.after(this.#poster);
    const text = notice ?? '';
    if (this.#notice.textContent !== text) this.#notice.textContent = text;
    if (notice === null) this.#message.remove();
    else if (this.#message.parentNode === null) this.panel.before(this.#message);
  }
}

export function create<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Readonly<Record<string, string>>,
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
}

/** Writes only what changes: every write is a mutation that the browser restyles and the page may observe. */
export function set(element: Element, name: string, value: string | null): void {
  if (element.getAttribute(name) === value) return;
  if (value === null) element.removeAttribute(name);
  else element.setAttribute(name, value);
}
