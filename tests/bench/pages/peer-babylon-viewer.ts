// <babylon-viewer> among its peers: the same box as a file, loaded as its documentation says. Its lighting is the one it comes
// with: files are all that it shows, and no attribute names a light. WebGL, so that all peers draw by the same API.
import { next, openPeers } from './peer-page.js';

await openPeers({
  tag: 'babylon-viewer',
  // The empty slot: its button would cover the middle of a small picture.
  markup: '<babylon-viewer engine="WebGL" source="box.glb"><span slot="tool-bar"></span></babylon-viewer>',
  // None of its events says it: it renders before its program is there, and then without the model.
  async loaded(viewer) {
    await next(viewer, 'modelchange');
    do await next(viewer, 'viewerrender');
    while (!showsCentre(viewer.shadowRoot!.querySelector('canvas')!));
  },
});

/** Whether a canvas that was drawn in this task has anything in its middle. */
function showsCentre(canvas: HTMLCanvasElement): boolean {
  const look = new OffscreenCanvas(1, 1).getContext('2d')!;
  look.drawImage(canvas, canvas.width / 2, canvas.height / 2, 1, 1, 0, 0, 1, 1);
  return look.getImageData(0, 0, 1, 1).data[3]! > 0;
}
