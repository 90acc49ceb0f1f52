// When a page has shown what it was opened for, in milliseconds since its navigation. Nothing is known of who draws.
import { finish } from './peers/peer.js';

declare global {
  interface Window {
    /** Milliseconds from navigation until the first picture was drawn. */
    firstPicture?: number;
  }
}

/** Right after a first frame was handed to this context: notes when it is drawn. */
export function pictureDrawn(gl: WebGL2RenderingContext): void {
  finish(gl);
  window.firstPicture = performance.now();
}

/** After everything was drawn: notes when the browser has come to show it. */
export function pictureShown(): void {
  requestAnimationFrame(() => {
    setTimeout(() => {
      window.firstPicture = performance.now();
    });
  });
}
