// Announces what the probe shows to screen readers: politely, the first change at once, then at most once a second the
// newest. No timer runs while nothing changes.
import { create, write } from '../../element/dom.js';

/** Milliseconds between two announcements. */
const PAUSE = 1000;

export class Announcer {
  /** The live region. */
  readonly element = create('p', { class: 'reader', 'aria-live': 'polite' });
  #timer: number | undefined;
  #waiting: string | null = null;

  say(text: string): void {
    if (text === (this.#waiting ?? this.element.textContent)) return;
    this.#waiting = text;
    if (this.#timer === undefined) this.#speak();
  }

  dispose(): void {
    clearTimeout(this.#timer);
    this.element.remove();
  }

  readonly #speak = (): void => {
    this.#timer = undefined;
    if (this.#waiting === null) return;
    write(this.element, this.#waiting);
    this.#waiting = null;
    this.#timer = window.setTimeout(this.#speak, PAUSE);
  };
}
