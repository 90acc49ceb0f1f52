// The shapes that meshes show now. Meshes of the page with the same shape and segments share one
// content.
import { type BufferGeometry, Matrix4 } from 'three';
import { PLAIN_LOOK } from '../../../phong/material/file-surface.js';
import { claimsOf, type Need } from '../../../phong/model/budget.js';
import type { Content } from '../../../phong/model/model.js';
import { Shared } from '../../model/shared.js';
import {
  type Cut,
  cutGeometry,
  type CutName,
  keyOfCut,
} from '../../../phong/model/shapes/cut-faces.js';
import {
  CLOSED,
  coarsestOf,
  createGeometry,
  effectiveSegments,
  flatTrianglesOf,
  type GeometryName,
  roundOf,
  trianglesOf,
} from '../../../phong/model/shapes/shapes.js';

/** Segments as written, `undefined` for the shape's default; or a level of `auto`. */
interface ShapeKey {
  readonly name: GeometryName;
  readonly segments: number | undefined;
  readonly isLevel: boolean;
  readonly cut?: Cut;
}

/** What `auto` chooses: a number of segments, the shape's own number by {@link FIXED}, or a cut. */
export type Level = number | Cut;

/**
 * Under `auto`, what a shape is first shown as: its coarsest level, or without round faces its
 * fixed segments.
 */
export const shapeKey = (name: GeometryName, segments: number | 'auto'): ShapeKey =>
  segments !== 'auto'
    ? { name, segments, isLevel: false }
    : levelKey(name, roundOf(name) === undefined ? FIXED : coarsestOf(name));

export const levelKey = (name: GeometryName, level: Level): ShapeKey =>
  typeof level === 'object'
    ? { name, segments: undefined, isLevel: true, cut: level }
    : { name, segments: level === FIXED ? undefined : level, isLevel: level !== FIXED };

/** Stands for a shape's own number of segments where a level is expected. */
export const FIXED = 0;

/**
 * Milliseconds that a level stays without users: the samples of a still picture use a finer one
 * than the frame before.
 */
const KEPT_MS = 1000;

export interface ShapeContent extends Content {
  /** What it and its flat copy hold: claimed before there is a geometry. */
  readonly needs: readonly Need[];
}

interface SharedShape {
  /** A promise until its code is here. */
  content: ShapeContent | Promise<ShapeContent>;
  freeing?: ReturnType<typeof setTimeout>;
}

const shapes = new Shared<SharedShape>();

const keyOf = ({ name, segments, isLevel, cut }: ShapeKey): string =>
  `${isLevel ? 'auto ' : ''}${name} ${cut === undefined ? String(effectiveSegments(name, segments)) : keyOfCut(cut)}`;

/** What a shape holds, and its flat copy, before they are built. */
export function shapeNeeds(key: ShapeKey, flat: boolean): readonly Need[] {
  const text = keyOf(key);
  const triangles = trianglesOf(key.name, key.segments);
  const smooth = { key: text, claims: claimsOf(triangles, 1), flat: false };
  return flat
    ? [smooth, { key: `flat ${text}`, claims: claimsOf(flatTrianglesOf(triangles)), flat: true }]
    : [smooth];
}

/**
 * A shape for one more user, who disposes of the content once; a promise until its code is loaded.
 * If that is rejected (a chunk could not be fetched), there is nothing to dispose of, and the next
 * call tries again.
 */
export function acquireShape(key: ShapeKey): ShapeContent | Promise<ShapeContent> {
  const shape = shapes.acquire(keyOf(key), () => shapeOf(key));
  clearTimeout(shape.freeing);
  return shape.content;
}

function shapeOf(key: ShapeKey): SharedShape {
  const { name } = key;
  const contentOf = (geometry: BufferGeometry): ShapeContent => {
    const free = (): void => {
      shapes.forget(shape);
      geometry.dispose();
    };
    const sides = CLOSED.has(name) ? 'closed' : 'double';
    return {
      parts: [{ name, geometry, matrix: IDENTITY, look: PLAIN_LOOK, sides, surface: {} }],
      motion: null,
      needs: shapeNeeds(key, true),
      dispose: () => {
        if (!shapes.release(shape)) {
          shapes.hold(shape, geometry);
        } else if (key.isLevel) {
          shape.freeing = setTimeout(free, KEPT_MS);
        } else {
          free();
        }
      },
    };
  };
  const geometry =
    key.cut === undefined
      ? createGeometry(name, key.segments, key.isLevel)
      : cutGeometry(name as CutName, key.cut);
  const content = geometry instanceof Promise ? geometry.then(contentOf) : contentOf(geometry);
  const shape: SharedShape = { content };
  if (content instanceof Promise) {
    content.then(
      (ready) => (shape.content = ready),
      () => shapes.forget(shape),
    );
  }
  return shape;
}

export const IDENTITY: Matrix4 = /* @__PURE__ */ new Matrix4();
