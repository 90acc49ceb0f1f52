// Adds style sheets to a shadow root, in any document, as constructed ones, which a strict CSP
// allows. A constructed sheet belongs to one document, and a root that comes into another document
// loses its sheets.

const used = new WeakMap<ShadowRoot, Set<string>>();
const parsed = new WeakMap<Document, Map<string, CSSStyleSheet>>();

/**
 * Adds a sheet to a root. Also brings back those that the root lost on its way into this document.
 * The returned function removes it.
 */
export function addStyles(root: ShadowRoot, text: string): () => void {
  const texts = (used.get(root) ?? new Set()).add(text);
  used.set(root, texts);
  for (const each of texts) {
    const sheet = sheetOf(root.ownerDocument, each);
    if (sheet !== null && !root.adoptedStyleSheets.includes(sheet)) {
      root.adoptedStyleSheets.push(sheet);
    }
  }
  return () => removeStyles(root, text);
}

function removeStyles(root: ShadowRoot, text: string) {
  used.get(root)?.delete(text);
  const sheet = sheetOf(root.ownerDocument, text);
  // In a document without a window, such as a template's, the root may still have the sheets of the
  // one before, which cannot be assigned there.
  if (sheet === null) return;
  root.adoptedStyleSheets = root.adoptedStyleSheets.filter((other) => other !== sheet);
}

/** Parsed once for each document; null where no window can make one. */
function sheetOf(document: Document, text: string): CSSStyleSheet | null {
  const view = document.defaultView;
  if (view === null) return null;
  const sheets = parsed.get(document) ?? new Map<string, CSSStyleSheet>();
  parsed.set(document, sheets);
  let sheet = sheets.get(text);
  if (sheet === undefined) {
    sheet = new view.CSSStyleSheet();
    sheet.replaceSync(text);
    sheets.set(text, sheet);
  }
  return sheet;
}
