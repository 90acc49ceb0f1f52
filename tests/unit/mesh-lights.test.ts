// Which lights each mesh is drawn with, and that this is found out only when it may have changed.

import { BoxGeometry, BufferGeometry, Mesh, Object3D } from 'three';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import * as lightReach from '../../src/light/cull-lights.js';
import type { LightValues } from '../../src/light/light-state.js';
import { lightBlockOf } from '../../src/material/light-block.js';
import type { LightList } from '../../src/material/light-list.js';
import { LightRows } from '../../src/material/light-buffer.js';
import { MeshLights, type ReachQuestion } from '../../src/material/mesh-lights.js';
import { light } from './arbitraries.js';
import { pack, read } from './packed-reader.js';

vi.mock(import('../../src/light/cull-lights.js'), async (original) => {
  const module = await original();
  return { ...module, reachedLights: vi.fn(module.reachedLights) };
});

const asked = vi.mocked(lightReach.reachedLights);
beforeEach(() => {
  asked.mockClear();
});

const QUESTION: ReachQuestion = {
  origin: [0, 0, 0],
  surface: { reflectance: { ka: [1, 1, 1], kd: [1, 1, 1], ks: [1, 1, 1] }, surfaceVersion: 1 },
  budget: 0,
};

/** A unit box at x. */
function meshAt(x: number, geometry: BufferGeometry = new BoxGeometry()): Mesh {
  const mesh = new Mesh(geometry);
  moveTo(mesh, x);
  return mesh;
}

function moveTo(mesh: Object3D, x: number): void {
  mesh.position.x = x;
  mesh.updateMatrixWorld();
}

/** Straight down on x, as wide as a unit box. */
const spotOver = (x: number, values: Partial<LightValues> = {}): LightValues =>
  light({ position: [x, 3, 0, 1], axis: [0, -1, 0], aperture: 15, ...values });

function lit(...lights: LightValues[]): MeshLights {
  const meshLights = new MeshLights();
  meshLights.take(pack(lights));
  return meshLights;
}

const chosen = (lights: MeshLights, mesh: Mesh, question: ReachQuestion): LightList =>
  lights.choose(mesh, question).list;

const spotsOf = (list: { packed: Parameters<typeof read>[0] }): number[] =>
  read(list.packed).spot.map((one) => one['position']!.xyz[0]);

describe('a mesh', () => {
  it('is drawn with the lights that reach it, and with all others that are no spots', () => {
    const lights = lit(spotOver(0), light(), spotOver(5), light({ position: [9, 9, 9, 1] }));
    const list = chosen(lights, meshAt(5), QUESTION);
    expect(spotsOf(list)).toStrictEqual([5]);
    expect(read(list.packed).counts).toStrictEqual([1, 1, 1]);
    expect(lights.all.packed.sent).toBe(4);
  });

  it('is drawn with all lights before it was asked after, and where all reach it', () => {
    const lights = lit(spotOver(0), light());
    const mesh = meshAt(0);
    expect(lights.of(mesh)).toBe(lights.all);
    expect(chosen(lights, mesh, QUESTION)).toBe(lights.all);
  });

  it('has its bounds turned, scaled and moved with it, relative to the origin that lights are packed about', () => {
    const lights = lit(spotOver(0), spotOver(5));
    const parent = new Object3D();
    const mesh = new Mesh(new BoxGeometry(0.1, 9, 0.1));
    parent.add(mesh);
    const reached = (origin: ReachQuestion['origin'] = [0, 0, 0]): number[] => {
      parent.updateMatrixWorld();
      lights.take(pack([spotOver(0), spotOver(5)])); // another origin is always another pack
      return spotsOf(chosen(lights, mesh, { ...QUESTION, origin }));
    };
    expect(reached()).toStrictEqual([0]);
    mesh.rotation.z = Math.PI / 2;
    mesh.scale.y = 0.9;
    expect(reached()).toStrictEqual([0]); // 4.05 to each side; the next cone is 0.8 wide there
    mesh.scale.y = 1;
    expect(reached()).toStrictEqual([0, 5]);
    parent.position.x = 50;
    expect(reached()).toStrictEqual([]);
    expect(reached([50, 0, 0])).toStrictEqual([0, 5]);
    expect(reached([45, 0, 0])).toStrictEqual([0, 5]);
    mesh.scale.y = 0.2;
    expect(reached([50, 0, 0])).toStrictEqual([0]);
    mesh.scale.y = -0.9;
    expect(reached([45, 0, 0])).toStrictEqual([5]);
  });

  it.each<[string, () => Mesh]>([
    ['without vertices', () => meshAt(0, new BufferGeometry())],
    ['nowhere', () => meshAt(NaN)],
    ['everywhere', () => meshAt(Infinity)],
  ])('%s is drawn with all lights', (_, make) => {
    const lights = lit(spotOver(99), light());
    const warned = vi.spyOn(console, 'error').mockReturnValue();
    expect(chosen(lights, make(), QUESTION)).toBe(lights.all);
    warned.mockRestore();
  });

  it('gets with a budget what is left of faint lamps, without one all of them', () => {
    const lamp = light({ position: [0, 99, 0, 1], attenuation: [0, 0, 1] });
    const lights = lit(lamp, light());
    expect(chosen(lights, meshAt(0), QUESTION)).toBe(lights.all);
    expect(asked).not.toHaveBeenCalled();
    const list = chosen(lights, meshAt(0), { ...QUESTION, budget: 0.01 });
    expect(read(list.packed).counts).toStrictEqual([1, 0, 0]);
  });

  it('keeps what its lights left of the budget for others to give up', () => {
    const lamp = light({ position: [0, 100.5, 0, 1], attenuation: [0, 0, 1], specular: [0, 0, 0] });
    const lights = lit(lamp, light());
    const mesh = meshAt(0);
    const left = (budget: number): number => lights.choose(mesh, { ...QUESTION, budget }).left;
    expect(left(0.01)).toBeCloseTo(0.01 - 1 / 100 ** 2, 9);
    expect(left(1e-9)).toBe(1e-9);
    expect(left(0)).toBe(0);
  });

  it('shares its list with others that the same lights reach', () => {
    const lights = lit(spotOver(0), spotOver(5));
    const [a, b, c] = [meshAt(5), meshAt(5.1), meshAt(0)].map((mesh) => chosen(lights, mesh, QUESTION));
    expect(a).toBe(b);
    expect(a).not.toBe(c);
    expect(spotsOf(c!)).toStrictEqual([0]);
  });
});

describe('nothing is found out anew', () => {
  it('while nothing changes', () => {
    const lights = lit(spotOver(0), spotOver(5));
    const mesh = meshAt(5);
    const list = chosen(lights, mesh, QUESTION);
    for (let frame = 0; frame < 5; frame++) {
      mesh.updateMatrixWorld(true);
      expect(chosen(lights, mesh, { ...QUESTION })).toBe(list);
    }
    expect(asked).toHaveBeenCalledTimes(1);
  });

  it('for a picture without spots', () => {
    const lights = lit(light(), light({ position: [9, 9, 9, 1] }));
    const mesh = meshAt(0);
    expect(chosen(lights, mesh, QUESTION)).toBe(lights.all);
    expect(mesh.geometry.boundingBox).toBeNull();
    expect(asked).not.toHaveBeenCalled();
  });

  it.each<[string, (lights: MeshLights, mesh: Mesh) => Partial<ReachQuestion>]>([
    ['the mesh moves', (_, mesh) => (moveTo(mesh, 1), {})],
    ['the mesh has another geometry', (_, mesh) => ((mesh.geometry = new BoxGeometry(2, 2, 2)), {})],
    ['the budget changes', () => ({ budget: 0.1 })],
    ['the lights change', (lights) => (lights.take(pack([spotOver(0), spotOver(5)])), {})],
  ])('but once where %s', (_, change) => {
    const lights = lit(spotOver(0), spotOver(5));
    const mesh = meshAt(5);
    chosen(lights, mesh, QUESTION);
    asked.mockClear();
    const question = { ...QUESTION, ...change(lights, mesh) };
    chosen(lights, mesh, question);
    chosen(lights, mesh, question);
    expect(asked).toHaveBeenCalledTimes(1);
  });

  it.each([
    ['but once where the surface changes and something may be given up', 0.1, 1],
    ['where the surface changes and nothing may be given up', 0, 0],
  ])('%s', (_, budget, times) => {
    const lights = lit(spotOver(0), spotOver(5));
    const mesh = meshAt(5);
    chosen(lights, mesh, { ...QUESTION, budget });
    asked.mockClear();
    const surface = { ...QUESTION.surface, surfaceVersion: 2 };
    chosen(lights, mesh, { ...QUESTION, budget, surface });
    chosen(lights, mesh, { ...QUESTION, budget, surface });
    expect(asked).toHaveBeenCalledTimes(times);
  });

  it('of a list that was selected for the same lights already', () => {
    const lights = lit(spotOver(0), spotOver(5));
    const written = vi.spyOn(LightRows.prototype, 'write');
    chosen(lights, meshAt(5), QUESTION);
    chosen(lights, meshAt(5.1), QUESTION);
    expect(written).toHaveBeenCalledTimes(1);
    written.mockRestore();
  });

  it('of a mesh that comes back to where it was: it has its list again', () => {
    const lights = lit(spotOver(0), spotOver(5));
    const mesh = meshAt(5);
    const list = chosen(lights, mesh, QUESTION);
    moveTo(mesh, 0);
    expect(spotsOf(chosen(lights, mesh, QUESTION))).toStrictEqual([0]);
    moveTo(mesh, 5);
    expect(chosen(lights, mesh, QUESTION)).toBe(list);
  });
});

describe('lights that move', () => {
  it('take a mesh’s list with them', () => {
    const lights = lit(spotOver(0), spotOver(5));
    const mesh = meshAt(5);
    const list = chosen(lights, mesh, QUESTION);
    const { shapeVersion } = list;
    lights.take(pack([spotOver(0), spotOver(5.1)]));
    expect(chosen(lights, mesh, QUESTION)).toBe(list);
    expect(read(list.packed).spot[0]!['position']!.xyz[0]).toBe(Math.fround(5.1));
    expect(list.shapeVersion).toBe(shapeVersion);
  });

  it('keep count of what freed lists have sent', () => {
    const lights = lit(spotOver(0), spotOver(5));
    const list = chosen(lights, meshAt(0), QUESTION);
    lightBlockOf(list.rows).send();
    lightBlockOf(lights.all.rows).send();
    expect(lights.uploads).toBe(2);
    for (let i = 0; i < 3; i++) lights.begin();
    expect(lights.uploads).toBe(2);
  });
});

it('a mesh that all lights have reached is asked about again where they move', () => {
  const lights = lit(spotOver(0));
  const mesh = meshAt(0);
  expect(chosen(lights, mesh, QUESTION)).toBe(lights.all);
  lights.take(pack([spotOver(5)]));
  expect(spotsOf(chosen(lights, mesh, QUESTION))).toStrictEqual([]);
});

describe('a frame', () => {
  const freed = vi.spyOn(LightRows.prototype, 'dispose');
  beforeEach(() => {
    freed.mockClear();
  });

  it.each<[string, (lights: MeshLights, i: number) => void]>([
    ['whose lights move', (lights, i) => lights.take(pack([spotOver(0), spotOver(5, { cutoff: i })]))],
    ['whose lights stand still', () => undefined],
  ])('%s frees the lists that the one before had no use for, and no others', (_, change) => {
    const lights = lit(spotOver(0), spotOver(5));
    const [stays, goes] = [meshAt(5), meshAt(0)];
    lights.begin();
    const [kept, lost] = [stays, goes].map((mesh) => chosen(lights, mesh, QUESTION));
    for (let i = 1; i < 4; i++) {
      lights.begin();
      change(lights, i);
      expect(chosen(lights, stays, QUESTION)).toBe(kept);
    }
    expect(freed.mock.contexts).toStrictEqual([lost!.rows]);
    const again = chosen(lights, goes, QUESTION);
    expect(again).not.toBe(lost);
    expect(spotsOf(again)).toStrictEqual([0]);
  });

  it('keeps no list of the places that a mesh has passed', () => {
    const lights = lit(...Array.from({ length: 20 }, (_, i) => spotOver(2 * i)));
    const mesh = meshAt(0);
    for (let x = 0; x < 40; x += 0.5) {
      lights.begin();
      moveTo(mesh, x);
      chosen(lights, mesh, QUESTION);
    }
    const before = freed.mock.contexts.length;
    lights.dispose();
    expect(freed.mock.contexts.length - before).toBeLessThanOrEqual(3); // all, the last and the one before
  });
});

describe('how many lights reach any of some meshes', () => {
  it('is all without meshes, or where one of them has all', () => {
    const lights = lit(spotOver(0), spotOver(5), spotOver(10));
    expect(lights.reaching([])).toBe(3);
    const mesh = meshAt(5);
    chosen(lights, mesh, QUESTION);
    expect(lights.reaching([mesh])).toBe(1);
    expect(lights.reaching([mesh, meshAt(0)])).toBe(3);
  });

  it('counts no light twice', () => {
    const lights = lit(spotOver(0), spotOver(5), spotOver(10), light());
    const meshes = [meshAt(5), meshAt(5.1), meshAt(0), meshAt(50)];
    for (const mesh of meshes) chosen(lights, mesh, QUESTION);
    expect(lights.reaching(meshes)).toBe(3);
    expect(meshes.map((mesh) => lights.of(mesh).packed.sent)).toStrictEqual([2, 2, 2, 1]);
  });
});

it('sends every list again after a loss, and frees every one', () => {
  const lights = lit(spotOver(0), spotOver(5));
  const lists = [lights.all, chosen(lights, meshAt(0), QUESTION), chosen(lights, meshAt(5), QUESTION)];
  for (const method of ['restore', 'dispose'] as const) {
    const called = vi.spyOn(LightRows.prototype, method);
    lights[method]();
    for (const list of lists) expect(called.mock.contexts).toContain(list.rows);
    called.mockRestore();
  }
});
