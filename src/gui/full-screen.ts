// A button beside the panel's title that shows the viewer in full screen, where the browser has full screen.
import type { PhongViewer } from '../element/phong-viewer.js';
import { explain } from './label.js';

/** Adds the button after `title`. Returns a function that removes it. */
export function addFullScreen(title: HTMLElement, viewer: PhongViewer): () => void {
  if (!viewer.ownerDocument.fullscreenEnabled) return () => undefined;
  const button = document.createElement('button');
  button.type = 'button';
  button.className = 'full-screen';
  const isOn = (): boolean => viewer.matches(':fullscreen');
  const update = (): void => explain(button, isOn() ? 'Leave full screen' : 'Full screen');
  button.addEventListener('click', () => {
    // The browser may refuse. Then the page stays as it is.
    (isOn() ? viewer.ownerDocument.exitFullscreen() : viewer.requestFullscreen()).catch(() => undefined);
  });
  viewer.addEventListener('fullscreenchange', update);
  title.after(button);
  update();
  return () => {
    viewer.removeEventListener('fullscreenchange', update);
    button.remove();
  };
}
