// Which point does the fragment page explain, when, and what does its pixel show? At most one explanation runs at a time, and none
// while nothing changes. Places are CSS pixels in the picture.
import '../page.js';
import type { FragmentExplanation, Vec3 } from 'phong-viewer';
import { distance, drawInPicture, type Place, project } from './drawing.js';
import { codes, pixelRow, stepRows, sumRows, vectorRows } from './tables.js';

/** A press that moves farther than this turns the camera and is not a click. CSS pixels. */
const CLICK_SLOP = 4;
/** Milliseconds without a change before the picture is read and the result is announced. */
const SETTLE_MS = 400;
/**
 * A surface hides the marked point if it is nearer to the eye by more than this share. Nearer by less, it is the same surface at
 * the centre of the pixel: half a pixel away (about a tenth of this) a surface can still lean by more than 80 degrees.
 */
const IN_FRONT = 0.005;

const viewer = document.querySelector<HTMLElementTagNameMap['phong-viewer']>('#shape')!;
const part = (id: string): HTMLElement => document.getElementById(id)!;
const across = part('across') as HTMLInputElement;
const down = part('down') as HTMLInputElement;

/** Where the user put the mark. `p` is the point of the surface there; the mark stays on it. */
interface Mark {
  /** Shares of the picture's width and height. */
  readonly x: number;
  readonly y: number;
  p: Vec3 | null;
}

let mark: Mark = { x: across.valueAsNumber / 100, y: down.valueAsNumber / 100, p: null };
/** Where the mouse hovers. Used instead of the mark while it is on the shape. */
let hover: Place | null = null;
/** The pixels of the present picture; null until they are read. */
let picture: ImageData | null = null;
/** What the page shows now; null for a place or a fragment that is not visible. */
interface Shown {
  readonly at: Place | null;
  readonly fragment: FragmentExplanation | null;
}

let shown: Shown = { at: null, fragment: null };
let busy = false;
let again = false;
let reading = false;
/** Counts the changes of the picture. */
let changes = 0;
let rest: ReturnType<typeof setTimeout> | undefined;

/** Explains the present point. A call while it runs makes it run once more at the end. */
async function explain(): Promise<void> {
  again = true;
  if (busy) return;
  busy = true;
  while (again) {
    again = false;
    show((await hovered()) ?? (await marked()));
  }
  busy = false;
}

async function hovered(): Promise<Shown | null> {
  const at = hover;
  const fragment = at && (await viewer.shadeAt(at.x, at.y));
  return at && fragment && { at, fragment };
}

async function marked(): Promise<Shown> {
  const { width, height } = viewer.getBoundingClientRect();
  const here = mark;
  const at = here.p === null ? { x: here.x * width, y: here.y * height } : project(viewer, here.p);
  if (at === null) return { at, fragment: null };
  const { eye } = viewer.camera;
  const fragment = await viewer.shadeAt(at.x, at.y);
  here.p ??= fragment?.p ?? null;
  const hidden = fragment !== null && distance(fragment.p, eye) < (1 - IN_FRONT) * distance(here.p!, eye);
  return { at, fragment: hidden ? null : fragment };
}

function show(now: Shown): void {
  shown = now;
  const { at, fragment } = now;
  drawInPicture(part('vectors'), viewer, at, fragment);
  const { width, height } = viewer.getBoundingClientRect();
  if (at !== null) {
    for (const [input, share] of [
      [across, at.x / width],
      [down, at.y / height],
    ] as const) {
      input.valueAsNumber = 100 * share;
      input.nextElementSibling!.textContent = (100 * share).toFixed(1);
    }
  }
  part('numbers').classList.toggle('empty', fragment === null);
  part('steps').classList.toggle('empty', fragment === null);
  if (fragment !== null) {
    part('directions').replaceChildren(...vectorRows(fragment));
    part('sum').replaceChildren(...sumRows(fragment), pixelRow(fragment.color, pixelAt(at)));
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
    if (seen === changes) picture = read;
  }
  reading = false;
  const { at, fragment } = shown;
  const pixel = pixelAt(at);
  if (fragment !== null) part('sum').lastElementChild?.replaceWith(pixelRow(fragment.color, pixel));
  const line =
    fragment === null
      ? 'No surface is visible there: it is the background, the far side of the shape, or outside the picture.'
      : `The equation gives ${codes(fragment.color)}${pixel === null ? '.' : `; the pixel is ${pixel.join(' ')}.`}`;
  if (part('result').textContent !== line) part('result').textContent = line;
}

/** Null while the WebGL context is lost. */
async function readPicture(): Promise<ImageData | null> {
  const blob = await viewer.toBlob().catch(() => null);
  if (blob === null) return null;
  const bitmap = await createImageBitmap(blob, { premultiplyAlpha: 'none', colorSpaceConversion: 'none' });
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext('2d');
  context?.drawImage(bitmap, 0, 0);
  return context?.getImageData(0, 0, width, height) ?? null;
}

/** The 8-bit colour of the device pixel at a CSS pixel, chosen as shadeAt does. */
function pixelAt(at: Place | null): Vec3 | null {
  if (picture === null || at === null) return null;
  const box = viewer.getBoundingClientRect();
  const column = Math.floor((at.x * picture.width) / box.width);
  const row = Math.floor((at.y * picture.height) / box.height);
  const [r, g, b] = picture.data.subarray(4 * (row * picture.width + column));
  return [r ?? 0, g ?? 0, b ?? 0];
}

function changed(): void {
  changes += 1;
  picture = null;
  void explain();
}

function put(x: number, y: number): void {
  hover = null;
  mark = { x, y, p: null };
  void explain();
}

function look(at: Place | null): void {
  if (at?.x === hover?.x && at?.y === hover?.y) return;
  hover = at;
  void explain();
}

let pressed: Place = { x: 0, y: 0 };
let steady = false;
viewer.addEventListener('pointermove', ({ offsetX: x, offsetY: y, buttons, pointerType }) => {
  if (buttons !== 0) steady &&= Math.hypot(x - pressed.x, y - pressed.y) <= CLICK_SLOP;
  else if (pointerType !== 'touch') look({ x, y });
});
viewer.addEventListener('pointerleave', () => look(null));
viewer.addEventListener('pointerdown', ({ offsetX: x, offsetY: y }) => {
  pressed = { x, y };
  steady = true;
  look(null);
});
viewer.addEventListener('click', ({ offsetX, offsetY }) => {
  if (!steady) return;
  const { width, height } = viewer.getBoundingClientRect();
  put(offsetX / width, offsetY / height);
});
for (const input of [across, down])
  input.addEventListener('input', () => put(across.valueAsNumber / 100, down.valueAsNumber / 100));
for (const box of document.querySelectorAll<HTMLInputElement>('input[data-light]'))
  box.addEventListener('change', () =>
    part(box.dataset['light']!).setAttribute('active', String(box.checked)),
  );

void viewer.ready.then(() => {
  for (const event of ['camera-change', 'light-change'] as const) viewer.addEventListener(event, changed);
  // The dials write the viewer's own attributes; a resize moves every point, and gives the first explanation.
  new MutationObserver(changed).observe(viewer, { attributes: true });
  new ResizeObserver(changed).observe(viewer);
});
