// Reads the materials of an MTL file. Ka, Kd, Ks, Ns and d are the coefficients of the equation and are kept as they
// are written (encoded sRGB, no conversion), except an Ns of 0. Other statements are skipped.
import type { Vec3 } from '../../math/vector.js';
import { LIMITS } from '../../light/light-state.js';
import { TextScanner } from '../text/text-scanner.js';

export interface MtlMaterial {
  /** Ambient; the diffuse colour if the file does not give it. Undefined if it gives neither. */
  readonly ka?: Vec3;
  readonly kd?: Vec3;
  readonly ks?: Vec3;
  readonly shininess?: number;
  /** 0 to 1. */
  readonly opacity: number;
  readonly map: MtlMap | null;
}

/** A texture that multiplies Ka and Kd. */
export interface MtlMap {
  /** As it is written, with slashes instead of backslashes. */
  readonly file: string;
  /** Texture coordinates are multiplied by this, in the file's own directions (v upward). */
  readonly scale: readonly [u: number, v: number];
  /** Then this is added. */
  readonly offset: readonly [u: number, v: number];
  readonly clamped: boolean;
}

/** Materials beyond this are skipped: a model cannot have that many draws. */
const MATERIAL_LIMIT = 10_000;

type Draft = { -readonly [K in keyof MtlMaterial]: MtlMaterial[K] } & { dissolved: boolean };

/** Materials by name. Never throws: a statement that cannot be read is as good as missing. */
export function readMtl(bytes: Uint8Array): ReadonlyMap<string, MtlMaterial> {
  const materials = new Map<string, Draft>();
  let material: Draft | null = null;
  const scanner = new TextScanner(bytes);
  for (let more = scanner.nextWord(); more; more = scanner.nextLine()) {
    const keyword = scanner.word().toLowerCase();
    if (keyword === 'newmtl') {
      if (materials.size >= MATERIAL_LIMIT) break;
      material = { opacity: 1, map: null, dissolved: false };
      materials.set(scanner.rest(NAME_LENGTH), material);
    } else if (material !== null) {
      readStatement(keyword, scanner, material);
    }
  }
  return new Map(Array.from(materials, ([name, draft]) => [name, finished(draft)]));
}

/** Longest name of a material in bytes, as in the OBJ file. */
const NAME_LENGTH = 256;

function readStatement(keyword: string, scanner: TextScanner, material: Draft): void {
  if (keyword === 'ka' || keyword === 'kd' || keyword === 'ks') {
    const color = readColor(scanner);
    if (color !== null) material[keyword] = color;
  } else if (keyword === 'ns') {
    const exponent = scanner.number();
    if (exponent >= 0) material.shininess = Math.min(exponent, LIMITS.exponent);
  } else if (keyword === 'd') {
    // `-halo` changes the opacity with the angle, which the equation does not.
    const words = scanner.rest().split(/\s+/);
    const opacity = Number(words.at(-1));
    if (words[0] === '' || Number.isNaN(opacity)) return;
    material.opacity = clamped(opacity);
    material.dissolved = true;
  } else if (keyword === 'tr') {
    const transparency = scanner.number();
    // Some exporters write both, and mean opacity by both. `d` is the older and the defined one.
    if (Number.isNaN(transparency) || material.dissolved) return;
    // 1 would be invisible. Programs that write it mean opaque.
    material.opacity = transparency < 1 ? 1 - clamped(transparency) : 1;
  } else if (keyword === 'map_kd') {
    material.map = readMap(scanner.rest());
  }
}

/** Three numbers, or one for grey. Null for the spectral and CIE XYZ forms, which exporters do not write. */
function readColor(scanner: TextScanner): Vec3 | null {
  const limit = LIMITS.color / 255;
  const [r, g, b] = [scanner.number(), scanner.number(), scanner.number()].map((value) =>
    Math.min(Math.max(value, 0), limit),
  ) as [number, number, number];
  if (Number.isNaN(r)) return null;
  return Number.isNaN(g) || Number.isNaN(b) ? [r, r, r] : [r, g, b];
}

const clamped = (value: number): number => Math.min(Math.max(value, 0), 1);

/** Options before the file's name, with the most numbers or words that they take. */
const OPTIONS: Readonly<Record<string, number>> = {
  '-blendu': 1,
  '-blendv': 1,
  '-bm': 1,
  '-boost': 1,
  '-cc': 1,
  '-clamp': 1,
  '-imfchan': 1,
  '-mm': 2,
  '-o': 3,
  '-s': 3,
  '-t': 3,
  '-texres': 1,
  '-type': 1,
};

/** Options with fewer numbers than they can take: the others are defaults. */
const VECTORS = new Set(['-o', '-s', '-t']);

function readMap(text: string): MtlMap | null {
  let rest = text;
  let scale: readonly [number, number] = [1, 1];
  let offset: readonly [number, number] = [0, 0];
  let clampedMap = false;
  for (;;) {
    const [, option = '', after = ''] = /^(-[a-z]+)\s+(.*)$/i.exec(rest) ?? [];
    const most = Object.hasOwn(OPTIONS, option.toLowerCase()) ? (OPTIONS[option.toLowerCase()] ?? 0) : 0;
    if (most === 0) break;
    const vector = VECTORS.has(option);
    const values: string[] = [];
    rest = after;
    while (values.length < most) {
      const [, value = '', next = ''] = /^(\S+)\s+(.*)$/.exec(rest) ?? [];
      // The name of a file may follow after one or two numbers.
      if (value === '' || (vector && values.length > 0 && Number.isNaN(Number(value)))) break;
      values.push(value);
      rest = next;
    }
    const [u = NaN, v = NaN] = values.map(Number);
    if (option === '-s') scale = [finite(u, 1), finite(v, 1)];
    if (option === '-o') offset = [finite(u, 0), finite(v, 0)];
    if (option === '-clamp') clampedMap = values[0]?.toLowerCase() === 'on';
  }
  const file = rest.trim().replace(/\\/g, '/');
  return file === '' ? null : { file, scale, offset, clamped: clampedMap };
}

const finite = (value: number, fallback: number): number => (Number.isFinite(value) ? value : fallback);

/**
 * `Ns 0` stands for no highlight: MeshLab, Blender and 3ds Max write it beside a bright Ks for plain surfaces. As an
 * exponent it would add all of Ks to every lit point.
 */
const PLAIN = { ks: [0, 0, 0] } as const;

function finished({ dissolved: _, ...draft }: Draft): MtlMaterial {
  const material = draft.shininess === 0 ? { ...draft, ...PLAIN } : draft;
  const { kd, map } = material;
  // A texture without a colour is shown as it is.
  const diffuse = kd ?? (map === null ? undefined : ([1, 1, 1] as const));
  if (diffuse === undefined) return material;
  return { ...material, kd: diffuse, ka: material.ka ?? diffuse };
}
