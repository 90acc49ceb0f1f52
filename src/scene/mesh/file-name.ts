// What is a file called, in messages and in markup? Knows nothing of its content.

/** The name of a `File`; `model` for a `Blob`, which has none. */
export const fileName = (file: Blob): string => ('name' in file ? String(file.name) : '') || 'model';
