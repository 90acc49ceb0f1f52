// The helpers of the scene itself: axes, grid, bounds and normals. Computed again only where the view, the scene's
// ball, a mesh, or what hides something has changed.
import type { Mesh, Object3D } from 'three';
import { sameValue } from '../../fields/field-store.js';
import type { ExtraHost } from '../../element/viewer/extras.js';
import type { Helper } from '../../element/fields/viewer-fields.js';
import type { Vec3 } from '../../math/vector.js';
import type { DrawnItem } from '../drawing/display-list.js';
import { type Drawing, type Name, NO_DRAWING } from '../drawing/label-layout.js';
import type { Projection } from '../drawing/projection.js';
import { isBehind, RayTests } from './occlusion.js';
import type { SceneBall } from './placed-light.js';
import { axesMarks, boundsMarks, gridMarks, type Hiding, normalMarks } from './scene-marks.js';

export class SceneHelpers {
  readonly #host: ExtraHost;
  readonly #hidden: RayTests<string, Vec3, boolean>;
  /** What the last drawing was computed from. */
  #seen: readonly unknown[] = [];
  #drawing = NO_DRAWING;
  /** What hides something has been found to differ. */
  #hidingChanged = false;

  /** `changed` is called when something looks different although nothing was drawn. */
  constructor(host: ExtraHost, changed: () => void) {
    this.#host = host;
    this.#hidden = new RayTests(host, isBehind, () => {
      this.#hidingChanged = true;
      changed();
    });
  }

  show(view: Projection, scene: SceneBall, helpers: readonly Helper[]): Drawing {
    if (!helpers.some((name) => name !== 'lights')) {
      this.hide();
      return NO_DRAWING;
    }
    const meshes = meshesIn(this.#host.viewport.picture.scene);
    const seen = [view, scene, helpers, ...meshes.flatMap(stateOf)];
    const changed = !sameValue(seen, this.#seen);
    if (!changed && !this.#hidingChanged) return this.#drawing;
    this.#seen = seen;
    this.#hidingChanged = false;
    const asked = new Map<string, Vec3>();
    this.#drawing = this.#drawingOf(view, scene, helpers, meshes, asked);
    this.#hidden.follow(view, asked, changed ? asked.keys() : []);
    return this.#drawing;
  }

  /** The same for another size. */
  drawingAt(view: Projection, scene: SceneBall, helpers: readonly Helper[]): Drawing {
    return this.#drawingOf(view, scene, helpers, meshesIn(this.#host.viewport.picture.scene), new Map());
  }

  hide(): void {
    this.#hidden.stop();
    this.#seen = [];
    this.#drawing = NO_DRAWING;
  }

  /** `asked` collects the places that have to be tested for being hidden. */
  #drawingOf(
    view: Projection,
    scene: SceneBall,
    helpers: readonly Helper[],
    meshes: readonly Mesh[],
    asked: Map<string, Vec3>,
  ): Drawing {
    const hiding: Hiding = (key, place) => {
      asked.set(key, place);
      return this.#hidden.answer(key);
    };
    const list: DrawnItem[] = [];
    const names: Name[] = [];
    if (helpers.includes('grid')) list.push(...gridMarks(view, scene, hiding));
    if (helpers.includes('bounds')) list.push(...boundsMarks(meshes, view));
    if (helpers.includes('normals')) list.push(...normalMarks(meshes, view, scene, hiding));
    if (helpers.includes('axes')) {
      const axes = axesMarks(view, scene, hiding);
      list.push(...axes.list);
      names.push(...axes.names);
    }
    return { list, names, covered: [] };
  }
}

/** The visible meshes, the page author's own included. */
function meshesIn(root: Object3D): Mesh[] {
  const meshes: Mesh[] = [];
  root.traverseVisible((object) => {
    // By its mark, not its class: another copy of three.js may have made it.
    if ((object as Partial<Mesh>).isMesh === true) meshes.push(object as Mesh);
  });
  return meshes;
}

/** What differs where a mesh has moved, or has other vertices, another material or other sides. */
const stateOf = ({ geometry, material, matrixWorld }: Mesh): unknown[] => [
  geometry,
  geometry.boundingBox,
  (geometry.attributes['position'] as { version?: number } | undefined)?.version,
  material,
  (material as { style?: unknown }).style,
  ...matrixWorld.elements,
];
