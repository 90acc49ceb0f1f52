// Draws one picture's meshes with its lights: brings what both need in step before each drawing, and counts what it costs.
// Knows neither when to draw nor where the pixels go.
import { Scene, type WebGLRenderer } from 'three';
import type { LightSet } from '../light/light-set.js';
import { PhongLighting } from '../material/phong-lighting.js';
import type { DrawnPart, ExactPrograms, Repeat } from './exact-programs.js';
import { releaseGpu } from './gpu/release-gpu.js';
import type { SceneMesh } from './mesh/scene-mesh.js';
import type { ViewCamera } from './view-camera.js';
import type { ViewportStats } from './viewport-stats.js';

/** Drawings before the code for faster programs is fetched: a still picture never does. */
const DRAWINGS_OF_MOTION = 4;

export class Painter {
  readonly scene = new Scene();
  readonly lighting: PhongLighting;
  readonly #meshes: ReadonlySet<SceneMesh>;
  /** Whose GPU memory holds the lights: another renderer is sent all of them. */
  #renderer: WebGLRenderer | null = null;
  #exact: ExactPrograms | null = null;
  #repeat: Repeat | null = null;
  #drawings = 0;
  #drawCalls = 0;

  constructor(lights: LightSet, meshes: ReadonlySet<SceneMesh>) {
    this.lighting = new PhongLighting(lights);
    this.#meshes = meshes;
    this.scene.matrixWorldAutoUpdate = false; // the viewport does it, before bounds and lights are found
  }

  /** Draws what `view` was last aimed at. `relit`: nothing but lights has changed since the last drawing. */
  paint(renderer: WebGLRenderer, { camera, frame }: ViewCamera, relit: boolean): void {
    const { scene, lighting } = this;
    if (renderer !== this.#renderer) lighting.restore();
    this.#renderer = renderer;
    lighting.update(frame);
    const parts = this.#parts();
    if (this.#exact !== null) this.#exact.choose(renderer, camera, parts);
    else for (const { mesh, material } of parts) lighting.reach(mesh, material);
    const [part] = parts;
    const drawing = part !== undefined && parts.length === 1 ? (this.#exact?.drawing(part) ?? null) : null;
    if (!relit || drawing === null || this.#repeat?.draw(renderer, drawing) !== true) {
      renderer.render(scene, camera);
      this.#drawCalls = renderer.info.render.calls;
      this.#repeat?.note(renderer, drawing);
    }
    this.#exact?.settle(renderer, camera, parts);
    this.#drawings += 1;
    if (this.#drawings === DRAWINGS_OF_MOTION) this.#quicken();
  }

  /** Gives back what the GPU holds; drawing sends it again. */
  release(): void {
    this.#exact?.dispose(this.#parts());
    releaseGpu(this.scene);
    this.lighting.dispose();
  }

  get stats(): Pick<
    ViewportStats,
    'lightsActive' | 'lightsSent' | 'lightsSentByMesh' | 'uploads' | 'drawCalls'
  > {
    const { lighting } = this;
    const reaching = (parts: readonly DrawnPart[]): number =>
      lighting.reaching(parts.map(({ mesh }) => mesh));
    return {
      lightsActive: lighting.packed.active,
      lightsSent: reaching(this.#parts()),
      lightsSentByMesh: [...this.#meshes]
        .filter(({ parts }) => parts.length > 0)
        .map(({ parts }) => reaching(parts)),
      uploads: lighting.uploads + (this.#exact?.uploads ?? 0),
      drawCalls: this.#drawCalls,
    };
  }

  #parts(): DrawnPart[] {
    const parts: DrawnPart[] = [];
    for (const mesh of this.#meshes) parts.push(...mesh.parts);
    return parts;
  }

  /** A picture that keeps being drawn is worth programs of its own; their code comes with the first one that does. */
  #quicken(): void {
    void import('./exact-programs.js').then(
      ({ ExactPrograms, Repeat }) => {
        this.#exact = new ExactPrograms(this.lighting);
        this.#repeat = new Repeat();
      },
      () => undefined, // it draws without, only not as fast
    );
  }
}
