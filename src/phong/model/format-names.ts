// The formats of models: their names, extensions and media types.
// What a file's bytes say is in extras/models/format.ts.

/** One row per format, in the order in which contents are tested: the strictest test first. */
export const FORMAT_NAMES = {
  gltf: {
    name: 'glTF',
    extensions: ['glb', 'gltf'],
    types: ['gltf', 'glb', 'model/gltf-binary', 'model/gltf+json'],
    otherTypes: [],
  },
  ply: {
    name: 'PLY',
    extensions: ['ply'],
    types: ['ply', 'model/ply'],
    otherTypes: ['application/ply', 'application/x-ply', 'text/ply'],
  },
  stl: {
    name: 'STL',
    extensions: ['stl'],
    types: ['stl', 'model/stl'],
    otherTypes: ['model/x.stl-binary', 'model/x.stl-ascii', 'application/sla'],
  },
  obj: {
    name: 'OBJ',
    extensions: ['obj'],
    types: ['obj', 'model/obj'],
    otherTypes: ['application/x-obj', 'text/prs.wavefront-obj'],
  },
} as const satisfies Readonly<Record<string, FormatNames>>;

export interface FormatNames {
  /** For messages. */
  readonly name: 'glTF' | 'PLY' | 'STL' | 'OBJ';
  /** Lower case, without the dot. */
  readonly extensions: readonly string[];
  /** The words and media types that the attribute `type` takes. */
  readonly types: readonly string[];
  /** Media types that servers send besides. */
  readonly otherTypes: readonly string[];
}

type FormatKey = keyof typeof FORMAT_NAMES;

export type ModelType = (typeof FORMAT_NAMES)[FormatKey]['types'][number];

/** What `type` takes. */
export const MODEL_TYPES: readonly ModelType[] = Object.values(FORMAT_NAMES).flatMap(
  ({ types }) => types,
);
