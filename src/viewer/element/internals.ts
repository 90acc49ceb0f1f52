// What this package's own code, the panel included, can reach on an element while users cannot.
import { bindingOf, type FieldBinding } from './fields/field-binding.js';
import type { SceneMesh } from '../scene/mesh/scene-mesh.js';
import type { PhongMesh, PhongViewer, ValuesByTag } from './elements.js';
import type { ExtraHost } from './viewer/extra-host.js';

/** The declared values of an element, with checks as for its properties. */
export const fieldsOf = <T extends keyof ValuesByTag>(
  element: HTMLElement & { readonly localName: T },
): FieldBinding<ValuesByTag[T]> => bindingOf(element);

/** What an element shows: a <phong-mesh>, or a viewer by its own attributes. */
export const sceneMeshes = new WeakMap<PhongMesh | PhongViewer, SceneMesh>();

/** A viewer has got its place in a comparison, which observers report only after a frame. */
export const placed = (viewer: PhongViewer & { connectedMoveCallback?(): void }): void =>
  viewer.connectedMoveCallback?.();

/** What an extra gets of a viewer. */
export const viewerHosts = new WeakMap<PhongViewer, ExtraHost>();

export const hostOf = (viewer: PhongViewer): ExtraHost => viewerHosts.get(viewer)!;
