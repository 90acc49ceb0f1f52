// A model that owns its geometries, textures and images.
import { mapsOfLook, type Model, type ModelPart } from './model.js';

/** @param closeImages frees what the textures' images hold. */
export function ownedModel(parts: readonly ModelPart[], closeImages: () => void = () => undefined): Model {
  const owned = new Set(parts.flatMap(({ geometry, look }) => [geometry, ...mapsOfLook(look)]));
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
