// `phong-viewer/core`'s material in a three.js renderer that a bench page rules: at any size, with or without multisampling, read
// back as codes. For axes whose variants differ in geometry, size or samples rather than in the loop.
import {
  type BufferGeometry,
  LinearSRGBColorSpace,
  Mesh,
  type Object3D,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import { LightSet, LightState, type LightValues, PhongLighting, PhongMaterial } from 'phong-viewer/core';
import type { ShadingStyle } from 'phong-viewer/core';
import type { ColorPicture } from '../error/error-figures.js';
import type { Size } from './stand.js';

export const CAMERA = { radius: 3, fov: 45 } as const;

export interface Look {
  readonly shininess: number;
  readonly style?: Partial<ShadingStyle>;
}

/** Full ambient and diffuse, half specular light, as a viewer's own mesh has. */
const SURFACE = { ka: [255, 255, 255], kd: [255, 255, 255], ks: [128, 128, 128] } as const;

/** In the reference's words. */
export const surfaceOf = (shininess: number) => ({ ...SURFACE, shininess });

export class CoreView {
  readonly renderer: WebGLRenderer;
  readonly camera = new PerspectiveCamera(CAMERA.fov, 1, 0.1, 20);
  readonly #lighting: PhongLighting;
  readonly #antialias: boolean;

  constructor(holder: HTMLElement, lights: readonly Partial<LightValues>[], antialias: boolean) {
    this.renderer = new WebGLRenderer({ antialias, alpha: false });
    this.renderer.outputColorSpace = LinearSRGBColorSpace; // colours are encoded already
    this.#antialias = antialias;
    holder.append(this.renderer.domElement);
    const set = new LightSet();
    set.assign(lights.map((values) => new LightState(values)));
    this.#lighting = new PhongLighting(set);
    this.camera.position.set(0, 0, CAMERA.radius);
  }

  get gl(): WebGL2RenderingContext {
    return this.renderer.getContext() as WebGL2RenderingContext;
  }

  /** Samples a pixel, as the context has them. */
  get samples(): number {
    return this.#antialias ? Math.max(this.gl.getParameter(this.gl.SAMPLES) as number, 1) : 1;
  }

  scene(geometry: BufferGeometry, { shininess, style = {} }: Look, places: readonly Object3D[] = []): Scene {
    const material = new PhongMaterial(this.#lighting);
    const { ka, kd, ks } = SURFACE;
    material.setSurface({ ka: [...ka], kd: [...kd], ks: [...ks], shininess });
    material.setStyle(style);
    const scene = new Scene();
    if (places.length === 0) scene.add(new Mesh(geometry, material));
    for (const { position, scale } of places) {
      const mesh = new Mesh(geometry, material);
      mesh.position.copy(position);
      mesh.scale.copy(scale);
      scene.add(mesh);
    }
    return scene;
  }

  /** Canvas, camera and lights for a picture of this size. */
  prepare([width, height]: Size): void {
    const { renderer, camera } = this;
    const { domElement } = renderer;
    if (domElement.width !== width || domElement.height !== height) renderer.setSize(width, height, false);
    const aspect = width / height;
    if (camera.aspect !== aspect) {
      camera.aspect = aspect;
      camera.updateProjectionMatrix();
    }
    const [right, up, back] = [[1, 0, 0] as const, [0, 1, 0] as const, [0, 0, 1] as const];
    this.#lighting.update({ origin: [0, 0, 0], eye: [0, 0, CAMERA.radius], right, up, back });
  }

  draw(scene: Scene, size: Size): void {
    this.prepare(size);
    this.renderer.render(scene, this.camera);
  }

  /** The codes that were drawn last: of the canvas, or of its part from `x`, `y` (from the top left) on. */
  read([width, height]: Size, x = 0, y = 0): ColorPicture {
    const { gl } = this;
    const codes = new Uint8Array(width * height * 4);
    gl.readPixels(x, gl.drawingBufferHeight - y - height, width, height, gl.RGBA, gl.UNSIGNED_BYTE, codes);
    return pictureOf(codes, [width, height]);
  }

  close(): void {
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.renderer.domElement.remove();
  }
}

/** Of RGBA codes whose rows WebGL counts from the bottom. */
export function pictureOf(codes: Uint8Array, [width, height]: Size): ColorPicture {
  const data = new Float64Array(width * height * 3);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      for (let k = 0; k < 3; k++)
        data[3 * (x + width * y) + k] = codes[4 * (x + width * (height - 1 - y)) + k]!;
    }
  }
  return { width, height, data };
}
