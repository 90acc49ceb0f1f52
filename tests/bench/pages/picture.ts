// One whole picture drawn by one side, for the bench to time and to compare with the exact one:
// picture.html?scene=sphere&side=full&width=400&height=300. Each way of the element has a page of
// its own, so that its programs stay.
import './page-hooks.js';
import type { CastScene } from '../../../src/extras/still/cast-scene.js';
import { FULL, full, PLAIN } from '../pictures.mjs';
import type { Mode } from './picture-element.js';
import { PICTURE_SCENES, type PictureName, type PictureScene } from './picture-scenes.js';

/** A side's ways to draw, and how many pictures each one shows on the way to its last. */
type Methods = Readonly<Record<string, { readonly steps: number }>>;

interface PictureSide {
  readonly methods: Methods;
  /**
   * Milliseconds from a change to each of the method's pictures, closed by reading a pixel back.
   */
  time(method: string): Promise<number[]>;
  /**
   * The codes of a picture: r, g, b of each pixel over black, row by row from the top, viewer by
   * viewer.
   */
  codes(method: string, step: number): Promise<Uint8Array>;
  /** What each viewer shows now; `round`: as the true shape. */
  scenes(round: boolean): readonly CastScene[];
}

export type OpenPicture = (
  holder: HTMLElement,
  scene: PictureScene,
  size: Cell,
) => Promise<PictureSide>;

/** The size of each viewer in pixels. */
export interface Cell {
  readonly width: number;
  readonly height: number;
}

declare global {
  interface Window {
    openPicture: () => Promise<{ methods: Methods; cell: Cell }>;
    picture: PictureSide;
  }
}

const openElement = async (mode: Mode) => (await import('./picture-element.js')).openElement(mode);
const SIDES: Readonly<Record<string, () => Promise<OpenPicture>>> = {
  ...Object.fromEntries(
    FULL.map((samples) => [full(samples), () => openElement({ antialias: 'full', samples })]),
  ),
  [PLAIN]: () => openElement({ antialias: 'edges', samples: 0 }),
  multisampled: async () => (await import('./picture-three.js')).openMultisampled,
  passes: async () => (await import('./picture-three.js')).openPasses,
};

const query = new URLSearchParams(location.search);
window.openPicture = async () => {
  const scene = PICTURE_SCENES[query.get('scene') as PictureName];
  const { columns, rows } = scene;
  const cell = {
    width: Math.floor(Number(query.get('width')) / columns),
    height: Math.floor(Number(query.get('height')) / rows),
  };
  const holder = document.getElementById('holder')!;
  holder.style.gridTemplate = `repeat(${String(rows)}, ${String(cell.height)}px) / repeat(${String(columns)}, ${String(cell.width)}px)`;
  const open = await SIDES[query.get('side') ?? '']!();
  window.picture = await open(holder, scene, cell);
  return { methods: window.picture.methods, cell };
};
