// The viewer's shadow tree: the picture's surface, what lies over it, and the slots. Knows nothing of how any of it works.
import { html, nothing } from 'lit';

export interface ViewerLook {
  /** What the picture shows, in words; empty where nobody said. */
  readonly label: string;
  /** Address of an image over the picture; empty for none. */
  readonly poster: string;
  /** Drags do not turn it. */
  readonly fixed: boolean;
  /** What has failed, if anything. */
  readonly notice: string | null;
  /** The canvas's own element. */
  readonly holder: HTMLElement;
  readonly slotchange: () => void;
}

export function viewerTemplate({ label, poster, fixed, notice, holder, slotchange }: ViewerLook): unknown {
  return html`
    <div
      class=${fixed ? 'surface fixed' : 'surface'}
      part="surface"
      tabindex="0"
      role=${label === '' ? nothing : 'img'}
      aria-label=${label === '' ? nothing : label}
    >
      ${holder}
    </div>
    ${poster === '' ? nothing : html`<img class="poster" part="poster" src=${poster} alt="" />`}
    ${
      notice === null
        ? nothing
        : html`<div class="message" role="alert">
            <slot name="error"><p class="notice" part="notice">${notice}</p></slot>
          </div>`
    }
    <div class="panel" part="panel"></div>
    <slot @slotchange=${slotchange}></slot>
  `;
}
