// The probe: which point does a viewer explain, when, and where is that shown? The place under the mouse or the cross-hair, or a pinned point
// in the scene. At most one explanation runs at a time, one a frame, and none while nothing changes.
import { type ViewerTexts, phrase } from '../../element/fields/texts.js';
import type { FragmentExplanation } from '../../element/viewer/shade-at.js';
import { create, set } from '../../element/viewer/template.js';
import { viewerPins } from '../../element/internals.js';
import type { Extra, ExtraHost } from '../../element/viewer/extras.js';
import { sameValue } from '../../fields/field-store.js';
import type { Vec3 } from '../../math/vector.js';
import { inside, type Point, Projection } from '../drawing/projection.js';
import { SvgLayer } from '../drawing/svg-layer.js';
import { Announcer } from './announcer.js';
import { drawingOf, markOf } from './drawing.js';
import { figureOf } from './figure.js';
import { ProbeBox } from './probe-box.js';
import { listen, type ProbeInputHost } from './probe-input.js';
import { adoptProbeStyles } from './probe-styles.js';
import { byShare, type Sum, sumOf } from './sum.js';
import { trianglePlaces } from './triangle.js';
import { fragmentText, HIDDEN, NOTHING, OUTSIDE } from './words.js';

/**
 * Another surface hides a pinned point if it is nearer to the eye by more than this share of the distance. Nearer by less, it is the same
 * surface at the centre of the pixel: half a pixel away (about a tenth of this) a surface can still lean by more than 80 degrees.
 */
const IN_FRONT = 0.005;

/** What the probe shows now. */
interface Shown {
  /** Null: outside the picture. */
  readonly at: Point | null;
  /** Null: nothing can be explained there, and `message` says why. */
  readonly fragment: FragmentExplanation | null;
  readonly sum: Sum | null;
  readonly message: string;
}

export const createProbe = (host: ExtraHost): Extra => new Probe(host);

class Probe implements Extra, ProbeInputHost {
  readonly #host: ExtraHost;
  readonly #root = create('div', { class: 'probe' });
  readonly #drawing = new SvgLayer();
  /** The cross-hair. The mark that is seen is part of the drawing. */
  readonly #cursor = create('div', { class: 'cursor', tabindex: '0', role: 'application' });
  readonly #announcer = new Announcer();
  readonly #box = new ProbeBox(
    () => this.#show(),
    () => this.release(),
  );
  readonly #listening = new AbortController();
  readonly #removeStyles: () => void;
  /** What `probe-at` was when it was pinned last. */
  #declared: Vec3 | null = null;
  /** The pinned point, in world space. */
  #pin: Vec3 | null = null;
  /** Where the mouse or the cross-hair is, if nothing is pinned. */
  #free: Point | null = null;
  /** The fragment here gets pinned with its explanation. */
  #toPin: Point | null = null;
  #shown: Shown | null = null;
  /** The user has pointed or pressed something since the last explanation: only such are announced. */
  #acted = false;
  #busy = false;
  #again = false;
  /** The time of the frame in which the last explanation began. */
  #frame: CSSNumberish | null = null;
  #request = 0;

  constructor(host: ExtraHost) {
    this.#host = host;
    this.#removeStyles = adoptProbeStyles(host.viewer.shadowRoot!);
    this.#root.append(this.#drawing.element, this.#cursor, this.#box.element, this.#announcer.element);
    host.tree.layer.append(this.#root);
    const parts = { surface: host.tree.surface, cursor: this.#cursor, root: this.#root };
    listen(parts, this, this.#listening.signal);
    this.#show();
  }

  update(): void {
    const { probeAt } = this.#host.values;
    if (!sameValue(probeAt, this.#declared)) {
      this.#declared = probeAt;
      this.#pin = probeAt;
    }
    this.#nameCursor();
    this.#explainOncePerFrame();
  }

  dispose(): void {
    this.#listening.abort();
    this.#cancel();
    viewerPins.delete(this.#host.viewer);
    this.#announcer.dispose();
    this.#box.dispose();
    this.#root.remove();
    this.#removeStyles();
  }

  look(at: Point | null): void {
    if (this.#pin !== null || (at === null && this.#free === null)) return;
    // The cross-hair stays where it is while it has the focus.
    if (at === null && this.#hasFocus) return;
    this.#free = at;
    this.#follow();
  }

  pin(at: Point): void {
    this.#toPin = at;
    this.#follow();
  }

  pinHere(): void {
    if (this.#free !== null && this.#pin === null) this.pin(this.#free);
  }

  release(): boolean {
    if (this.#pin === null) return false;
    if (this.#box.element.contains(this.#focus)) this.#cursor.focus({ preventScroll: true });
    // A user's pin gives way to the declared one, and that one to none.
    const declared = this.#host.values.probeAt;
    this.#pin = sameValue(this.#pin, declared) ? null : declared;
    this.#free = this.#hasFocus ? (this.#shown?.at ?? null) : null;
    this.#follow();
    return true;
  }

  step(across: number, down: number): void {
    const { width, height } = this.#size;
    const { x, y } = (this.#pin === null ? this.#free : this.#shown?.at) ?? this.#middle;
    this.#pin = null;
    // Half a pixel inside: there is nothing to explain on the far edges.
    this.#free = inside({ x: x + across, y: y + down }, { width, height }, 0.5);
    this.#follow();
  }

  focused(): void {
    if (this.#pin !== null) return;
    this.#free ??= this.#middle;
    this.#follow();
  }

  blurred(): void {
    if (this.#pin === null) this.look(null);
  }

  get #texts(): ViewerTexts | null {
    return this.#host.viewer.texts;
  }

  get #focus(): Element | null {
    return this.#host.viewer.shadowRoot?.activeElement ?? null;
  }

  get #hasFocus(): boolean {
    return this.#root.contains(this.#focus);
  }

  get #size(): { readonly width: number; readonly height: number } {
    const { clientWidth, clientHeight } = this.#host.tree.layer;
    return { width: Math.max(clientWidth, 1), height: Math.max(clientHeight, 1) };
  }

  get #middle(): Point {
    const { width, height } = this.#size;
    return { x: width / 2, y: height / 2 };
  }

  get #projection(): Projection {
    const { viewport } = this.#host;
    const { width, height, orbit, fov } = viewport;
    // None before the first layout.
    const aspect = width > 0 && height > 0 ? { aspect: width / height } : {};
    return new Projection({ pose: orbit.pose, fov, ...this.#size, ...aspect });
  }

  /** The user chose another point. */
  #follow(): void {
    this.#acted = true;
    this.#explainOncePerFrame();
  }

  /** In this frame, or in the next one if this one has had its explanation. */
  #explainOncePerFrame(): void {
    const { ownerDocument } = this.#root;
    if (ownerDocument.timeline.currentTime !== this.#frame) this.#explain();
    else if (this.#request === 0)
      this.#request = ownerDocument.defaultView?.requestAnimationFrame(() => this.#explain()) ?? 0;
  }

  #cancel(): void {
    if (this.#request !== 0) this.#root.ownerDocument.defaultView?.cancelAnimationFrame(this.#request);
    this.#request = 0;
  }

  #explain(): void {
    this.#cancel();
    this.#again = true;
    if (this.#busy) return;
    this.#busy = true;
    this.#frame = this.#root.ownerDocument.timeline.currentTime;
    this.#again = false;
    void this.#explained().then((shown) => {
      this.#busy = false;
      if (this.#listening.signal.aborted) return;
      this.#shown = shown;
      this.#show();
      if (this.#acted && shown !== null) this.#announcer.say(this.#inWords(shown));
      this.#acted = false;
      if (this.#again) this.#explainOncePerFrame();
    });
  }

  async #explained(): Promise<Shown | null> {
    const [toPin, pin] = [this.#toPin, this.#pin];
    const projection = this.#projection;
    const at = toPin ?? (pin === null ? this.#free : projection.point(pin));
    const nothing = { at, fragment: null, sum: null };
    if (at === null || !isInside(at, projection))
      return pin === null ? null : { ...nothing, at: null, message: phrase(this.#texts, OUTSIDE) };
    const { viewer, tree, values } = this.#host;
    const zoom = (tree.layer as { currentCSSZoom?: number }).currentCSSZoom ?? 1;
    let fragment: FragmentExplanation | null;
    try {
      fragment = await viewer.shadeAt(at.x * zoom, at.y * zoom);
    } catch (error) {
      return { ...nothing, message: (error as Error).message };
    }
    if (toPin !== null && toPin === this.#toPin) {
      this.#toPin = null;
      this.#pin = fragment?.p ?? null;
      // A press beside the shape shows nothing, as the mouse does there.
      this.#free = this.#hasFocus ? at : null;
      if (fragment === null && !this.#hasFocus) return null;
    }
    if (fragment === null) {
      const silent = (this.#pin === null && !this.#hasFocus) || !viewer.loaded;
      return silent ? null : { ...nothing, message: phrase(this.#texts, NOTHING) };
    }
    const hidden =
      pin !== null &&
      toPin === null &&
      projection.depthOf(fragment.p) < (1 - IN_FRONT) * projection.depthOf(pin);
    if (hidden) return { ...nothing, message: phrase(this.#texts, HIDDEN) };
    const sum = sumOf(fragment, values.colorInterpolation === 'linear');
    return { at, fragment, sum, message: '' };
  }

  /** Writes what is explained to the page. */
  #show(): void {
    viewerPins.set(this.#host.viewer, this.#pin);
    this.#box.pinned = this.#pin !== null;
    const focused = this.#box.element.contains(this.#focus);
    set(this.#root, 'data-shown', this.#shown === null ? null : '');
    if (this.#shown === null) this.#drawing.show([]);
    else this.#showPoint(this.#shown);
    // What had the focus may be gone: a row with its light, or the box.
    if (focused && (this.#shown === null || this.#focus === null))
      this.#cursor.focus({ preventScroll: true });
  }

  #showPoint({ at, fragment, sum, message }: Shown): void {
    const texts = this.#texts;
    const { x, y } = at ?? this.#middle;
    this.#cursor.style.translate = `${x.toFixed(1)}px ${y.toFixed(1)}px`;
    const covered = this.#box.keepAwayFrom(y, this.#size);
    if (at === null || fragment === null || sum === null) {
      this.#drawing.show(at === null ? [] : markOf(at, true));
      this.#box.showMessage(message, texts);
      return;
    }
    const { viewer } = this.#host;
    const { mesh } = fragment;
    const halfway = (mesh.reflection ?? viewer.reflection) === 'blinn-phong';
    const gouraud = (mesh.shading ?? viewer.shading) === 'gouraud';
    const { chosen } = this.#box;
    const row = chosen === undefined ? byShare(sum.rows)[0] : sum.rows.find(({ light }) => light === chosen);
    const figure = figureOf(fragment, sum, row ?? null, { alone: chosen !== undefined, halfway });
    const outline = gouraud ? trianglePlaces(fragment) : [];
    this.#drawing.show(drawingOf(this.#projection, fragment.p, at, figure, { outline, covered }));
    this.#box.show({ fragment, sum, row: row ?? null, halfway, gouraud }, texts, this.#size.width);
  }

  #inWords({ fragment, sum, message }: Shown): string {
    return fragment === null || sum === null ? message : fragmentText(this.#texts, fragment, sum);
  }

  #nameCursor(): void {
    const texts = this.#texts;
    set(this.#cursor, 'aria-label', phrase(texts, 'Probe'));
    set(this.#cursor, 'aria-roledescription', phrase(texts, 'cross-hair'));
    set(this.#cursor, 'aria-description', phrase(texts, KEYS));
  }
}

const isInside = ({ x, y }: Point, { width, height }: Projection): boolean =>
  x >= 0 && x < width && y >= 0 && y < height;

const KEYS =
  'Arrow keys move it by a pixel, with Shift by ten. Enter pins it to the surface, Escape releases it.';
