// The lights of one list: all, or some of all, as if those alone had been packed; and when a program for exactly them is theirs.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { HEADER } from '../../src/light/light-layout.js';
import type { LightValues } from '../../src/light/light-state.js';
import type { PackedLights } from '../../src/light/pack-lights.js';
import { lightBlockOf } from '../../src/material/light-block.js';
import { LightList } from '../../src/material/light-list.js';
import { anyLight, light } from './arbitraries.js';
import { pack, read } from './packed-reader.js';

/** As declared, but on and in the order of their rows, and none that brings nothing. */
const shining = fc
  .array(anyLight, { minLength: 1, maxLength: 10 })
  .map((lights) => lights.map((one) => ({ ...one, active: true })).filter((one) => pack([one]).sent === 1))
  .map((lights) => [...lights].sort((a, b) => rank(a) - rank(b)));

const rank = (one: LightValues): number => pack([one]).counts.spot * 2 + pack([one]).counts.point;

const essence = ({ data, rows, sent, counts, shapes }: Readonly<PackedLights>): object => ({
  ...{ rows, sent, counts },
  data: [...data.slice(0, rows * 4)],
  shapes: [...shapes.slice(0, sent)],
});

const lamp = (x: number, values: Partial<LightValues> = {}): LightValues =>
  light({ position: [x, 2, 0, 1], ...values });

const spot = (x: number, values: Partial<LightValues> = {}): LightValues =>
  lamp(x, { axis: [0, -1, 0], aperture: 20, ...values });

describe('some of the lights', () => {
  it('are packed as they would be alone, but for the ambient light that all of them bring', () => {
    fc.assert(
      fc.property(shining, fc.array(fc.boolean(), { minLength: 10, maxLength: 10 }), (lights, wanted) => {
        const all = pack(lights);
        const list = new LightList();
        list.select(all, Uint8Array.from(wanted, Number));
        const alone = pack(lights.filter((_, i) => wanted[i]));
        alone.data.set(all.data.subarray(HEADER.ambient * 4, HEADER.ambient * 4 + 4), HEADER.ambient * 4);
        expect(essence(list.packed)).toStrictEqual(essence(alone));
        expect(list.packed.active).toBe(all.active);
      }),
      { numRuns: 300 },
    );
  });

  it('are selected anew in the same room, whatever was selected before', () => {
    const all = pack([light(), lamp(1), lamp(2), spot(3), spot(4)]);
    const list = new LightList();
    for (const mask of [
      [1, 1, 1, 1, 1],
      [0, 0, 0, 0, 0],
      [0, 1, 0, 0, 1],
      [1, 0, 0, 0, 0],
      [0, 0, 1, 1, 0],
    ]) {
      list.select(all, Uint8Array.from(mask));
      const { directional, point, spot: spots } = read(list.packed);
      expect([directional, point, spots].map(({ length }) => length)).toStrictEqual([
        mask[0],
        mask[1]! + mask[2]!,
        mask[3]! + mask[4]!,
      ]);
      expect(list.packed.sent).toBe(mask.reduce((sum, one) => sum + one, 0));
      expect([...point, ...spots].map((one) => one['position']!.xyz[0])).toStrictEqual(
        [1, 2, 3, 4].filter((i) => mask[i] === 1),
      );
    }
  });

  it('may be any number', () => {
    const all = pack(Array.from({ length: 100 }, (_, i) => spot(i, { cutoff: 1 + (i % 64) })));
    const list = new LightList();
    list.select(all, new Uint8Array(100).fill(1));
    expect(essence(list.packed)).toStrictEqual(essence(all));
  });

  it('leave all lights as they are', () => {
    const all = pack([lamp(1), lamp(2)]);
    const before = essence(all);
    new LightList().select(all, Uint8Array.of(0, 1));
    expect(essence(all)).toStrictEqual(before);
  });

  it('are sent as selected', () => {
    const list = new LightList();
    list.select(pack([lamp(1), lamp(2)]), Uint8Array.of(0, 1));
    const sent = (lightBlockOf(list.rows).group.uniforms[0] as unknown as { value: Float32Array }).value;
    expect([...sent.slice(0, list.packed.rows * 4)]).toStrictEqual([
      ...list.packed.data.slice(0, list.packed.rows * 4),
    ]);
  });
});

describe('the version of the shapes', () => {
  /** The version after each of these in turn, less the first one's. */
  const versions = (...states: readonly (readonly LightValues[])[]): number[] => {
    const list = new LightList();
    const all = states.map((lights) => {
      list.take(pack(lights));
      return list.shapeVersion;
    });
    return all.map((version) => version - all[0]!);
  };

  it('is another than that of a list that was never given any', () => {
    const list = new LightList();
    const { shapeVersion } = list;
    list.take(pack([]));
    expect(list.shapeVersion).not.toBe(shapeVersion);
  });

  it.each<[string, LightValues, LightValues]>([
    ['moves', lamp(1), lamp(7)],
    ['changes colour', lamp(1, { diffuse: [1, 2, 3] }), lamp(1, { diffuse: [0, 0, 9] })],
    ['turns', spot(1), spot(1, { axis: [1, 1, 1] })],
    ['widens its cone within 15°', spot(1, { aperture: 1 }), spot(1, { aperture: 14 })],
    ['widens its cone from 15° on', spot(1, { aperture: 15 }), spot(1, { aperture: 165 })],
    ['changes a cutoff that is not whole', spot(1, { cutoff: 65.5 }), spot(1, { cutoff: 99 })],
    [
      'changes how it is attenuated',
      lamp(1, { attenuation: [1, 1, 0] }),
      lamp(1, { attenuation: [2, 3, 2] }),
    ],
    ['brings other ambient light everywhere', lamp(1), lamp(1, { ambient: [9, 9, 9] })],
    [
      'is switched off, being black',
      lamp(1, { diffuse: [0, 0, 0], specular: [0, 0, 0] }),
      lamp(1, { active: false }),
    ],
  ])('stays where a light %s', (_, before, after) => {
    expect(versions([before, light()], [after, light()], [before, light()])).toStrictEqual([0, 0, 0]);
  });

  it.each<[string, LightValues, LightValues]>([
    ['loses its diffuse light', lamp(1), lamp(1, { diffuse: [0, 0, 0] })],
    ['loses its specular light', light(), light({ specular: [0, 0, 0] })],
    ['gets ambient light of its cone', spot(1), spot(1, { ambient: [9, 0, 0] })],
    ['becomes a spot', lamp(1), spot(1)],
    ['moves to infinity', lamp(1), light()],
    ['is switched off', lamp(1), lamp(1, { active: false })],
    ['is attenuated', lamp(1), lamp(1, { attenuation: [1, 1, 0] })],
    ['gets a decay', spot(1), spot(1, { cutoff: 0.5 })],
    ['gets a cutoff too large to be mild', spot(1, { cutoff: 0.5 }), spot(1, { cutoff: 99 })],
    ['gets another whole cutoff', spot(1, { cutoff: 7 }), spot(1, { cutoff: 8 })],
    ['opens beyond 15°', spot(1, { aperture: 14 }), spot(1, { aperture: 16 })],
    ['opens wholly', spot(1, { cutoff: 2 }), spot(1, { cutoff: 2, aperture: 180 })],
  ])('goes up where a light %s, and again where it is as before', (_, before, after) => {
    expect(versions([before, lamp(5)], [after, lamp(5)], [after, lamp(6)], [before, lamp(5)])).toStrictEqual([
      0, 1, 1, 2,
    ]);
  });

  it('goes up where lights change their places in the order, if they are of other shapes', () => {
    const faint = lamp(3, { specular: [0, 0, 0] });
    expect(versions([lamp(1), faint], [faint, lamp(1)])).toStrictEqual([0, 1]);
    expect(versions([lamp(1), lamp(2)], [lamp(2), lamp(1)])).toStrictEqual([0, 0]);
  });

  it('goes up where as many lights of the same shapes are of other kinds', () => {
    expect(versions([light(), lamp(1)], [lamp(1), lamp(2)])).toStrictEqual([0, 1]);
  });

  it('changes exactly when what a program is made for changes', () => {
    fc.assert(
      fc.property(fc.array(shining, { minLength: 2, maxLength: 5 }), (states) => {
        const list = new LightList();
        let [before, version] = ['', list.shapeVersion];
        for (const lights of states) {
          const packed = pack(lights);
          list.take(packed);
          const now = JSON.stringify([packed.counts, [...packed.shapes.slice(0, packed.sent)]]);
          expect(list.shapeVersion).toBe(version + Number(now !== before));
          [before, version] = [now, list.shapeVersion];
        }
      }),
    );
  });

  it('knows its own shapes where the lights are packed anew into the same room', () => {
    const list = new LightList();
    const packed = pack([lamp(1)]);
    list.take(packed);
    const { shapeVersion } = list;
    packed.shapes[0] = 0;
    list.take(packed);
    expect(list.shapeVersion).toBe(shapeVersion + 1);
  });
});
