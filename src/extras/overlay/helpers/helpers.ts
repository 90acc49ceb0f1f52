// Draws the helpers over a viewer's picture after each frame, as SVG, or in a picture file as the
// same list.
import { sameValue } from '../../../phong/fields/field-store.js';
import {
  addStyles,
  type Extra,
  type ExtraHost,
  type PictureOptions,
} from '../../../viewer/extra.js';
import { fileLayer } from '../drawing/canvas-drawing.js';
import { listOf, NO_DRAWING } from '../drawing/label-layout.js';
import { type Projection, projectionOf } from '../drawing/projection.js';
import { Room } from '../drawing/room.js';
import { SvgLayer } from '../drawing/svg-layer.js';
import styles from './helpers.css?inline';
import { LIGHT_NAME, LightHelpers } from './light-helpers.js';
import type { SceneBall } from './light-marks.js';
import { SceneHelpers } from './scene-helpers.js';
import { createElement } from '../drawing/dom.js';

export const create = (host: ExtraHost): Extra => new Helpers(host);

class Helpers implements Extra {
  readonly #host: ExtraHost;
  readonly #removeStyles: () => void;
  readonly #element = createElement('div', { class: 'helpers' });
  readonly #svg = new SvgLayer();
  readonly #lights: LightHelpers;
  readonly #objects: SceneHelpers;
  readonly #room: Room;
  #view: Projection | null = null;
  /** What the view and the scene's ball depend on. */
  #seen: readonly unknown[] = [];
  #scene: SceneBall;
  /** The frame that shows what rays have found; 0 if none is requested. */
  #later = 0;

  constructor(host: ExtraHost) {
    this.#host = host;
    this.#scene = ballOf(host);
    this.#removeStyles = addStyles(host.tree.layer.getRootNode() as ShadowRoot, styles);
    this.#element.append(this.#svg.element);
    const changed = (): void => this.#showLater();
    this.#lights = new LightHelpers(host, this.#element, changed);
    this.#objects = new SceneHelpers(host, changed);
    host.tree.room.before(this.#element);
    this.#room = new Room(host.tree, () => this.#show(false), LIGHT_NAME);
  }

  update(): void {
    this.#show(true);
  }

  /** With the next frame: what a timer writes, the next reading of a size would lay out. */
  #showLater(): void {
    this.#later ||= requestAnimationFrame(() => this.#show(false));
  }

  #show(isFrame: boolean): void {
    cancelAnimationFrame(this.#later);
    this.#later = 0;
    const view = this.#projectionNow();
    const helpers = view === null ? [] : this.#host.values.helpers;
    const hasLights = helpers.includes('lights');
    const hasObjects = helpers.some((name) => name !== 'lights');
    if (!hasLights) {
      this.#lights.hide();
    }
    if (!hasObjects) {
      this.#objects.hide();
    }
    const objects = hasObjects ? this.#objects.show(view!, this.#scene, helpers) : NO_DRAWING;
    const lights = hasLights ? this.#lights.show(view!, this.#scene, isFrame) : NO_DRAWING;
    const { box, fontSize, boxes } = this.#room;
    const { list, placed } = listOf([objects, lights], box, fontSize, boxes);
    this.#host.names.placed = placed;
    this.#svg.show(list);
  }

  /** The same at the picture's size: as large in it, in proportion, as on the page. */
  drawOver(canvas: HTMLCanvasElement, options: PictureOptions): void {
    if (options.helpers !== true) return;
    const { view, room, draw } = fileLayer(this.#host, canvas);
    const scene = ballOf(this.#host);
    const { helpers } = this.#host.values;
    const objects = this.#objects.drawingAt(view, scene, helpers);
    const lights = helpers.includes('lights') ? this.#lights.drawingAt(view, scene) : NO_DRAWING;
    const { fontSize } = this.#room;
    const { list, placed } = listOf([objects, lights], room, fontSize);
    draw(list, fontSize);
    // For the probe, which draws next.
    const { names } = this.#host;
    const shown = names.placed;
    names.placed = placed;
    queueMicrotask(() => (names.placed = shown));
  }

  dispose(): void {
    cancelAnimationFrame(this.#later);
    this.#lights.hide();
    this.#objects.hide();
    this.#room.dispose();
    this.#host.names.placed = [];
    this.#element.remove();
    this.#removeStyles();
  }

  /**
   * The projection of the picture as it is now; the same object while that stays. Null without a
   * picture.
   */
  #projectionNow(): Projection | null {
    const size = this.#host.size();
    if (!(size.width > 0 && size.height > 0)) return null;
    const { width, height, picture } = this.#host.viewport;
    const { orbit, fit } = picture;
    const bounds = picture.measure();
    const seen = [bounds, fit.fov, orbit.pose, width, height, size.width, size.height];
    if (this.#view === null || !sameValue(seen, this.#seen)) {
      this.#seen = seen;
      this.#scene = ballOf(this.#host);
      this.#svg.over(size);
      this.#view = projectionOf(this.#host.viewport, size);
    }
    return this.#view;
  }
}

/** An empty scene has the ball that its camera assumes. */
function ballOf({ viewport }: ExtraHost): SceneBall {
  const { center = [0, 0, 0], radius = 0 } = viewport.picture.measure() ?? {};
  return { center, radius: radius || 1 };
}
