// Adds to the viewer's probe the numbers of its fragment as tables, and the colour that its pixel
// has. The picture is read once after each change, when nothing has changed for a while.
import '../page.js';
import type { PhongViewerEventMap, Vec3 } from 'phong-viewer';
import { codes, stepRows, vectorRows } from './tables.js';

/** Milliseconds without a change before the picture is read and the result is announced. */
const SETTLE_MS = 400;

const viewer = document.querySelector<HTMLElementTagNameMap['phong-viewer']>('#shape')!;
const part = (id: string): HTMLElement => document.getElementById(id)!;

type Shown = PhongViewerEventMap['probe-change']['detail'];

let shown: Shown | null = null;
/** The pixels of the present picture; null until they are read. */
let picture: ImageData | null = null;
let reading = false;
/** Counts the changes of the picture. */
let changes = 0;
let rest: ReturnType<typeof setTimeout> | undefined;

function show(now: Shown): void {
  shown = now;
  const { fragment } = now;
  part('numbers').classList.toggle('empty', fragment === null);
  part('steps').classList.toggle('empty', fragment === null);
  if (fragment !== null) {
    part('directions').replaceChildren(...vectorRows(fragment));
    part('of-lights').replaceChildren(...stepRows(fragment));
  }
  clearTimeout(rest);
  rest = setTimeout(() => void settle(), SETTLE_MS);
}

/** After a pause: reads the picture if it has changed, and announces the result in one line. */
async function settle(): Promise<void> {
  if (reading) return;
  reading = true;
  for (let seen = -1; picture === null && seen !== changes;) {
    seen = changes;
    const read = await readPicture();
    if (seen === changes) {
      picture = read;
    }
  }
  reading = false;
  const line = resultLine();
  if (part('result').textContent !== line) {
    part('result').textContent = line;
  }
}

function resultLine(): string {
  if (shown === null || shown.fragment === null) {
    return 'No surface is visible there: it is the background, the far side of the shape, or outside the picture.';
  }
  const pixel = pixelAt(shown);
  const equation = `The equation gives ${codes(shown.fragment.color)}`;
  return pixel === null ? `${equation}.` : `${equation}; the pixel is ${pixel.join(' ')}.`;
}

/** Null while the WebGL context is lost. */
async function readPicture(): Promise<ImageData | null> {
  const blob = await viewer.toBlob().catch(() => null);
  if (blob === null) return null;
  const bitmap = await createImageBitmap(blob, {
    premultiplyAlpha: 'none',
    colorSpaceConversion: 'none',
  });
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext('2d');
  context?.drawImage(bitmap, 0, 0);
  return context?.getImageData(0, 0, width, height) ?? null;
}

/** The 8-bit colour of the device pixel at a CSS pixel, chosen as shadeAt does. */
function pixelAt({ x, y }: Shown): Vec3 | null {
  if (picture === null || x === null || y === null) return null;
  const box = viewer.getBoundingClientRect();
  const column = Math.floor((x * picture.width) / box.width);
  const row = Math.floor((y * picture.height) / box.height);
  const [r, g, b] = picture.data.subarray(4 * (row * picture.width + column));
  return [r ?? 0, g ?? 0, b ?? 0];
}

for (const box of document.querySelectorAll<HTMLInputElement>('input[data-light]')) {
  box.addEventListener('change', () =>
    part(box.dataset['light']!).setAttribute('active', String(box.checked)),
  );
}

/** The present picture is not the one that was read. */
function changed(): void {
  changes += 1;
  picture = null;
}

for (const event of ['camera-change', 'light-change', 'render'] as const) {
  viewer.addEventListener(event, changed);
}
new ResizeObserver(changed).observe(viewer);
viewer.addEventListener('probe-change', ({ detail }) => show(detail));
