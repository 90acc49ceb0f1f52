// Turns a loaded model into content that a mesh can show, as a built-in shape is. Entry point of the code that reads
// models, fetched with the first one.
import { exponentOfRoughness, NO_FILE_SURFACE } from '../material/file-surface.js';
import type { SurfaceValues } from '../material/material-values.js';
import type { Content, Motion } from './content.js';
import { nameOf } from './file-name.js';
import { loadModel, type LoadOptions, type ModelLook, type ModelMotion } from './load-model.js';
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
    console.warn(`${nameOf(url)} is shown without ${[...model.dropped].join(', ')}.`);
  return {
    parts: model.parts.map(({ name, geometry, matrix, look }) => ({
      name,
      geometry,
      matrix,
      look: { ...NO_FILE_SURFACE, ...look, vertexColors: 'color' in geometry.attributes },
      sides: look.doubleSided ? 'double' : 'single',
      surface: surfaceOf(look),
    })),
    motion: model.motion ? motionOf(model.motion, nameOf(url)) : null,
    missing: model.missing ?? [],
    dispose: () => {
      model.dispose();
    },
  };
}

/** @param file its name, for warnings. */
function motionOf(motion: ModelMotion, file: string): Motion {
  const { clips } = motion;
  const unknown = new Set<string>();
  const indexOf = (wanted: string): number => {
    const index = wanted === '' ? 0 : clips.findIndex(({ name }) => name === wanted);
    if (index < 0 && !unknown.has(wanted)) {
      const names = clips.map(({ name }) => JSON.stringify(name)).join(', ');
      console.warn(
        `${file} has no animation ${JSON.stringify(wanted)}, so its first one is shown. It has: ${names}`,
      );
      unknown.add(wanted);
    }
    return Math.max(index, 0);
  };
  const durationOf = (name: string): number => clips[indexOf(name)]?.duration ?? 0;
  return {
    names: clips.map(({ name }) => name),
    durationOf,
    pose: (name, seconds) => {
      if (name === null) motion.pose(null, 0);
      else motion.pose(indexOf(name), durationOf(name) > 0 ? seconds % durationOf(name) : 0);
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
