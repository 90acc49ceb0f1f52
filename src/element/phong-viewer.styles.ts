// The viewer's style sheet. Constructed, so that a strict CSP allows it.
import { unsafeCSS } from '@lit/reactive-element';
import sheet from './phong-viewer.css?inline';

/** Imported, not written with Lit's `css`: the bundle would keep its white space and comments. */
export const styles = unsafeCSS(sheet);
