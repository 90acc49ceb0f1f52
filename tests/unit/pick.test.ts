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
  LinearFilter,
  LinearMipmapLinearFilter,
  type MagnificationTextureFilter,
  Mesh,
  MeshBasicMaterial,
  type MinificationTextureFilter,
  NearestFilter,
  NearestMipmapNearestFilter,
  type Object3D,
  PlaneGeometry,
  Points,
  Scene,
  Sprite,
  Texture,
} from 'three';
import fc from 'fast-check';
import { beforeEach, describe, expect, it } from 'vitest';
import { Orbit } from '../../src/camera/orbit.js';
import type { Sides } from '../../src/material/back-faces.js';
import type { BaseLook } from '../../src/material/file-surface.js';
import { PhongLighting } from '../../src/material/lighting.js';
import type { ShadingStyle } from '../../src/material/material-values.js';
import { PhongMaterial } from '../../src/material/phong-material.js';
import { drawnObjects, copyFrame, type SceneSnapshot } from '../../src/scene/snapshot/scene-snapshot.js';
import { distanceAlong, type Hit, pick } from '../../src/scene/snapshot/pick.js';
import type { Vec3 } from '../../src/math/vector.js';
import { cornersOf } from '../../src/scene/snapshot/corners.js';
import { ViewCamera } from '../../src/scene/view-camera.js';

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
  const view = new ViewCamera(new Orbit({ theta: 0, phi: 90, radius: 3 }));
  view.aim(45, scene, { center: [0, 0, 0], radius: 2 }, SIZE, SIZE);
  return pick(snapshotThrough(view), column, row);
}

function snapshotThrough({ camera, frame }: ViewCamera): SceneSnapshot {
  scene.updateMatrixWorld();
  const objects = drawnObjects(scene, camera, (object) =>
    own.includes(object as Mesh) ? 'ours' : undefined,
  );
  return { width: SIZE, height: SIZE, frame: copyFrame(frame), camera: camera.clone(), objects };
}

beforeEach(() => {
  scene = new Scene();
  own = [];
});

describe('the pick', () => {
  it('is the nearest of our meshes, wherever it is in the tree', () => {
    const group = new Group();
    group.position.z = 0.5;
    scene.add(group);
    const nearest = wall(0.5, group);
    wall(0.9);
    wall(-1);
    expect(look()!.drawn.object).toBe(nearest);
    expect(look()!.depth).toBeCloseTo(2, 12);
    expect(look(0, 0)).toBeNull();
  });

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

  it('respects the draw range of the geometry', () => {
    wall(0.5).geometry.setDrawRange(0, 3); // the upper left half
    const behind = wall(0);
    expect(look(40, 40)!.depth).toBeCloseTo(2.5, 12);
    expect(look(60, 60)!.drawn.object).toBe(behind);
  });

  it('is the later of two that are equally near, as the depth test decides', () => {
    wall();
    const later = wall();
    expect(look()!.drawn.object).toBe(later);
  });

  it('is the same face of a flattened box everywhere', () => {
    const box = new Mesh(new BoxGeometry(1, 1, 1), new PhongMaterial(lighting));
    box.scale.set(1, 1, 0);
    box.rotation.set(0.3, 0.5, 0.7);
    own.push(box);
    scene.add(box);
    const faces = new Set<number>();
    for (let at = 40; at <= 60; at++) faces.add(Math.floor(look(at, 97 - at)!.triangle / 2));
    expect([...faces]).toEqual([5]); // the last of its six
  });

  describe('is filtered', () => {
    /** Width of a pixel on a wall at z = 0. */
    const PIXEL = (2 * 3 * Math.tan(Math.PI / 8)) / SIZE;
    const textureOf = (size: number, minFilter: MinificationTextureFilter = LinearMipmapLinearFilter) =>
      Object.assign(new Texture(), { image: { width: size, height: size }, minFilter });
    const texturedWall = (given: Partial<BaseLook>, style: Partial<ShadingStyle> = {}): Mesh => {
      const mesh = wall();
      const material = new PhongMaterial(lighting, given);
      material.setStyle(style);
      mesh.material = material;
      return mesh;
    };
    const glowing = (emissiveMap: Texture): Mesh => texturedWall({ emissive: [1, 1, 1], emissiveMap });

    it('where a pixel has more than one texel, however the texture is turned, repeated and moved', () => {
      const some = (min: number, max: number) => fc.double({ min, max, noNaN: true });
      fc.assert(
        fc.property(some(0, 360), some(1, 4), some(0.3, 3), some(-0.5, 2), (turn, repeat, texels, z) => {
          fc.pre(Math.abs(texels - 1) > 0.002);
          const size = 1024;
          const texture = textureOf(size);
          texture.repeat.set(repeat, repeat);
          texture.rotation = turn;
          texture.updateMatrix();
          const mesh = glowing(texture);
          // As large as it takes for so many texels in a pixel.
          mesh.scale.setScalar((size * repeat * PIXEL * (1 - z / 3)) / texels);
          mesh.rotation.z = 3 * turn;
          mesh.position.z = z;
          expect(look(47, 58)!.filtered).toBe(texels > 1);
          mesh.removeFromParent();
          own = [];
        }),
      );
    });

    it('where one direction has more than one texel', () => {
      const mesh = glowing(textureOf(64));
      mesh.scale.setScalar(64 * PIXEL); // at its own size
      expect(look()!.filtered).toBe(false);
      mesh.rotation.x = 1;
      expect(look()!.filtered).toBe(true);
    });

    it('only by filters that magnification does not have', () => {
      const filtered = (min: MinificationTextureFilter, mag: MagnificationTextureFilter): boolean => {
        const mesh = glowing(Object.assign(textureOf(1024, min), { magFilter: mag }));
        const hit = look()!;
        mesh.removeFromParent();
        return hit.filtered;
      };
      expect(filtered(LinearFilter, LinearFilter)).toBe(false);
      expect(filtered(NearestFilter, NearestFilter)).toBe(false);
      expect(filtered(LinearFilter, NearestFilter)).toBe(true);
      expect(filtered(NearestMipmapNearestFilter, NearestFilter)).toBe(true);
    });

    it('by each texture that the surface uses, and by no other', () => {
      const texture = textureOf(1024);
      const cases: readonly (readonly [boolean, Partial<BaseLook>, Partial<ShadingStyle>?])[] = [
        [true, { normalMap: texture }],
        [false, { normalMap: texture }, { shading: 'flat' }],
        [true, { metalRoughMap: texture, metalness: 0.5 }, { shading: 'gouraud' }],
        [true, { metalRoughMap: texture, roughness: 0.5 }],
        [false, { metalRoughMap: texture, roughness: 0.5 }, { shading: 'gouraud' }],
        [false, { metalRoughMap: texture }],
        [false, { emissiveMap: texture, unlit: true }],
        [false, {}],
      ];
      for (const [filtered, given, style] of cases) {
        const mesh = texturedWall(given, style);
        expect(look()!.filtered, JSON.stringify([Object.keys(given), style])).toBe(filtered);
        mesh.removeFromParent();
      }
    });
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

    it('looks through single-sided faces from behind, mirrored ones too', () => {
      for (const mirror of [1, -1]) {
        const seen = wall(0);
        const single = wall(0.5);
        Object.assign(single.material, { sides: 'single' });
        single.scale.x = mirror;
        expect(look()!.drawn.object).toBe(single);
        single.rotation.y = Math.PI;
        expect(look()!.drawn.object).toBe(seen);
      }
    });

    it('sees a flattened single-sided face from both sides', () => {
      const { box } = boxWithWall('single');
      box.scale.z = 0;
      for (const turn of [0, Math.PI]) {
        box.rotation.y = turn;
        expect(look()!.drawn.object).toBe(box);
      }
    });

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
    const view = new ViewCamera(orbit);
    view.aim(45, scene, null, SIZE, SIZE);
    const snapshot = snapshotThrough(view);
    const before = pick(snapshot, 50, 50)!;
    const eye = [...before.frame.eye];
    orbit.set({ theta: 90, radius: 7 });
    view.aim(45, scene, null, SIZE, SIZE);
    expect(before.frame.eye).toEqual(eye);
    expect(pick(snapshot, 50, 50)).toEqual(before);
  });

  it('does not change when the scene changes afterwards, own and foreign meshes alike', () => {
    const mesh = wall();
    const foreign = new Mesh(new BoxGeometry(0.2, 0.2, 0.2), new MeshBasicMaterial());
    foreign.position.set(0.5, 0, 1);
    scene.add(foreign);
    const view = new ViewCamera(new Orbit({ theta: 0, phi: 90, radius: 3 }));
    view.aim(45, scene, null, SIZE, SIZE);
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

  it('lie around the point that was hit', () => {
    wall(0.25).scale.set(1, 0.5, 1);
    const hit = look(45, 52)!;
    const corners = cornersOf(hit);
    for (const axis of [0, 1, 2] as const) {
      const sum = corners.reduce((all, { p }, i) => all + p[axis] * hit.weights[i]!, 0);
      expect(sum).toBeCloseTo(hit.p[axis], 12);
    }
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
  const view = new ViewCamera(new Orbit({ theta: 0, phi: 90, radius: 3 }));
  const taken = (): BufferGeometry | undefined =>
    snapshotThrough(view).objects.find(({ object }) => object === own[0])?.geometry;

  function animated(): BufferGeometry {
    const { geometry } = wall();
    (geometry.getAttribute('position') as BufferAttribute).setUsage(DynamicDrawUsage);
    return geometry;
  }

  it('has a copy of the vertices, which does not change', () => {
    const geometry = animated();
    const before = taken()!;
    const place = geometry.getAttribute('position') as BufferAttribute;
    place.setX(0, 7);
    place.needsUpdate = true;
    expect(before.getAttribute('position').getX(0)).toBe(-0.5);
    expect(taken()!.getAttribute('position').getX(0)).toBe(7);
  });

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
    const view = new ViewCamera(new Orbit({ theta: 0, phi: 90, radius: 3 }));
    view.aim(45, scene, { center: [0, 0, 0], radius: 2 }, SIZE, SIZE);
    return distanceAlong(snapshotThrough(view), from, direction);
  };

  it('ends at the nearest surface, from either side, wherever the eye is', () => {
    wall(0);
    wall(-1);
    expect(along([0.1, 0.2, 5], [0, 0, -1])).toBeCloseTo(5, 12);
    expect(along([0.1, 0.2, -5], [0, 0, 1])).toBeCloseTo(4, 12);
    expect(along([0.1, 0.2, -0.25], [0.6, 0, 0.8])).toBeCloseTo(0.25 / 0.8, 12);
    expect(along([0, 0, 5], [0, 1, 0])).toBe(Infinity);
  });

  it("ends at a page author's own mesh too", () => {
    wall(0);
    const other = new Mesh(new PlaneGeometry(1, 1), new MeshBasicMaterial());
    other.position.z = 1;
    scene.add(other);
    expect(along([0.1, 0.2, 5], [0, 0, -1])).toBeCloseTo(4, 12);
  });
});
