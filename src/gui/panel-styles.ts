// The panel's style sheet inside a viewer's shadow root: constructed, so that a strict CSP has nothing to say about it, and
// shared by all panels of the page.
import controls from './controls.css?inline';
import panel from './panel.css?inline';

let sheet: CSSStyleSheet | undefined;

/** Puts the sheet beside those that are there; the function it gives takes it away again. */
export function adoptStyles(root: ShadowRoot): () => void {
  sheet ??= parsed();
  const ours = sheet;
  root.adoptedStyleSheets = [...root.adoptedStyleSheets, ours];
  return () => {
    root.adoptedStyleSheets = root.adoptedStyleSheets.filter((other) => other !== ours);
  };
}

function parsed(): CSSStyleSheet {
  const styles = new CSSStyleSheet();
  styles.replaceSync(panel + controls);
  return styles;
}
