// The animations of a model in the parts of a mesh.
import type { BufferAttribute, BufferGeometry } from 'three';
import { declareReach } from '../../phong/geometry/bounds.js';
import { hasMovingVertices } from '../../phong/geometry/geometry-size.js';
import { separateTriangles } from '../../phong/material/flat-geometry.js';
import type {
  AnimatedContent,
  AnimationValues,
  Motion,
  PlayedAnimation,
} from '../../phong/model/model.js';

type Poses = Omit<Motion, 'play'>;

/** Motion that meshes can play. */
export const playable = (poses: Poses): Motion => ({
  ...poses,
  play: (values, shown) => new MeshAnimation(poses, values, shown),
});

class MeshAnimation implements PlayedAnimation {
  readonly #motion: Poses;
  readonly #shown: AnimatedContent;
  /** Empty for the first one; null for none. */
  #name: string | null;
  /** Since it began. */
  #seconds = 0;
  /** Ends the measuring of the reach of an animation that has begun since the content came. */
  #measuring: AbortController | null = null;

  constructor(motion: Poses, values: AnimationValues, shown: AnimatedContent) {
    this.#motion = motion;
    this.#name = nameOf(values);
    this.#shown = shown;
    this.#frame();
  }

  update(values: AnimationValues): void {
    if (nameOf(values) === this.#name) return;
    this.#name = nameOf(values);
    this.#seconds = 0;
    this.pose();
    void this.#measure();
  }

  get plays() {
    return this.#name !== null && this.#motion.durationOf(this.#name) > 0;
  }

  get work() {
    return this.#motion.work;
  }

  advance(seconds: number): void {
    this.#seconds += seconds;
    if (seconds > 0) {
      this.pose();
    }
  }

  pose(): void {
    this.#motion.pose(this.#name, this.#seconds);
    for (const { mesh, source } of this.#shown.parts) {
      mesh.matrix.copy(source.matrix);
      mesh.matrixWorldNeedsUpdate = true;
      if (mesh.geometry !== source.geometry && hasMovingVertices(source.geometry)) {
        updateFlatGeometry(mesh.geometry, source.geometry);
      }
    }
  }

  dispose(): void {
    this.#measuring?.abort('replaced');
  }

  /** Frames the poses of the present animation, as soon as they are known. */
  async #measure() {
    this.#frame();
    this.dispose();
    const name = this.#name;
    if (name === null || this.#motion.knownReach(name) !== undefined) return;
    const { signal } = (this.#measuring = new AbortController());
    await this.#motion.reach(name, signal).then(
      () => this.#frame(),
      () => undefined,
    );
  }

  /** `auto` frames the reach of the animation, if it is known; without one what is there. */
  #frame() {
    const reach = this.#name === null ? undefined : this.#motion.knownReach(this.#name);
    const { root, picture } = this.#shown;
    if (root !== null) {
      declareReach(root, reach ?? null);
    }
    picture.reshaped();
  }
}

const nameOf = ({ autoplay, animationName }: AnimationValues) => (autoplay ? animationName : null);

/** Positions, tangents, index or bounds of `source` have changed: updates its flat copy. */
export function updateFlatGeometry(flat: BufferGeometry, source: BufferGeometry): void {
  // Joints that mirror triangles turn them: their corners change places.
  const isTurned = source.index !== null && flat.userData['order'] !== source.index.version;
  const { attributes, userData } = separateTriangles(
    source,
    isTurned ? Object.keys(source.attributes) : ['position', 'tangent'],
  );
  flat.userData = userData;
  for (const [name, { array }] of Object.entries(attributes)) {
    const own = flat.getAttribute(name) as BufferAttribute;
    own.array.set(array);
    own.needsUpdate = true;
  }
  flat.boundingBox = source.boundingBox;
  flat.boundingSphere = source.boundingSphere;
}
