// The geometries of shapes that meshes show now. Meshes of the whole page with the same shape and segments share one;
// users are counted.
import {
  coarsestOf,
  createGeometry,
  effectiveSegments,
  flatTrianglesOf,
  type GeometryName,
  type PendingGeometry,
  roundOf,
  trianglesOf,
} from './shapes.js';
import { claimsOf, type Need } from '../../../model/budget.js';

/** Segments as written, `undefined` for the shape's default; or a level of `auto`. */
export interface ShapeKey {
  readonly name: GeometryName;
  readonly segments: number | undefined;
  readonly isLevel: boolean;
}

/**
 * What a shape is first shown as. Under `auto` round shapes begin with their coarsest level, others with their fixed
 * number of segments.
 */
export const shapeKey = (name: GeometryName, segments: number | 'auto'): ShapeKey =>
  segments !== 'auto'
    ? { name, segments, isLevel: false }
    : levelKey(name, roundOf(name) === undefined ? FIXED : coarsestOf(name));

/** A level by its segments, or the shape's {@link FIXED} number. */
export const levelKey = <Name extends GeometryName>(name: Name, level: number): ShapeKey & { readonly name: Name } => ({
  name,
  segments: level === FIXED ? undefined : level,
  isLevel: level !== FIXED,
});

/** Stands for a shape's own number of segments where a level is expected. */
export const FIXED = 0;

/** A level stays so long without users: the samples of a still picture use a finer one than the frame before. */
const KEPT_MS = 1000;

interface Shared {
  /** A promise until its code is here. */
  geometry: PendingGeometry;
  users: number;
  freeing?: ReturnType<typeof setTimeout>;
}

const shared = new Map<string, Shared>();

const keyOf = ({ name, segments, isLevel }: ShapeKey): string =>
  `${isLevel ? 'auto ' : ''}${name} ${String(effectiveSegments(name, segments))}`;

/** What a shape holds, and its flat copy, before they are built. */
export function shapeNeeds(key: ShapeKey, flat: boolean): Need[] {
  const text = keyOf(key);
  const triangles = trianglesOf(key.name, key.segments);
  const smooth = { key: text, claims: claimsOf(triangles, 1), flat: false };
  return flat ? [smooth, { key: `flat ${text}`, claims: claimsOf(flatTrianglesOf(triangles)), flat: true }] : [smooth];
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
    entry = { geometry: createGeometry(key.name, key.segments, key.isLevel), users: 0 };
    add(text, entry);
  }
  clearTimeout(entry.freeing);
  entry.users += 1;
  return entry.geometry;
}

function add(text: string, entry: Shared): void {
  shared.set(text, entry);
  if (!(entry.geometry instanceof Promise)) return;
  entry.geometry.then(
    (geometry) => (entry.geometry = geometry),
    () => {
      if (shared.get(text) === entry) shared.delete(text);
    },
  );
}

/**
 * Ends one use; the last one frees the geometry, that of a level a second later. More releases than uses do nothing.
 */
export function releaseGeometry(key: ShapeKey): void {
  const text = keyOf(key);
  const entry = shared.get(text);
  if (entry === undefined || entry.users === 0) return;
  entry.users -= 1;
  if (entry.users > 0) return;
  const free = (): void => {
    if (shared.get(text) === entry) shared.delete(text);
    if (!(entry.geometry instanceof Promise)) entry.geometry.dispose();
    // A rejection was reported to the caller of acquireGeometry; there is nothing to free.
    else
      entry.geometry.then(
        (geometry) => geometry.dispose(),
        () => undefined,
      );
  };
  if (key.isLevel) entry.freeing = setTimeout(free, KEPT_MS);
  else free();
}
