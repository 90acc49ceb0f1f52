// One move of a light by the user, from its start to its end: writes the light's values, and makes the move one step
// that undo takes back. If something else writes to the light meanwhile, the move continues from there.
import { sameValue } from '../../fields/field-store.js';
import type { LightValues } from '../../light/light-state.js';
import { fieldsOf } from '../../element/internals.js';
import type { PhongLight, PhongViewer } from '../../element/elements.js';
import { historyOf, type Undoable, valuesOf } from '../../element/viewer/history.js';
import type { Projection } from '../drawing/projection.js';
import { lightMarks, type HandlePart } from './light-marks.js';
import { type Anchor, type Change, moved, travelOfTurn } from './moves.js';
import type { SceneBall } from './placed-light.js';

/** Travel of one press of an arrow key: CSS pixels, and degrees where it turns a direction. */
const STEP = { pixels: 8, degrees: 5 } as const;

interface Move {
  readonly light: PhongLight;
  readonly part: HandlePart;
  readonly byKeys: boolean;
  readonly subject: Undoable<ReadonlyMap<string, unknown>>;
  readonly before: ReadonlyMap<string, unknown>;
  anchor: Anchor;
  along: boolean;
  /** The pointer's whole travel as it was last; null before it moves, and for keys. */
  last: readonly [dx: number, dy: number] | null;
  /** Pointer travel at the anchor, or keys' travel since then. */
  x: number;
  y: number;
  written: Change;
}

export class LightMove {
  readonly #viewer: PhongViewer;
  #move: Move | null = null;
  readonly #surfaceOf: (light: PhongLight) => number;
  #view: Projection | null = null;
  #scene: SceneBall | null = null;

  /** `surfaceOf`: distance along a spot's axis to the first surface, as it is drawn. */
  constructor(viewer: PhongViewer, surfaceOf: (light: PhongLight) => number) {
    this.#viewer = viewer;
    this.#surfaceOf = surfaceOf;
  }

  get active(): boolean {
    return this.#move !== null;
  }

  get byKeys(): boolean {
    return this.#move?.byKeys === true;
  }

  moves(light: PhongLight): boolean {
    return this.#move?.light === light;
  }

  /** Call when the view changes: a dragged light stays under the pointer while something else moves the camera. */
  see(view: Projection, scene: SceneBall): void {
    const isNew = view !== this.#view;
    [this.#view, this.#scene] = [view, scene];
    const move = this.#move;
    if (isNew && move !== null && !move.byKeys && move.last !== null) this.to(...move.last, move.along);
  }

  /** False if another move is in progress, or there is nothing to move. */
  start(light: PhongLight, part: HandlePart, byKeys: boolean): boolean {
    if (this.#move !== null) return false;
    const anchor = this.#anchor(light, part);
    if (anchor === null) return false;
    const subject = valuesOf(light);
    this.#move = {
      ...{ light, part, byKeys, subject, before: subject.read() },
      ...{ anchor, along: false, last: null, x: 0, y: 0, written: {} },
    };
    return true;
  }

  /** The pointer's whole travel since the start, CSS pixels of the layer. */
  to(dx: number, dy: number, along: boolean): void {
    const move = this.#current(along, dx, dy);
    if (move === null) return;
    move.last = [dx, dy];
    this.#write(move, dx - move.x, dy - move.y);
  }

  /** One press of a key: right and down are 1. */
  step(right: number, down: number, along: boolean): void {
    const move = this.#current(along, 0, 0);
    const view = this.#view;
    if (move === null || view === null) return;
    const { placed } = move.anchor;
    const turns = move.part === 'axis' || (move.part === 'place' && placed.directional);
    const size = turns ? travelOfTurn(STEP.degrees, view) : STEP.pixels;
    move.x += right * size;
    move.y += down * size;
    this.#write(move, move.x, move.y);
  }

  /** Puts back what the light was at the start. */
  restore(): void {
    const move = this.#move;
    if (move === null) return;
    const { subject, before } = move;
    subject.restore(subject.read(), before);
  }

  end(): void {
    const move = this.#move;
    this.#move = null;
    if (move !== null) historyOf(this.#viewer).record(move.subject, move.before);
  }

  /**
   * The move, measured from here if its kind changed or something else has written to the light, and for keys if the
   * camera has moved: earlier steps were along other axes.
   */
  #current(along: boolean, x: number, y: number): Move | null {
    const move = this.#move;
    if (move === null) return null;
    const { values } = fieldsOf(move.light).store;
    const isOwn = Object.entries(move.written).every(([key, value]) =>
      sameValue(value, values[key as keyof LightValues]),
    );
    const isSameView = !move.byKeys || move.anchor.view === this.#view;
    if (along === move.along && isOwn && isSameView) return move;
    const anchor = this.#anchor(move.light, move.part);
    if (anchor === null) return null;
    Object.assign(move, { anchor, along, x, y, written: {} });
    return move;
  }

  #write(move: Move, dx: number, dy: number): void {
    const view = this.#view;
    if (view === null) return;
    const { along, byKeys } = move;
    move.written = moved(move.anchor, view, { dx, dy, along, byKeys });
    for (const [key, value] of Object.entries(move.written)) fieldsOf(move.light).set(key as keyof Change, value);
  }

  /** The light by its current values. What is drawn may be older, because keys can be faster than frames. */
  #anchor(light: PhongLight, part: HandlePart): Anchor | null {
    const [view, scene] = [this.#view, this.#scene];
    if (view === null || scene === null) return null;
    const values = { ...fieldsOf(light).store.values };
    const { placed, handles } = lightMarks(values, view, scene, false, this.#surfaceOf(light));
    const handle = handles.find((each) => each.part === part);
    return handle === undefined ? null : { part, values, placed, handle, view, scene };
  }
}
