// The keys of texts.json, all sections in one. The table itself is not in the package: the build
// (.ci/texts.mjs) writes the type of this file anew, with the keys alone.
import type table from './texts.json';

type Sections = typeof table;

export type TextKey = { [S in keyof Sections]: keyof Sections[S] }[keyof Sections];
