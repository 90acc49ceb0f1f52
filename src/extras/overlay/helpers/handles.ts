// The handles of lights: one Tab stop for all of them. Arrow keys choose, Enter starts and ends
// moving, Escape restores; pointers drag. Places elements over what is drawn, and reports what the
// user does.
import { alongAxes } from '../../../phong/camera/gesture.js';
import { sameValue } from '../../../phong/fields/field-store.js';
import {
  type ExtraHost,
  fieldsOf,
  historyOf,
  lightName,
  lightText,
  localNumber,
  type PhongLight,
  phrase,
  pictureBox,
  type ViewerText,
} from '../../../viewer/extra.js';
import { ARROWS, inside, type Projection } from '../drawing/projection.js';
import { clamp } from '../../../phong/math/vector.js';
import {
  EDGE,
  type Handle,
  type LightMarks,
  type HandlePart,
  type SceneBall,
} from './light-marks.js';
import { LightMove } from './light-move.js';
import { followDrag } from '../../../phong/camera/followed-drag.js';
import { createElement, set, write } from '../drawing/dom.js';

interface HandleEntry {
  readonly element: HTMLElement;
  readonly light: PhongLight;
  readonly part: HandlePart;
  /** What it was placed and named by. */
  handle: Handle | null;
  named: readonly unknown[];
}

/**
 * CSS pixels of the page. A press that moves less is a click. Less than the camera's, so that
 * lights move a little.
 */
const SLOP = 3;

/** What handles of parts add to the light's name. */
const PART_TEXTS = {
  axis: '{name}: axis',
  aperture: '{name}: edge of the cone, {degrees}°',
} as const;

export class Handles {
  readonly #host: ExtraHost;
  readonly #list = createElement('div', { role: 'listbox' });
  readonly #region = createElement('p', { class: 'reader', 'aria-live': 'polite' });
  readonly #shown = new Map<EventTarget, HandleEntry>();
  readonly #byLight = {
    place: new Map<PhongLight, HandleEntry>(),
    axis: new Map<PhongLight, HandleEntry>(),
    aperture: new Map<PhongLight, HandleEntry>(),
  } satisfies Record<HandlePart, unknown>;
  readonly #move: LightMove;
  #drag: { readonly element: HTMLElement; readonly end: () => void } | null = null;
  /** The handle that Tab reaches. */
  #current: HandleEntry | null = null;

  /** `surfaceOf`: distance along a spot's axis to the first surface, as it is drawn. */
  constructor(host: ExtraHost, place: HTMLElement, surfaceOf: (light: PhongLight) => number) {
    this.#host = host;
    this.#move = new LightMove(host.viewer, surfaceOf);
    place.append(this.#list, this.#region);
    this.#list.addEventListener('keydown', (event) => this.#onKey(event));
    this.#list.addEventListener('focusin', ({ target }) => this.#choose(this.#shown.get(target!)));
    this.#list.addEventListener('focusout', () => this.#endKeys());
    // The picture below zooms, if it may.
    this.#list.addEventListener('wheel', (event) => this.#passOn(event), { passive: false });
    this.#list.addEventListener('pointerdown', (event) => this.#press(event));
  }

  show(
    lights: readonly PhongLight[],
    marks: readonly LightMarks[],
    view: Projection,
    scene: SceneBall,
  ): void {
    this.#move.see(view, scene);
    const { texts } = this.#host.viewer;
    set(this.#list, { 'aria-label': phrase(texts, 'Lights in the picture') });
    const entries = lights.flatMap((light, index) =>
      marks[index]!.handles.map((handle) => ({
        handle,
        index,
        shown: this.#byLight[handle.part].get(light) ?? this.#add(light, handle.part),
      })),
    );
    const kept = new Set(entries.map(({ shown }) => shown));
    const hadFocus = kept.size < this.#shown.size && this.#list.matches(':focus-within');
    // First: an element that moves in the tree loses focus and pointer.
    for (const shown of this.#shown.values()) {
      if (!kept.has(shown)) {
        this.#remove(shown);
      }
    }
    let before: Element | null = null;
    for (const { handle, index, shown } of entries) {
      const expected: Element | null =
        before === null ? this.#list.firstElementChild : before.nextElementSibling;
      if (expected !== shown.element) {
        this.#list.insertBefore(shown.element, expected);
      }
      before = shown.element;
      this.#place(shown, handle, index, view);
    }
    this.#list.hidden = kept.size === 0;
    if (this.#current === null) {
      this.#choose(this.#shown.values().next().value);
    }
    // All lights were replaced by others.
    if (hadFocus && !this.#list.matches(':focus-within')) {
      this.#current?.element.focus({ preventScroll: true });
    }
  }

  hide(): void {
    this.#end();
    for (const shown of this.#shown.values()) {
      this.#remove(shown);
    }
    this.#list.hidden = true;
  }

  /**
   * Travel is along the axes of the picture's surface, which CSS transforms may turn. One pointer
   * at a time.
   */
  #press(event: PointerEvent): void {
    const shown = this.#shown.get(event.target!);
    if (this.#drag !== null || event.button !== 0 || shown === undefined) return;
    event.preventDefault(); // no selection, no focus elsewhere
    this.#endKeys();
    const { element } = shown;
    element.focus({ preventScroll: true });
    if (!this.#start(shown, false)) return;
    const { axes } = pictureBox(this.#host.tree.surface);
    const end = followDrag(element, event, SLOP, {
      moved: (dx, dy, { shiftKey }) => this.#move.to(...alongAxes(axes, dx, dy), shiftKey),
      ended: () => {
        this.#drag = null;
        this.#end();
      },
    });
    this.#drag = { element, end };
  }

  #add(light: PhongLight, part: HandlePart): HandleEntry {
    const element = createElement('div', {
      class: `handle ${part}`,
      role: 'option',
      tabindex: '-1',
      'aria-selected': 'false',
    });
    const shown: HandleEntry = { element, light, part, handle: null, named: [] };
    this.#shown.set(element, shown);
    this.#byLight[part].set(light, shown);
    return shown;
  }

  #remove(shown: HandleEntry): void {
    const { element, light, part } = shown;
    const hadFocus = element.matches(':focus');
    this.#shown.delete(element);
    this.#byLight[part].delete(light);
    // Removed, it gets no event at the end of its drag.
    if (this.#drag?.element === element) {
      this.#drag.end();
    } else if (element.classList.contains('moving')) {
      this.#end();
    }
    const next = element.nextElementSibling ?? element.previousElementSibling;
    element.remove();
    if (this.#current === shown) {
      this.#current = null;
      this.#choose(next === null ? undefined : this.#shown.get(next));
    }
    // Otherwise the focus would be lost with the element.
    if (hadFocus) {
      (this.#current?.element ?? this.#host.tree.surface).focus({ preventScroll: true });
    }
  }

  #place(shown: HandleEntry, handle: Handle, index: number, view: Projection): void {
    const { element, light, part } = shown;
    if (shown.handle !== handle) {
      shown.handle = handle;
      const { at, outside } = handle;
      const { x, y } = inside(at, view, EDGE);
      element.style.transform = `translate(${x}px, ${y}px)`;
      // At the edge, handles of parts outside would lie on each other. Keys still reach them.
      element.style.pointerEvents = part !== 'place' && outside ? 'none' : '';
    }
    const { texts } = this.#host.viewer;
    const { store } = fieldsOf(light);
    const { values } = store;
    const named = [index, texts, ...Object.values(values)];
    if (sameValue(shown.named, named)) return;
    shown.named = named;
    const name = lightName(store, index, texts);
    const label =
      part === 'place'
        ? lightText(texts, name, values)
        : phrase(texts, PART_TEXTS[part], {
            name,
            degrees: localNumber(String(values.aperture), texts),
          });
    set(element, {
      'aria-label': label,
      'aria-description': phrase(texts, 'Enter starts moving.'),
    });
  }

  #choose(shown: HandleEntry | undefined): void {
    if (shown === undefined || shown === this.#current) return;
    if (this.#current !== null) {
      set(this.#current.element, { tabindex: '-1', 'aria-selected': 'false' });
    }
    set(shown.element, { tabindex: '0', 'aria-selected': 'true' });
    this.#current = shown;
  }

  #onKey(event: KeyboardEvent): void {
    const history = historyOf(this.#host.viewer);
    const undo = history.actionOf(event);
    if (undo !== null) {
      event.preventDefault();
      this.#end();
      history[undo]();
      return;
    }
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (this.#current === null || !this.#act(event, this.#current)) return;
    event.preventDefault();
    event.stopPropagation();
  }

  #act({ key, shiftKey }: KeyboardEvent, current: HandleEntry): boolean {
    const arrow = ARROWS[key];
    if (key === 'Escape') {
      if (!this.#move.active) return false;
      this.#move.restore();
      this.#end();
      this.#say('');
      return true;
    }
    if (key === 'Enter' || key === ' ') {
      if (this.#move.active) {
        this.#endKeys();
      } else if (this.#start(current, true)) {
        this.#say(MOVING);
      }
      return true;
    }
    if (this.#move.active) {
      if (arrow !== undefined && this.#move.byKeys) {
        this.#move.step(arrow[0], arrow[1], shiftKey);
      }
      return arrow !== undefined;
    }
    if (key === 'Home' || key === 'End') return this.#focus(key === 'Home' ? -Infinity : Infinity);
    if (arrow === undefined || shiftKey) return false;
    const isRtl = getComputedStyle(this.#list).direction === 'rtl';
    return this.#focus(arrow[0] * (isRtl ? -1 : 1) + arrow[1]);
  }

  /** Moves the focus by `by` handles and stops at the first and the last. */
  #focus(by: number): boolean {
    const all = [...this.#list.children];
    const from = this.#current === null ? 0 : all.indexOf(this.#current.element);
    const to = clamp(from + by, 0, all.length - 1);
    (all[to] as HTMLElement | undefined)?.focus({ preventScroll: true });
    return true;
  }

  #start({ element, light, part }: HandleEntry, byKeys: boolean): boolean {
    if (!this.#move.start(light, part, byKeys)) return false;
    element.classList.add('moving');
    return true;
  }

  #end(): void {
    this.#move.end();
    for (const { element } of this.#shown.values()) {
      element.classList.remove('moving');
    }
  }

  #endKeys(): void {
    if (!this.#move.byKeys) return;
    this.#end();
    this.#say('');
  }

  #say(text: ViewerText | ''): void {
    write(this.#region, text === '' ? '' : phrase(this.#host.viewer.texts, text));
  }

  #passOn(event: WheelEvent): void {
    const copy = new WheelEvent('wheel', event);
    if (!this.#host.tree.surface.dispatchEvent(copy)) {
      event.preventDefault();
    }
  }
}

const MOVING = 'Arrow keys move, with Shift toward you and away. Enter ends, Escape restores.';
