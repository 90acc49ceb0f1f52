// The point of a viewer that a <phong-probe> explains: the one that its markup declares, or that
// the user points at or pins. Explains at most once a frame, and never while nothing changes. A
// ring marks the point in pictures without a probe of their own.
import {
  addStyles,
  type FragmentExplanation,
  hostOf,
  type PhongViewer,
} from '../../viewer/extra.js';
import { SLOP } from '../../phong/camera/kept-drag.js';
import type { Vec3 } from '../../phong/math/vector.js';
import { Projection } from '../overlay/drawing/projection.js';
import { askedOf, formOf, type ProbeValues } from './probe-fields.js';
import { seededFragment, seededNumbers } from './seeded.js';
import { zoomOf } from '../../phong/camera/gesture.js';

/** Where the pointer is, as `shadeAt` takes it. */
interface Place {
  readonly x: number;
  readonly y: number;
  readonly pins: boolean;
}

const RING = `.pointed {
  position: absolute;
  inset: -7px auto auto -7px;
  box-sizing: border-box;
  width: 14px;
  height: 14px;
  border: 2px solid #fff;
  border-radius: 50%;
  outline: 1px solid #000;
}
.pointed[hidden] {
  display: none;
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
    ariaHidden: 'true',
    hidden: true,
  });
  /** The last point of the user. */
  #point: Vec3 | null = null;
  #isPinned = false;
  /** Explained before the point. */
  #place: Place | null = null;
  #seeded: { readonly key: string; readonly point: Vec3 } | null = null;
  #busy = false;
  #again = false;

  /** `changed` is called after each explanation, with the error that it ended in. */
  constructor(
    viewer: PhongViewer,
    values: Readonly<ProbeValues>,
    changed: (error?: Error) => void,
  ) {
    this.#viewer = viewer;
    this.#values = values;
    this.#changed = changed;
    void viewer.updateComplete
      .then(() => this.#listen())
      .then(() => viewer.ready)
      .then(() => this.update());
  }

  /** Explains the point again, because anything may have changed. */
  update(): void {
    const viewer = this.#viewer;
    this.#again = this.#busy;
    if (this.#busy || !this.#ring.isConnected || !viewer.loaded) return;
    this.#busy = true;
    const done = (fragment: FragmentExplanation | null, error?: Error): void => {
      if (this.#isOver) return;
      this.fragment = fragment;
      this.#mark();
      this.#changed(error);
      // Not at once: a listener may have changed the viewer, which would never end.
      viewer.ownerDocument.defaultView?.requestAnimationFrame(() => {
        this.#busy = false;
        if (this.#again) {
          this.update();
        }
      });
    };
    this.#explain().then(done, (error: unknown) => done(null, error as Error));
  }

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
        { signal: this.#listening.signal },
      );
    const go = ({ offsetX: x, offsetY: y }: MouseEvent, pins: boolean): void => {
      this.#place = { x, y, pins };
      this.update();
    };
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
      const { x, y, pins } = place;
      const fragment = await viewer.shadeAt(x, y);
      if (pins) {
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
    const isSeen = (point: Vec3): boolean => this.#placeOf(point) !== null;
    const fragment = await seededFragment(viewer, seed, askedOf(ask), isSeen);
    this.#seeded = fragment && { key, point: fragment.p };
    return fragment;
  }

  /** At the point, or at its pixel where no surface is close to it; else in the picture's middle. */
  async #at(point: Vec3 | null): Promise<FragmentExplanation | null> {
    const viewer = this.#viewer;
    const near = point === null ? null : await viewer.explain([...point]);
    if (near !== null) return near;
    const { width, height } = this.#size;
    const zoom = zoomOf(this.#ring.parentElement!);
    const pixel = point === null ? { x: width / 2, y: height / 2 } : this.#placeOf(point);
    return pixel === null ? null : viewer.shadeAt(pixel.x * zoom, pixel.y * zoom);
  }

  /** Of the layer over the picture, CSS pixels. */
  get #size(): { readonly width: number; readonly height: number } {
    const { offsetWidth, offsetHeight } = this.#ring.parentElement!;
    return { width: Math.max(offsetWidth, 1), height: Math.max(offsetHeight, 1) };
  }

  #placeOf(point: Vec3): { readonly x: number; readonly y: number } | null {
    const { camera: pose, fov } = this.#viewer;
    return new Projection({ pose, fov, ...this.#size }).pointInside(point);
  }

  #mark(): void {
    const { fragment } = this;
    const at =
      fragment === null || fragment === undefined || this.#viewer.probe
        ? null
        : this.#placeOf(fragment.p);
    this.#ring.hidden = at === null;
    this.#ring.style.translate = at === null ? '' : `${at.x.toFixed(1)}px ${at.y.toFixed(1)}px`;
  }
}
