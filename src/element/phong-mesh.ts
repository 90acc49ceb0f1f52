// <phong-mesh>: a mesh as markup. It renders nothing; its attributes and properties write into one state, which the
// viewer around it picks up. Knows nothing of geometry or materials.
import { FieldStore } from '../fields/field-store.js';
import { MESH_FIELDS, type MeshValues } from '../scene/mesh/mesh-fields.js';
import { attributesOf, FieldBinding, defineProperties } from './fields/field-binding.js';
import type { Listen, PhongMeshEventMap } from './events.js';

/** Importing this file where there is no DOM does nothing. */
const Base = typeof HTMLElement === 'undefined' ? (class {} as typeof HTMLElement) : HTMLElement;

export interface PhongMesh extends MeshValues {
  readonly localName: 'phong-mesh';
  addEventListener: Listen<this, PhongMeshEventMap>;
  removeEventListener: Listen<this, PhongMeshEventMap>;
}

/**
 * A mesh of the `<phong-viewer>` around it. Properties are those of {@link MeshValues}, under the attributes' names; bad
 * attribute values give way to defaults with a warning, bad property values throw. Events are those of
 * {@link PhongMeshEventMap}.
 */
export class PhongMesh extends Base {
  static readonly observedAttributes: readonly string[] = attributesOf(MESH_FIELDS);

  readonly state = new FieldStore<MeshValues>(MESH_FIELDS);
  readonly declared = new FieldBinding<MeshValues>(this, this.state);

  connectedCallback(): void {
    this.declared.upgrade();
  }

  attributeChangedCallback(attribute: string, _old: string | null, text: string | null): void {
    this.declared.attributeChanged(attribute, text);
  }
}

defineProperties(PhongMesh.prototype, MESH_FIELDS, (mesh) => mesh.declared);

declare global {
  interface HTMLElementTagNameMap {
    'phong-mesh': PhongMesh;
  }
}
