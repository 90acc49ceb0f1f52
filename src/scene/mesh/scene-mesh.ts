// One declared mesh in the scene: follows its values, loads what they name, and keeps what was shown until something
// else can be. Knows neither elements nor frames.
import { Group, Mesh, type Object3D } from 'three';
import type { SurfaceValues } from '../../material/material-values.js';
import type { PhongLighting } from '../../material/lighting.js';
import { PhongMaterial, type ShadingStyle } from '../../material/phong-material.js';
import { type FieldStore, sameValue } from '../../fields/field-store.js';
import { radians } from '../../math/angle.js';
import { type Content, type ContentPart, modelContent, NOTHING, shapeContent } from './content.js';
import { flatGeometry } from '../../material/flat-geometry.js';
import type { MeshValues, ShapeValues } from './mesh-fields.js';
import type { CrossOrigin } from '../model/load-model.js';

/** The picture that a mesh is in. */
export interface MeshHost {
  readonly lighting: PhongLighting;
  readonly style: ShadingStyle;
  readonly crossOrigin: CrossOrigin;
  /** Loading may begin: false while a lazy viewer has not been seen. */
  readonly mayLoad: boolean;
  /** It looks different: draw again. */
  changed(): void;
  /** Its triangles or its place are different: measure again. */
  reshaped(): void;
  progress(mesh: SceneMesh, loaded: number, total: number): void;
  /** A load that began has ended: with what it loaded, or why not. Not told of loads that were overtaken. */
  ended(mesh: SceneMesh, url: URL | null, error: unknown): void;
  /** What it had asked for, loading or failed, is asked for no more. */
  dropped(mesh: SceneMesh): void;
}

type Values = Readonly<ShapeValues & Partial<Omit<MeshValues, keyof ShapeValues>>>;

interface Part {
  readonly mesh: Mesh;
  readonly material: PhongMaterial;
  readonly source: ContentPart;
}

const SURFACE_KEYS = ['ka', 'kd', 'ks', 'shininess'] as const satisfies readonly (keyof SurfaceValues)[];

export class SceneMesh {
  readonly root = new Group();
  readonly #state: FieldStore<ShapeValues> | FieldStore<MeshValues>;
  readonly #host: MeshHost;
  #content: Content = NOTHING;
  #parts: readonly Part[] = [];
  #loading: AbortController | null = null;
  #asked: string | null = null;
  readonly #retired = new Set<PhongMaterial>();
  #showsModel = false;
  /** Position, rotation and scale as last written to the scene: measuring it anew costs a pass over all vertices. */
  #placed: readonly number[] = [];

  constructor(state: FieldStore<ShapeValues> | FieldStore<MeshValues>, host: MeshHost) {
    this.#state = state;
    this.#host = host;
  }

  get #values(): Values {
    return this.#state.values;
  }

  /** Something is asked for that is not shown yet, and may still come. */
  get loading(): boolean {
    return this.#loading !== null;
  }

  /** Its `src` is what it shows. */
  get showsModel(): boolean {
    return this.#showsModel && this.#asked !== null && !this.loading;
  }

  /** After a drawing: gives back the programs of what was shown before, which what is shown now may have taken over. */
  sweep(): void {
    if (this.#retired.size === 0) return;
    for (const material of this.#retired) material.dispose();
    this.#retired.clear();
  }

  /** What shows this mesh: three.js meshes, each with its material. */
  get parts(): readonly Part[] {
    return this.#parts;
  }

  /** Whether `object` is one of those that show this mesh. */
  shows(object: Object3D): boolean {
    return this.#parts.some(({ mesh }) => mesh === object);
  }

  /** Values were written: bring everything in step. Cheap where nothing changed. */
  update(): void {
    this.#load();
    this.#place();
    this.restyle();
  }

  /** Shading may differ: the mesh's own or the picture's. */
  restyle(): void {
    const { shading, reflection } = this.#values;
    const { style } = this.#host;
    const own = { ...style, shading: shading ?? style.shading, reflection: reflection ?? style.reflection };
    for (const { mesh, material, source } of this.#parts) {
      material.setStyle(own);
      material.setSurface(this.#surfaceOf(source));
      const geometry = own.shading === 'flat' ? flatGeometry(source.geometry) : source.geometry;
      if (mesh.geometry !== geometry) mesh.geometry = geometry;
    }
    this.#host.changed();
  }

  /** Ends any load and frees everything. */
  dispose(): void {
    this.#drop();
    this.#asked = null;
    this.#show(NOTHING);
    this.sweep();
    this.root.removeFromParent();
  }

  /** Attributes win, then what the file says, then the defaults. */
  #surfaceOf(source: ContentPart): SurfaceValues {
    const surface: Partial<Record<keyof SurfaceValues, unknown>> = {};
    const state = this.#state as FieldStore<ShapeValues>;
    for (const key of SURFACE_KEYS) {
      surface[key] = state.given(key) ? state.values[key] : (source.surface[key] ?? state.values[key]);
    }
    return surface as SurfaceValues;
  }

  #place(): void {
    const { position = [0, 0, 0], rotation = [0, 0, 0], scale = [1, 1, 1], name = '' } = this.#values;
    const { root } = this;
    root.name = name;
    const place = [...position, ...rotation, ...scale];
    if (sameValue(place, this.#placed)) return;
    this.#placed = place;
    root.position.set(...position);
    root.rotation.set(radians(rotation[0]), radians(rotation[1]), radians(rotation[2]));
    root.scale.set(...scale);
    this.#host.reshaped();
  }

  #load(): void {
    const { src, geometry, segments } = this.#values;
    const { mayLoad, crossOrigin } = this.#host;
    const asked = src === '' ? `${geometry ?? ''} ${String(segments)}` : `src ${src} ${crossOrigin ?? ''}`;
    if (asked === this.#asked || (src !== '' && !mayLoad)) return;
    this.#drop();
    this.#asked = asked;
    if (src !== '') {
      const url = addressOf(src);
      this.#await(url, (signal) => this.#loadModel(url, src, signal));
    } else if (geometry === null) {
      this.#show(NOTHING);
    } else {
      const content = shapeContent(geometry, segments);
      if (content instanceof Promise) this.#await(null, () => content);
      else this.#show(content);
    }
  }

  async #loadModel(url: URL | null, src: string, signal: AbortSignal): Promise<Content> {
    if (url === null) throw new TypeError(`src=${JSON.stringify(src)} is not an address`);
    const onProgress = (loaded: number, total: number): void => {
      this.#host.progress(this, loaded, total);
    };
    return modelContent(url, { signal, onProgress, crossOrigin: this.#host.crossOrigin });
  }

  #await(url: URL | null, load: (signal: AbortSignal) => Promise<Content>): void {
    const loading = new AbortController();
    this.#loading = loading;
    load(loading.signal).then(
      (content) => {
        if (this.#loading !== loading) {
          content.dispose();
          return;
        }
        this.#loading = null;
        this.#show(content);
        this.#showsModel = url !== null;
        this.#host.ended(this, url, null);
      },
      (error: unknown) => {
        if (this.#loading !== loading) return;
        this.#loading = null;
        this.#asked = null; // asked for again, it is tried again
        this.#host.ended(this, url, error);
      },
    );
  }

  #drop(): void {
    this.#loading?.abort();
    this.#loading = null;
    this.#host.dropped(this);
  }

  #show(content: Content): void {
    this.#showsModel = false;
    const before = this.#parts;
    for (const { mesh } of before) mesh.removeFromParent();
    this.#content.dispose();
    this.#content = content;
    this.#parts = content.parts.map((source) => {
      // The same look keeps its material, and so its program: another shape compiles nothing.
      const same = before.find((part) => part.source.look === source.look);
      const material = same?.material ?? new PhongMaterial(this.#host.lighting, source.look);
      const mesh = new Mesh(source.geometry, material);
      mesh.name = source.name;
      mesh.matrixAutoUpdate = false;
      mesh.matrix.copy(source.matrix);
      this.root.add(mesh);
      return { mesh, material, source };
    });
    for (const { material } of before) {
      if (!this.#parts.some((part) => part.material === material)) this.#retired.add(material);
    }
    this.restyle();
    this.#host.reshaped();
  }
}

function addressOf(src: string): URL | null {
  return URL.canParse(src, document.baseURI) ? new URL(src, document.baseURI) : null;
}
