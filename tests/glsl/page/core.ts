// A page that draws with `phong-viewer/core` in plain three.js, driven by
// tests/visual/core*.spec.ts. One view at a time: each step changes it and draws some frames.
import {
  BoxGeometry,
  type BufferGeometry,
  Mesh,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  SphereGeometry,
  WebGLRenderer,
} from 'three';
import {
  LightSet,
  LightState,
  type LightValues,
  PhongLighting,
  PhongMaterial,
  type ShadingStyle,
  type Sides,
  type SurfaceValues,
} from '../../../src/phong/core.js';
import type { Vec3 } from '../../../src/phong/math/vector.js';

const SHAPES = {
  sphere: () => new SphereGeometry(0.5, 48, 24),
  box: () => new BoxGeometry(),
  floor: () => new PlaneGeometry(8, 8).rotateX(-Math.PI / 2),
} as const satisfies Record<string, () => BufferGeometry>;

/** What changes before the frames are drawn; the rest stays. */
export interface Step {
  readonly lights?: readonly Partial<LightValues>[];
  readonly shape?: keyof typeof SHAPES;
  readonly sides?: Sides;
  readonly surface?: Partial<SurfaceValues>;
  readonly style?: Partial<ShadingStyle>;
  readonly scale?: Vec3;
  readonly eye?: Vec3;
  readonly target?: Vec3;
  /** Vertical, in degrees. */
  readonly fov?: number;
  /** Distance of the near plane. */
  readonly near?: number;
  /** Each step's meshes are clones, in a row. */
  readonly meshes?: number;
  /** Goes on with clones of the materials. */
  readonly clone?: boolean;
  /** The context is lost and restored. */
  readonly lose?: boolean;
  /** Frames to draw. Default 1. */
  readonly frames?: number;
}

export interface Drawn {
  /** Straight alpha or opaque: rows from the bottom, r g b a. */
  readonly codes: Uint8Array;
  /** Programs that three.js holds. */
  readonly programs: number;
  /** Whether the first mesh is drawn by a program for exactly its lights. */
  readonly isSpecialised: boolean;
}

declare global {
  interface Window {
    /** Draws these steps on a new canvas. */
    drawCore: (size: { width: number; height: number }, steps: readonly Step[]) => Promise<Drawn[]>;
  }
}

class View {
  readonly #renderer: WebGLRenderer;
  readonly #camera = new PerspectiveCamera();
  readonly #scene = new Scene();
  readonly #lights = new LightSet();
  readonly #lighting = new PhongLighting(this.#lights);
  #meshes: Mesh[] = [];
  #target: Vec3 = [0, 0, 0];

  constructor(canvas: HTMLCanvasElement) {
    this.#renderer = new WebGLRenderer({
      canvas,
      antialias: true,
      alpha: true,
      preserveDrawingBuffer: true,
    });
    this.#renderer.setSize(canvas.width, canvas.height, false);
    this.#camera.aspect = canvas.width / canvas.height;
    this.#setMeshes(1);
  }

  get canvas() {
    return this.#renderer.domElement;
  }

  apply(step: Step) {
    if (step.meshes !== undefined) {
      this.#setMeshes(step.meshes);
    }
    if (step.lights) {
      this.#lights.assign(step.lights.map((values) => new LightState(values)));
    }
    for (const mesh of this.#meshes) {
      if (step.clone === true) {
        mesh.material = (mesh.material as PhongMaterial).clone();
      }
      const material = mesh.material as PhongMaterial;
      if (step.shape) {
        mesh.geometry = SHAPES[step.shape]();
      }
      if (step.sides) {
        material.sides = step.sides;
      }
      if (step.surface) {
        material.setSurface(step.surface);
      }
      if (step.style) {
        material.setStyle(step.style);
      }
      if (step.scale) {
        mesh.scale.set(...step.scale);
      }
    }
    this.#target = step.target ?? this.#target;
    const camera = this.#camera;
    if (step.eye) {
      camera.position.set(...step.eye);
    }
    camera.near = step.near ?? camera.near;
    camera.fov = step.fov ?? camera.fov;
    camera.lookAt(...this.#target);
    camera.updateProjectionMatrix();
  }

  draw() {
    this.#camera.updateMatrixWorld();
    this.#lighting.update(this.#camera, this.#target);
    this.#renderer.render(this.#scene, this.#camera);
  }

  /** What the canvas shows and what the renderer holds. */
  read(): Drawn {
    const gl = this.#renderer.getContext();
    const { width, height } = this.canvas;
    const codes = new Uint8Array(width * height * 4);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, codes);
    const { defines } = this.#meshes[0]!.material as PhongMaterial;
    return {
      codes,
      programs: this.#renderer.info.programs?.length ?? 0,
      isSpecialised: 'LIGHT_STATEMENTS' in defines || 'HAS_LIGHT_GRID' in defines,
    };
  }

  async loseContext() {
    const extension = this.#renderer.getContext().getExtension('WEBGL_lose_context');
    const next = (name: string) =>
      new Promise((resolve) => this.canvas.addEventListener(name, resolve, { once: true }));
    const lost = next('webglcontextlost');
    extension?.loseContext();
    await lost;
    await new Promise((resolve) => setTimeout(resolve)); // restoring is allowed once the event has been handled
    const restored = next('webglcontextrestored');
    extension?.restoreContext();
    await restored;
  }

  dispose() {
    this.#lighting.dispose();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
  }

  #setMeshes(count: number) {
    this.#scene.remove(...this.#meshes);
    this.#meshes = Array.from({ length: count }, (_, i) => {
      const mesh = new Mesh<BufferGeometry>(SHAPES.box(), new PhongMaterial(this.#lighting));
      mesh.position.x = 1.5 * i;
      return mesh;
    });
    this.#scene.add(...this.#meshes);
  }
}

window.drawCore = async ({ width, height }, steps) => {
  const canvas = document.body.appendChild(document.createElement('canvas'));
  Object.assign(canvas, { width, height });
  const view = new View(canvas);
  const drawn: Drawn[] = [];
  for (const step of steps) {
    if (step.lose === true) {
      await view.loseContext();
    }
    view.apply(step);
    for (let frame = 0; frame < (step.frames ?? 1); frame++) {
      if (frame > 0) {
        await new Promise(requestAnimationFrame);
      }
      view.draw();
    }
    drawn.push(view.read());
  }
  view.dispose();
  canvas.remove();
  return drawn;
};
