// Undo and redo: edits of one viewer (declared values, camera, order of its children). Loaded with
// its first user.
import { sameValue } from '../../../phong/fields/field-store.js';
import { registryOf } from '../child-registry.js';
import { fieldsOf, hostOf } from '../internals.js';
import type { PhongLight, PhongMesh, PhongViewer } from '../elements.js';
import { writtenPose } from '../../../phong/camera/written-pose.js';
import type { Pose } from '../../../phong/camera/orbit.js';
import type { CameraPlacement } from './camera.js';

interface Undoable<S> {
  read(): S;
  same(a: S, b: S): boolean;
  /** Puts back what differs between the two states, and leaves everything else as it is now. */
  restore(from: S, to: S): void;
}

/** What an edit changes: the declared values of an element, or what else can be put back. */
export type Subject = PhongLight | PhongMesh | PhongViewer | Undoable<unknown>;

/** One that is undone leads from `after` to `before`: its two values have changed places. */
interface Step {
  readonly subject: Undoable<unknown>;
  readonly before: unknown;
  after: unknown;
  readonly gesture: object | null;
}

/** Older steps are forgotten. A step holds a few small values. */
const MOST_STEPS = 500;

class History {
  /** Where the camera is now, which its declared values do not say. */
  readonly camera: CameraSubject;
  /** Which children the viewer has, and where. */
  readonly children: Undoable<ReadonlyMap<HTMLElement, TreePlace>>;
  readonly #done: Step[] = [];
  readonly #undone: Step[] = [];
  readonly #changed = new Set<() => void>();
  #open = false;

  constructor(viewer: PhongViewer) {
    this.camera = cameraOf(viewer);
    this.children = childrenOf(viewer);
  }

  get canUndo(): boolean {
    return this.#done.length > 0;
  }

  get canRedo(): boolean {
    return this.#undone.length > 0;
  }

  /**
   * Records what `write` changes as one step. Edits with the same `gesture` are one step until
   * {@link seal}.
   */
  edit(
    subject: Subject | readonly Subject[],
    write: () => void,
    gesture: object | null = null,
  ): void {
    const { end } = this.begin(subject, gesture);
    try {
      write();
    } finally {
      end();
    }
  }

  /**
   * An edit that lasts: `restore` puts back what was before, `end` records what has changed as one
   * step, if anything has.
   */
  begin(subjects: Subject | readonly Subject[], gesture: object | null = null) {
    const subject = together(subjects instanceof Array ? subjects : [subjects]);
    const before = subject.read();
    return {
      restore: (): void => subject.restore(subject.read(), before),
      end: () => {
        const after = subject.read();
        if (!subject.same(before, after)) {
          this.#add({ subject, before, after, gesture });
        }
      },
    };
  }

  /** Ends the gesture: the next edit is a step of its own. */
  seal(): void {
    this.#open = false;
  }

  undo(): boolean {
    return this.#shift(this.#done, this.#undone);
  }

  /** Takes back the last step if it is of this gesture. */
  takeBack(gesture: unknown): void {
    if (this.#done.at(-1)?.gesture === gesture) {
      this.undo();
    }
  }

  redo(): boolean {
    return this.#shift(this.#undone, this.#done);
  }

  /** What a press of a key means: Ctrl or Cmd with Z, Shift + Z, and Y. Null for other keys. */
  actionOf({ key, ctrlKey, metaKey, shiftKey, altKey }: KeyboardEvent): 'undo' | 'redo' | null {
    if (!(ctrlKey || metaKey) || altKey) return null;
    const letter = key.toLowerCase();
    if (letter === 'z') return shiftKey ? 'redo' : 'undo';
    return letter === 'y' && !shiftKey ? 'redo' : null;
  }

  /** Calls `changed` after every step, undo and redo. The returned function stops that. */
  listen(changed: () => void): () => void {
    this.#changed.add(changed);
    return () => this.#changed.delete(changed);
  }

  #add(step: Step) {
    const last = this.#done.at(-1);
    if (this.#open && step.gesture !== null && last?.gesture === step.gesture) {
      last.after = step.after;
    } else {
      this.#done.push(step);
    }
    if (this.#done.length > MOST_STEPS) {
      this.#done.shift();
    }
    this.#undone.length = 0;
    this.#open = true;
    this.#notify();
  }

  #shift(from: Step[], to: Step[]): boolean {
    const step = from.pop();
    this.#open = false;
    if (step === undefined) return false;
    const { subject, before, after } = step;
    to.push({ ...step, before: after, after: before });
    subject.restore(after, before);
    this.#notify();
    return true;
  }

  #notify() {
    for (const changed of this.#changed) {
      changed();
    }
  }
}

const histories = new WeakMap<PhongViewer, History>();

export function historyOf(viewer: PhongViewer): History {
  const history = histories.get(viewer) ?? new History(viewer);
  histories.set(viewer, history);
  return history;
}

function together(all: readonly Subject[]): Undoable<readonly unknown[]> {
  const subjects = all.map((one) => ('restore' in one ? one : valuesOf(one)));
  return {
    read: () => subjects.map((subject) => subject.read()),
    same: (a, b) => subjects.every((subject, i) => subject.same(a[i], b[i])),
    restore: (from, to) => subjects.forEach((subject, i) => subject.restore(from[i], to[i])),
  };
}

/** Given values by key; a key without one has its default. */
type Given = ReadonlyMap<string, unknown>;

function valuesOf(element: PhongLight | PhongMesh | PhongViewer): Undoable<Given> {
  const binding = fieldsOf(element as PhongViewer);
  const { store } = binding;
  const keys = Object.keys(store.fields) as (keyof typeof store.values)[];
  const changed = (a: Given, b: Given) => keys.filter((key) => !sameValue(a.get(key), b.get(key)));
  return {
    read: () =>
      new Map(keys.filter((key) => store.given(key)).map((key) => [key, store.values[key]])),
    same: (a, b) => changed(a, b).length === 0,
    restore(from, to) {
      for (const key of changed(from, to)) {
        binding.set(key, to.get(key) ?? null);
      }
    },
  };
}

interface CameraSubject extends Undoable<CameraPlacement> {
  /** As a drag does: nothing fits the camera to the scene afterwards. */
  move(to: Partial<Pose>): void;
  /** To what is declared. */
  reset(): void;
}

function cameraOf(viewer: PhongViewer): CameraSubject {
  const { camera } = hostOf(viewer);
  return {
    read: () => camera.placement(),
    same: (a, b) => JSON.stringify(a) === JSON.stringify(b), // keys are always written in the same order
    restore: (_, to) => camera.place(to, 'panel'),
    move: (to) =>
      camera.place(
        { pose: writtenPose({ ...camera.placement().pose, ...to }), framing: null },
        'panel',
      ),
    reset: () => camera.reset('panel'),
  };
}

interface TreePlace {
  readonly parent: Node | null;
  readonly next: Node | null;
}

/** `node` is `element` or inside it, shadow trees included: `element` cannot be moved into it. */
function holds(element: HTMLElement, node: Node | null): boolean {
  for (let at = node; at !== null; at = at instanceof ShadowRoot ? at.host : at.parentNode) {
    if (at === element) return true;
  }
  return false;
}

/** A step back that would move one into itself does nothing. */
function childrenOf(viewer: PhongViewer): Undoable<ReadonlyMap<HTMLElement, TreePlace>> {
  const stays = (a: TreePlace | undefined, b: TreePlace | undefined) =>
    a?.parent === b?.parent && a?.next === b?.next;
  return {
    read: () =>
      new Map(
        registryOf(viewer).inOrder.map((child) => [
          child,
          { parent: child.parentNode, next: child.nextSibling },
        ]),
      ),
    same: (a, b) =>
      a.size === b.size && [...a].every(([child, place]) => stays(place, b.get(child))),
    restore(from, to) {
      // A script may have moved the parent into the child since.
      for (const [child, place] of to) {
        if (!stays(from.get(child), place) && holds(child, place.parent)) return;
      }
      for (const child of from.keys()) {
        if (!to.has(child)) {
          child.remove();
        }
      }
      // Backwards, so that the sibling a child stands before is in its place already.
      for (const [child, place] of [...to].reverse()) {
        const { parent, next } = place;
        if (parent === null || stays(from.get(child), place)) continue;
        parent.insertBefore(child, next?.parentNode === parent ? next : null);
      }
    },
  };
}
