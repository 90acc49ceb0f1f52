// Lets several meshes show one model in poses of their own. Each has a copy of what moves;
// everything else is shared.
import { Box3, type BufferAttribute, type BufferGeometry, DynamicDrawUsage, Sphere } from 'three';
import type { Content } from '../../phong/model/model.js';
import { playable } from './mesh-animation.js';

/**
 * Values of 4 bytes that {@link movingCopy} takes, the matrices of the parts included, an index and
 * bounds of its own not.
 */
export function movingValues({ parts }: Content): number {
  let values = parts.length * 32;
  for (const geometry of new Set(parts.map((part) => part.geometry))) {
    for (const [, { array }] of movingAttributes(geometry)) {
      values += array.length;
    }
  }
  return values;
}

/**
 * The content in a pose of its own, at first that of the file. Disposing of it leaves `content` as
 * it is.
 */
export function movingCopy(content: Content): Content {
  const { motion } = content;
  if (motion === null) return content;
  motion.pose(null, 0);
  const copies = new Map<BufferGeometry, Vertices>();
  const parts = content.parts.map((part) => {
    const { geometry } = part;
    const copy = copies.get(geometry) ?? (isMoving(geometry) ? new Vertices(geometry) : null);
    if (copy !== null) {
      copies.set(geometry, copy);
    }
    return { ...part, geometry: copy?.geometry ?? geometry, matrix: part.matrix.clone() };
  });
  return {
    ...content,
    parts,
    motion: playable({
      ...motion,
      pose: (name, seconds) => {
        motion.pose(name, seconds);
        parts.forEach(({ matrix }, i) => matrix.copy(content.parts[i]!.matrix));
        for (const copy of copies.values()) {
          copy.follow();
        }
      },
    }),
    dispose: () => {
      for (const copy of copies.values()) {
        copy.dispose();
      }
    },
  };
}

/** A geometry whose moving vertices are copies of another one's. */
class Vertices {
  readonly geometry: BufferGeometry;
  readonly #source: BufferGeometry;
  /** The attributes that move, each before the source's. */
  readonly #moving: readonly (readonly [own: BufferAttribute, source: BufferAttribute])[];
  /** Version of the source's positions that was copied last. */
  #version = -1;
  /**
   * The same of its index; 0 while the source's own is shared, because joints have turned no
   * triangle yet.
   */
  #indexVersion = 0;
  /** Two, in turns: a new object says that the bounds have changed. */
  readonly #boxes = [new Box3(), new Box3()] as const;

  constructor(source: BufferGeometry) {
    this.#source = source;
    // Not `clone`, which copies what is shared too.
    const copy = (this.geometry = new (source.constructor as new () => BufferGeometry)());
    for (const [name, attribute] of Object.entries(source.attributes)) {
      copy.setAttribute(name, attribute);
    }
    this.#moving = movingAttributes(source).map(([name, attribute]) => {
      const own = attribute.clone();
      copy.setAttribute(name, own);
      return [own, attribute];
    });
    copy.setIndex(source.index);
    this.follow();
  }

  follow(): void {
    const { geometry } = this;
    const source = this.#source;
    const { version } = source.attributes['position'] as BufferAttribute;
    if (version === this.#version) return;
    this.#version = version;
    for (const pair of this.#moving) {
      copyItems(...pair);
    }
    const { index } = source;
    if (index !== null && index.version !== this.#indexVersion) {
      if (this.#indexVersion === 0) {
        geometry.setIndex(index.clone());
      }
      copyItems(geometry.index!, index); // a clone, too: its version tells a flat copy that it is another one
      this.#indexVersion = index.version;
    }
    const [one, other] = this.#boxes;
    const box = geometry.boundingBox === one ? other : one;
    if (source.boundingBox === null) {
      source.computeBoundingBox();
    }
    geometry.boundingBox = box.copy(source.boundingBox!);
    if (source.boundingSphere === null) {
      source.computeBoundingSphere();
    }
    geometry.boundingSphere = (geometry.boundingSphere ?? new Sphere()).copy(
      source.boundingSphere!,
    );
  }

  /**
   * Frees what is not the source's. The GPU's buffers of what is shared go with the garbage
   * collector: three.js frees those of geometries that were drawn, and the source never is.
   */
  dispose(): void {
    const { geometry } = this;
    const moving = new Set(movingAttributes(geometry).map(([name]) => name));
    for (const name of Object.keys(geometry.attributes)) {
      if (!moving.has(name)) {
        geometry.deleteAttribute(name);
      }
    }
    if (this.#indexVersion === 0) {
      geometry.setIndex(null);
    }
    geometry.dispose();
  }
}

function copyItems(own: BufferAttribute, { array }: BufferAttribute) {
  own.array.set(array);
  own.needsUpdate = true;
}

export const isMoving = (geometry: BufferGeometry) => movingAttributes(geometry).length > 0;

const movingAttributes = ({ attributes }: BufferGeometry) =>
  Object.entries(attributes as Record<string, BufferAttribute>).filter(
    ([, { usage }]) => usage === DynamicDrawUsage,
  );
