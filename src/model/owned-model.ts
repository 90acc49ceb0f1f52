// A model that owns its geometries, textures and images.
import type { Texture } from 'three';
import type { BaseLook } from '../material/file-surface.js';
import type { Content } from './model.js';

/** Without motion. @param closeImages frees what the textures' images hold. */
export function ownedModel(parts: Content['parts'], closeImages: () => void = () => undefined): Content {
  const owned = new Set(parts.flatMap(({ geometry, look }) => [geometry, ...mapsOfLook(look)]));
  let disposed = false;
  return {
    parts,
    motion: null,
    dispose() {
      if (disposed) return;
      disposed = true;
      for (const item of owned) item.dispose();
      closeImages();
    },
  };
}

/** All textures of a look. */
export const mapsOfLook = ({ map, emissiveMap, metalRoughMap, normalMap }: BaseLook): Texture[] =>
  [map, emissiveMap, metalRoughMap, normalMap].flatMap((texture) => texture ?? []);
