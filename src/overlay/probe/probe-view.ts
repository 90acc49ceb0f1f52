// How is a probed point shown on the page? Arrows over the picture, a cross-hair for the keyboard, a box with the sum, and announcements.
// Knows which light is looked at, but not which point is next.
import { phrase, type ViewerTexts } from '../../element/fields/texts.js';
import type { ExtraHost } from '../../element/viewer/extras.js';
import type { FragmentExplanation } from '../../element/viewer/shade-at.js';
import { create, set } from '../../element/viewer/template.js';
import { type Point, Projection } from '../drawing/projection.js';
import { SvgLayer } from '../drawing/svg-layer.js';
import { Announcer } from './announcer.js';
import { drawingOf, markOf } from './drawing.js';
import { figureOf } from './figure.js';
import { ProbeBox } from './probe-box.js';
import { adoptProbeStyles } from './probe-styles.js';
import { byShare, type Sum, sumOf } from './sum.js';
import { trianglePlaces } from './triangle.js';
import { fragmentText } from './words.js';

/** What the probe shows. */
export interface Shown {
  /** Null: outside the picture. */
  readonly at: Point | null;
  /** Null: nothing can be explained there, and `message` says why. */
  readonly fragment: FragmentExplanation | null;
  readonly message: string;
  /** A point of the scene, rather than what is under the mouse or the cross-hair. */
  readonly pinned: boolean;
}

const KEYS =
  'Arrow keys move it by a pixel, with Shift by ten. Enter pins it to the surface, Escape releases it.';

export class ProbeView {
  readonly root = create('div', { class: 'probe' });
  /** The cross-hair. The mark that is seen is part of the drawing. */
  readonly cursor = create('div', { class: 'cursor', tabindex: '0', role: 'application' });
  readonly #host: ExtraHost;
  readonly #drawing = new SvgLayer();
  readonly #announcer = new Announcer();
  readonly #box: ProbeBox;
  readonly #removeStyles: () => void;
  #shown: Shown | null = null;

  /** `release` is called by the button that takes the pin away. */
  constructor(host: ExtraHost, release: () => void) {
    this.#host = host;
    this.#box = new ProbeBox(() => this.#show(), release);
    this.#removeStyles = adoptProbeStyles(host.viewer.shadowRoot!);
    this.root.append(this.#drawing.element, this.cursor, this.#box.element, this.#announcer.element);
    host.tree.layer.append(this.root);
  }

  get shown(): Shown | null {
    return this.#shown;
  }

  /** Cross-hair, table or button has the focus. */
  get hasFocus(): boolean {
    return this.root.contains(this.#focus);
  }

  /** CSS pixels of the layer; at least one. */
  get size(): { readonly width: number; readonly height: number } {
    const { width, height } = this.#host.size();
    return { width: Math.max(width, 1), height: Math.max(height, 1) };
  }

  get middle(): Point {
    const { width, height } = this.size;
    return { x: width / 2, y: height / 2 };
  }

  get projection(): Projection {
    const { width, height, orbit, fov } = this.#host.viewport;
    // None before the first layout.
    const aspect = width > 0 && height > 0 ? { aspect: width / height } : {};
    return new Projection({ pose: orbit.pose, fov, ...this.size, ...aspect });
  }

  /** `releasable`: the user has pinned the point. */
  show(shown: Shown | null, releasable: boolean): void {
    this.#shown = shown;
    const focused = this.#box.element.contains(this.#focus);
    this.#box.setPinned(shown?.pinned === true, releasable);
    this.#show();
    // What had the focus may be gone: a row with its light, a button, or the box.
    const gone = shown === null || this.#focus === null || !(this.#focus as HTMLElement).checkVisibility();
    if (focused && gone) this.cursor.focus({ preventScroll: true });
  }

  announce(): void {
    if (this.#shown === null) return;
    const { fragment, message } = this.#shown;
    this.#announcer.say(
      fragment === null ? message : fragmentText(this.#texts, fragment, this.#sumOf(fragment)),
    );
  }

  nameCursor(): void {
    set(this.cursor, 'aria-label', phrase(this.#texts, 'Probe'));
    set(this.cursor, 'aria-roledescription', phrase(this.#texts, 'cross-hair'));
    set(this.cursor, 'aria-description', phrase(this.#texts, KEYS));
  }

  dispose(): void {
    this.#announcer.dispose();
    this.#box.dispose();
    this.root.remove();
    this.#removeStyles();
  }

  get #texts(): ViewerTexts | null {
    return this.#host.viewer.texts;
  }

  get #focus(): Element | null {
    return this.#host.viewer.shadowRoot?.activeElement ?? null;
  }

  #sumOf(fragment: FragmentExplanation): Sum {
    return sumOf(fragment, this.#host.values.colorInterpolation === 'linear');
  }

  #show(): void {
    set(this.root, 'data-shown', this.#shown === null ? null : '');
    if (this.#shown === null) this.#drawing.show([]);
    else this.#showPoint(this.#shown);
  }

  #showPoint({ at, fragment, message }: Shown): void {
    const { viewer, values } = this.#host;
    const { x, y } = at ?? this.middle;
    this.cursor.style.translate = `${x.toFixed(1)}px ${y.toFixed(1)}px`;
    // The legend of a view is at the lower edge.
    const covered = this.#box.keepAwayFrom(y, this.size, values.view === 'shaded' ? 'low' : 'high');
    if (at === null || fragment === null) {
      this.#drawing.show(at === null ? [] : markOf(at, true));
      this.#box.showMessage(message, this.#texts);
      return;
    }
    const sum = this.#sumOf(fragment);
    const halfway = (fragment.mesh.reflection ?? viewer.reflection) === 'blinn-phong';
    const gouraud = (fragment.mesh.shading ?? viewer.shading) === 'gouraud';
    const { chosen } = this.#box;
    const row = chosen === undefined ? byShare(sum.rows)[0] : sum.rows.find(({ light }) => light === chosen);
    const figure = figureOf(fragment, sum, row ?? null, { alone: chosen !== undefined, halfway });
    const outline = gouraud ? trianglePlaces(fragment) : [];
    this.#drawing.show(drawingOf(this.projection, fragment.p, at, figure, { outline, covered }));
    this.#box.show({ fragment, sum, row: row ?? null, halfway, gouraud }, this.#texts, this.size.width);
  }
}
