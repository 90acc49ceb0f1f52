// The viewer's own style sheet. Constructed, so a strict CSP has nothing to say about it.
import { unsafeCSS } from 'lit';
import sheet from './phong-viewer.css?inline';

/** Not Lit's `css`: its text would reach dist/ with all white space and comments. */
export const styles = unsafeCSS(sheet);
