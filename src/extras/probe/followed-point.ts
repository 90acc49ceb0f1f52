// The point of a viewer that a <phong-probe> explains: the one that its markup declares, or that
// the user points at or pins. Explains at most once a frame, and never while nothing changes. A
// ring marks the point in pictures without a probe of their own.
import {
  addStyles,
  afterPictures,
  type FragmentExplanation,
  hostOf,
  type PhongViewer,
  phrase,
} from '../../viewer/extra.js';
import { SLOP } from '../../phong/camera/kept-drag.js';
import type { Size } from '../../phong/math/region.js';
import type { Vec3 } from '../../phong/math/vector.js';
import { ARROWS, layerSize, type Point, Projection } from '../overlay/drawing/projection.js';
import { KEYS } from '../overlay/probe/sum.js';
import { askedOf, formOf, type ProbeValues } from './probe-fields.js';
import { seededFragment, seededNumbers } from './seeded.js';

/** Where the pointer is, or a key has moved the ring to, as `shadeAt` takes it. */
interface Place extends Point {
  readonly pins: boolean;
  /** A step of the keyboard: on to the next surface. */
  readonly step?: Point;
}

/** Moves the points of all probes that follow a viewer. Dispatched at its surface. */
const STEP = 'probe-step';

/** Where it lies follows the picture, which keeps its shape where paper gives it another box. */
const RING = `.pointed {
  position: absolute;
  left: calc(100% * var(--x));
  top: calc(100% * var(--y));
  margin: -7px;
  box-sizing: border-box;
  width: 14px;
  height: 14px;
  border: 2px solid #fff;
  border-radius: 50%;
  outline: 1px solid #000;
}
.pointed:is(:focus-visible, [data-strong]) {
  outline: 3px solid #000;
}
.pointed[data-strong] {
  z-index: 1;
  scale: 1.6;
}
.pointed[hidden] {
  display: none;
}
@media print {
  .layer:has(> .pointed) {
    container-type: size;
  }
  .pointed {
    left: calc(50% + (var(--x) - 0.5) * min(100cqw, 100cqh * var(--shape)));
    top: calc(50% + (var(--y) - 0.5) * min(100cqh, 100cqw / var(--shape)));
  }
}`;

export class FollowedPoint {
  /** Null if no surface is there; undefined before the first explanation. */
  fragment: FragmentExplanation | null | undefined;
  readonly #viewer: PhongViewer;
  readonly #values: Readonly<ProbeValues>;
  readonly #changed: (error?: Error) => void;
  readonly #listening = new AbortController();
  readonly #ring = Object.assign(document.createElement('div'), {
    className: 'pointed',
    role: 'application',
    hidden: true,
  });
  /** The last point of the user. */
  #point: Vec3 | null = null;
  #isPinned = false;
  /** Explained before the point. */
  #place: Place | null = null;
  #seeded: { readonly key: string; readonly point: Vec3 } | null = null;
  /** Also until everything requested is there. Viewers far from view need not be drawn for that. */
  #busy = true;
  #again = false;

  /**
   * `changed` is called after each explanation, with the error that it ended in. Of several rings
   * in a picture, that of the `element` under the mouse or with the focus is the strong one.
   */
  constructor(
    element: HTMLElement,
    viewer: PhongViewer,
    values: Readonly<ProbeValues>,
    changed: (error?: Error) => void,
  ) {
    this.#viewer = viewer;
    this.#values = values;
    this.#changed = changed;
    const { signal } = this.#listening;
    const strengthen = (): void =>
      void this.#ring.toggleAttribute('data-strong', element.matches(':hover, :focus-within'));
    for (const type of ['pointerenter', 'pointerleave', 'focusin', 'focusout'] as const) {
      element.addEventListener(type, strengthen, { signal });
    }
    void viewer.updateComplete
      .then(() => this.#listen())
      .then(() => viewer.ready)
      .then(() => {
        this.#busy = false;
        this.update();
      });
  }

  /** Explains the point again, because anything may have changed. */
  update(): void {
    afterPictures(this.#viewer, this.#update, true);
  }

  readonly #update = (): void => {
    this.#again = this.#busy;
    if (this.#busy || !this.#ring.isConnected) return;
    this.#busy = true;
    const done = (fragment: FragmentExplanation | null, error?: Error): void => {
      if (this.#isOver) return;
      this.fragment = fragment;
      this.#mark();
      this.#busy = false;
      this.#changed(error);
      if (this.#again) {
        this.update();
      }
    };
    this.#explain().then(done, (error: unknown) => done(null, error as Error));
  };

  stop(): void {
    this.#listening.abort('stopped');
    this.#ring.remove();
  }

  get #isOver(): boolean {
    return this.#listening.signal.aborted;
  }

  /** The markup says which point. */
  get #isDeclared(): boolean {
    return this.#values.at !== null || this.#values.seed !== '';
  }

  /** Questions stay at their point while the mouse moves. */
  get #isStill(): boolean {
    return formOf(this.#values) === 'ask';
  }

  #listen(): void {
    const viewer = this.#viewer;
    const tree = viewer.shadowRoot!;
    const { signal } = this.#listening;
    if (this.#isOver) return;
    addStyles(tree, RING);
    tree.querySelector('.layer')!.append(this.#ring);
    const update = (): void => this.update();
    const updates = { hostUpdated: update };
    viewer.addController(updates);
    signal.addEventListener('abort', () => viewer.removeController(updates));
    for (const type of ['render', 'load']) {
      viewer.addEventListener(type, update, { signal });
    }
    viewer.addEventListener(
      'probe-change',
      ({ detail: { fragment, pinned } }) => {
        if (this.#isDeclared || fragment === null || (this.#isStill && !pinned)) return;
        this.#point = fragment.p;
        update();
      },
      { signal },
    );
    this.#listenToPointer(tree.querySelector('.surface')!);
  }

  /** Where the picture has a probe of its own, that one follows the pointer. */
  #listenToPointer(surface: HTMLElement): void {
    const { signal } = this.#listening;
    let pressed = { x: 0, y: 0 };
    const on = <K extends keyof HTMLElementEventMap>(
      type: K,
      listener: (event: HTMLElementEventMap[K]) => void,
    ): void =>
      surface.addEventListener(
        type,
        (event) => {
          if (!this.#isDeclared && !this.#viewer.probe) {
            listener(event);
          }
        },
        { signal },
      );
    const go = ({ offsetX: x, offsetY: y }: MouseEvent, pins: boolean): void =>
      this.#go({ x, y, pins });
    on('pointerdown', ({ clientX: x, clientY: y }) => {
      pressed = { x, y };
    });
    on('pointermove', (event) => {
      if (event.buttons === 0 && !this.#isPinned && !this.#isStill) {
        go(event, false);
      }
    });
    on('click', (event) => {
      if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) <= SLOP.touch) {
        go(event, true);
      }
    });
    on('keydown', ({ key }) => {
      this.#isPinned &&= key !== 'Escape';
    });
    surface.addEventListener(STEP, (event) => this.#go((event as CustomEvent<Place>).detail), {
      signal,
    });
    this.#ring.addEventListener('keydown', (event) => {
      const arrow = ARROWS[event.key];
      const { fragment } = this;
      if (event.key === 'Escape' && this.#isPinned) {
        this.#isPinned = false;
        event.preventDefault();
      }
      if (arrow === undefined || !fragment || event.ctrlKey || event.altKey || event.metaKey)
        return;
      const pixels = (event.shiftKey ? 10 : 1) * this.#zoom;
      const step = { x: arrow[0] * pixels, y: arrow[1] * pixels };
      const from = this.#place ?? this.#pixelOf(fragment.p);
      const detail: Place | null = from && {
        x: from.x + step.x,
        y: from.y + step.y,
        pins: true,
        step,
      };
      surface.dispatchEvent(new CustomEvent(STEP, { detail }));
      event.preventDefault();
    });
  }

  #go(place: Place): void {
    if (this.#isDeclared || this.#viewer.probe) return;
    this.#place = place;
    this.update();
  }

  async #explain(): Promise<FragmentExplanation | null> {
    const viewer = this.#viewer;
    const { at, seed, ask } = this.#values;
    const place = this.#place;
    if (seed !== '') {
      const fragment = await (at === null ? this.#explainSeeded(seed, ask) : this.#at(at));
      return fragment && seededNumbers(fragment, seed, viewer.colorInterpolation === 'linear');
    }
    if (place !== null) {
      this.#place = null;
      const fragment = await this.#surfaceFrom(place);
      if (place.pins) {
        this.#isPinned = fragment !== null;
      }
      this.#point = fragment?.p ?? this.#point;
    }
    return this.#at(at ?? this.#point ?? hostOf(viewer).pin ?? viewer.probeAt);
  }

  /** The same point until the surface is gone. */
  async #explainSeeded(seed: string, ask: string): Promise<FragmentExplanation | null> {
    const viewer = this.#viewer;
    const key = `${seed} ${ask}`;
    const before = this.#seeded;
    const again = before?.key === key ? await viewer.explain([...before.point]) : null;
    if (again !== null) return again;
    const isSeen = (point: Vec3) => this.#placeOf(point) !== null;
    const fragment = await seededFragment(viewer, seed, askedOf(ask), isSeen);
    this.#seeded = fragment && { key, point: fragment.p };
    return fragment;
  }

  /**
   * At the point, or at its pixel where no surface is close to it; else in the picture's middle.
   */
  async #at(point: Vec3 | null): Promise<FragmentExplanation | null> {
    const viewer = this.#viewer;
    const near = point === null ? null : await viewer.explain([...point]);
    if (near !== null) return near;
    const { width, height } = this.#size;
    const zoom = this.#zoom;
    const pixel =
      point === null ? { x: (width / 2) * zoom, y: (height / 2) * zoom } : this.#pixelOf(point);
    return pixel === null ? null : viewer.shadeAt(pixel.x, pixel.y);
  }

  /** What is there; with a step, the first surface on the way to the edge of the picture. */
  async #surfaceFrom({ x, y, step }: Place): Promise<FragmentExplanation | null> {
    if (step === undefined) return this.#viewer.shadeAt(x, y);
    const { width, height } = this.#size;
    const zoom = this.#zoom;
    for (; x > 0 && y > 0 && x < width * zoom && y < height * zoom; x += step.x, y += step.y) {
      const fragment = await this.#viewer.shadeAt(x, y);
      if (fragment !== null) return fragment;
    }
    return this.fragment ?? null;
  }

  /** Pixels of pointer events for each of the layer. */
  get #zoom(): number {
    return hostOf(this.#viewer).size().zoom;
  }

  get #size(): Size {
    return layerSize(hostOf(this.#viewer).size());
  }

  #placeOf(point: Vec3): Point | null {
    const { camera: pose, fov } = this.#viewer;
    return new Projection({ pose, fov, ...this.#size }).pointInside(point);
  }

  /** As `shadeAt` takes it. */
  #pixelOf(point: Vec3): Point | null {
    const zoom = this.#zoom;
    const at = this.#placeOf(point);
    return at && { x: at.x * zoom, y: at.y * zoom };
  }

  #mark(): void {
    const { fragment } = this;
    const at = fragment && !this.#viewer.probe ? this.#placeOf(fragment.p) : null;
    const { texts } = this.#viewer;
    const { width, height } = this.#size;
    const isFirst = this.#ring.parentElement!.querySelector('[class=pointed]') === this.#ring;
    Object.assign(this.#ring, {
      hidden: at === null,
      // The keys move all rings that follow.
      tabIndex: isFirst && !this.#isDeclared ? 0 : -1,
      ariaLabel: phrase(texts, 'Probe'),
      ariaRoleDescription: phrase(texts, 'cross-hair'),
      ariaDescription: phrase(texts, KEYS),
    });
    this.#ring.style.cssText =
      at === null ? '' : `--x: ${at.x / width}; --y: ${at.y / height}; --shape: ${width / height}`;
  }
}
