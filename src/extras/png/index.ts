/** `phong-viewer/still/markup`: the scene that a PNG file holds, in browsers and in Node. */
export { markupIn, PngTextError } from './read-text.js';
