// Resolves the package's own names inside this repository, so that demo pages and tests import them
// as a user would.

import { entries, sourcePath } from './entries.mjs';

/** The order does not matter: each pattern matches one whole specifier. */
export const packageAliases = entries.flatMap(({ as, source, config }) =>
  as === undefined || config !== undefined
    ? []
    : [{ find: new RegExp(`^phong-viewer${as.slice(1)}$`), replacement: sourcePath(source) }],
);
