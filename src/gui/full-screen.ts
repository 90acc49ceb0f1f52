// A button beside the panel's title that shows the viewer in full screen, where the browser has full screen.
import type { PhongViewer } from '../element/phong-viewer.js';
import { explain } from './label.js';

export class FullScreenButton {
  readonly #viewer: PhongViewer;
  readonly #button = document.createElement('button');

  /** Adds the button after `title`. */
  constructor(title: HTMLElement, viewer: PhongViewer) {
    this.#viewer = viewer;
    if (!viewer.ownerDocument.fullscreenEnabled) return;
    this.#button.type = 'button';
    this.#button.className = 'full-screen';
    this.#button.addEventListener('click', this.#toggle);
    viewer.addEventListener('fullscreenchange', this.#update);
    title.after(this.#button);
    this.#update();
  }

  readonly #update = (): void => explain(this.#button, this.#isOn ? 'Leave full screen' : 'Full screen');

  dispose(): void {
    this.#viewer.removeEventListener('fullscreenchange', this.#update);
    this.#button.remove();
  }

  get #isOn(): boolean {
    return this.#viewer.matches(':fullscreen');
  }

  readonly #toggle = (): void => {
    const change = this.#isOn
      ? this.#viewer.ownerDocument.exitFullscreen()
      : this.#viewer.requestFullscreen();
    // The browser may refuse. Then the page stays as it is.
    change.catch(() => undefined);
  };
}
