// <phong-mesh>: a mesh as markup. Renders nothing; its attributes and properties write into one
// FieldStore.
import { FieldStore } from '../../phong/fields/field-store.js';
import { MESH_FIELDS, type MeshValues } from '../../phong/model/mesh-fields.js';
import { ChildElement } from './child-element.js';
import type {
  ElementClass,
  Listen,
  PhongMesh as PublicMesh,
  PhongMeshEventMap,
} from './elements.js';
import { attributesOf, defineProperties } from './fields/field-binding.js';
import type { MeshProperties } from './fields/properties.js';

// The accessors come from the table of fields.
interface MeshElement extends MeshProperties {
  readonly localName: 'phong-mesh';
  addEventListener: Listen<this, PhongMeshEventMap>;
  removeEventListener: Listen<this, PhongMeshEventMap>;
}

/**
 * A mesh of the nearest `<phong-viewer>` around it, as with lights. Its properties have the
 * attributes' names. A bad attribute value warns and gives the default; a bad property value
 * throws.
 */
class MeshElement extends ChildElement<MeshValues> implements PublicMesh {
  static readonly observedAttributes: readonly string[] = attributesOf(MESH_FIELDS);

  constructor() {
    super(new FieldStore<MeshValues>(MESH_FIELDS), assigned);
  }
}

/** The same value again retries what failed. */
function assigned(key: keyof MeshValues, store: FieldStore<MeshValues>) {
  if (key === 'src' || key === 'geometry') {
    store.notify(key);
  }
}

defineProperties(MeshElement.prototype, MESH_FIELDS);

export type PhongMesh = PublicMesh;
export const PhongMesh: ElementClass<PhongMesh> = MeshElement;
