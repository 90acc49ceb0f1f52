// The texts that a viewer shows or announces, by their English text or an error's code: the keys of `texts`. A text is
// one entry of texts.json, with its translations; words in braces stand for values. Types only, so that the first file
// contains no texts.
import type texts from './texts.json';

export type ViewerErrorCode = 'load-failed' | 'bad-model' | 'too-large' | 'csp' | 'context-lost' | 'no-webgl2';

type Sections = typeof texts;

export type ViewerText = Exclude<{ [S in keyof Sections]: keyof Sections[S] }[keyof Sections], ViewerErrorCode>;
