// Draws a picture again of which only the lights have changed: one mesh and nothing else, by the very state that three.js's last
// drawing has left in the context. It sends the lights, clears and draws; all else that three.js does for a frame takes several
// times as long. Knows neither which lights a mesh has nor when to draw.
import type { Material, Mesh, WebGLRenderer } from 'three';
import { lightBlockOf } from '../material/light-block.js';
import type { LightRows } from '../material/light-rows.js';

/** What a drawing is made with. While all of it stays, so does the context's state. */
export interface Drawing {
  readonly mesh: Mesh;
  readonly rows: LightRows;
  /** The program reads the lights from the block; else from the texture. */
  readonly inBlock: boolean;
  /** It reads another texture as well. */
  readonly textured: boolean;
}

interface Repeatable extends Drawing {
  readonly renderer: WebGLRenderer;
  readonly material: Material;
  readonly version: number;
  readonly geometry: object;
  /** three.js's count of drawings: another one since then has left another state. */
  readonly frame: number;
  readonly texture: WebGLTexture | null;
  /** Bound for sending. */
  bound: boolean;
}

export class Repeat {
  #last: Repeatable | null = null;

  /** After three.js has drawn: what it drew with, where that is all there is to say; null where there are more meshes. */
  note(renderer: WebGLRenderer, drawing: Drawing | null): void {
    const { calls, frame } = renderer.info.render;
    this.#last = null;
    if (drawing === null || calls !== 1) return; // blended ones take two
    const { mesh, rows, inBlock, textured } = drawing;
    const { geometry } = mesh;
    const material = mesh.material as Material;
    // Sending to a texture binds it, perhaps where another one is read.
    if (textured && !inBlock) return;
    const { version } = material;
    const { texture } = rows;
    this.#last = { ...drawing, renderer, material, version, geometry, frame, texture, bound: false };
  }

  /** True where the last drawing could be repeated, and is now, with the lights as they are. */
  draw(renderer: WebGLRenderer, { mesh, rows, inBlock }: Drawing): boolean {
    const last = this.#last;
    const { geometry, material } = mesh;
    const same =
      last?.renderer === renderer &&
      last.frame === renderer.info.render.frame &&
      last.mesh === mesh &&
      last.geometry === geometry &&
      last.material === material &&
      last.version === material.version &&
      last.rows === rows &&
      last.inBlock === inBlock;
    if (!same) return false;
    const gl = renderer.getContext() as WebGL2RenderingContext;
    if (inBlock) {
      const block = lightBlockOf(rows);
      if (!last.bound) block.bind(gl);
      last.bound = true;
      block.patch(gl);
    } else {
      rows.sendTexture(renderer);
      if (rows.texture !== last.texture) return false;
    }
    renderer.clear();
    const { index, attributes } = geometry;
    if (index === null) gl.drawArrays(gl.TRIANGLES, 0, attributes['position']?.count ?? 0);
    else gl.drawElements(gl.TRIANGLES, index.count, indexType(gl, index.array.BYTES_PER_ELEMENT), 0);
    return true;
  }
}

function indexType(gl: WebGL2RenderingContext, bytes: number): GLenum {
  if (bytes === 4) return gl.UNSIGNED_INT;
  return bytes === 2 ? gl.UNSIGNED_SHORT : gl.UNSIGNED_BYTE;
}
