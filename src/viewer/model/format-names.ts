// The formats of models: their names, extensions and media types, and the code that reads them.
// What a file's bytes say is in format.ts.
import { type ExtraCode, extraCode } from './lazy-code.js';
import type { Content } from './model.js';

/** One row per format, in the order in which contents are tested: the strictest test first. */
export const FORMAT_NAMES = {
  gltf: {
    name: 'glTF',
    code: /* @__PURE__ */ extraCode<ReaderCode>('glTF models'),
    extensions: ['glb', 'gltf'],
    types: ['gltf', 'glb', 'model/gltf-binary', 'model/gltf+json'],
    otherTypes: [],
  },
  ply: {
    name: 'PLY',
    code: /* @__PURE__ */ extraCode<ReaderCode>('PLY files'),
    extensions: ['ply'],
    types: ['ply', 'model/ply'],
    otherTypes: ['application/ply', 'application/x-ply', 'text/ply'],
  },
  stl: {
    name: 'STL',
    code: /* @__PURE__ */ extraCode<ReaderCode>('STL files'),
    extensions: ['stl'],
    types: ['stl', 'model/stl'],
    otherTypes: ['model/x.stl-binary', 'model/x.stl-ascii', 'application/sla'],
  },
  obj: {
    name: 'OBJ',
    code: /* @__PURE__ */ extraCode<ReaderCode>('OBJ files'),
    extensions: ['obj'],
    types: ['obj', 'model/obj'],
    otherTypes: ['application/x-obj', 'text/prs.wavefront-obj'],
  },
} as const satisfies Readonly<Record<string, FormatNames>>;

/** The code that reads a format. What it reads from is the extra's own. */
interface ReaderCode {
  readonly read: (source: never) => Promise<Content>;
}

export interface FormatNames {
  /** For messages. */
  readonly name: string;
  /** Requests its reader. */
  readonly code: ExtraCode<ReaderCode>;
  /** Lower case, without the dot. */
  readonly extensions: readonly string[];
  /** The words and media types that the attribute `type` takes. */
  readonly types: readonly string[];
  /** Media types that servers send besides. */
  readonly otherTypes: readonly string[];
}

export type FormatKey = keyof typeof FORMAT_NAMES;

export type ModelType = (typeof FORMAT_NAMES)[FormatKey]['types'][number];

/** What `type` takes. */
export const MODEL_TYPES: readonly ModelType[] = Object.values(FORMAT_NAMES).flatMap(
  ({ types }) => types,
);
