// The keys of all texts. The tables themselves are not in the package: the build (.ci/texts.mjs)
// writes the type of this file anew, with the keys alone.
import type mistakes from '../../../phong/mistakes/texts.json';
import type own from './texts.json';

/** The texts of each folder that has some. The table of extras (`viewer/extras.ts`) adds theirs. */
export interface TextTables {
  readonly viewer: typeof own;
  readonly mistakes: typeof mistakes;
}

type KeysIn<Sections> = { [S in keyof Sections]: keyof Sections[S] }[keyof Sections];

export type TextKey = { [T in keyof TextTables]: KeysIn<TextTables[T]> }[keyof TextTables];
