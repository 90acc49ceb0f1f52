// Which surface is seen at a pixel? The nearest of what three.js draws, or null if that is not one
// of the viewer's meshes.

import {
  BackSide,
  BoxGeometry,
  BufferAttribute,
  type BufferGeometry,
  Group,
  Line,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  PlaneGeometry,
  Points,
  Scene,
  Sprite,
} from 'three';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { Orbit } from '../../../src/phong/camera/orbit.js';
import { dot, length, subtract, type Vec3 } from '../../../src/phong/math/vector.js';
import { PhongLighting } from '../../../src/phong/material/lighting.js';
import { PhongMaterial } from '../../../src/phong/material/phong-material.js';
import {
  copyFrame,
  drawnObjects,
  type SceneSnapshot,
} from '../../../src/phong/geometry/scene-snapshot.js';
import {
  cornersOf,
  distanceAlong,
  type Hit,
  pick,
  pickNear,
  type SeenHit,
} from '../../../src/extras/explain/pick.js';
import { shadeAt } from '../../../src/extras/explain/shade-at.js';
import type { ViewerSnapshot } from '../../../src/viewer/element/viewer/extra-host.js';
import { createGeometry, type GeometryName } from '../../../src/phong/model/shapes/shapes.js';
import { Frame } from '../../../src/viewer/scene/frame.js';
import { answerOf, stepsOf } from './answer-of.js';

const lighting = new PhongLighting();
const SIZE = 100;

let scene: Scene;
let own: Mesh[];

/**
 * A wall of ours at a distance of 3 from the eye, which looks along −z; nearer where `z` is above
 * 0.
 */
function wall(z = 0, parent: Object3D = scene): Mesh {
  const mesh = new Mesh(new PlaneGeometry(1, 1), new PhongMaterial(lighting));
  mesh.position.z = z;
  own.push(mesh);
  parent.add(mesh);
  return mesh;
}

/** From 3 away, along −z. */
function aimed(orbit = new Orbit({ theta: 0, phi: 90, radius: 3 })) {
  const view = new Frame(orbit);
  view.update(45, { width: SIZE, height: SIZE });
  view.aim(scene, { center: [0, 0, 0], radius: 2 });
  return view;
}

function snapshotThrough({ camera, shading } = aimed()): SceneSnapshot {
  scene.updateMatrixWorld();
  const objects = drawnObjects(scene, camera, (object) =>
    own.includes(object as Mesh) ? 'ours' : undefined,
  );
  return { width: SIZE, height: SIZE, frame: copyFrame(shading), camera: camera.clone(), objects };
}

const look = (snapshot = snapshotThrough()): SeenHit | null => answerOf(pick(snapshot, 50, 50));

beforeEach(() => {
  scene = new Scene();
  own = [];
});

describe('the pick', () => {
  it('ignores what is not drawn: hidden objects, parents and materials, and other layers', () => {
    const seen = wall(0);
    const group = new Group();
    group.visible = false;
    scene.add(group);
    wall(0.5, group);
    wall(0.6).visible = false;
    (wall(0.7).material as PhongMaterial).visible = false;
    wall(0.8).layers.set(1);
    expect(look()!.drawn.object).toBe(seen);
  });

  it('finds a visible child of a parent in another layer', () => {
    const group = new Group();
    group.layers.set(1);
    scene.add(group);
    const child = wall(0, group);
    expect(look()!.drawn.object).toBe(child);
  });

  it('is the later of two that are equally near, as the depth test decides', () => {
    wall();
    const later = wall();
    expect(look()!.drawn.object).toBe(later);
  });

  it('is never in front of the near plane or behind the eye', () => {
    wall(2.9999);
    wall(4);
    expect(look()).toBeNull();
  });

  it('is null where a foreign mesh or sprite is nearer, and only there', () => {
    wall();
    for (const foreign of [
      new Mesh(new BoxGeometry(0.2, 0.2, 0.2), new MeshBasicMaterial()),
      new Sprite(),
    ]) {
      scene.add(foreign);
      const isNull = ([x, z]: readonly [number, number]) => {
        foreign.position.set(x, 0, z);
        return look() === null;
      };
      const places = [[0, 1], [0, -1], [0.8, 1]] as const; // oxfmt-ignore
      expect(places.map(isNull), foreign.type).toEqual([true, false, false]);
      foreign.removeFromParent();
    }
  });

  it('counts a mesh as ours by its owner, not by its material', () => {
    const mesh = wall();
    own = [];
    expect(look()).toBeNull();
    own = [mesh];
    expect(look()).not.toBeNull();
    mesh.material = new MeshBasicMaterial();
    expect(look()).toBeNull();
  });

  it('looks through lines and points, and through faces that three.js culls', () => {
    const mesh = wall();
    const flat = new PlaneGeometry(1, 1);
    const culled = new Mesh(flat, new MeshBasicMaterial({ side: BackSide }));
    for (const [i, object] of [new Line(flat), new Points(flat), culled].entries()) {
      object.position.z = 0.2 * (i + 1);
      scene.add(object);
    }
    expect(look()!.drawn.object).toBe(mesh);
  });

  it('sees the inside of a closed shape from inside, and looks through its back from outside', () => {
    const behind = wall(-1);
    const material = new PhongMaterial(lighting);
    material.sides = 'closed';
    const box = new Mesh(new BoxGeometry(1, 1, 1), material);
    own.push(box);
    scene.add(box);
    box.geometry.setDrawRange(30, 6); // only the face that looks along −z
    expect(look()!.drawn.object).toBe(behind);
    box.scale.setScalar(4);
    box.position.z = 1.5;
    behind.visible = false;
    expect(look()!.drawn.object).toBe(box);
    box.scale.setScalar(1);
    box.position.z = 0;
    material.sides = 'double';
    behind.visible = true;
    expect(look()!.drawn.object).toBe(box);
  });

  it('does not change when camera and own meshes change afterwards', () => {
    const mesh = wall();
    const orbit = new Orbit({ theta: 0, phi: 90, radius: 3 });
    const view = aimed(orbit);
    const snapshot = snapshotThrough(view);
    const before = look(snapshot)!;
    const { depth } = before;
    const eye = [...before.frame.eye];
    const material = mesh.material as PhongMaterial;
    const { surface } = material;
    mesh.position.z = 1;
    mesh.geometry = new PlaneGeometry(5, 5);
    material.setSurface({ shininess: 7 });
    expect(look(snapshotThrough(view))?.depth).toBeCloseTo(depth - 1, 12);
    orbit.set({ theta: 90, radius: 7 });
    view.update(45, { width: SIZE, height: SIZE });
    view.aim(scene, null);
    expect(before.frame.eye).toEqual(eye);
    const hit = look(snapshot)!;
    expect(hit).toEqual(before);
    expect(hit.depth).toBe(depth);
    expect(hit.drawn.phong.surface).toBe(surface);
  });
});

describe('the surface nearest to a point', () => {
  const POINTS = 10_000;

  /** Points of a round shape, spread evenly: multiples of irrational numbers. */
  async function* pointsOf(name: GeometryName): AsyncGenerator<Vec3> {
    const geometry = await createGeometry(name, 300, false);
    const position = geometry.getAttribute('position');
    const index = geometry.index!;
    for (let k = 0; k < POINTS; k++) {
      const triangle = Math.floor((index.count / 3) * ((k * Math.SQRT2) % 1));
      const share = Math.sqrt((k * 0.7548776662) % 1);
      const across = (k * 0.5698402909) % 1;
      const weights: Vec3 = [1 - share, share * (1 - across), share * across];
      const along = (axis: number) =>
        dot(
          weights,
          [0, 1, 2].map((corner) =>
            position.getComponent(index.getX(3 * triangle + corner), axis),
          ) as unknown as Vec3,
        );
      yield [along(0), along(1), along(2)];
    }
  }

  it.each(['sphere', 'torus', 'teapot'] as const)(
    'is found for each point of a %s, at its outline too',
    async (name) => {
      const mesh = wall();
      mesh.geometry = await createGeometry(name, undefined, true);
      const snapshot = snapshotThrough();
      let missed = 0;
      let farthest = 0;
      for await (const point of pointsOf(name)) {
        const hit = answerOf(pickNear(snapshot, point));
        if (hit === null) {
          missed += 1;
        } else {
          farthest = Math.max(farthest, length(subtract(hit.p, point)));
        }
      }
      expect(missed).toBe(0);
      expect(farthest).toBeLessThan(0.002);
    },
    60_000,
  );

  it('is none for a point that is farther from all than a two-hundredth of the eye is from it', () => {
    wall();
    const snapshot = snapshotThrough();
    expect(answerOf(pickNear(snapshot, [0.1, 0.1, 0.02]))).toBeNull();
    expect(answerOf(pickNear(snapshot, [0.52, 0, 0]))).toBeNull();
    const beside = answerOf(pickNear(snapshot, [0.51, 0.1, 0]))!;
    expect(beside.p.map((x) => Number(x.toFixed(9)) + 0)).toEqual([0.5, 0.1, 0]);
    expect(beside.front).toBe(true);
  });
});

describe('the corners of what was picked', () => {
  const normalsOf = () => cornersOf(look()!).map(({ N }) => N.map((x) => x + 0));

  it('have unit normals on the side that is seen, mirrored, flattened and from behind too', () => {
    const mesh = wall();
    for (const scale of ['1 1 1', '-1 1 1', '2 3 0', '1 1 -4']) {
      mesh.scale.fromArray(scale.split(' ').map(Number));
      expect(normalsOf(), `scale ${scale}`).toEqual(Array(3).fill([0, 0, 1]));
    }
    mesh.scale.set(1, 1, 1);
    mesh.rotation.y = Math.PI;
    for (const N of normalsOf()) {
      expect(N[2]).toBeCloseTo(1, 12);
    }
  });

  it('have no normals if the geometry has none', () => {
    wall().geometry.deleteAttribute('normal');
    expect(normalsOf()).toEqual(Array(3).fill([0, 0, 0]));
  });
});

it("measures a distance along a ray to a page author's own mesh too", () => {
  wall(0);
  const other = new Mesh(new PlaneGeometry(1, 1), new MeshBasicMaterial());
  other.position.z = 1;
  scene.add(other);
  const distance = answerOf(distanceAlong(snapshotThrough(), [0.1, 0.2, 5], [0, 0, -1]));
  expect(distance).toBeCloseTo(4, 12);
});

describe('a search in a pile of triangles', () => {
  /** The wall's triangles so many times, in one place. */
  function pile(
    copies: number,
    look: ConstructorParameters<typeof PhongMaterial>[1] = {},
  ): { readonly mesh: Mesh; readonly reads: () => number } {
    const mesh = wall();
    const { geometry } = mesh as Mesh<BufferGeometry>;
    const { array } = geometry.index!;
    const index = new Uint16Array(copies * array.length);
    for (let at = 0; at < index.length; at += array.length) {
      index.set(array, at);
    }
    geometry.setIndex(new BufferAttribute(index, 1));
    const colors = new BufferAttribute(new Float32Array(12).fill(1), 3);
    let reads = 0;
    colors.getComponent = (i, c) => {
      reads += 1;
      return colors.array[3 * i + c]!;
    };
    geometry.setAttribute('color', colors);
    mesh.material = new PhongMaterial(lighting, { vertexColors: true, ...look });
    return { mesh, reads: () => reads };
  }
  const COPIES = 2 ** 15;
  /** Three numbers of three corners. */
  const READ_ONCE = 9;
  /** Each with what a triangle and its box count at most. */
  const searches = [
    ['seen at a pixel', (snapshot: SceneSnapshot) => pick(snapshot, 50, 50), 2],
    ['nearest to a point', (snapshot: SceneSnapshot) => pickNear(snapshot, [0.01, 0.02, 0]), 24],
  ] as const;

  it.each(searches)('reads the colour of one surface: the one %s', (_, search, most) => {
    const { mesh, reads } = pile(COPIES);
    const { answer, steps } = stepsOf<Hit | null>(search(snapshotThrough()));
    expect(answer!.drawn.object).toBe(mesh);
    expect(answer!.triangle).toBeGreaterThanOrEqual(2 * COPIES - 2);
    expect(reads()).toBe(READ_ONCE);
    // Boxes around the triangles, then the triangles, and half of these are hit.
    const least = (4 * COPIES) / 2 ** 14;
    expect([steps >= least, steps <= most * least]).toEqual([true, true]);
  });

  it('reads more only where a mask may cut it out, in steps that are as much shorter', () => {
    const { reads } = pile(COPIES, { alphaMode: 'mask', alphaCutoff: 2 });
    const { answer, steps } = stepsOf<Hit | null>(pick(snapshotThrough(), 50, 50));
    expect(answer).toBeNull();
    expect(reads()).toBe(COPIES * READ_ONCE);
    expect(steps).toBeGreaterThan(COPIES / 2 ** 10);
  });

  it('begins at once, and looks at the clock after each step to end a task', async () => {
    let [tasks, now] = [0, 0];
    vi.spyOn(performance, 'now').mockImplementation(() => now++);
    class CountedChannel extends MessageChannel {
      constructor() {
        super();
        tasks += 1;
      }
    }
    vi.stubGlobal('MessageChannel', CountedChannel);
    const tasksWith = async (copies: number) => {
      const { mesh } = pile(copies);
      tasks = 0;
      const whole = { scene: snapshotThrough(), width: SIZE, height: SIZE, lights: [] };
      const found = await shadeAt(whole as unknown as ViewerSnapshot, 50, 50);
      expect(found?.object).toBe(mesh);
      mesh.removeFromParent();
      return tasks;
    };
    expect(await tasksWith(2 ** 10)).toBe(0);
    // 2^18 triangles and their boxes are 32 steps or more, 8 in a task.
    expect(await tasksWith(2 ** 17)).toBeGreaterThanOrEqual(4);
    vi.restoreAllMocks();
    vi.unstubAllGlobals();
  });
});
