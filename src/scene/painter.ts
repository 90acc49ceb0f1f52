// Draws one picture's meshes with its lights, and counts what that costs.
import { Scene, type WebGLRenderer, type Mesh, type Object3D, type ShaderMaterial, Texture } from 'three';
import type { LightSet } from '../light/light-set.js';
import { PhongLighting } from '../material/lighting.js';
import type { SceneMesh } from './mesh/scene-mesh.js';
import type { ViewCamera } from './view-camera.js';

export class Painter {
  readonly scene = new Scene();
  readonly lighting: PhongLighting;
  readonly #meshes: ReadonlySet<SceneMesh>;
  #drawCalls = 0;

  constructor(lights: LightSet, meshes: ReadonlySet<SceneMesh>) {
    this.lighting = new PhongLighting(lights);
    this.#meshes = meshes;
    this.scene.matrixWorldAutoUpdate = false; // the viewport updates matrices, before it measures
  }

  /** Lights for what `view` was last aimed at. */
  begin(view: ViewCamera): void {
    this.lighting.updateFrame(view.frame, view.camera);
  }

  /** Draws what `view` was last aimed at. `samples`: so many such pictures are averaged. */
  paint(renderer: WebGLRenderer, view: ViewCamera, samples = 1): void {
    this.begin(view);
    this.paintAgain(renderer, view, samples);
  }

  /** Draws the scene and the lights of the last {@link begin} once more. Counts as no frame for programs. */
  paintAgain(renderer: WebGLRenderer, { camera }: ViewCamera, samples = 1): void {
    this.lighting.mapBias.value = mapBiasOf(samples);
    renderer.render(this.scene, camera);
    this.#drawCalls = renderer.info.render.calls;
  }

  /** Gives back what the GPU holds; drawing sends it again. */
  release(): void {
    releaseGpu(this.scene);
    this.lighting.dispose();
  }

  get stats(): Pick<
    ViewportStats,
    'lightsActive' | 'lightsSent' | 'lightsSentByMesh' | 'uploads' | 'drawCalls'
  > {
    const { lighting } = this;
    const reaching = (parts: SceneMesh['parts']): number =>
      lighting.countReaching(parts.map(({ mesh }) => mesh));
    const shown = [...this.#meshes].filter(({ parts }) => parts.length > 0);
    return {
      lightsActive: lighting.packed.active,
      lightsSent: reaching(shown.flatMap(({ parts }) => parts)),
      lightsSentByMesh: shown.map(({ parts }) => reaching(parts)),
      uploads: lighting.uploads,
      drawCalls: this.#drawCalls,
    };
  }
}

/**
 * Levels of maps suit a whole pixel, and a sample stands for a share of it. Left so, a floor whose texture is minified 2
 * to 16 times is 10.1 codes (RMSE) off the exact mean, whatever the number of samples; by this formula 1.7, 0.50 and 0.33
 * with 16, 64 and 256 (H200). −1/2, the share's side, leaves 1.3 times the error with 64: a level's texels reach farther
 * than the share. GPUs may stop at −2.
 */
const mapBiasOf = (samples: number): number => (-2 / 3) * Math.log2(samples);

/** What drawing costs. Counts since the viewport was created unless stated otherwise. */
export interface ViewportStats {
  readonly frames: number;
  /**
   * Samples per pixel of the picture that is shown now: with `antialias="full"` up to `samples`, 0 before its first
   * ones are shown. Stays 0 where the GPU has no float targets: `full` is like `edges` there.
   */
  readonly samples: number;
  readonly lightsActive: number;
  /** Lights that the shader loops over for at least one mesh; the others add ambient light only, or nothing. */
  readonly lightsSent: number;
  /** The same for each mesh: the viewer's own, if it has one, then `meshes` in the order they were added. */
  readonly lightsSentByMesh: readonly number[];
  /** Programs of the page's WebGL context. */
  readonly programs: number;
  /** In the last frame. */
  readonly drawCalls: number;
  /** Uploads of light data. */
  readonly uploads: number;
  /** Viewers that the page's last frame has drawn: those in view that had changed. */
  readonly viewersDrawn: number;
}

/**
 * Releases a scene's buffers, programs and textures on the GPU. Nothing is lost: the next drawing uploads them again.
 */
function releaseGpu(root: Object3D): void {
  root.traverse((object) => {
    const { geometry, material } = object as Partial<Mesh>;
    geometry?.dispose();
    for (const one of [material ?? []].flat()) {
      one.dispose();
      const { uniforms = {} } = one as Partial<ShaderMaterial>;
      for (const { value } of Object.values(uniforms)) if (value instanceof Texture) value.dispose();
    }
  });
}
