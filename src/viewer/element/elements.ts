// The elements, their events and explanations, as their users and each other's parts see them. The
// classes implement these types. Types only.
import type { LightValues } from '../../phong/light/light-state.js';
import type { MeshValues } from '../../phong/model/mesh-fields.js';
import type { Vec3 } from '../../phong/math/vector.js';
import type { LightShare } from '../../phong/reference/index.js';
import type { ViewportStats } from '../scene/viewport-stats.js';
import type { CompareProperties, CompareValues } from './fields/compare-fields.js';
import type { Inputs, LightProperties, MeshProperties } from './fields/properties.js';
import type { ViewerErrorCode, ViewerTexts } from './fields/texts.js';
import type { ViewerProperties, ViewerValues } from './fields/viewer-fields.js';
import type { LitElement } from 'lit';
import type { Mesh, Scene } from 'three';

/** The class of an element. */
export interface ElementClass<E extends HTMLElement> {
  new (): E;
  readonly prototype: E;
  readonly observedAttributes: readonly string[];
}

/** A light of the `<phong-viewer>` around it. */
export interface PhongLight extends HTMLElement, LightProperties {
  readonly localName: 'phong-light';
  /**
   * Text shown in the panel and in explanations. Default: `light N`, N counting the viewer's lights
   * from 1.
   */
  get name(): LightProperties['name'];
  set name(name: string | null | undefined);
}

/** A mesh of the `<phong-viewer>` around it. */
export interface PhongMesh extends HTMLElement, MeshProperties {
  readonly localName: 'phong-mesh';
  addEventListener: Listen<this, PhongMeshEventMap>;
  removeEventListener: Listen<this, PhongMeshEventMap>;
}

/** Shows a Phong-lit 3D scene. Lights and meshes are elements inside it, at any depth. */
export interface PhongViewer extends LitElement, ViewerProperties {
  readonly localName: 'phong-viewer';
  addEventListener: Listen<this, PhongViewerEventMap>;
  removeEventListener: Listen<this, PhongViewerEventMap>;
  /** Its `<phong-light>` elements in document order. Frozen; a new list when they change. */
  readonly lights: readonly PhongLight[];
  /**
   * Makes the viewer's lights those of `lights`: `setLights({ sun: { position: [1, 2, 3, 0] },
   * lamp: {} })`. A light of that name is changed, one that is missing is appended, all others are
   * removed. Values that are left out have their defaults. A bad or unknown value throws, and
   * nothing changes. Not a step of undo: that takes back what the user did.
   */
  setLights(lights: LightsByName): void;
  /** Its `<phong-mesh>` elements in document order. Frozen; a new list when they change. */
  readonly meshes: readonly PhongMesh[];
  /** The camera as it is now, wherever the user, `auto-rotate` or `auto` has moved it. */
  readonly camera: CameraState;
  /**
   * Everything requested is there, and shapes have been drawn. False while nothing is requested.
   */
  readonly loaded: boolean;
  /**
   * Texts in place of the element's own, by the English text: `{ 'Try again': 'Nochmal' }`. Others
   * are the page's ({@link ViewerClass.texts}), or English. Reading gives those in use; null, the
   * default, if all are English. Anything but an object of strings throws.
   */
  get texts(): ViewerTexts | null;
  set texts(texts: ViewerTexts | null | undefined);
  /**
   * The three.js scene, for objects of your own. After changing it call {@link requestRender}, or
   * {@link refit} if it has new vertices. In the standalone file, which is without the shaders of
   * three.js's own materials, objects need a ShaderMaterial or a RawShaderMaterial.
   */
  readonly scene: Scene;
  /**
   * Most triangles that all meshes together may hold, shared ones counted once and flat ones 4.4
   * times. A mesh beyond is not shown and reports `too-large`, until it is tried again, by the
   * message's button or by setting this. Default and most: 16,777,216. Lower it where strangers
   * write the markup.
   */
  get maxTriangles(): number;
  set maxTriangles(triangles: number | null | undefined);
  /**
   * Most bytes that vertices and images take together, estimated for the page and the GPU process;
   * the limits of files, images and draws shrink with it. As {@link maxTriangles}; default and
   * most: 950,000,000. If one page shows several viewers of strangers, give each its share.
   */
  get maxMemory(): number;
  set maxMemory(bytes: number | null | undefined);
  readonly stats: ViewerStats;
  /**
   * Resolves once everything requested has been drawn, or could be drawn if it were visible. Never
   * rejects. After a change it is a new promise.
   */
  readonly ready: Promise<void>;
  /**
   * Draws one frame, for changes to {@link scene} that the element cannot see. Measures nothing:
   * target, radius and the geometries' bounds stay.
   */
  requestRender(): void;
  /**
   * Measures the scene again and draws one frame: for new vertices in a geometry, and for a new
   * framing where `target` or `radius` is `auto` and the user has not moved the camera.
   */
  refit(): void;
  /** The picture now, at exactly `width` × `height` pixels. `RangeError` for invalid sizes. */
  toBlob(options?: PictureOptions): Promise<Blob>;
  /**
   * Explains, in float64, the fragment at `x`, `y`: CSS pixels from the picture's top left corner,
   * inside any border, like `offsetX` and `offsetY`. It is the one at the centre of the device
   * pixel there, with `exact` the one at that point. Blended surfaces are explained without
   * what lies behind them, textures without mipmaps. Null where nothing is hit, where an object of
   * your own is nearest (its lines and points are ignored), and while the viewer had no box in the
   * last frame. Rejects unless x and y are finite.
   */
  shadeAt(x: number, y: number, options?: ShadeOptions): Promise<FragmentExplanation | null>;
  /**
   * Explains a point in world space as {@link shadeAt} does a pixel: the surface there, drawn,
   * hidden or outside the picture. Null if no surface is within a two-hundredth of the eye's
   * distance. Rejects unless it is three finite numbers.
   */
  explain(point: readonly [number, number, number]): Promise<FragmentExplanation | null>;
  /** The scene as markup with the camera as it is now: at the same size, the same picture. */
  toHTML(): string;
  /** Back to the last declared camera. */
  resetCamera(): void;
}

/** What {@link PhongViewer.setLights} takes: each light's values, as its properties accept them. */
export type LightsByName = Readonly<
  Record<string, Readonly<Partial<Omit<Inputs<LightValues>, 'name'>>>>
>;

/** What `toBlob` makes. */
export interface PictureOptions {
  /** Pixels, whole, at least 1. Default: the canvas's own size; 300 × 150 without a box on the page. */
  readonly width?: number;
  readonly height?: number;
  /**
   * Any type that the browser's canvas can encode; others give PNG, as there. Default `image/png`.
   */
  readonly type?: string;
  /** 0–1, for lossy types. Default: the browser's. */
  readonly quality?: number;
  /**
   * Draws what `helpers` shows over the picture and the arrows of `probe`, while the viewer is on a
   * page. Default false.
   */
  readonly helpers?: boolean;
  /**
   * Samples per pixel, whole, 1–1,024: the picture is their mean, as with `antialias="full"`. Takes
   * a while, during which the page goes on. A picture whose scene changes begins again, the fourth
   * time in one task: the scene is that of the last beginning. Report changes to the page's own
   * objects in `scene` by `requestRender`. Pictures are drawn one after the other. Default: the
   * picture as the page shows it, where it has this size; otherwise one with smooth edges only.
   */
  readonly samples?: number;
  /**
   * Writes {@link PhongViewer.toHTML} into the file, so that the scene opens again where the file is
   * dropped on a `droppable` viewer. For PNG; not where it has more than 100,000 characters. Default
   * false.
   */
  readonly markup?: boolean;
}

/** The class of `<phong-viewer>`. */
export interface ViewerClass extends ElementClass<PhongViewer> {
  /**
   * Texts for all viewers and comparisons of the page, those added later too, as {@link
   * PhongViewer.texts}. A viewer's own texts go first; those of a `<script type="application/json"
   * data-phong-viewer-texts>` come after these. Reading gives the texts in use on the page. Null,
   * the default, leaves the script's. Throws TypeError for anything but an object of strings.
   */
  get texts(): ViewerTexts | null;
  set texts(texts: ViewerTexts | null | undefined);
}

/**
 * Shows the viewers that are its children over each other, with dividers between them, or side by
 * side.
 */
export interface PhongCompare extends LitElement, CompareProperties {
  readonly localName: 'phong-compare';
  addEventListener: Listen<this, PhongCompareEventMap>;
  removeEventListener: Listen<this, PhongCompareEventMap>;
  /** The viewers that are compared, in document order. */
  readonly viewers: readonly PhongViewer[];
  /** The comparison as markup, with the cameras and dividers as they are now. */
  toHTML(): string;
}

/**
 * A snapshot of what drawing costs. Counts since the viewer was created unless stated otherwise.
 */
export interface ViewerStats extends ViewportStats {
  readonly lightsDeclared: number;
}

/** What moved the camera. */
export type CameraSource = 'pointer' | 'wheel' | 'key' | 'panel' | 'script' | 'auto';

/**
 * The camera as it is now. Frozen. Angles in degrees, lengths in scene units, vectors in world
 * space.
 */
export interface CameraState {
  readonly eye: Vec3;
  readonly target: Vec3;
  readonly up: Vec3;
  /** In [-180, 180). */
  readonly theta: number;
  readonly phi: number;
  readonly radius: number;
}

/**
 * The types of each element, by its tag. Elements that are extras add theirs beside their classes.
 * One without a class in `viewer/index.ts` does not compile.
 */
export interface ElementTypes {
  'phong-light': Types<PhongLight, LightValues>;
  'phong-mesh': Types<PhongMesh, MeshValues, PhongMeshEventMap>;
  'phong-viewer': Types<PhongViewer, ViewerValues, PhongViewerEventMap, ViewerOwnProps>;
  'phong-compare': Types<PhongCompare, CompareValues, PhongCompareEventMap>;
}

/** `Own`: what templates accept besides values. */
export interface Types<Element, Values, Events = object, Own = object> {
  element: Element;
  /** What it declares. */
  values: Values;
  events: Events;
  properties: Own;
}

/** Properties of `<phong-viewer>` without an attribute. */
export interface ViewerOwnProps {
  readonly texts?: ViewerTexts | null | undefined;
  readonly maxTriangles?: number | null | undefined;
  readonly maxMemory?: number | null | undefined;
}

export type ElementsByTag = { [T in keyof ElementTypes]: ElementTypes[T]['element'] };
export type ValuesByTag = { [T in keyof ElementTypes]: ElementTypes[T]['values'] };

declare global {
  // oxlint-disable-next-line typescript/no-empty-object-type
  interface HTMLElementTagNameMap extends ElementsByTag {}
}

export interface ViewerErrorDetail {
  readonly code: ViewerErrorCode;
  /** For the page's author. */
  readonly message: string;
  /** The address that could not be loaded; null if the error is about something else. */
  readonly url: string | null;
}

/** What was loaded. */
export interface LoadDetail {
  readonly url: string;
  /**
   * Images and material libraries that are missing or broken, by the names in the model; empty if
   * all are there.
   */
  readonly missing: readonly string[];
}

/** Events of `<phong-mesh>`. None bubbles. */
export interface PhongMeshEventMap {
  /**
   * Its `src` is shown; `detail.url` is where it came from, `detail.missing` what it is shown
   * without.
   */
  load: CustomEvent<LoadDetail>;
  /** Its `src` cannot be shown; `detail.code` and `detail.message` say why. */
  error: CustomEvent<ViewerErrorDetail>;
}

/** What the probe shows. */
export interface ProbeDetail {
  /** As by `shadeAt`; null where none is explained. */
  readonly fragment: FragmentExplanation | null;
  /** Where it is, as `shadeAt` takes it. Null outside the picture, and while nothing is shown. */
  readonly x: number | null;
  readonly y: number | null;
  /** It stays there when the mouse moves. */
  readonly pinned: boolean;
}

/**
 * Events of `<phong-viewer>`. None bubbles. `progress`, `camera-change` and `light-change` come
 * once for a task, however many there were.
 */
export interface PhongViewerEventMap {
  /**
   * A `src` is shown, the viewer's own or a child's; `detail.url` is where it came from,
   * `detail.missing` what it is shown without.
   */
  load: CustomEvent<LoadDetail>;
  /** Bytes of models have arrived; `detail.totalProgress` is from 0 to 1. */
  progress: CustomEvent<{ readonly totalProgress: number }>;
  /** Something failed: `detail.code`, `detail.message`, and `detail.url`, the address, if any. */
  error: CustomEvent<ViewerErrorDetail>;
  /** The camera moved; `detail.source` says by what. `detail.linked`: with its `camera-group`. */
  'camera-change': CustomEvent<{ readonly source: CameraSource; readonly linked?: true }>;
  /**
   * Lights were written to (`detail.lights`, in that order), added, removed or reordered (it may be
   * empty).
   */
  'light-change': CustomEvent<{ readonly lights: readonly PhongLight[] }>;
  /**
   * The probe's point is another, or has changed: `detail.fragment` at `detail.x` and `detail.y`.
   */
  'probe-change': CustomEvent<ProbeDetail>;
  /** A changed picture is on the canvas. Its pixels can be read in the listener, but not later. */
  render: CustomEvent<null>;
}

/** Events of `<phong-compare>`. None bubbles. */
export interface PhongCompareEventMap {
  /** The user moved a divider; `detail.at` are the places of all, in percent. */
  'divider-change': CustomEvent<{ readonly at: readonly number[] }>;
}

/** All events by name, including those of every element. */
type HeardEvents<Own> = Omit<HTMLElementEventMap, keyof Own> & Own;

/** `addEventListener` and `removeEventListener` of an element with its own events. */
export interface Listen<E, Own> {
  <K extends keyof HeardEvents<Own>>(
    type: K,
    listener: (this: E, event: HeardEvents<Own>[K]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  (
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
}

/** One light's share of a fragment. Frozen. */
export interface LightExplanation extends LightShare {
  /** The light's element; null for the head-light of a viewer without lights. */
  readonly light: PhongLight | null;
  /** Its name as the panel shows it. */
  readonly name: string;
}

export interface ShadeOptions {
  /**
   * Explains the point at `x`, `y` itself, not the one at its pixel's centre: for
   * `antialias="full"`, whose pixels are means. Default false.
   */
  readonly exact?: boolean;
}

/**
 * One fragment by the equation in float64. Frozen; lengths in scene units, vectors in world space.
 */
export interface FragmentExplanation {
  /** The point on the surface. */
  readonly p: Vec3;
  /**
   * Unit normal, interpolated and flipped toward the visible side; zero where the surface has none.
   */
  readonly N: Vec3;
  /** Unit vector toward the eye. */
  readonly V: Vec3;
  /**
   * The element the surface belongs to: a `<phong-mesh>`, or the viewer for its own `src` or
   * `geometry`.
   */
  readonly mesh: PhongMesh | PhongViewer;
  /** Its object in {@link PhongViewer.scene}. */
  readonly object: Mesh;
  /** The object's triangle, counted from 0 in the order of its geometry's index. */
  readonly triangle: number;
  /**
   * Ka, Kd and Ks as the equation uses them: 0–1, with base colour and metalness, decoded if
   * shading is linear.
   */
  readonly ka: Vec3;
  readonly kd: Vec3;
  readonly ks: Vec3;
  /** The specular exponent n. */
  readonly shininess: number;
  /**
   * The factor of ka and kd from a model's own colour, texture and vertex colours. Encoded sRGB,
   * 0–1; 1 1 1 without any.
   */
  readonly baseColor: Vec3;
  /** E, what the surface adds to the sum itself. Encoded sRGB; black for most. */
  readonly emissive: Vec3;
  /** m, 0–1: ka, kd and ks above include it. */
  readonly metalness: number;
  /** The colour is the base colour, whatever the lights; ka, kd and ks are black. */
  readonly unlit: boolean;
  /**
   * The picture averages texels here, because a texture is drawn smaller than it is; this answer
   * reads the texture at the one point `p`. So `color` can be another one than the picture's.
   */
  readonly filtered: boolean;
  /** How much of `color` the picture shows, 0–1; the rest comes from what lies behind. */
  readonly opacity: number;
  /**
   * One for each of {@link PhongViewer.lights}, in their order, null if it is not active; or the
   * head-light alone. The terms of all of them add up to the sum.
   */
  readonly shares: readonly (LightExplanation | null)[];
  /** The sum over the lights before it is clamped; encoded if shading is linear. 1 is full. */
  readonly sum: Vec3;
  /** The colour drawn: the sum clamped to 0–1. */
  readonly color: Vec3;
}
