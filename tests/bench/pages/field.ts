// The element with boxes, or a floor, under many lamps: ?lamps=128&floor=0&seed=1&budget=0.5
import { runFrame } from './manual-frames.js';
import 'phong-viewer';
import './framed.css';
import { contextOf, drawnFirst, setSize } from './peers/element.js';
import { settle } from './peers/peer.js';
import { EYE, fieldOf, LOOK, SIZE } from '../stands/field.js';

export interface FieldPage {
  readonly gl: WebGL2RenderingContext;
  draw(): void;
  resize(width: number, height: number): Promise<void>;
}

declare global {
  interface Window {
    field: Promise<FieldPage>;
  }
}

/** What the element's own rules need to settle, twice over. */
const SETTLED = { frames: 60, ms: 600, atMost: 8000 };

async function open(): Promise<FieldPage> {
  const query = new URLSearchParams(location.search);
  const number = (name: string): number => Number(query.get(name));
  const { lamps, boxes } = fieldOf(number('lamps'), number('floor') === 1, number('seed'));
  const viewer = document.createElement('phong-viewer');
  Object.assign(viewer, EYE, { target: [0, 0, 0], errorBudget: number('budget') });
  for (const values of lamps) viewer.append(Object.assign(document.createElement('phong-light'), values));
  const mesh = (shape: object): void => {
    viewer.append(Object.assign(document.createElement('phong-mesh'), LOOK, shape));
  };
  for (const position of boxes) mesh({ geometry: 'box', position });
  if (boxes.length === 0) mesh({ geometry: 'plane', scale: SIZE });
  const holder = document.getElementById('holder')!;
  holder.append(viewer);
  const resize = (width: number, height: number): Promise<void> =>
    setSize(holder, contextOf(viewer), width, height);
  const [width, height] = [innerWidth, innerHeight];
  Object.assign(holder.style, { width: '64px', height: '48px' });
  await drawnFirst(viewer);
  const gl = contextOf(viewer);
  const draw = (): void => {
    viewer.requestRender();
    if (runFrame() === 0) throw new Error('the viewer asked for no frame');
  };
  await settle({ gl, draw, resize, programs: () => viewer.stats.programs }, SETTLED);
  await resize(width, height);
  return { gl, draw, resize };
}

window.field = open();
