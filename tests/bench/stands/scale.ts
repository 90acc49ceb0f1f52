// Drawing fewer or more pixels than the screen has and letting the browser scale: the canvas's own resolution as an axis.
import { SphereGeometry } from 'three';
import { lightsOf } from '../pages/scenes.js';
import type { ColorPicture } from '../error/error-figures.js';
import { CoreView } from './core-view.js';
import { type Axis, type Size, squareSide, type Stand, type Subject } from './stand.js';
import { converged } from './supersampling.js';

const SCALES = [0.35, 0.5, 0.71, 1, 1.41, 2] as const;
/** Of the reference, along each side of a pixel. */
const CONVERGED = 8;
const LIGHTS = 8;
const SCENES = { 'shininess 32': 32, 'shininess 1e3': 1e3 } as const;

export const scale: Axis = {
  title: 'The canvas’s own resolution',
  scenes: Object.keys(SCENES),
  open(name, { size, seed, evaluations }, holder) {
    const shininess = SCENES[name as keyof typeof SCENES];
    const view = new CoreView(
      holder,
      lightsOf({ lights: LIGHTS, active: LIGHTS, kind: 'mixed', seed }),
      true,
    );
    const scene = view.scene(new SphereGeometry(1.03, 128, 64), { shininess });
    const side = Math.min(size[1], squareSide(evaluations, LIGHTS));
    const subjects = SCALES.map((times): Subject => {
      const scaled = ([width, height]: Size): Size => [Math.round(width * times), Math.round(height * times)];
      return {
        id: String(times),
        label: `${String(times)} of the screen’s pixels a side`,
        gl: view.gl,
        draw: () => {
          view.draw(scene, scaled(size));
        },
        picture() {
          view.draw(scene, scaled([side, side]));
          return asShown(view.renderer.domElement, [side, side]);
        },
      };
    });
    const stand: Stand = {
      title: `The canvas’s own resolution: a sphere under 8 lights, ${name.replace('1e3', '1,000')}`,
      truth: `the mean of ${String(CONVERGED ** 2)} pictures of the same mesh, moved by parts of a pixel`,
      ...{ base: '1', shipped: '1', size, errorSize: [side, side], subjects },
      reference(pace) {
        const whole: Size = [side, side];
        return converged(view, scene, { size: whole, part: whole, x: 0, y: 0, side: CONVERGED }, pace);
      },
      close: () => {
        view.close();
      },
    };
    return Promise.resolve(stand);
  },
};

/** What the browser makes of a canvas of another size. */
function asShown(source: HTMLCanvasElement, [width, height]: Size): ColorPicture {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext('2d', { willReadFrequently: true })!;
  context.imageSmoothingQuality = 'low'; // bilinear, as when a page's canvas is scaled
  context.drawImage(source, 0, 0, width, height);
  const codes = context.getImageData(0, 0, width, height).data;
  const data = new Float64Array(width * height * 3);
  for (let i = 0; i < width * height; i++) for (let k = 0; k < 3; k++) data[3 * i + k] = codes[4 * i + k]!;
  return { width, height, data };
}
