// The buffer views of a glTF document that meshopt has compressed, and what they claim to decompress to. Checked before
// anything is allocated. Knows the JSON only.
import { countAt, indexAt, optionalObject, textAt, type JsonObject } from './json.js';

/** The same data under two names; the second is the ratified one. */
const MESHOPT = ['EXT_meshopt_compression', 'KHR_meshopt_compression'] as const;

export interface MeshoptView {
  /** Where the compressed bytes are. */
  readonly buffer: number;
  readonly byteOffset: number;
  readonly byteLength: number;
  /** Elements, and bytes of each, once decoded. */
  readonly count: number;
  readonly stride: number;
  readonly mode: MeshoptMode;
  readonly filter: MeshoptFilter;
}

const MODES = ['ATTRIBUTES', 'TRIANGLES', 'INDICES'] as const;
const FILTERS = ['NONE', 'OCTAHEDRAL', 'QUATERNION', 'EXPONENTIAL', 'COLOR'] as const;

type MeshoptMode = (typeof MODES)[number];
type MeshoptFilter = (typeof FILTERS)[number];

/** Null if the view is not compressed. @throws Error for a claim that the decoder must not see. */
export function readMeshoptView(view: JsonObject, buffers: number, what: string): MeshoptView | null {
  const extensions = optionalObject(view['extensions'], `${what}.extensions`);
  const name = MESHOPT.find((known) => known in extensions);
  if (name === undefined) return null;
  const packed = optionalObject(extensions[name], `${what}.${name}`);
  const mode = MODES.find((known) => known === packed['mode']);
  const filter = FILTERS.find((known) => known === (textAt(packed['filter']) || 'NONE'));
  const count = countAt(packed['count'], `${what}.count`);
  const stride = countAt(packed['byteStride'], `${what}.byteStride`);
  if (mode === undefined || filter === undefined) throw new Error(`${what} has an unknown mode or filter`);
  const fits = mode === 'ATTRIBUTES' ? stride % 4 === 0 && stride > 0 && stride <= 256 : stride === 2 || stride === 4;
  const filtered = filter === 'NONE' || (mode === 'ATTRIBUTES' && filterFits(filter, stride));
  const whole = mode !== 'TRIANGLES' || count % 3 === 0;
  if (!fits || !filtered || !whole || count * stride !== view['byteLength']) {
    throw new Error(`${what} does not unpack to the bytes that it claims`);
  }
  return {
    buffer: indexAt(packed['buffer'], buffers, `${what}.buffer`),
    byteOffset: countAt(packed['byteOffset'], `${what}.byteOffset`, 0),
    byteLength: countAt(packed['byteLength'], `${what}.byteLength`),
    count,
    stride,
    mode,
    filter,
  };
}

/** The strides that the decoder takes for a filter; it does not check them. */
function filterFits(filter: MeshoptFilter, stride: number): boolean {
  if (filter === 'QUATERNION') return stride === 8;
  return filter === 'EXPONENTIAL' || stride === 4 || stride === 8;
}
