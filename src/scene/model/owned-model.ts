// A model that owns its geometries, textures and images. Knows no format.
import type { Model, ModelPart } from './model.js';

/** @param closeImages frees what the textures' images hold. */
export function ownedModel(parts: readonly ModelPart[], closeImages: () => void = () => undefined): Model {
  const owned = new Set(parts.flatMap(({ geometry, look }) => [geometry, ...(look.map ? [look.map] : [])]));
  let disposed = false;
  return {
    parts,
    dispose() {
      if (disposed) return;
      disposed = true;
      for (const item of owned) item.dispose();
      closeImages();
    },
  };
}
