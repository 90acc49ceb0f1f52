// How does the user save the picture? As a PNG that the browser downloads. Needs nothing that a strict Content-Security-Policy refuses.
import type { PhongViewer } from '../element/phong-viewer.js';

/** How long the file stays in memory for the browser to save it, ms. Browsers read it after the click, some after a dialog. */
const KEPT_MS = 40_000;

export async function savePicture(viewer: PhongViewer): Promise<void> {
  const address = URL.createObjectURL(await viewer.toBlob());
  const link = document.createElement('a');
  link.href = address;
  link.download = 'phong-viewer.png';
  link.click();
  setTimeout(() => {
    URL.revokeObjectURL(address);
  }, KEPT_MS);
}
