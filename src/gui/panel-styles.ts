// How does the panel's style sheet get into a viewer's shadow root? As a constructed style sheet, which a strict CSP allows, shared by
// all panels of the page.
import controls from './controls.css?inline';
import panel from './panel.css?inline';

let sheet: CSSStyleSheet | undefined;

/** Adds the sheet to the root. The returned function removes it. */
export function adoptStyles(root: ShadowRoot): () => void {
  sheet ??= parsed();
  const own = sheet;
  root.adoptedStyleSheets = [...root.adoptedStyleSheets, own];
  return () => {
    root.adoptedStyleSheets = root.adoptedStyleSheets.filter((other) => other !== own);
  };
}

function parsed(): CSSStyleSheet {
  const styles = new CSSStyleSheet();
  styles.replaceSync(panel + controls);
  return styles;
}
