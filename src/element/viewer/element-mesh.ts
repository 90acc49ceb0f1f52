// The mesh of the scene that a <phong-mesh> shows.
import { type MeshHost, SceneMesh } from '../../scene/mesh/scene-mesh.js';
import type { PhongMesh } from '../elements.js';
import { fieldsOf, sceneMeshes } from '../internals.js';

/** The mesh that an element shows. */
export class ElementMesh extends SceneMesh {
  readonly element: PhongMesh;
  /** Listens to the element's values. */
  readonly written: (key?: string) => void;

  constructor(element: PhongMesh, host: MeshHost, update: (mesh: ElementMesh) => void) {
    super(fieldsOf(element).store, host);
    this.element = element;
    sceneMeshes.set(element, this);
    this.written = (key) => {
      if (key === 'src' || key === 'geometry') this.retry();
      update(this);
    };
  }
}

/** The child that shows this mesh; undefined for the viewer's own mesh. */
export const elementOf = (mesh: SceneMesh): PhongMesh | undefined =>
  mesh instanceof ElementMesh ? mesh.element : undefined;
