// The viewer's shadow tree: the surface with the picture, poster, message and panel over it, and the slots. Markup only.
import { html, nothing } from 'lit';

export interface ViewerLook {
  /** Text alternative of the picture; empty for none. */
  readonly label: string;
  /** Address of an image over the picture; empty for none. */
  readonly poster: string;
  /** A drag does not rotate the picture. */
  readonly fixed: boolean;
  /** The message about what failed; null for none. */
  readonly notice: string | null;
  /** The element that holds the canvas. */
  readonly holder: HTMLElement;
}

export function viewerTemplate({ label, poster, fixed, notice, holder }: ViewerLook): unknown {
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
    <slot></slot>
  `;
}
