// How time grows with what there is more of: lights, pixels, triangles, meshes. Subjects are sizes; their ids are how many.
import { BoxGeometry, Object3D, SphereGeometry } from 'three';
import { isSoftware } from '../sampling.mjs';
import { rendererName } from '../../glsl/float-pass.js';
import { lightsOf } from '../pages/scenes.js';
import { CoreView } from './core-view.js';
import { floatCanvas, Floor } from './floor.js';
import { floorUnder } from './floor-scenes.js';
import { loopsOf } from './loops.js';
import { type Axis, type Size, type Stand, type StandOptions, type Subject } from './stand.js';

const powers = (base: number, from: number, to: number): number[] =>
  Array.from({ length: to - from + 1 }, (_, i) => base ** (from + i));

type Opener = (options: StandOptions, holder: HTMLElement) => Pick<Stand, 'title' | 'subjects' | 'close'>;

const SHININESS = 32;

/** By the shipped loop, as it is once settled. */
const lights: Opener = ({ size, seed }, holder) => {
  const { gl, close } = floatCanvas(holder, size);
  const software = isSoftware(rendererName(gl));
  const subjects = powers(2, 0, 10).map((count) => {
    const scene = floorUnder(count, seed);
    const shipped = loopsOf(scene, software).find(({ id }) => id === 'shipped')!;
    return named(count, new Floor(gl, scene, size, size).subject(shipped));
  });
  return { title: 'lights', subjects, close };
};

const pixels: Opener = ({ size: [width, height], seed }, holder) => {
  const view = new CoreView(holder, lightsOf({ lights: 8, active: 8, kind: 'mixed', seed }), true);
  const scene = view.scene(new SphereGeometry(1.03, 64, 32), { shininess: SHININESS });
  const subjects = powers(Math.SQRT1_2, 0, 8)
    .map((times): Size => [Math.round(width * times), Math.round(height * times)])
    .map((size) => drawn(view, size[0] * size[1], () => view.draw(scene, size)));
  return { title: 'pixels', subjects, close: () => view.close() };
};

/** Of so few pixels that fragments cost little. */
const FEW: Size = [64, 64];

const triangles: Opener = ({ seed }, holder) => {
  const view = new CoreView(holder, lightsOf({ lights: 8, active: 8, kind: 'mixed', seed }), false);
  const subjects = powers(2, 3, 9).map((segments) => {
    const geometry = new SphereGeometry(1.03, segments, segments / 2);
    const scene = view.scene(geometry, { shininess: SHININESS });
    return drawn(view, geometry.index!.count / 3, () => view.draw(scene, FEW));
  });
  return { title: 'triangles', subjects, close: () => view.close() };
};

const meshes: Opener = ({ seed }, holder) => {
  const view = new CoreView(holder, lightsOf({ lights: 8, active: 8, kind: 'mixed', seed }), false);
  const geometry = new BoxGeometry();
  const subjects = powers(2, 0, 5).map((side) => {
    const places = Array.from({ length: side * side }, (_, k) => {
      const box = new Object3D();
      box.position.set(((k % side) + 0.5) / side - 0.5, (Math.floor(k / side) + 0.5) / side - 0.5, 0);
      box.scale.setScalar(0.8 / side);
      return box;
    });
    const scene = view.scene(geometry, { shininess: SHININESS }, places);
    return drawn(view, side * side, () => view.draw(scene, FEW));
  });
  return { title: 'meshes', subjects, close: () => view.close() };
};

const named = (count: number, { gl, draw, picture }: Subject): Subject => ({
  ...{ id: String(count), label: count.toLocaleString('en') },
  ...{ gl, draw, picture },
});

const drawn = (view: CoreView, count: number, draw: () => void): Subject =>
  named(count, {
    ...{ id: '', label: '', gl: view.gl, draw },
    picture: () => {
      throw new Error('growth has no errors');
    },
  });

const OPENERS: Readonly<Record<string, Opener>> = { lights, pixels, triangles, meshes };

export const growth: Axis = {
  title: 'Growth',
  scenes: Object.keys(OPENERS),
  open(name, options, holder) {
    const { title, subjects, close } = OPENERS[name]!(options, holder);
    const { size } = options;
    const [{ id }] = subjects as [Subject];
    const reference = (): never => {
      throw new Error('growth has no errors');
    };
    const stand = {
      title,
      truth: '',
      base: id,
      shipped: id,
      size,
      errorSize: size,
      subjects,
      reference,
      close,
    };
    return Promise.resolve(stand);
  },
};
