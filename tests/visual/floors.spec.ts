// Are large floors and walls right where the eye and the lamps are near? Against the equation at points of rays in
// float64.
import { compare, expect, type Mount, pixels, type Picture, test } from '../support/test.js';
import { innerPixels } from './against-reference.js';
import { floorScene, overFloor } from './floor-scenes.js';
import { sceneMarkup } from './random-scene.js';
import type { CastMesh, DeclaredScene } from './ray-cast.js';

const SIZE = { width: 96, height: 64 };
const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);

/** The pictures of these scenes, on one page. */
async function picturesOf(
  mount: Mount,
  scenes: readonly DeclaredScene[],
  shading?: string,
): Promise<Picture[]> {
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const pictures: Picture[] = [];
  for (const scene of scenes) {
    await viewer.evaluate(
      (element, text) => {
        element.outerHTML = text;
      },
      sceneMarkup(scene, shading),
    );
    pictures.push(await pixels(viewer, SIZE));
  }
  return pictures;
}

/** Largest error in codes inside faces, and the channels compared. Beside what is not drawn, samples mix. */
function errorOf({ data, width, height }: Picture, scene: DeclaredScene): { max: number; compared: number } {
  let max = 0;
  let compared = 0;
  const isDrawn = (x: number, y: number): boolean =>
    [-1, 0, 1].every((dy) => [-1, 0, 1].every((dx) => data[4 * ((y + dy) * width + x + dx) + 3] === 255));
  for (const { x, y, hit } of innerPixels(scene, width, height)) {
    if (!isDrawn(x, y)) continue;
    hit.shaded.color.forEach((value, channel) => {
      compared += 1;
      max = Math.max(max, Math.abs(Math.round(255 * value) - data[4 * (y * width + x) + channel]!));
    });
  }
  return { max, compared };
}

async function holds(mount: Mount, scenes: readonly DeclaredScene[], shading?: string): Promise<void> {
  const pictures = await picturesOf(mount, scenes, shading);
  let compared = 0;
  pictures.forEach((picture, i) => {
    const errors = errorOf(picture, scenes[i]!);
    compared += errors.compared;
    expect.soft(errors.max, `seed ${FIRST + i}: ${sceneMarkup(scenes[i]!, shading)}`).toBeLessThanOrEqual(1);
  });
  expect(compared).toBeGreaterThan(2000 * scenes.length);
}

test('shades floors of side 30 to 1e6 within one code, from eyes 60° to 89.5° off the vertical', async ({
  mount,
}) => {
  const views = [[1e4, 60], [1e6, 75], [30, 80], [1e3, 85], [100, 89], [50, 89.5]] as const; // prettier-ignore
  await holds(
    mount,
    views.map(([side, phi], i) => floorScene(FIRST + i, side, phi)),
  );
});

test('shades tilted and mirrored floors, and the tops and walls of boxes, within one code', async ({
  mount,
}) => {
  const tilted: Partial<CastMesh> = { rotation: [0, 40, 8], scale: [-2000, 1, 3000] };
  await holds(
    mount,
    [
      floorScene(FIRST, 0, 70, tilted),
      floorScene(FIRST + 1, 1e4, 65, { geometry: 'box' }),
      floorScene(FIRST + 2, 1e3, 80, { geometry: 'box', segments: 3 }),
    ],
    'flat',
  );
});

test('shows no step where an eye comes near a floor', async ({ mount }) => {
  const scenes = [0, 1, 2].flatMap((i) =>
    // An eye is near a floor from a quarter of its side on.
    [1 - 1e-6, 1 + 1e-6].map((share) => overFloor(FIRST + i, 4 * share, [45, 70, 85][i]!)),
  );
  const pictures = await picturesOf(mount, scenes);
  let compared = 0;
  for (let i = 0; i < pictures.length; i += 2) {
    // Rounding may move the edge of a cone across a pixel.
    const steps = [...innerPixels(scenes[i]!, SIZE.width, SIZE.height)].flatMap(({ x, y }) => {
      const at = 4 * (y * SIZE.width + x);
      return [0, 1, 2].map((k) => Math.abs(pictures[i]!.data[at + k]! - pictures[i + 1]!.data[at + k]!));
    });
    compared += steps.length;
    expect.soft(Math.max(0, ...steps), `seed ${FIRST + i / 2}`).toBeLessThanOrEqual(1);
  }
  expect(compared).toBeGreaterThan(2000);
});

test('finds the rays of pictures in an atlas and of the tiles of a large picture', async ({
  mount,
  page,
}) => {
  const scene = floorScene(FIRST, 1e3, 75);
  await mount(sceneMarkup(scene).repeat(3), SIZE);
  const viewers = await page.locator('phong-viewer').all();
  const [whole] = await Promise.all(viewers.map((viewer) => pixels(viewer, SIZE)));
  for (const viewer of viewers) {
    const codes = await viewer.evaluate((element, { width, height }) => {
      const canvas = document.createElement('canvas');
      Object.assign(canvas, { width, height });
      const context = canvas.getContext('2d')!;
      context.drawImage(element.shadowRoot!.querySelector('canvas')!, 0, 0);
      return [...context.getImageData(0, 0, width, height).data];
    }, SIZE);
    expect(compare({ ...SIZE, data: Uint8Array.from(codes) }, whole!).max).toBe(0);
  }
  // More pixels than one drawing has on a side: 4096.
  const wide = { width: 4200, height: 20 };
  const errors = errorOf(await pixels(viewers[0]!, wide), scene);
  expect(errors.max, sceneMarkup(scene)).toBeLessThanOrEqual(1);
  expect(errors.compared).toBeGreaterThan(1e5);
});
