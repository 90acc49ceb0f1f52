// One declared mesh in the scene: follows its values, loads what they name, and keeps showing the last content until the next
// one is there. Knows neither elements nor frames.
import { Group, Matrix4, Mesh, type Object3D } from 'three';
import { flatGeometry } from '../../material/flat-geometry.js';
import type { SurfaceValues } from '../../material/material-values.js';
import type { BaseLook, PhongMaterial, ShadingStyle } from '../../material/phong-material.js';
import type { FieldStore } from '../../fields/field-store.js';
import { radians } from '../../math/angle.js';
import type { Vec3 } from '../../math/vector.js';
import type { CrossOrigin } from '../model/load-model.js';
import { type Content, type ContentPart, modelContent, NOTHING, shapeContent } from './content.js';
import type { MeshValues, ShapeValues } from './mesh-fields.js';
import type { Appearance, SharedMaterials } from './shared-materials.js';

/** The picture that shows a mesh. */
export interface MeshHost {
  readonly materials: SharedMaterials;
  readonly crossOrigin: CrossOrigin;
  /** False while a lazy viewer has not come near the view. */
  readonly mayLoad: boolean;
  /** The mesh looks different: draw again. */
  changed(): void;
  /** The mesh's geometry or place is different: measure again. */
  reshaped(): void;
  progress(mesh: SceneMesh, loaded: number, total: number): void;
  /** A load has ended; `error` is null on success. Not called for loads that a newer one replaced. */
  ended(mesh: SceneMesh, url: URL | null, error: unknown): void;
  /** A load in progress was cancelled, or one that failed is no longer wanted. */
  dropped(mesh: SceneMesh): void;
}

type Values = Readonly<ShapeValues & Partial<Omit<MeshValues, keyof ShapeValues>>>;

interface Part {
  readonly mesh: Mesh;
  readonly source: ContentPart;
  material: PhongMaterial;
  look: BaseLook;
  surface: SurfaceValues;
}

const SURFACE_KEYS = ['ka', 'kd', 'ks', 'shininess'] as const satisfies readonly (keyof SurfaceValues)[];

export class SceneMesh {
  readonly #state: FieldStore<ShapeValues> | FieldStore<MeshValues>;
  readonly #host: MeshHost;
  #parent: Object3D | null = null;
  #root: Object3D | null = null;
  #content: Content = NOTHING;
  #parts: readonly Part[] = [];
  #loading: AbortController | null = null;
  #failed = false;
  /** What the content was requested by; null before the first request and after a failure. */
  #request: string | null = null;
  #showsModel = false;
  /** Position, rotation and scale as last written to the scene; values are replaced when they change. */
  #placed: readonly Vec3[] = [];
  #shading: ShadingStyle['shading'] | null = null;
  #reflection: ShadingStyle['reflection'] | null = null;

  constructor(state: FieldStore<ShapeValues> | FieldStore<MeshValues>, host: MeshHost) {
    this.#state = state;
    this.#host = host;
  }

  /** The mesh in the scene: a three.js mesh, or a group where there are several parts. Null while nothing is shown. */
  get root(): Object3D | null {
    return this.#root;
  }

  /** Shows it below `parent`, whose world matrix is the identity. */
  attach(parent: Object3D): void {
    this.#parent = parent;
    if (this.#root !== null) parent.add(this.#root);
  }

  get #values(): Values {
    return this.#state.values;
  }

  /** A load is in progress. */
  get loading(): boolean {
    return this.#loading !== null;
  }

  /** It shows the model that `src` names. */
  get showsModel(): boolean {
    return this.#showsModel && this.#request !== null && !this.loading;
  }

  /** The three.js meshes that show it, each with its material. */
  get parts(): readonly Readonly<Part>[] {
    return this.#parts;
  }

  /** Brings the scene in step with the values. Cheap where nothing changed. */
  update(): void {
    this.#load();
    this.#place();
    this.restyle();
  }

  /** Brings materials and flat normals in step: the mesh's own style or the picture's may have changed. */
  restyle(): void {
    const { shading = null, reflection = null } = this.#values;
    const { materials } = this.#host;
    const restyled = shading !== this.#shading || reflection !== this.#reflection;
    this.#shading = shading;
    this.#reflection = reflection;
    for (const part of this.#parts) {
      const surface = this.#surfaceOf(part.source);
      const look = this.#lookOf(part.source);
      if (restyled || look !== part.look || !sameSurface(surface, part.surface)) {
        part.surface = surface;
        part.look = look;
        part.material = materials.exchange(part.material, this.#appearanceOf(part));
        part.mesh.material = part.material;
      }
      const { geometry } = part.source;
      const shown = (shading ?? materials.style.shading) === 'flat' ? flatGeometry(geometry) : geometry;
      if (part.mesh.geometry !== shown) part.mesh.geometry = shown;
    }
    this.#host.changed();
  }

  /** Ends any load and frees everything. */
  dispose(): void {
    this.#drop();
    this.#request = null;
    this.#parent = null;
    this.#show(NOTHING);
  }

  /** Attributes win, then the file's values, then the defaults. */
  #surfaceOf(source: ContentPart): SurfaceValues {
    const surface: Partial<Record<keyof SurfaceValues, unknown>> = {};
    const state = this.#state as FieldStore<ShapeValues>;
    for (const key of SURFACE_KEYS) {
      surface[key] = state.given(key) ? state.values[key] : (source.surface[key] ?? state.values[key]);
    }
    return surface as SurfaceValues;
  }

  /** An exponent that the author gives replaces the file's roughness. */
  #lookOf({ look }: ContentPart): BaseLook {
    const state = this.#state as FieldStore<ShapeValues>;
    return state.given('shininess') ? withoutRoughness(look) : look;
  }

  #appearanceOf({ source, look, surface }: Pick<Part, 'source' | 'look' | 'surface'>): Appearance {
    const { sides } = source;
    return { look, sides, surface, shading: this.#shading, reflection: this.#reflection };
  }

  #place(): void {
    const { position = ZERO, rotation = ZERO, scale = ONE, name = '' } = this.#values;
    const [part] = this.#parts;
    const root = this.#root;
    if (root !== null) root.name = name === '' && part?.mesh === root ? part.source.name : name;
    const place = [position, rotation, scale];
    if (place.every((vector, i) => vector === this.#placed[i])) return;
    this.#placed = place;
    if (root !== null) {
      root.position.set(...position);
      root.rotation.set(radians(rotation[0]), radians(rotation[1]), radians(rotation[2]));
      root.scale.set(...scale);
      root.updateMatrix();
    }
    this.#host.reshaped();
  }

  #load(): void {
    const { src, geometry, segments } = this.#values;
    const { mayLoad, crossOrigin } = this.#host;
    const request = src === '' ? `${geometry ?? ''} ${String(segments)}` : `src ${src} ${crossOrigin ?? ''}`;
    if (request === this.#request || (src !== '' && !mayLoad)) return;
    this.#drop();
    this.#request = request;
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
        this.#place();
        this.restyle();
        this.#showsModel = url !== null;
        this.#host.ended(this, url, null);
      },
      (error: unknown) => {
        if (this.#loading !== loading) return;
        this.#loading = null;
        this.#request = null; // another request for the same tries again
        this.#failed = true;
        this.#host.ended(this, url, error);
      },
    );
  }

  #drop(): void {
    const wanted = this.loading || this.#failed;
    this.#loading?.abort();
    this.#loading = null;
    this.#failed = false;
    if (wanted) this.#host.dropped(this);
  }

  /** Call {@link #place} and {@link restyle} next. */
  #show(content: Content): void {
    this.#showsModel = false;
    const { materials } = this.#host;
    const before = this.#parts;
    const { shading = null, reflection = null } = this.#values;
    this.#shading = shading;
    this.#reflection = reflection;
    this.#parts = content.parts.map((source) => {
      const surface = this.#surfaceOf(source);
      const look = this.#lookOf(source);
      const material = materials.acquire(this.#appearanceOf({ source, look, surface }));
      const mesh = new Mesh(source.geometry, material);
      mesh.name = source.name;
      mesh.matrixAutoUpdate = false;
      return { mesh, material, look, surface, source };
    });
    // After the new ones are acquired: equal looks keep their material, and so their program.
    for (const { material } of before) materials.release(material);
    this.#root?.removeFromParent();
    this.#content.dispose();
    this.#content = content;
    this.#root = rootOf(this.#parts);
    if (this.#root !== null) this.#parent?.add(this.#root);
    this.#placed = []; // the new root has no place yet
  }
}

/** A part that its content does not move needs no group around it: 2,000 boxes are 2,000 objects. */
function rootOf(parts: readonly Part[]): Object3D | null {
  const [first] = parts;
  if (first === undefined) return null;
  if (parts.length === 1 && first.source.matrix.equals(IDENTITY)) return first.mesh;
  const group = new Group();
  group.matrixAutoUpdate = false;
  for (const { mesh, source } of parts) {
    mesh.matrix.copy(source.matrix);
    group.add(mesh);
  }
  return group;
}

const IDENTITY = /* @__PURE__ */ new Matrix4();

const smooth = new WeakMap<BaseLook, BaseLook>();

/** The same object each time: materials are compared by it. */
function withoutRoughness(look: BaseLook): BaseLook {
  if (look.roughness === null) return look;
  const known = smooth.get(look) ?? { ...look, roughness: null };
  smooth.set(look, known);
  return known;
}

const sameSurface = (a: SurfaceValues, b: SurfaceValues): boolean =>
  a.ka === b.ka && a.kd === b.kd && a.ks === b.ks && a.shininess === b.shininess;

function addressOf(src: string): URL | null {
  return URL.canParse(src, document.baseURI) ? new URL(src, document.baseURI) : null;
}

const ZERO: Vec3 = [0, 0, 0];
const ONE: Vec3 = [1, 1, 1];
