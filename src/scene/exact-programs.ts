// Programs for exactly what is drawn, compiled in the background while general ones go on drawing, as a just-in-time compiler
// does. A mesh gets one when its lights' number and shapes have stood still for a while of drawing, and loses it at once when
// they have not: nothing is ever waited for. Works only in frames that are drawn anyway: no timer, no promise.
import { type Material, Mesh, type PerspectiveCamera, Scene, type WebGLRenderer } from 'three';
import { NearLights } from '../material/near-lights.js';
import {
  type ExactChoice,
  type ExactForm,
  ExactMaterial,
  exactText,
  readsBlock,
} from '../material/exact-material.js';
import { FormChoice, isSettled } from './exact-form.js';
import type { Drawing } from './repeat.js';
import { unfinished } from './gpu/link-check.js';
import type { LightList } from '../material/light-list.js';
import { ALL_TERMS } from '../material/exact-lights.js';
import type { PhongLighting } from '../material/phong-lighting.js';
import type { PhongMaterial } from '../material/phong-material.js';

/** Distances of what is drawn for which float32 needs no rescue: ten times what the shader takes, either way. */
const USUAL = { near: 1e-9, far: 1e14 } as const;

/** Exact programs that a page keeps at most; further meshes stay with general ones. */
const MOST_PROGRAMS = 8;

/**
 * Frames until a program is taken for compiled where the browser does not tell: commands are carried out in order, so by
 * then it has been, and asking waits for nothing.
 */
const UNTOLD_FRAMES = 4;

export { Repeat } from './repeat.js';

export interface DrawnPart {
  readonly mesh: Mesh;
  readonly material: PhongMaterial;
}

interface Record {
  readonly near: NearLights;
  material: PhongMaterial;
  readonly form: FormChoice;
  /** What the program is made for: this, the shapes of its lights, and what else of the material is in the text. */
  choice: ExactChoice | null;
  shapeVersion: number;
  /** The text that its lights have in common; empty where each is written out. */
  text: string;
  programVersion: number;
  exactKey: string;
  /** Frames drawn, and when the first was, since that has changed. */
  frames: number;
  since: number;
  twin: ExactMaterial | null;
  ready: boolean;
  /** The twin has been drawn with. */
  drawn: boolean;
  seen: boolean;
}

let programs = 0;

export class ExactPrograms {
  readonly #lighting: PhongLighting;
  readonly #records = new Map<Mesh, Record>();
  #compiling: Record | null = null;
  #framesCompiling = 0;
  #renderer: WebGLRenderer | null = null;

  constructor(lighting: PhongLighting) {
    this.#lighting = lighting;
  }

  /** Before a frame: gives each mesh the lights that reach it and the material that draws it, exact where one is ready. */
  choose(renderer: WebGLRenderer, camera: PerspectiveCamera, parts: Iterable<DrawnPart>): void {
    this.#renderer = renderer;
    const usual = camera.near > USUAL.near && camera.far < USUAL.far;
    for (const record of this.#records.values()) record.seen = false;
    for (const { mesh, material } of parts) {
      const record = this.#records.get(mesh) ?? this.#add(mesh, material);
      record.seen = true;
      const choice = this.#lighting.reach(mesh, material);
      record.near.update(choice, material);
      const { cells, apart } = record.near;
      const list = cells ?? choice.list;
      const form = record.form.of(renderer, list, cells !== null, material);
      material.chooseProgram();
      if (record.material !== material) this.#drop(record);
      record.material = material;
      if (isAsBefore(record, material, list, form, usual, apart)) {
        record.frames += 1;
      } else {
        this.#drop(record);
        record.choice = { list, form, usual, apart };
        record.text = commonText(list, form);
        record.programVersion = material.programVersion;
        record.exactKey = material.exactKey;
        record.frames = 0;
        record.since = performance.now();
      }
      record.drawn ||= record.ready;
      mesh.material = record.ready && record.twin !== null ? record.twin : material;
    }
    for (const [mesh, record] of this.#records) {
      if (record.seen) continue;
      this.#end(record);
      this.#records.delete(mesh);
    }
  }

  /** What a part is drawn with, as last chosen. */
  drawing({ mesh, material }: DrawnPart): Drawing {
    const { choice = null, twin = null } = this.#records.get(mesh) ?? {};
    const list = choice !== null && mesh.material === twin ? choice.list : this.#lighting.lightsOf(mesh);
    const inBlock = choice?.list === list && readsBlock(choice.form) && mesh.material === twin;
    return { mesh, rows: list.rows, inBlock, textured: material.look.map !== null };
  }

  /** After a frame: begins or ends compiling, one program at a time. */
  settle(renderer: WebGLRenderer, camera: PerspectiveCamera, parts: Iterable<DrawnPart>): void {
    if (this.#compiling !== null) {
      const { twin } = this.#compiling;
      this.#framesCompiling += 1;
      if (twin !== null && !isReady(renderer, twin, this.#framesCompiling)) return;
      // One that a driver cannot link is told of, and never drawn with: the general one goes on.
      this.#compiling.ready = twin !== null && hasLinked(renderer, twin);
      if (twin !== null) unfinished.delete(programOf(renderer, twin) ?? twin);
      this.#compiling = null;
    }
    for (const { mesh, material } of parts) {
      const record = this.#records.get(mesh);
      if (record === undefined || record.twin !== null || record.choice === null) continue;
      // Constants have stood still for long enough when they are chosen.
      if (record.choice.form !== 'constant' && !isSettled(record.frames, record.since)) continue;
      if (material.transparent || programs >= MOST_PROGRAMS) continue; // three.js draws blended ones in two passes
      programs += 1;
      record.twin = new ExactMaterial(material, record.choice);
      this.#compiling = record;
      this.#framesCompiling = 0;
      renderer.compile(new Scene().add(new Mesh(mesh.geometry, record.twin)), camera);
      unfinished.add(programOf(renderer, record.twin) ?? record.twin);
      return;
    }
  }

  /** Gives all programs back. */
  dispose(parts: Iterable<DrawnPart>): void {
    for (const { mesh, material } of parts) mesh.material = material;
    for (const record of this.#records.values()) this.#end(record);
    this.#records.clear();
  }

  /** How often lights in cells have been sent. */
  get uploads(): number {
    let sum = 0;
    for (const { near } of this.#records.values()) sum += near.uploads;
    return sum;
  }

  #add(mesh: Mesh, material: PhongMaterial): Record {
    const record: Record = {
      ...{
        near: new NearLights(),
        material,
        form: new FormChoice(),
        choice: null,
        shapeVersion: -1,
        text: '',
        programVersion: -1,
        exactKey: '',
      },
      ...{ frames: 0, since: 0, twin: null, ready: false, drawn: false, seen: true },
    };
    this.#records.set(mesh, record);
    return record;
  }

  /** three.js deletes a program's shaders when it is first drawn with, and never those of one that is not. */
  #deleteShaders(twin: ExactMaterial): void {
    const renderer = this.#renderer;
    const program = renderer === null ? undefined : programOf(renderer, twin)?.program;
    const gl = renderer?.getContext();
    if (program !== undefined)
      for (const shader of gl?.getAttachedShaders(program) ?? []) gl?.deleteShader(shader);
  }

  #end(record: Record): void {
    this.#drop(record);
    record.near.dispose();
  }

  #drop(record: Record): void {
    if (this.#compiling === record) this.#compiling = null;
    if (record.twin === null) return;
    if (!record.drawn) this.#deleteShaders(record.twin);
    record.twin.dispose();
    record.twin = null;
    record.ready = false;
    record.drawn = false;
    programs -= 1;
  }
}

/** Whether a program for this would be the record's own. */
function isAsBefore(
  record: Record,
  { programVersion, exactKey }: PhongMaterial,
  list: LightList,
  form: ExactForm,
  usual: boolean,
  apart: boolean,
): boolean {
  const { choice, shapeVersion } = record;
  record.shapeVersion = list.shapeVersion;
  return (
    choice?.list === list &&
    choice.form === form &&
    choice.usual === usual &&
    choice.apart === apart &&
    record.programVersion === programVersion &&
    record.exactKey === exactKey &&
    // Written out, every light's shape and row is in the program; in loops only what the shapes have in common.
    (shapeVersion === list.shapeVersion || (isCommon(form) && record.text === commonText(list, form)))
  );
}

const isCommon = (form: ExactForm): boolean => form === 'loops' || form === 'cells';

const commonText = (list: LightList, form: ExactForm): string =>
  isCommon(form) ? exactText(form, list.packed, ALL_TERMS) : '';

function isReady(renderer: WebGLRenderer, material: Material, frames: number): boolean {
  if (frames < UNTOLD_FRAMES && !renderer.extensions.has('KHR_parallel_shader_compile')) return false;
  return programOf(renderer, material)?.isReady() ?? false;
}

function hasLinked(renderer: WebGLRenderer, material: Material): boolean {
  const gl = renderer.getContext();
  const program = programOf(renderer, material)?.program;
  return program !== undefined && gl.getProgramParameter(program, gl.LINK_STATUS) === true;
}

/** Not in three.js's types. */
interface Program {
  readonly program: WebGLProgram;
  isReady(): boolean;
}

const programOf = (renderer: WebGLRenderer, material: Material): Program | undefined =>
  (renderer.properties.get(material) as { currentProgram?: Program }).currentProgram;
