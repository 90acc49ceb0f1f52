// The viewer's shadow tree: the surface with the picture, poster, message and panel over it, and the slots. Markup only.
import { html, nothing } from 'lit';
import type { PhongViewer } from '../phong-viewer.js';
import { keyShortcuts, keyText, PHRASES } from './description.js';
import { namingOf } from './naming.js';

export interface ViewerLook {
  /** Address of an image over the picture; empty for none. */
  readonly poster: string;
  /** The message about what failed; null for none. */
  readonly notice: string | null;
  /** The element that holds the canvas. */
  readonly holder: HTMLElement;
  /** For screen readers: description, list and announcements. */
  readonly reader: HTMLElement;
}

export function viewerTemplate(viewer: PhongViewer, { poster, notice, holder, reader }: ViewerLook): unknown {
  const { label, labelledBy, decoration } = namingOf(viewer);
  const keys = keyShortcuts(viewer);
  // Nothing that can have the focus may be hidden or nameless.
  const hidden = decoration && keys === '';
  return html`
    <div
      class=${viewer.orbit ? 'surface' : 'surface fixed'}
      part="surface"
      tabindex=${keys === '' ? nothing : 0}
      role=${keys === '' ? 'img' : 'application'}
      aria-hidden=${hidden || nothing}
      aria-label=${label || PHRASES.scene}
      aria-keyshortcuts=${keys || nothing}
      aria-describedby="keys scene"
      .ariaLabelledByElements=${labelledBy}
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
    ${
      hidden
        ? nothing
        : html`<p id="keys" hidden>${keyText(viewer)}</p>
            ${reader}`
    }
    <div class="panel" part="panel"></div>
    <slot></slot>
  `;
}
