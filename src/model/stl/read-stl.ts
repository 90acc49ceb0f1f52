// Reads an STL file, binary or text. Each triangle has its own normal, taken from its corners: the normals in files are
// often zero or stale, and the order of the corners is what the format defines. Colours of the two 15-bit conventions.
// A separate chunk.
import { BufferAttribute, BufferGeometry } from 'three';
import type { Vec3 } from '../../math/vector.js';
import { faceNormals } from '../face-normals.js';
import type { ModelReader } from '../model-reader.js';
import { LeftOut } from '../left-out.js';
import { type BaseLook, PLAIN_LOOK } from '../../material/file-surface.js';
import { ModelBudget } from '../model-budget.js';
import type { ContentPart } from '../model.js';
import { ownedModel } from '../owned-model.js';
import { Slices } from '../slices.js';
import { Positions, wrongCoordinate } from '../triangles/corner-lists.js';
import { isBinaryStl, isTextStl, STL_HEADER, STL_TRIANGLE } from './stl-kind.js';
import { readStlText } from './stl-text.js';

export const readStl: ModelReader = async ({ bytes, signal, budget }) => {
  const slices = new Slices(signal, budget);
  const leftOut = new LeftOut();
  const asText = !isBinaryStl(bytes) && isTextStl(bytes);
  if (asText) budget.add({ text: bytes.byteLength });
  const solids = asText ? await readStlText(bytes, leftOut, slices) : [await readBinary(bytes, leftOut, slices)];
  const parts: ContentPart[] = [];
  for (const solid of solids) {
    if (solid.places.count > 0) parts.push(await partOf(solid, budget, slices));
    if (slices.took(16)) await slices.pause();
  }
  if (parts.length === 0) throw await leftOut.error(bytes, slices, 'it has no triangles');
  return { ...ownedModel(parts), dropped: await leftOut.names(bytes, slices) };
};

/** A body as it is read. */
export interface StlSolid {
  readonly name: string;
  /** Three per triangle. */
  readonly places: Positions;
  /** Gives the colour of a triangle, encoded sRGB, 0 to 1. Null if none has its own. */
  readonly colorOf: ((triangle: number) => Vec3) | null;
  /** Colour of the whole body. Encoded sRGB, 0 to 1. */
  readonly color: Vec3;
  /** 0 to 1. */
  readonly opacity: number;
}

async function readBinary(bytes: Uint8Array<ArrayBuffer>, leftOut: LeftOut, slices: Slices): Promise<StlSolid> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = countOf(view);
  // Before anything is allocated.
  new ModelBudget().add({ corners: 3 * count });
  const header = headerColor(view);
  const places = new Positions(3 * count);
  /** Of the triangles that are kept. */
  const bits = new Uint16Array(count);
  const coordinate = (at: number): number => view.getFloat32(at, true);
  let colored = false;
  let anyBits = 0;
  for (let i = 0; i < count; i += 1) {
    if (slices.took(1 / 4)) await slices.pause();
    const at = STL_HEADER + i * STL_TRIANGLE;
    const kept = places.count;
    for (let corner = at + 12; corner < at + 48; corner += 12) {
      const [x, y, z] = [coordinate(corner), coordinate(corner + 4), coordinate(corner + 8)];
      if (places.push(x, y, z)) continue;
      places.cut(kept);
      leftOut.add('triangle');
      leftOut.because('triangle', wrongCoordinate(x, y, z));
      break;
    }
    if (places.count === kept) continue;
    const own = view.getUint16(at + 48, true);
    bits[kept / 3] = own;
    anyBits |= own;
    colored ||= triangleColor(own, header !== null) !== null;
  }
  // All 0: the writer knows no colours of triangles. By Magics' convention they would be black.
  colored &&= anyBits > 0;
  const color = header?.color ?? WHITE;
  return {
    name: '',
    places,
    colorOf: colored ? (triangle) => triangleColor(bits[triangle] ?? 0, header !== null) ?? color : null,
    color: colored ? WHITE : color,
    opacity: header?.opacity ?? 1,
  };
}

/** The number of triangles. 0 in files whose writer did not go back to fill it in: then as many as there are. */
function countOf(view: DataView): number {
  if (view.byteLength < STL_HEADER) throw new Error('it ends inside its header');
  const there = Math.floor((view.byteLength - STL_HEADER) / STL_TRIANGLE);
  const count = view.getUint32(STL_HEADER - 4, true) || there;
  if (count === 0) throw new Error('it has no triangles');
  if (count <= there) return count;
  const size = STL_HEADER + count * STL_TRIANGLE;
  throw new Error(
    `it is truncated: ${String(view.byteLength)} of ${String(size)} bytes for ${String(count)} triangles`,
  );
}

const WHITE: Vec3 = [1, 1, 1];

const SPACE = 0x20;

/** The body's colour as Magics writes it: `COLOR=` and four bytes r g b a in the header. */
function headerColor(view: DataView): { readonly color: Vec3; readonly opacity: number } | null {
  const word = 'COLOR=';
  for (let at = 0; at + word.length + 4 <= STL_HEADER - 4; at += 1) {
    if (!Array.from(word).every((character, i) => view.getUint8(at + i) === character.charCodeAt(0))) continue;
    const [r = 0, g = 0, b = 0] = [6, 7, 8].map((i) => view.getUint8(at + i) / 255);
    const alpha = view.getUint8(at + 9);
    // Some writers leave it 0, and do not mean an invisible body. Others write three bytes and a space.
    return { color: [r, g, b], opacity: alpha === 0 || alpha === SPACE ? 1 : alpha / 255 };
  }
  return null;
}

/**
 * A triangle's colour, five bits per channel; null if it has none. Magics (files with `COLOR=`): red in the low bits,
 * bit 15 clear. VisCAM and SolidView: blue in the low bits, bit 15 set.
 */
function triangleColor(bits: number, magics: boolean): Vec3 | null {
  if (((bits & 0x8000) === 0) !== magics) return null;
  const channels: Vec3 = [(bits & 31) / 31, ((bits >> 5) & 31) / 31, ((bits >> 10) & 31) / 31];
  return magics ? channels : [channels[2], channels[1], channels[0]];
}

async function partOf(solid: StlSolid, budget: ModelBudget, slices: Slices): Promise<ContentPart> {
  const { name, places, colorOf, color, opacity } = solid;
  const corners = places.count;
  budget.add({ parts: 1, corners, values: corners * (colorOf === null ? 6 : 9) });
  const geometry = new BufferGeometry();
  const filled = places.array.length === 3 * corners;
  const positions = filled ? places.array : new Float32Array(3 * corners);
  if (!filled) {
    await slices.over(positions.length, (from, to) => positions.set(places.array.subarray(from, to), from));
  }
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', await faceNormals(positions, slices));
  if (colorOf !== null) {
    const colors = new Float32Array(3 * corners);
    await slices.over(corners / 3, (from, to) => {
      for (let triangle = from; triangle < to; triangle += 1) {
        const own = colorOf(triangle);
        for (let corner = 0; corner < 3; corner += 1) colors.set(own, 9 * triangle + 3 * corner);
      }
    });
    geometry.setAttribute('color', new BufferAttribute(colors, 3));
  }
  const look: BaseLook = {
    ...PLAIN_LOOK,
    baseColor: color,
    opacity,
    alphaMode: opacity < 1 ? 'blend' : 'opaque',
    vertexColors: colorOf !== null,
  };
  return { name, geometry, matrix: places.matrix, look, sides: 'double', surface: {} };
}
