// How often a sphere is shaded: per triangle, vertex or fragment, on ever finer meshes.
import { SphereGeometry } from 'three';
import { flatGeometry, LightState } from 'phong-viewer/core';
import { lightsOf } from '../pages/scenes.js';
import { CoreView } from './core-view.js';
import { roundSphere } from './sphere.js';
import { type Axis, squareSide, type Stand, type Subject } from './stand.js';

const SEGMENTS = [8, 16, 32, 64, 128, 256] as const;
const QUICK_SIDE = 128;
const QUICK_SEGMENTS = 128;
const SHADINGS = ['flat', 'gouraud', 'phong'] as const;

/** `64` is what the element's sphere has. */
const SHIPPED = 'phong 64';

const SCENES = { '1 directional': [1, 'directional'], '8 mixed': [8, 'mixed'] } as const;
const SHININESS = 32;
/** Fills nine tenths of the picture's height. */
const BALL = { center: [0, 0, 0], radius: 1.03 } as const;

export const shading: Axis = {
  title: 'How often a mesh is shaded',
  scenes: Object.keys(SCENES),
  open(name, { size, seed, evaluations, quick = false }, holder) {
    const [count, kind] = SCENES[name as keyof typeof SCENES];
    const values = lightsOf({ lights: count, active: count, kind, seed }).map(
      (v) => new LightState(v).values,
    );
    const view = new CoreView(holder, values, false);
    const side = squareSide(evaluations, count, quick ? QUICK_SIDE : undefined);
    const segmentsOf = quick ? SEGMENTS.filter((n) => n <= QUICK_SEGMENTS) : SEGMENTS;
    const subjects = segmentsOf.flatMap((segments) => {
      const geometry = new SphereGeometry(BALL.radius, segments, segments / 2);
      return SHADINGS.map((style): Subject => {
        const shape = style === 'flat' ? flatGeometry(geometry) : geometry;
        const scene = view.scene(shape, { shininess: SHININESS, style: { shading: style } });
        return {
          id: `${style} ${String(segments)}`,
          label: `${style}, ${String(segments)} segments`,
          gl: view.gl,
          draw: () => {
            view.draw(scene, size);
          },
          picture() {
            view.draw(scene, [side, side]);
            return view.read([side, side]);
          },
        };
      });
    });
    const stand: Stand = {
      title: `How often a sphere is shaded: ${name.replace('mixed', 'lights of mixed kinds').replace('directional', 'directional light')}`,
      truth: 'the round sphere in float64, one sample a pixel',
      ...{ base: SHIPPED, shipped: SHIPPED, size, errorSize: [side, side], subjects },
      reference: (pace) => roundSphere(BALL, side, values, SHININESS, pace),
      close: () => {
        view.close();
      },
    };
    return Promise.resolve(stand);
  },
};
