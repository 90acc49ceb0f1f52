// Cameras that move together: of viewers with one `camera-group` in a document, and of one
// <phong-compare>. All have the same angles, radius and target, are framed as one, and show round
// shapes by the same rule. A chunk.
import type { Extra, ExtraHost } from '../../viewer/extra.js';

type Member = Pick<ExtraHost, 'viewer' | 'values' | 'camera' | 'viewport'>;
type Camera = ExtraHost['camera'];
type AutoFit = Member['viewport']['picture']['fit'];
type Framing = NonNullable<AutoFit['framing']>;
type Fit = ReturnType<AutoFit['fitOf']>;

/** Keeps a viewer in the group that its attributes and its parent name. */
export function create(member: Member): Extra {
  let group: CameraGroup | null = null;
  const join = (next: CameraGroup | null): void => {
    if (next === group) return;
    group?.leave(member);
    group = next;
    group?.join(member);
  };
  return { update: () => join(groupOf(member)), dispose: () => join(null) };
}

/** By the document and a name, or by a <phong-compare> and no name. */
const groups = new WeakMap<Node, Map<string, CameraGroup>>();

/**
 * A name goes before the <phong-compare> around the viewer. Empty groups are removed from the map.
 */
function groupOf({ viewer, values: { cameraGroup: name } }: Member): CameraGroup | null {
  const { ownerDocument, parentElement } = viewer;
  const compare = parentElement?.localName === 'phong-compare' ? parentElement : null;
  const place = name === '' ? compare : ownerDocument;
  if (place === null) return null;
  const inPlace = groups.get(place) ?? new Map<string, CameraGroup>();
  groups.set(place, inPlace);
  const group = inPlace.get(name) ?? new CameraGroup(() => inPlace.delete(name));
  inPlace.set(name, group);
  return group;
}

/** Frames the pictures of its members as one, and chooses the levels of their shapes together. */
class CameraGroup {
  /** In the order in which they joined, which is document order for a page's markup. */
  readonly #members = new Map<Camera, Member>();
  /** For the framing that all members share; null after a change. */
  #fitted: { readonly framing: Framing; readonly fit: Fit; readonly from: Member } | null = null;
  #settling = false;
  #wasFixed = false;
  readonly #emptied: () => void;

  constructor(emptied: () => void) {
    this.#emptied = emptied;
  }

  /** The first member keeps its camera. Those that follow take the group's. */
  join(member: Member): void {
    const [first] = this.#members.values();
    this.#members.set(member.camera, member);
    member.camera.link = this;
    member.viewport.picture.fit.shared = this;
    member.viewport.picture.levels.shared = this;
    this.changed();
    if (first !== undefined) {
      member.camera.place(placementOf(first), 'script', true);
    }
  }

  /** The member keeps the camera that it has, or fits it to its own scene if that is `auto`. */
  leave(member: Member): void {
    this.#members.delete(member.camera);
    member.camera.link = null;
    member.viewport.picture.fit.shared = null;
    member.viewport.picture.levels.shared = null;
    member.viewport.picture.invalidate();
    if (this.#members.size === 0) {
      this.#emptied();
    } else {
      this.changed();
    }
  }

  /** A member's camera was moved or framed in another way, and not by the group. */
  moved(camera: Camera, source: Parameters<Camera['place']>[1]): void {
    const mover = this.#members.get(camera);
    if (mover === undefined) return;
    const placement = placementOf(mover);
    for (const other of this.#members.keys()) {
      if (other !== camera) {
        other.place(placement, source, true);
      }
    }
  }

  /** The first member with `auto-rotate` turns all. It pauses during a drag in any viewer. */
  turns(camera: Camera): boolean {
    const cameras = [...this.#members.keys()];
    return (
      cameras.find(({ turning }) => turning) === camera && !cameras.some(({ dragging }) => dragging)
    );
  }

  /** Fits at the end of the task, for members that are not drawn now, too. */
  changed(): void {
    this.#fitted = null;
    if (this.#settling) return;
    this.#settling = true;
    queueMicrotask(() => {
      this.#settling = false;
      this.#settle();
    });
  }

  /**
   * The fit with the largest radius, and its target. Scenes that show nothing count only where all
   * are empty.
   */
  fit(framing: Framing): Fit {
    if (this.#fitted?.framing !== framing) {
      const members = [...this.#members.values()];
      const fits = members.map((from) => ({
        framing,
        fit: from.viewport.picture.fit.fitOf(framing),
        from,
      }));
      const full = fits.filter(({ fit }) => !fit.empty);
      this.#fitted = (full.length > 0 ? full : fits).reduce((a, b) =>
        b.fit.radius > a.fit.radius ? b : a,
      );
    }
    return this.#fitted.fit;
  }

  /**
   * A picture shows round shapes by a fixed number of segments: then all do, so that outlines meet
   * at a divider.
   */
  get isFixed(): boolean {
    for (const { viewport } of this.#members.values()) {
      if (viewport.picture.levels.isFixed) return true;
    }
    return false;
  }

  /**
   * Moves all cameras to the fit, on behalf of its member. All draw again where {@link isFixed} has
   * changed.
   */
  #settle(): void {
    const { isFixed } = this;
    if (isFixed !== this.#wasFixed) {
      for (const { viewport } of this.#members.values()) {
        viewport.picture.invalidate();
      }
    }
    this.#wasFixed = isFixed;
    const [first] = this.#members.values();
    const framing = first?.viewport.picture.fit.framing ?? null;
    if (framing === null) return;
    const { target, radius } = this.fit(framing);
    const from = this.#fitted?.from;
    if (from === undefined) return;
    const { pose } = from.viewport.picture.orbit;
    const fitted = framing.radius === 'auto' ? radius : framing.radius;
    from.camera.place({ pose: { ...pose, target, radius: fitted }, framing }, 'auto');
  }
}

const placementOf = ({ viewport: { picture } }: Member) => ({
  pose: picture.orbit.pose,
  framing: picture.fit.framing,
});
