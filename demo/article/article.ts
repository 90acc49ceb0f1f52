// Draws Figure 17 of the article: the view of its viewer in a few large pixels, after 1, 4, 16 and
// 64 samples.
import '../page.js';

const viewer =
  document.querySelector<HTMLElementTagNameMap['phong-viewer']>('#fig-pixel phong-viewer')!;
const canvases = document.querySelectorAll<HTMLCanvasElement>('#fig-pixel canvas');

let drawing = false;
/** The view has changed since it was drawn last. */
let outdated = true;

/** Draws the latest view, and never two at a time. */
async function draw(): Promise<void> {
  if (drawing) return;
  drawing = true;
  while (outdated) {
    outdated = false;
    await Promise.all(Array.from(canvases, drawInto));
  }
  drawing = false;
}

async function drawInto(canvas: HTMLCanvasElement): Promise<void> {
  const { width, height, dataset } = canvas;
  // Without a picture, as without WebGL, the plates stay empty, and the viewer says why.
  const blob = await viewer
    .toBlob({ width, height, samples: Number(dataset['samples']) })
    .catch(() => null);
  if (blob === null) return;
  const bitmap = await createImageBitmap(blob);
  const context = canvas.getContext('2d');
  context?.clearRect(0, 0, width, height);
  context?.drawImage(bitmap, 0, 0);
}

for (const event of ['camera-change', 'light-change'] as const) {
  viewer.addEventListener(event, () => {
    outdated = true;
    void draw();
  });
}
void customElements
  .whenDefined('phong-viewer')
  .then(() => viewer.ready)
  .then(draw);
