// The lights that each mesh is drawn with: all, or those whose cones reach its bounds, culled where
// lights or mesh have changed. Meshes that the same lights reach share one buffer.
import { Box3, type BufferGeometry, Matrix4, type Mesh } from 'three';
import { type Box, cullLights } from '../light/cull-lights.js';
import { selectLights } from '../light/pack-lights.js';
import type { Vec3 } from '../math/vector.js';
import { LightBuffer } from './light-buffer.js';

interface Subset {
  readonly buffer: LightBuffer;
  /** The revision of all lights that it was selected from. */
  source: number;
  /** The last frame that used it. */
  frame: number;
}

export class MeshLights {
  readonly all: LightBuffer;
  /** By their masks as text. */
  readonly #subsets = new Map<string, Subset>();
  #frame = 0;
  #origin: Vec3 = [0, 0, 0];
  #mask = new Uint8Array(64);
  #uploads = 0;

  constructor(all: LightBuffer) {
    this.all = all;
  }

  /**
   * A frame begins: frees the buffers that the last one did not use. `origin` is another array
   * after each move.
   */
  begin(origin: Vec3): void {
    for (const [key, subset] of this.#subsets) {
      if (subset.frame === this.#frame) continue;
      subset.buffer.dispose();
      this.#subsets.delete(key);
    }
    this.#frame += 1;
    this.#origin = origin;
  }

  /** The lights for `mesh`, whose world matrix is up to date. */
  of(mesh: Mesh): LightBuffer {
    if (this.all.packed.counts.spot === 0) return this.all;
    const { subset } = this.#culledFor(mesh);
    if (subset === null) return this.all;
    subset.frame = this.#frame;
    return subset.buffer;
  }

  /** The bounds of `mesh` in shading space; null where it has none. Another object after a change. */
  boxOf(mesh: Mesh): Box | null {
    return this.#culledFor(mesh).box;
  }

  /** How many lights reach any of these meshes; all of them where there are no meshes. */
  countReaching(meshes: readonly Mesh[]): number {
    const { sent } = this.all.packed;
    if (meshes.length === 0) return sent;
    let count = 0;
    for (let light = 0; light < sent; light++) {
      if (
        meshes.some((mesh) => this.of(mesh) === this.all || this.#culledFor(mesh).mask[light] === 1)
      ) {
        count += 1;
      }
    }
    return count;
  }

  /** How often light data that differs from the last draw's was sent. */
  get uploads(): number {
    return this.#uploads;
  }

  /** Counts a draw that sent these lights. */
  countUpload(buffer: LightBuffer): void {
    if (buffer.counted === buffer.revision) return;
    buffer.counted = buffer.revision;
    this.#uploads += 1;
  }

  dispose(): void {
    this.all.dispose();
    for (const { buffer } of this.#subsets.values()) {
      buffer.dispose();
    }
  }

  #culledFor(mesh: CulledMesh): CulledLights {
    let culled = mesh[LIGHTS];
    if (culled?.owner !== this) {
      mesh[LIGHTS] = culled = new CulledLights(this);
    }
    const moved = culled.update(mesh, this.#origin);
    // Subsets that the last frame did not use were freed when this one began.
    const freed = culled.subset !== null && culled.subset.frame < this.#frame - 1;
    if (moved || freed || culled.source !== this.all.revision) {
      this.#cull(culled);
    }
    return culled;
  }

  #cull(culled: CulledLights): void {
    const { packed, revision } = this.all;
    culled.source = revision;
    culled.subset = null;
    if (culled.box === null) return;
    if (this.#mask.length < packed.sent) {
      this.#mask = new Uint8Array(packed.features.length);
    }
    const mask = this.#mask.subarray(0, packed.sent);
    if (cullLights(packed, culled.box, mask) === packed.sent) return;
    culled.mask = mask.slice();
    culled.subset = this.#subsetOf(culled.mask);
  }

  #subsetOf(mask: Uint8Array): Subset {
    const key = asText.decode(mask);
    let subset = this.#subsets.get(key);
    if (subset === undefined) {
      subset = { buffer: new LightBuffer(), source: -1, frame: 0 };
      this.#subsets.set(key, subset);
    }
    subset.frame = this.#frame;
    const { revision } = this.all;
    if (subset.source === revision) return subset;
    subset.source = revision;
    selectLights(this.all.packed, mask, subset.buffer.packed);
    subset.buffer.changed();
    return subset;
  }
}

const LIGHTS = /* @__PURE__ */ Symbol('lights');

/**
 * A map took 0.2 µs for each draw, a tenth of the script of 10,000 boxes. Several lightings may
 * draw one mesh, in turns.
 */
type CulledMesh = Mesh & { [LIGHTS]?: CulledLights };

const NO_MASK = new Uint8Array(0);

/** The lights that reach one mesh. */
class CulledLights {
  readonly owner: MeshLights;
  /** Null: all lights. */
  subset: Subset | null = null;
  mask = NO_MASK;
  /** The revision of all lights that they were culled from. */
  source = -1;
  #geometry: BufferGeometry | null = null;
  /** The geometry's bounds: another object when its vertices have changed. */
  #bounds: Box3 | null = null;
  #origin: Vec3 = [0, 0, 0];
  readonly #matrix = new Matrix4();
  /** Bounds in shading space; null where the mesh has none. */
  box: Box | null = null;

  constructor(owner: MeshLights) {
    this.owner = owner;
  }

  /** Computes the box again if the mesh has changed. True if so. */
  update({ geometry, matrixWorld }: Mesh, origin: Vec3): boolean {
    const sameBounds = this.#geometry === geometry && this.#bounds === geometry.boundingBox;
    if (sameBounds && this.#origin === origin && this.#matrix.equals(matrixWorld)) return false;
    this.#geometry = geometry;
    this.#origin = origin;
    this.#matrix.copy(matrixWorld);
    this.box = boundsOf(geometry, matrixWorld, origin);
    this.#bounds = geometry.boundingBox;
    return true;
  }
}

const asText = /* @__PURE__ */ new TextDecoder('latin1');
const bounds = /* @__PURE__ */ new Box3();

function boundsOf(geometry: BufferGeometry, matrixWorld: Matrix4, origin: Vec3): Box | null {
  if (geometry.boundingBox === null) {
    geometry.computeBoundingBox();
  }
  if (geometry.boundingBox === null) return null;
  const { min, max } = bounds.copy(geometry.boundingBox).applyMatrix4(matrixWorld);
  const [x, y, z] = origin;
  const box: Box = [min.x - x, min.y - y, min.z - z, max.x - x, max.y - y, max.z - z];
  return box.every((x, i) => Number.isFinite(x) && (i < 3 || x >= box[i - 3]!)) ? box : null;
}
