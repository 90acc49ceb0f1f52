// How does a loaded model become content that a mesh can show, as a built-in shape is? Entry point of the code that reads models,
// fetched with the first one. Knows neither materials nor elements.
import type { SurfaceValues } from '../../material/material-values.js';
import type { Content } from '../mesh/content.js';
import { fileName } from '../mesh/file-name.js';
import type { ModelRequest } from './fetch-bytes.js';
import { requestFile } from './file-group.js';
import { loadModel, type LoadOptions, type ModelLook } from './load-model.js';

export { droppedModel } from './dropped-files.js';

/** The model at `url`, or in `file`; see {@link loadModel}. One of `request` and `file` is null. */
export async function modelContent(
  url: URL,
  options: LoadOptions,
  request: ModelRequest | null,
  file: Blob | null,
): Promise<Content> {
  const opened = file === null ? request : requestFile(file, fileName(file));
  const model = await loadModel(url, options, opened ?? undefined);
  return {
    parts: model.parts.map(({ name, geometry, matrix, look }) => ({
      name,
      geometry,
      matrix,
      look: { ...look, vertexColors: 'color' in geometry.attributes },
      sides: look.doubleSided ? 'double' : 'single',
      surface: surfaceOf(look),
    })),
    dispose: () => {
      model.dispose();
    },
  };
}

function surfaceOf({ ka, kd, ks, shininess }: ModelLook): Partial<SurfaceValues> {
  const surface: Partial<SurfaceValues> = {};
  if (ka !== undefined) surface.ka = [ka[0] * 255, ka[1] * 255, ka[2] * 255];
  if (kd !== undefined) surface.kd = [kd[0] * 255, kd[1] * 255, kd[2] * 255];
  if (ks !== undefined) surface.ks = [ks[0] * 255, ks[1] * 255, ks[2] * 255];
  if (shininess !== undefined) surface.shininess = shininess;
  return surface;
}
