// The viewer's shadow tree: the surface with the picture, poster, description, message and panel over it, and the
// slots.

import { html, nothing, type TemplateResult } from 'lit';
import { phrase, type ViewerTexts } from '../fields/texts.js';
import { CORNER_MARKS } from '../page/picture-box.js';
import type { SurfaceName } from './naming.js';
import type { Failure } from './viewer-context.js';

/** What the tree shows. */
interface ViewerView {
  /** The element that holds the canvas. */
  readonly holder: HTMLElement;
  readonly name: SurfaceName;
  /** The scene and the keys in words. */
  readonly description: string;
  /** What a screen reader finds beside the picture. */
  readonly reader: unknown;
  /** A drag does not rotate the picture. */
  readonly fixed: boolean;
  /** Something has not arrived yet. */
  readonly busy: boolean;
  /** Address of an image over the picture; empty for none. */
  readonly poster: string;
  /** The image could not be shown. */
  readonly onPosterError: () => void;
  /** The share that has arrived, 0 to 1, or null if that is not known. Undefined for no bar. */
  readonly bar: number | null | undefined;
  /** Text size of the page around the viewer, for slotted content. Empty while nothing can be slotted. */
  readonly pageText: string;
  readonly failure: Failure | null;
  /** Trying again may help. */
  readonly retryable: boolean;
  /** The user may remove the message. */
  readonly dismissible: boolean;
  /** Removes the message, or tries again. */
  readonly onButton: () => void;
  /** In place of the texts here. */
  readonly texts: ViewerTexts | null;
}

/** Elements that the viewer's parts are built on. They stay as long as the viewer. */
export interface ViewerTree {
  /** The picture, without the panel. */
  readonly surface: HTMLElement;
  /** Over the picture; the pointer goes through it. Its room is its last child. */
  readonly layer: HTMLElement;
  /** In the layer: what dividers, labels and panel leave of the picture. */
  readonly room: HTMLElement;
  /** In the room: what a notice leaves of it. The place of legends and boxes. */
  readonly free: HTMLElement;
  /** The control panel's place. */
  readonly panel: HTMLElement;
}

export const viewerTemplate = (view: ViewerView): TemplateResult => {
  const { name, poster, bar, failure, texts } = view;
  return html`
    <div
      part="surface"
      class=${view.fixed ? 'surface fixed' : 'surface'}
      tabindex=${name.keys === '' ? nothing : 0}
      role=${name.keys === '' ? 'img' : 'application'}
      aria-hidden=${name.hidden ? 'true' : nothing}
      aria-label=${name.label}
      aria-description=${view.description}
      aria-keyshortcuts=${name.keys || nothing}
      aria-busy=${view.busy ? 'true' : nothing}
      .ariaLabelledByElements=${name.labelledBy}
    >
      ${view.holder}${CORNER_MARKS}
    </div>
    ${
      poster === ''
        ? nothing
        : html`<img class="poster" part="poster" alt="" src=${poster} @error=${view.onPosterError} />`
    }
    <div class="reader" ?hidden=${name.hidden}>${view.reader}</div>
    <div class="layer">
      <div class="room">
        ${failure === null ? nothing : messageTemplate(failure, view)}
        <div class="free"></div>
      </div>
    </div>
    ${bar === undefined ? nothing : progressTemplate(bar, phrase(texts, 'Loading'), view.pageText)}
    <div class="panel" part="panel"></div>
    <slot></slot>
  `;
};

/** What {@link viewerTemplate} has made in `root`. */
export const treeIn = (root: ParentNode): ViewerTree => ({
  surface: root.querySelector('.surface')!,
  layer: root.querySelector('.layer')!,
  room: root.querySelector('.room')!,
  free: root.querySelector('.free')!,
  panel: root.querySelector('.panel')!,
});

const pageText = (size: string): string => `--phong-page: ${size}`;

function progressTemplate(share: number | null, label: string, size: string): TemplateResult {
  const percent = share === null ? null : String(Math.round(share * 100));
  // The style as a property: a strict CSP refuses style attributes.
  return html`<slot name="progress" .style=${pageText(size)}>
    <div class="progress" part="progress" role="progressbar" aria-label=${label} aria-valuenow=${percent ?? nothing}>
      <div
        class=${percent === null ? 'arrived unknown' : 'arrived'}
        .style=${percent === null ? '' : `inline-size: ${percent}%`}
      ></div>
    </div>
  </slot>`;
}

const messageTemplate = (
  { fact, detail: { code, url } }: Failure,
  { texts, onButton, retryable, dismissible, pageText: size }: ViewerView,
): TemplateResult =>
  html`<div class=${dismissible ? 'message own' : 'message'} role="alert">
    <slot name="error" .style=${pageText(size)}>
      <p
        class="notice"
        part="notice"
        dir="auto"
        data-code=${code}
        data-url=${url ?? nothing}
        .textContent=${texts?.[code] === undefined ? fact : phrase(texts, code, { message: fact, url: url ?? '' })}
      ></p>
      <button
        class="retry"
        part=${dismissible ? 'dismiss' : 'retry'}
        type="button"
        aria-label=${dismissible ? phrase(texts, 'Close') : nothing}
        ?hidden=${!retryable && !dismissible}
        .textContent=${dismissible ? '×' : phrase(texts, 'Try again')}
        @click=${onButton}
      ></button>
    </slot>
  </div>`;
