// The first screen: a pixel of the picture as the sum of its lights, and the markup that runs with
// the picture.
import '../page.js';
import { copy, edit } from '../parts/listings.js';
import { markupOfNow, showCode } from './code.js';
import { showNone, showSum } from './sum.js';

const part = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;
const viewer = document.querySelector('phong-viewer')!;
const line = part('sum');
const ring = part('pixel');

// -- The pixel
// -------------------------------------------------------------------------------------------------

/**
 * Where it is, from the middle of the picture, in heights: there it shows the same point of the
 * scene whatever the width. At first it is beside the highlight of the teapot.
 */
let at = { right: -0.14, down: -0.0475 };
let busy = false;
let again = false;

/** The picture without the panel beside it. */
function picture(): { readonly width: number; readonly height: number } {
  const surface = viewer.shadowRoot?.querySelector('[part~=surface]') ?? viewer;
  return { width: surface.clientWidth, height: surface.clientHeight };
}

function place(): { readonly x: number; readonly y: number } {
  const { width, height } = picture();
  return { x: width / 2 + at.right * height, y: height / 2 + at.down * height };
}

/** Shows the sum at `at`. */
async function update(): Promise<void> {
  again = busy;
  if (busy) return;
  busy = true;
  do {
    again = false;
    const { x, y } = place();
    const fragment = await viewer.shadeAt(x, y);
    ring.hidden = fragment === null;
    if (fragment === null) {
      showNone(line);
    } else {
      showSum(line, fragment);
      ring.style.left = `${String(x)}px`;
      ring.style.top = `${String(y)}px`;
    }
  } while (again);
  busy = false;
}

/** Beside the shapes the pixel stays where it was. */
async function moveTo(x: number, y: number): Promise<void> {
  const { width, height } = picture();
  if (x < 0 || y < 0 || x >= width || y >= height) return;
  if ((await viewer.shadeAt(x, y)) === null) return;
  at = { right: (x - width / 2) / height, down: (y - height / 2) / height };
  await update();
}

function pointed(event: PointerEvent): void {
  // Not through the panel, and not while something is dragged.
  const onPanel = event.composedPath().some((node) => (node as Partial<Element>).part?.contains('panel')); // oxfmt-ignore
  if (onPanel || (event.type === 'pointermove' && event.buttons !== 0)) return;
  const { left, top } = viewer.getBoundingClientRect();
  void moveTo(event.clientX - left, event.clientY - top);
}

viewer.addEventListener('pointermove', pointed);
viewer.addEventListener('pointerdown', pointed);
viewer.addEventListener('render', () => void update());

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

ring.addEventListener('keydown', (event) => {
  const [right, down] = ARROWS[event.key] ?? [0, 0];
  if (right === 0 && down === 0) return;
  event.preventDefault();
  const pixels = event.shiftKey ? 10 : 1;
  const { x, y } = place();
  void moveTo(x + pixels * right, y + pixels * down);
});
// Read out where it is moved by keys, and not at every move of the mouse.
ring.addEventListener('focus', () => line.setAttribute('aria-live', 'polite'));
ring.addEventListener('blur', () => line.removeAttribute('aria-live'));

// -- The markup
// -------------------------------------------------------------------------------------------------

const refresh = showCode(part('code'), viewer);
viewer.addEventListener('render', refresh);
addEventListener('resize', refresh);

const copying = part('copy');
copying.addEventListener('click', () => {
  void copy(viewer.toHTML(), part('code')).then((done) => {
    copying.textContent = done ? 'Copied' : 'Selected';
    setTimeout(() => (copying.textContent = 'Copy'), 1500);
  });
});
part('edit').addEventListener('click', () => void edit(markupOfNow(viewer)));

const panel = part('panel');
panel.addEventListener('click', () => {
  viewer.gui = viewer.gui === false;
  panel.setAttribute('aria-pressed', String(viewer.gui !== false));
});

await viewer.ready;
refresh();
await update();
