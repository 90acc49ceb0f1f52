// Code that is fetched on first use and may not come: the picture goes on without it, and the page's author is told.

/** What `load` imports; null, with a warning that names it, where that fails. */
export async function fetched<Code>(load: () => Promise<Code>, name: string): Promise<Code | null> {
  try {
    return await load();
  } catch {
    console.warn(`<phong-viewer>: the code of ${name} could not be fetched; the picture goes on without it.`);
    return null;
  }
}
