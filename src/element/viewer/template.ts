// The viewer's shadow tree: the surface with the picture, poster, message and panel over it, and the slots. Made by the DOM's
// own calls: a template library needs a Trusted Types policy, which a page under `trusted-types 'none'` refuses.

import { phrase, type ViewerTexts } from '../fields/texts.js';
import type { ViewerFailure } from './failure.js';
import type { ViewerLoading } from './loading.js';

export interface ViewerLook {
  /** Address of an image over the picture; empty for none. */
  readonly poster: string;
  /** A drag does not rotate the picture. */
  readonly fixed: boolean;
  readonly loading: Pick<ViewerLoading, 'pending' | 'bar'>;
  readonly failure: Pick<ViewerFailure, 'newest' | 'retryable'>;
  /** In place of the texts here. */
  readonly texts: ViewerTexts | null;
}

export class ViewerTree {
  /** The picture, without the panel. */
  readonly surface = create('div', { part: 'surface' });
  /** Over the picture; the pointer goes through it. */
  readonly layer = create('div', { class: 'layer' });
  /** The control panel's place. */
  readonly panel = create('div', { class: 'panel', part: 'panel' });
  readonly #poster = create('img', { class: 'poster', part: 'poster', alt: '' });
  /** The poster that could not be shown. */
  #badPoster = '';
  readonly #progress = create('slot', { name: 'progress' });
  readonly #bar = create('div', { class: 'progress', part: 'progress', role: 'progressbar' });
  readonly #arrived = create('div', {});
  readonly #message = create('div', { class: 'message', role: 'alert' });
  readonly #notice = create('p', { class: 'notice', part: 'notice', dir: 'auto' });
  readonly #retry = create('button', { class: 'retry', part: 'retry', type: 'button' });

  /** `holder` is the element that holds the canvas; `retry` is called by the button of the message. */
  constructor(root: Node, holder: HTMLElement, retry: () => void) {
    this.surface.append(holder);
    this.#poster.addEventListener('error', () => {
      this.#badPoster = this.#poster.getAttribute('src') ?? '';
      this.#poster.remove();
    });
    this.#bar.append(this.#arrived);
    this.#progress.append(this.#bar);
    this.#retry.addEventListener('click', retry);
    const slot = create('slot', { name: 'error' });
    slot.append(this.#notice, this.#retry);
    this.#message.append(slot);
    for (const part of [this.surface, this.layer, this.panel, create('slot', {})]) root.appendChild(part);
  }

  update({ poster, fixed, loading, failure, texts }: ViewerLook): void {
    set(this.surface, 'class', fixed ? 'surface fixed' : 'surface');
    set(this.surface, 'aria-busy', loading.pending ? 'true' : null);
    if (poster !== this.#badPoster) this.#badPoster = '';
    if (poster === '' || this.#badPoster !== '') this.#poster.remove();
    else if (this.#poster.parentNode === null) this.surface.after(this.#poster);
    set(this.#poster, 'src', poster === '' ? null : poster);
    if (loading.bar === undefined) this.#progress.remove();
    else this.#showProgress(loading.bar, phrase(texts, 'Loading'));
    const { newest, retryable } = failure;
    if (newest === null) this.#removeMessage();
    else {
      const { code, message, url } = newest;
      write(
        this.#notice,
        texts?.[code] === undefined ? message : phrase(texts, code, { message, url: url ?? '' }),
      );
      write(this.#retry, phrase(texts, 'Try again'));
      this.#retry.hidden = !retryable;
      if (this.#message.parentNode === null) this.panel.before(this.#message);
    }
  }

  #showProgress(share: number | null, label: string): void {
    const percent = share === null ? null : String(Math.round(share * 100));
    set(this.#bar, 'aria-label', label);
    set(this.#bar, 'aria-valuenow', percent);
    set(this.#arrived, 'class', percent === null ? 'arrived unknown' : 'arrived');
    this.#arrived.style.inlineSize = percent === null ? '' : `${percent}%`;
    if (this.#progress.parentNode === null) this.panel.before(this.#progress);
  }

  #removeMessage(): void {
    // Otherwise the focus would be lost with the button.
    if (this.#message.matches(':focus-within')) this.surface.focus({ preventScroll: true });
    this.#message.remove();
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

/** Writes only what changes, for the same reason as {@link set}. Screen readers may also read again what is written. */
export function write(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** Writes only what changes: every write is a mutation that the browser restyles and the page may observe. */
export function set(element: Element, name: string, value: string | null): void {
  if (element.getAttribute(name) === value) return;
  if (value === null) element.removeAttribute(name);
  else element.setAttribute(name, value);
}
