// Reads the materials of an MTL file. Ka, Kd, Ks, Ns and d are the coefficients of the equation and
// are kept as they are written (encoded sRGB, no conversion), except an Ns of 0; Ke is what the
// surface emits. Other statements are skipped, and named if they would change the picture.
import { clamp, scale, type Vec3 } from '../../../phong/math/vector.js';
import type { SurfaceValues } from '../../../phong/material/material-values.js';
import { LIMITS } from '../../../phong/light/light-state.js';
import type { Slices } from '../slices.js';
import { NAME_LENGTH, TextScanner } from '../text/text-scanner.js';

export interface MtlMaterial {
  /** What the file gives of Ka, Kd, Ks and the exponent; Ka is Kd if it gives that alone. */
  readonly surface: Partial<SurfaceValues>;
  /** 0 to 1. */
  readonly opacity: number;
  /** Multiplies Ka and Kd. */
  readonly map: MtlMap | null;
  /** E, the emission. White if the file gives only its map, black if it gives neither. */
  readonly ke: Vec3;
  /** Multiplies E. */
  readonly keMap: MtlMap | null;
  /** Statements that are left out, as the format's documents write them. */
  readonly leftOut: ReadonlySet<string>;
}

/** A texture. */
export interface MtlMap {
  /**
   * Its path from the model, with slashes instead of backslashes, as it may be read: the likeliest
   * first.
   */
  readonly files: readonly [string, ...string[]];
  /** Texture coordinates are multiplied by this, in the file's own directions (v upward). */
  readonly scale: readonly [u: number, v: number];
  /** Then this is added. */
  readonly offset: readonly [u: number, v: number];
  readonly clamped: boolean;
}

/** Materials beyond this are skipped: a model cannot have that many draws. */
const MATERIAL_LIMIT = 10_000;

/** What a material's statements say. */
interface Draft {
  readonly colors: Partial<Record<ColorKey, Vec3>>;
  readonly maps: Partial<Record<'map_ka' | 'map_kd' | 'map_ke', MtlMap | null>>;
  readonly leftOut: Set<string>;
  shininess?: number;
  opacity: number;
  dissolved: boolean;
}

const emptyDraft = (): Draft => ({
  colors: {},
  maps: {},
  leftOut: new Set(),
  opacity: 1,
  dissolved: false,
});

const COLOR_KEYS = ['ka', 'kd', 'ks', 'ke'] as const;
type ColorKey = (typeof COLOR_KEYS)[number];
const isColor = (keyword: string): keyword is ColorKey => COLOR_KEYS.some((key) => key === keyword);

/**
 * Materials by name. A statement that cannot be read is as good as missing.
 * @param folder of the library, with a slash behind it: images are named relative to it.
 */
export async function readMtl(
  bytes: Uint8Array,
  folder: string,
  slices: Slices,
): Promise<ReadonlyMap<string, MtlMaterial>> {
  const materials = new Map<string, Draft>();
  let material: Draft | null = null;
  const scanner = new TextScanner(bytes, 0, true);
  let { at } = scanner;
  for (let more = scanner.nextWord(); more; more = scanner.nextLine()) {
    const keyword = scanner.word().toLowerCase();
    if (keyword === 'newmtl') {
      if (materials.size >= MATERIAL_LIMIT) break;
      material = emptyDraft();
      materials.set(scanner.rest(NAME_LENGTH), material);
    } else if (material !== null) {
      readStatement(keyword, scanner, material, folder);
    }
    if (slices.took(1 + (scanner.at - at) / 8)) {
      await slices.pause();
    }
    ({ at } = scanner);
  }
  const colors = [...materials.values()].flatMap(({ colors: { ka, kd } }) => [ka, kd]);
  const full = colors.some((color) => color?.some((c) => c > MOST_BRIGHT)) ? 255 : 1;
  return new Map(
    await slices.map([...materials], ([name, draft]) => [name, finished(draft, full)] as const),
  );
}

/** A library with a Ka or Kd above this counts to 255. Less may be a bright colour. */
const MOST_BRIGHT = 16;

function readStatement(
  keyword: string,
  scanner: TextScanner,
  material: Draft,
  folder: string,
): void {
  if (isColor(keyword)) {
    const color = readColor(scanner);
    if (color !== null) {
      material.colors[keyword] = color;
    }
  } else if (keyword === 'ns') {
    const exponent = scanner.number();
    if (exponent >= 0) {
      material.shininess = Math.min(exponent, LIMITS.exponent);
    }
  } else if (keyword === 'd') {
    // `-halo` changes the opacity with the angle, which the equation does not.
    const words = withoutComment(scanner.rest()).split(/\s+/);
    const opacity = Number(words.at(-1));
    if (words[0] === '' || Number.isNaN(opacity)) return;
    material.opacity = clamp(opacity, 0, 1);
    material.dissolved = true;
  } else if (keyword === 'tr') {
    const transparency = scanner.number();
    // Some exporters write both, and mean opacity by both. `d` is the older and the defined one.
    if (Number.isNaN(transparency) || material.dissolved) return;
    // 1 would be invisible. Programs that write it mean opaque.
    material.opacity = transparency < 1 ? 1 - clamp(transparency, 0, 1) : 1;
  } else if (keyword === 'map_kd' || keyword === 'map_ke' || keyword === 'map_ka') {
    material.maps[keyword] = mapOf(scanner.readings(), folder);
  } else {
    const name = LEFT_OUT.get(keyword);
    if (name !== undefined && !NEUTRAL.get(name)?.test(withoutComment(scanner.rest()))) {
      material.leftOut.add(name);
    }
  }
}

/** For numbers only: a name may contain `#`. */
const withoutComment = (numbers: string) => numbers.replace(/#.*/, '').trim();

/** Statements that change the picture in other programs, by their lower-case keywords. */
const LEFT_OUT: ReadonlyMap<string, string> = new Map(
  [
    'map_Ks',
    'map_Ns',
    'map_d',
    'map_Tr',
    'map_bump',
    'bump',
    'norm',
    'disp',
    'decal',
    'refl',
    'map_refl',
    'Tf',
    'Pr',
    'Pm',
    'Ps',
    'Pc',
    'Pcr',
    'aniso',
    'map_Pr',
    'map_Pm',
    'map_Ps',
  ].map((name) => [name.toLowerCase(), name]),
);

/** Values that change nothing, as exporters write them. */
const ZERO = /^[0.]*$/;
const NEUTRAL: ReadonlyMap<string, RegExp> = new Map([
  ...['Pm', 'Ps', 'Pc', 'Pcr', 'aniso'].map((name) => [name, ZERO] as const),
  ['Tf', /^(1(\.0*)?\s*)*$/],
]);

/**
 * Three numbers, or one for grey. Null for the spectral and CIE XYZ forms, which exporters do not
 * write.
 */
function readColor(scanner: TextScanner): Vec3 | null {
  const limit = LIMITS.color / 255;
  const [r, g, b] = [scanner.number(), scanner.number(), scanner.number()].map((value) =>
    clamp(value, 0, limit),
  ) as [number, number, number];
  if (Number.isNaN(r)) return null;
  return Number.isNaN(g) || Number.isNaN(b) ? [r, r, r] : [r, g, b];
}

/** Options with vectors. Fewer numbers than three: the others are defaults. */
const VECTORS = ['-o', '-s', '-t'];

/** Options before the file's name, with the most numbers or words that they take. */
const OPTIONS: ReadonlyMap<string, number> = new Map([
  ...'-blendu -blendv -bm -boost -cc -clamp -colorspace -imfchan -texres -type'
    .split(' ')
    .map((option) => [option, 1] as const),
  ['-mm', 2],
  ...VECTORS.map((option) => [option, 3] as const),
]);

/** An option and what may be its values. */
const OPTION = /^\s*(-[a-z]+)(?=\s)/i;
/**
 * An option behind the name. A name may contain what looks like one, but not with a number or a
 * switch behind it.
 */
const TRAILING =
  /\s-(?:blend[uv]|bm|boost|cc|clamp|imfchan|mm|[ost]|texres|type)\s+(?:[-+.\d]|on\b|off\b|[rgbmlz]\b)/i;

function mapOf(readings: readonly string[], folder: string): MtlMap | null {
  const [first = null, ...others] = readings.map((text) => readMap(text, folder));
  return (
    first && { ...first, files: [first.files[0], ...others.flatMap((map) => map?.files ?? [])] }
  );
}

function readMap(text: string, folder: string): MtlMap | null {
  const options: Options = { scale: [1, 1], offset: [0, 0], clamped: false };
  let rest = takeOptions(text, options);
  const [, quoted, behind] = /^\s*("[^"]+")(.*)$/.exec(rest) ?? [];
  const end = quoted === undefined ? (TRAILING.exec(rest)?.index ?? rest.length) : 0;
  takeOptions(behind ?? rest.slice(end), options);
  rest = quoted ?? rest.slice(0, end);
  const file = imageName(rest);
  return file === '' ? null : { files: [folder + file], ...options };
}

type Options = { -readonly [K in Exclude<keyof MtlMap, 'files'>]: MtlMap[K] };

/** Reads the options at the start of a text. Returns what follows them. */
function takeOptions(text: string, options: Options): string {
  let rest = text;
  for (;;) {
    const option = OPTION.exec(rest)?.[1]?.toLowerCase() ?? '';
    const most = OPTIONS.get(option) ?? 0;
    if (most === 0) return rest;
    const values: string[] = [];
    rest = rest.trimStart().slice(option.length);
    while (values.length < most) {
      const value = /^\s*(\S+)/.exec(rest)?.[1];
      // The name of a file may follow after one or two numbers.
      if (
        value === undefined ||
        (VECTORS.includes(option) && values.length > 0 && Number.isNaN(Number(value)))
      ) {
        break;
      }
      values.push(value);
      rest = rest.trimStart().slice(value.length);
    }
    const [u = NaN, v = NaN] = values.map(Number);
    if (option === '-s') {
      options.scale = [finite(u, 1), finite(v, 1)];
    }
    if (option === '-o') {
      options.offset = [finite(u, 0), finite(v, 0)];
    }
    if (option === '-clamp') {
      options.clamped = values[0]?.toLowerCase() === 'on';
    }
  }
}

const finite = (value: number, fallback: number) => (Number.isFinite(value) ? value : fallback);

/** @param full the value of Ka, Kd and Ks that stands for full intensity: 1, or 255 in some files. */
function finished({ colors, maps, shininess, opacity, leftOut }: Draft, full = 1): MtlMaterial {
  const map = maps.map_kd ?? null;
  const keMap = maps.map_ke ?? null;
  // A texture without a colour is shown as it is.
  const kd = colors.kd ?? (map === null ? undefined : scale(WHITE, full));
  const ka = colors.ka ?? kd;
  // `Ns 0` stands for no highlight: MeshLab, Blender and 3ds Max write it beside a bright Ks for
  // plain surfaces. As an exponent it would add all of Ks to every lit point.
  const ks = shininess === 0 ? BLACK : colors.ks;
  // The map of Kd is that of Ka too.
  if (maps.map_ka && maps.map_ka.files[0] !== map?.files[0]) {
    leftOut.add('map_Ka');
  }
  return {
    surface: {
      ...(ka && { ka: scale(ka, 255 / full) }),
      ...(kd && { kd: scale(kd, 255 / full) }),
      ...(ks && { ks: scale(ks, 255 / full) }),
      ...(shininess !== undefined && { shininess }),
    },
    opacity,
    map,
    ke: colors.ke ?? (keMap === null ? BLACK : WHITE),
    keMap,
    leftOut,
  };
}

const WHITE: Vec3 = [1, 1, 1];
const BLACK: Vec3 = [0, 0, 0];

export const NO_MATERIAL = /* @__PURE__ */ finished(emptyDraft());

/** Without the quotes around it, if there are any. */
export const unquoted = (name: string) => /^"([^"]*)"$/.exec(name)?.[1]?.trim() ?? name;

/**
 * A material's name as it is compared if it is not found as written: without quotes, and without a
 * comment behind it. Names can contain `#`, as 3ds Max's own do.
 */
export const plainName = (name: string) => unquoted(name.replace(/\s#.*$/, '').trim());

/** An image's name without quotes, or a comment behind its extension. */
const imageName = (text: string) =>
  unquoted(text.trim().replace(/(\.\w{2,5}"?)\s+#.*$/, '$1')).replace(/\\/g, '/');
