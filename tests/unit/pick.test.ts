// Which surface is seen at a pixel? The nearest of what three.js draws, or null if that is not one of the viewer's
// meshes.

import {
  BackSide,
  BoxGeometry,
  type BufferAttribute,
  type BufferGeometry,
  DynamicDrawUsage,
  Group,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  PlaneGeometry,
  Points,
  Scene,
  Sprite,
} from 'three';
import { beforeEach, describe, expect, it } from 'vitest';
import { Orbit } from '../../src/camera/orbit.js';
import type { Sides } from '../../src/material/back-faces.js';
import { PhongLighting } from '../../src/material/lighting.js';
import { PhongMaterial } from '../../src/material/phong-material.js';
import { drawnObjects, copyFrame, type SceneSnapshot } from '../../src/scene/snapshot/scene-snapshot.js';
import { distanceAlong, type Hit, pick } from '../../src/scene/snapshot/pick.js';
import type { Vec3 } from '../../src/math/vector.js';
import { cornersOf } from '../../src/scene/snapshot/corners.js';
import { Frame } from '../../src/scene/frame.js';

const lighting = new PhongLighting();
const SIZE = 100;

let scene: Scene;
let own: Mesh[];

/** A wall of ours at a distance of 3 from the eye, which looks along −z; nearer where `z` is above 0. */
function wall(z = 0, parent: Object3D = scene): Mesh {
  const mesh = new Mesh(new PlaneGeometry(1, 1), new PhongMaterial(lighting));
  mesh.position.z = z;
  own.push(mesh);
  parent.add(mesh);
  return mesh;
}

function look(column = 50, row = 50): Hit | null {
  const view = new Frame(new Orbit({ theta: 0, phi: 90, radius: 3 }));
  view.look(45, { width: SIZE, height: SIZE });
  view.aim(scene, { center: [0, 0, 0], radius: 2 });
  return pick(snapshotThrough(view), column, row);
}

function snapshotThrough({ camera, shading }: Frame): SceneSnapshot {
  scene.updateMatrixWorld();
  const objects = drawnObjects(scene, camera, (object) =>
    own.includes(object as Mesh) ? 'ours' : undefined,
  );
  return { width: SIZE, height: SIZE, frame: copyFrame(shading), camera: camera.clone(), objects };
}

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
    for (const foreign of [new Mesh(new BoxGeometry(0.2, 0.2, 0.2), new MeshBasicMaterial()), new Sprite()]) {
      scene.add(foreign);
      foreign.position.set(0, 0, 1);
      expect(look(), foreign.type).toBeNull();
      foreign.position.set(0, 0, -1);
      expect(look(), foreign.type).not.toBeNull();
      foreign.position.set(0.8, 0, 1);
      expect(look(), foreign.type).not.toBeNull();
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
    for (const [i, object] of [
      new Line(flat, new LineBasicMaterial()),
      new Points(flat),
      new Mesh(flat, new MeshBasicMaterial({ side: BackSide })),
    ].entries()) {
      object.position.z = 0.2 * (i + 1);
      scene.add(object);
    }
    expect(look()!.drawn.object).toBe(mesh);
  });

  describe('with back faces that are culled', () => {
    /** A closed box around the origin, and a wall behind it. */
    const boxWithWall = (sides: Sides): { box: Mesh; behind: Mesh } => {
      const behind = wall(-1);
      const box = new Mesh(new BoxGeometry(1, 1, 1), new PhongMaterial(lighting));
      Object.assign(box.material, { sides });
      own.push(box);
      scene.add(box);
      return { box, behind };
    };

    it('sees the inside of a closed shape from inside, and looks through its back from outside', () => {
      const { box, behind } = boxWithWall('closed');
      box.geometry.setDrawRange(30, 6); // only the face that looks along −z
      expect(look()!.drawn.object).toBe(behind);
      box.scale.setScalar(4);
      box.position.z = 1.5;
      behind.visible = false;
      expect(look()!.drawn.object).toBe(box);
      box.scale.setScalar(1);
      box.position.z = 0;
      (box.material as PhongMaterial & { sides: Sides }).sides = 'double';
      behind.visible = true;
      expect(look()!.drawn.object).toBe(box);
    });
  });

  it('does not change when the camera moves afterwards', () => {
    wall();
    const orbit = new Orbit({ theta: 0, phi: 90, radius: 3 });
    const view = new Frame(orbit);
    view.look(45, { width: SIZE, height: SIZE });
    view.aim(scene, null);
    const snapshot = snapshotThrough(view);
    const before = pick(snapshot, 50, 50)!;
    const eye = [...before.frame.eye];
    orbit.set({ theta: 90, radius: 7 });
    view.look(45, { width: SIZE, height: SIZE });
    view.aim(scene, null);
    expect(before.frame.eye).toEqual(eye);
    expect(pick(snapshot, 50, 50)).toEqual(before);
  });

  it('does not change when the scene changes afterwards, own and foreign meshes alike', () => {
    const mesh = wall();
    const foreign = new Mesh(new BoxGeometry(0.2, 0.2, 0.2), new MeshBasicMaterial());
    foreign.position.set(0.5, 0, 1);
    scene.add(foreign);
    const view = new Frame(new Orbit({ theta: 0, phi: 90, radius: 3 }));
    view.look(45, { width: SIZE, height: SIZE });
    view.aim(scene, null);
    const snapshot = snapshotThrough(view);
    const { depth } = pick(snapshot, 50, 50)!;
    const material = mesh.material as PhongMaterial;
    const { surface } = material;
    mesh.position.z = 1;
    mesh.geometry = new PlaneGeometry(5, 5);
    material.setSurface({ shininess: 7 });
    foreign.position.x = 0;
    scene.updateMatrixWorld();
    const hit = pick(snapshot, 50, 50)!;
    expect(hit.depth).toBe(depth);
    expect(hit.drawn.phong.surface).toBe(surface);
    expect(foreign.matrixWorld.elements[12]).toBe(0);
    expect(pick(snapshotThrough(view), 50, 50)).toBeNull();
  });
});

describe('the corners of what was picked', () => {
  const normalsOf = (): number[][] => cornersOf(look()!).map(({ N }) => N.map((x) => x + 0));

  it('have unit normals on the side that is seen, mirrored, flattened and from behind too', () => {
    const mesh = wall();
    for (const [x, y, z] of [
      [1, 1, 1],
      [-1, 1, 1],
      [2, 3, 0],
      [1, 1, -4],
    ] as const) {
      mesh.scale.set(x, y, z);
      expect(normalsOf(), `scale ${x} ${y} ${z}`).toEqual([
        [0, 0, 1],
        [0, 0, 1],
        [0, 0, 1],
      ]);
    }
    mesh.scale.set(1, 1, 1);
    mesh.rotation.y = Math.PI;
    for (const N of normalsOf()) expect(N[2]).toBeCloseTo(1, 12);
  });

  it('have no normals if the geometry has none', () => {
    wall().geometry.deleteAttribute('normal');
    expect(normalsOf()).toEqual([
      [0, 0, 0],
      [0, 0, 0],
      [0, 0, 0],
    ]);
  });
});

describe('a snapshot of an animated mesh', () => {
  const view = new Frame(new Orbit({ theta: 0, phi: 90, radius: 3 }));
  const taken = (): BufferGeometry | undefined =>
    snapshotThrough(view).objects.find(({ object }) => object === own[0])?.geometry;

  function animated(): BufferGeometry {
    const { geometry } = wall();
    (geometry.getAttribute('position') as BufferAttribute).setUsage(DynamicDrawUsage);
    return geometry;
  }

  it('shares them with the next one while the mesh does not move, so that a probe copies nothing', () => {
    const geometry = animated();
    const before = taken();
    expect(taken()).toBe(before);
    geometry.setAttribute('normal', (geometry.getAttribute('normal') as BufferAttribute).clone());
    expect(taken()).not.toBe(before);
  });
});

describe('the distance along a ray', () => {
  const along = (from: Vec3, direction: Vec3): number => {
    const view = new Frame(new Orbit({ theta: 0, phi: 90, radius: 3 }));
    view.look(45, { width: SIZE, height: SIZE });
    view.aim(scene, { center: [0, 0, 0], radius: 2 });
    return distanceAlong(snapshotThrough(view), from, direction);
  };

  it("ends at a page author's own mesh too", () => {
    wall(0);
    const other = new Mesh(new PlaneGeometry(1, 1), new MeshBasicMaterial());
    other.position.z = 1;
    scene.add(other);
    expect(along([0.1, 0.2, 5], [0, 0, -1])).toBeCloseTo(4, 12);
  });
});
