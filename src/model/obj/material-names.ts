// How OBJ and MTL files write names: of materials, libraries and images.

/** Without the quotes around it, if there are any. */
export const unquoted = (name: string): string => /^"([^"]*)"$/.exec(name)?.[1]?.trim() ?? name;

/**
 * A material's name as it is compared if it is not found as written: without quotes, and without a comment behind it.
 * Names can contain `#`, as 3ds Max's own do.
 */
export const plainName = (name: string): string => unquoted(name.replace(/\s#.*$/, '').trim());

/** An image's name without quotes, or a comment behind its extension. */
export const imageName = (text: string): string =>
  unquoted(text.trim().replace(/(\.\w{2,5}"?)\s+#.*$/, '$1')).replace(/\\/g, '/');
