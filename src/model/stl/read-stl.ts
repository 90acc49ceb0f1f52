// Reads an STL file, binary or text. Each triangle has its own normal, taken from its corners: the normals in files are
// often zero or stale, and the order of the corners is what the format defines. Colours of the two 15-bit conventions.
// A separate chunk.
import { BufferAttribute, BufferGeometry } from 'three';
import type { Vec3 } from '../../math/vector.js';
import { faceNormals } from '../face-normals.js';
import type { ModelReader } from '../format.js';
import { ModelBudget } from '../model-budget.js';
import { type BaseLook, PLAIN_LOOK } from '../../material/file-surface.js';
import type { ContentPart } from '../model.js';
import { ownedModel } from '../owned-model.js';
import { PAUSE_MASK, Slices } from '../slices.js';
import { Growing, Positions } from '../triangles/corner-lists.js';
import { isBinaryStl, isTextStl, STL_HEADER, STL_TRIANGLE } from './stl-kind.js';
import { readStlText } from './stl-text.js';

export const readStl: ModelReader = async ({ bytes, signal, budget }) => {
  const slices = new Slices(signal);
  const asText = !isBinaryStl(bytes) && isTextStl(bytes);
  if (asText) budget.add({ text: bytes.byteLength });
  const solids = asText ? await readStlText(bytes, slices) : [await readBinary(bytes, slices)];
  const parts: ContentPart[] = [];
  for (const solid of solids) parts.push(await partOf(solid, budget, slices));
  if (parts.length === 0) throw new Error('it has no triangles');
  return ownedModel(parts);
};

/** A body as it is read. */
export interface StlSolid {
  readonly name: string;
  /** Three per triangle. */
  readonly places: Positions;
  /** r g b of each triangle, or null. Encoded sRGB, 0 to 1. */
  readonly colors: Growing<Float32Array> | null;
  /** Colour of the whole body. Encoded sRGB, 0 to 1. */
  readonly color: Vec3;
  /** 0 to 1. */
  readonly opacity: number;
}

async function readBinary(bytes: Uint8Array<ArrayBuffer>, slices: Slices): Promise<StlSolid> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.byteLength < STL_HEADER) throw new Error('it ends inside its header');
  const count = view.getUint32(STL_HEADER - 4, true);
  const size = STL_HEADER + count * STL_TRIANGLE;
  if (size > bytes.byteLength) {
    throw new Error(
      `it is truncated: ${String(bytes.byteLength)} of ${String(size)} bytes for ${String(count)} triangles`,
    );
  }
  if (count === 0) throw new Error('it has no triangles');
  // Before anything is allocated.
  new ModelBudget().add({ corners: 3 * count });
  const header = headerColor(view);
  const places = new Positions(3 * count);
  const colors = new Growing(Float32Array);
  let colored = false;
  let anyBits = 0;
  for (let i = 0; i < count; i += 1) {
    if ((i & PAUSE_MASK) === 0 && slices.due) await slices.pause();
    const at = STL_HEADER + i * STL_TRIANGLE;
    for (let corner = at + 12; corner < at + 48; corner += 12) {
      places.push(
        view.getFloat32(corner, true),
        view.getFloat32(corner + 4, true),
        view.getFloat32(corner + 8, true),
      );
    }
    const bits = view.getUint16(at + 48, true);
    anyBits |= bits;
    const own = triangleColor(bits, header !== null);
    if (own !== null && !colored) {
      // Triangles before the first coloured one have the body's colour.
      colored = true;
      for (let before = 0; before < i; before += 1) pushColor(colors, header?.color ?? WHITE);
    }
    if (colored) pushColor(colors, own ?? header?.color ?? WHITE);
  }
  // All 0: the writer knows no colours of triangles. By Magics' convention they would be black.
  colored &&= anyBits > 0;
  return {
    name: '',
    places,
    colors: colored ? colors : null,
    color: colored ? WHITE : (header?.color ?? WHITE),
    opacity: header?.opacity ?? 1,
  };
}

const WHITE: Vec3 = [1, 1, 1];

function pushColor(colors: Growing<Float32Array>, color: Vec3): void {
  for (const channel of color) colors.push(channel);
}

const SPACE = 0x20;

/** The body's colour as Magics writes it: `COLOR=` and four bytes r g b a in the header. */
function headerColor(view: DataView): { readonly color: Vec3; readonly opacity: number } | null {
  const word = 'COLOR=';
  for (let at = 0; at + word.length + 4 <= STL_HEADER - 4; at += 1) {
    if (!Array.from(word).every((character, i) => view.getUint8(at + i) === character.charCodeAt(0)))
      continue;
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
  const { name, places, colors, color, opacity } = solid;
  const corners = places.count;
  budget.add({ parts: 1, corners, values: corners * (colors === null ? 6 : 9) });
  const geometry = new BufferGeometry();
  const filled = places.array.length === 3 * corners;
  const positions = filled ? places.array : places.array.slice(0, 3 * corners);
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', await faceNormals(positions, slices));
  if (colors !== null) {
    const perCorner = new Float32Array(3 * corners);
    await slices.over(perCorner.length, (from, to) => {
      for (let i = from; i < to; i += 1) perCorner[i] = colors.array[3 * Math.floor(i / 9) + (i % 3)] ?? 0;
    });
    geometry.setAttribute('color', new BufferAttribute(perCorner, 3));
  }
  const look: BaseLook = {
    ...PLAIN_LOOK,
    baseColor: color,
    opacity,
    alphaMode: opacity < 1 ? 'blend' : 'opaque',
    vertexColors: colors !== null,
  };
  return { name, geometry, matrix: places.matrix, look, sides: 'double', surface: {} };
}
