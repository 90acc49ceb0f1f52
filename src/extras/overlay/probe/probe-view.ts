// Shows a probed point: arrows over the picture, a cross-hair for the keyboard, a box with the sum,
// and announcements.
import {
  addStyles,
  type ExtraHost,
  type FragmentExplanation,
  phrase,
  type ViewerTexts,
} from '../../../viewer/extra.js';
import { html, render } from 'lit';
import type { Size } from '../../../phong/math/region.js';
import { fileLayer } from '../drawing/canvas-drawing.js';
import type { DrawnItem } from '../drawing/display-list.js';
import { layerSize, type Point, type Projection, projectionOf } from '../drawing/projection.js';
import { Room } from '../drawing/room.js';
import { SvgLayer } from '../drawing/svg-layer.js';
import { drawingOf, figureOf, markOf, type Surroundings, trianglePlaces } from './figure.js';
import { ProbeBox } from './probe-box.js';
import styles from './probe.css?inline';
import { type Sum, probeSum, fragmentText, KEYS } from './sum.js';
import { isGouraud, isHalfway, rowOf, type SumContent } from './sum-table.js';
import tableStyles from './sum-table.css?inline';
import { createElement, write } from '../drawing/dom.js';

export interface ProbedPoint {
  /** Null: outside the picture. */
  readonly at: Point | null;
  /** Null if nothing can be explained there; `message` gives the reason. */
  readonly fragment: FragmentExplanation | null;
  readonly message: string;
  /** A point of the scene, rather than what is under the mouse or the cross-hair. */
  readonly pinned: boolean;
}

/** Milliseconds between two announcements. */
const PAUSE = 1000;

export class ProbeView {
  /** What is drawn, below boxes and notices. */
  readonly root = createElement('div', { class: 'probe' });
  readonly #removeStyles: () => void;
  /** The cross-hair. The mark that is seen is part of the drawing. */
  readonly cursor: HTMLElement;
  shown: ProbedPoint | null = null;
  readonly #host: ExtraHost;
  readonly #drawing = new SvgLayer();
  readonly #region = createElement('p', { class: 'reader', 'aria-live': 'polite' });
  readonly #room: Room;
  readonly #box: ProbeBox;
  #releasable = false;
  /** The texts that it shows. */
  #written: ViewerTexts | null = null;
  /** Runs after an announcement. */
  #pause: number | undefined;
  #unsaid = false;

  /** `release` is called by the button that removes the pin. */
  constructor(host: ExtraHost, release: () => void) {
    this.#host = host;
    this.#room = new Room(host.tree, () => {
      if (this.#box.isHigh) {
        // Not here: the observer would have to report what it reports.
        host.viewer.ownerDocument.defaultView?.requestAnimationFrame(() => this.#show(true));
      }
      this.#show();
    });
    this.#box = new ProbeBox(this.#room, () => this.#show(), release);
    this.#removeStyles = addStyles(host.viewer.shadowRoot!, tableStyles + styles);
    host.tree.room.before(this.root);
    host.tree.free.append(this.place);
    this.#show();
    this.cursor = this.root.querySelector('.cursor')!;
  }

  /** Holds the box. */
  get place(): HTMLElement {
    return this.#box.place;
  }

  /** Cross-hair, table or button has the focus. */
  get hasFocus(): boolean {
    return this.root.contains(this.#focus) || this.place.contains(this.#focus);
  }

  get size(): Size {
    return layerSize(this.#host.size());
  }

  get middle(): Point {
    const { width, height } = this.size;
    return { x: width / 2, y: height / 2 };
  }

  get projection(): Projection {
    return projectionOf(this.#host.viewport, this.size);
  }

  /** Draws the arrows of a fragment into the file of a picture that was captured in this task. */
  drawerOf(picture: HTMLCanvasElement): (fragment: FragmentExplanation) => void {
    const { view, room, draw } = fileLayer(this.#host, picture);
    const space = { room, boxes: this.#host.names.placed };
    return (fragment) => {
      const at = view.point(fragment.p);
      if (at === null) return;
      draw(this.#drawingOf(this.#contentOf(fragment), at, view, space), this.#room.fontSize);
    };
  }

  /** `releasable`: the user has pinned the point. */
  show(shown: ProbedPoint | null, releasable: boolean): void {
    // As during each frame of a drag: there is nothing to lay out.
    const stays = (shown ?? this.shown) === null && releasable === this.#releasable;
    if (stays && this.#texts === this.#written) return;
    this.shown = shown;
    this.#releasable = releasable;
    const focused = this.hasFocus && this.#focus !== this.cursor;
    this.#show();
    if (!focused) return;
    // The focused row, button or box may have been removed. Asking lays the page out.
    if (shown === null || this.#focus === null || !(this.#focus as HTMLElement).checkVisibility()) {
      this.cursor.focus({ preventScroll: true });
    }
  }

  /**
   * Says what is shown to screen readers: the first change at once, then the newest at most once a
   * second.
   */
  announce(): void {
    this.#unsaid = true;
    if (this.#pause === undefined) {
      this.#say();
    }
  }

  dispose(): void {
    clearTimeout(this.#pause);
    this.#unsaid = false;
    this.#room.dispose();
    this.root.remove();
    this.place.remove();
    this.#removeStyles();
  }

  get #texts(): ViewerTexts | null {
    return this.#host.viewer.texts;
  }

  get #focus(): Element | null {
    return this.#host.viewer.shadowRoot?.activeElement ?? null;
  }

  #sumOf(fragment: FragmentExplanation): Sum {
    return probeSum(fragment, this.#host.values.colorInterpolation === 'linear');
  }

  readonly #say = (): void => {
    this.#pause = undefined;
    if (!this.#unsaid) return;
    this.#unsaid = false;
    // With the next frame: what a timer writes, the next reading of a size would lay out.
    const view = this.#host.viewer.ownerDocument.defaultView;
    this.#pause = window.setTimeout(() => view?.requestAnimationFrame(this.#say), PAUSE);
    const { fragment = null, message = '' } = this.shown ?? {};
    write(
      this.#region,
      fragment === null ? message : fragmentText(this.#texts, fragment, this.#sumOf(fragment)),
    );
  };

  #show(anew = false): void {
    const { at, fragment, message } = this.shown ?? { at: null, fragment: null, message: null };
    const texts = (this.#written = this.#texts);
    const { x, y } = at ?? this.middle;
    const content = fragment === null ? null : this.#contentOf(fragment);
    const state = {
      content: content ?? message,
      at: { x, y },
      pinned: this.shown?.pinned === true,
      releasable: this.#releasable,
      texts,
    };
    this.#box.show(state, anew);
    this.#drawing.over(this.size);
    if (at === null) {
      this.#drawing.show([]);
    } else if (content === null) {
      this.#drawing.show(markOf(at, true));
    } else {
      const space = {
        room: this.#room.box,
        boxes: [...this.#room.boxes, ...this.#host.names.placed],
      };
      this.#drawing.show(this.#drawingOf(content, at, this.projection, space));
    }
    const probe = html`
      ${this.#drawing.element}
      <div
        class="cursor"
        tabindex="0"
        role="application"
        aria-label=${phrase(texts, 'Probe')}
        aria-roledescription=${phrase(texts, 'cross-hair')}
        aria-description=${phrase(texts, KEYS)}
        .style=${`translate: ${x.toFixed(1)}px ${y.toFixed(1)}px`}
      ></div>
      ${this.#region}
    `;
    render(probe, this.root);
  }

  #contentOf(fragment: FragmentExplanation): SumContent {
    const { viewer } = this.#host;
    const sum = this.#sumOf(fragment);
    const row = rowOf(sum, this.#box.chosen);
    const halfway = isHalfway(fragment, viewer);
    return { fragment, sum, row, halfway, gouraud: isGouraud(fragment, viewer) };
  }

  /** The arrows at `at`, with labels in the space. */
  #drawingOf(
    { fragment, sum, row, halfway, gouraud }: SumContent,
    at: Point,
    projection: Projection,
    space: Pick<Surroundings, 'room' | 'boxes'>,
  ): readonly DrawnItem[] {
    const alone = this.#box.chosen !== undefined;
    const figure = figureOf(fragment, sum, row, { alone, halfway }, this.#texts);
    const outline = gouraud ? trianglePlaces(fragment) : [];
    const { fontSize } = this.#room;
    return drawingOf(projection, fragment.p, at, figure, { outline, ...space, fontSize });
  }
}
