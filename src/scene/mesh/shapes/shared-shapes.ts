// The geometries of shapes that meshes show now. Meshes of the whole page with the same shape and segments share one;
// users are counted. Levels of `segments="auto"` are kept for a while after their last use: a camera that goes back
// needs them again.
import { finish } from './grid-geometry.js';
import {
  beginGeometry,
  coarsestOf,
  effectiveSegments,
  flatTrianglesOf,
  type GeometryName,
  type PendingGeometry,
  roundOf,
  trianglesOf,
} from './shapes.js';
import { claimsOf, type Need } from '../../../model/budget.js';
import type { BufferGeometry } from 'three';

/** Segments as written, `undefined` for the shape's default; or a level of `auto`. */
export interface ShapeKey {
  readonly name: GeometryName;
  readonly segments: number | undefined;
  readonly isLevel: boolean;
}

/**
 * What a shape is first shown as. Under `auto` round shapes begin with their coarsest level; others have one number of
 * segments.
 */
export const shapeKey = (name: GeometryName, segments: number | 'auto'): ShapeKey =>
  segments !== 'auto'
    ? { name, segments, isLevel: false }
    : levelKey(name, roundOf(name) === undefined ? FIXED : coarsestOf(name));

/** A level by its segments, or the shape's {@link FIXED} number. */
export const levelKey = <Name extends GeometryName>(
  name: Name,
  level: number,
): ShapeKey & { readonly name: Name } => ({
  name,
  segments: level === FIXED ? undefined : level,
  isLevel: level !== FIXED,
});

/** Stands for a shape's own number of segments where a level is expected. */
export const FIXED = 0;

interface Shared {
  /** A promise until its code is here. */
  geometry: PendingGeometry;
  users: number;
}

const shared = new Map<string, Shared>();

/** Levels without users, the one used last at the end, and their triangles. */
const unused = new Map<string, number>();
let unusedTriangles = 0;
let usedLevels = 0;

/** Most triangles of levels without users: 7 MB in the page and on the GPU together. */
const UNUSED_LIMIT = 2 ** 17;

const keyOf = ({ name, segments, isLevel }: ShapeKey): string =>
  `${isLevel ? 'auto ' : ''}${name} ${String(effectiveSegments(name, segments))}`;

/** What a shape holds, and its flat copy, before they are built. */
export function shapeNeeds(key: ShapeKey, flat: boolean): Need[] {
  const text = keyOf(key);
  const triangles = trianglesOf(key.name, key.segments);
  const smooth = { key: text, claims: claimsOf(triangles, 1), flat: false };
  return flat
    ? [smooth, { key: `flat ${text}`, claims: claimsOf(flatTrianglesOf(triangles)), flat: true }]
    : [smooth];
}

/**
 * The geometry of a shape, for one more user. Each call needs one {@link releaseGeometry} with the same key, whether or
 * not a promise has settled by then; only this cache disposes of the geometry. A rejected promise (a chunk that could
 * not be fetched) needs no release, and the next call tries again.
 */
export function acquireGeometry(key: ShapeKey): PendingGeometry {
  const text = keyOf(key);
  let entry = shared.get(text);
  if (entry === undefined) {
    const steps = beginGeometry(key.name, key.segments, key.isLevel);
    entry = { geometry: steps instanceof Promise ? steps.then(finish) : finish(steps), users: 0 };
    add(text, entry, key.isLevel);
  }
  if (key.isLevel) {
    usedLevels += 1;
    takeUnused(text);
  }
  entry.users += 1;
  return entry.geometry;
}

function add(text: string, entry: Shared, isLevel: boolean): void {
  shared.set(text, entry);
  if (!(entry.geometry instanceof Promise)) return;
  entry.geometry.then(
    (geometry) => (entry.geometry = geometry),
    () => {
      if (shared.get(text) === entry) shared.delete(text);
      if (isLevel) usedLevels -= entry.users;
    },
  );
}

/** Whether it is there, and costs nothing to acquire. */
export const isBuilt = (key: ShapeKey): boolean => shared.has(keyOf(key));

/** A level that was built in slices: it is there for whoever wants it. */
export function offerLevel(key: ShapeKey, geometry: BufferGeometry): void {
  const text = keyOf(key);
  if (shared.has(text) || usedLevels === 0) {
    geometry.dispose();
    return;
  }
  shared.set(text, { geometry, users: 0 });
  keepUnused(text, key);
}

/** Ends one use; the last one frees the geometry, or keeps it if it is a level. More releases than uses do nothing. */
export function releaseGeometry(key: ShapeKey): void {
  const text = keyOf(key);
  const entry = shared.get(text);
  if (entry === undefined || entry.users === 0) return;
  entry.users -= 1;
  if (key.isLevel) usedLevels -= 1;
  if (entry.users === 0) {
    if (key.isLevel) keepUnused(text, key);
    else drop(text);
  }
  if (usedLevels === 0) for (const each of [...unused.keys()]) drop(each);
}

function keepUnused(text: string, { name, segments }: ShapeKey): void {
  const triangles = trianglesOf(name, segments);
  unused.set(text, triangles);
  unusedTriangles += triangles;
  for (const oldest of unused.keys()) {
    if (unusedTriangles <= UNUSED_LIMIT) return;
    drop(oldest);
  }
}

function takeUnused(text: string): void {
  unusedTriangles -= unused.get(text) ?? 0;
  unused.delete(text);
}

function drop(text: string): void {
  takeUnused(text);
  const entry = shared.get(text);
  shared.delete(text);
  if (entry?.geometry instanceof Promise) {
    // A rejection was reported to the caller of acquireGeometry; there is nothing to free.
    entry.geometry.then(
      (geometry) => {
        geometry.dispose();
      },
      () => undefined,
    );
  } else {
    entry?.geometry.dispose();
  }
}
