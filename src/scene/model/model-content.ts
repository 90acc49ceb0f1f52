// How does a loaded model become content that a mesh can show, as a built-in shape is? Entry point of the code that reads models,
// fetched with the first one. Knows neither materials nor elements.
import { exponentOfRoughness, NO_FILE_SURFACE } from '../../material/file-surface.js';
import type { SurfaceValues } from '../../material/material-values.js';
import type { Content } from '../mesh/content.js';
import { nameOf } from './format.js';
import { loadModel, type LoadOptions, type ModelLook } from './load-model.js';
import type { FileRequest } from './request-file.js';

export { droppedModel } from './dropped-files.js';

/** The model at `url`; see {@link loadModel}. */
export async function modelContent(
  url: URL,
  options: LoadOptions,
  from: FileRequest | Blob | null,
): Promise<Content> {
  const model = await loadModel(url, options, from);
  if (model.dropped !== undefined && model.dropped.size > 0)
    console.warn(
      `${nameOf(url)}: ${[...model.dropped].join(', ')} cannot be shown by this equation and are left out.`,
    );
  return {
    parts: model.parts.map(({ name, geometry, matrix, look }) => ({
      name,
      geometry,
      matrix,
      look: { ...NO_FILE_SURFACE, ...look, vertexColors: 'color' in geometry.attributes },
      sides: look.doubleSided ? 'double' : 'single',
      surface: surfaceOf(look),
    })),
    dispose: () => {
      model.dispose();
    },
  };
}

function surfaceOf({ ka, kd, ks, shininess, roughness = null }: ModelLook): Partial<SurfaceValues> {
  const surface: Partial<SurfaceValues> = {};
  if (ka !== undefined) surface.ka = [ka[0] * 255, ka[1] * 255, ka[2] * 255];
  if (kd !== undefined) surface.kd = [kd[0] * 255, kd[1] * 255, kd[2] * 255];
  if (ks !== undefined) surface.ks = [ks[0] * 255, ks[1] * 255, ks[2] * 255];
  if (shininess !== undefined) surface.shininess = shininess;
  else if (roughness !== null) surface.shininess = exponentOfRoughness(roughness);
  return surface;
}
