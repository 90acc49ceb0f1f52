// The elements as their users and each other's parts see them. The classes implement these types.
// Types only.
import type { LitElement } from 'lit';
import type { Scene } from 'three';
import type {
  Listen,
  PhongCompareEventMap,
  PhongMeshEventMap,
  PhongViewerEventMap,
} from './events.js';
import type { FragmentExplanation, ShadeOptions } from './explanation.js';
import type { CompareProperties } from './fields/compare-fields.js';
import type { ControlProperties } from './fields/control-properties.js';
import type { LightProperties, MeshProperties } from './fields/properties.js';
import type { ViewerTexts } from './fields/texts.js';
import type { ViewerProperties } from './fields/viewer-fields.js';
import type { Vec3 } from '../../phong/math/vector.js';
import type { ViewportStats } from '../scene/picture.js';

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
  /**
   * The `<phong-light>` elements that belong to this viewer, in document order. Frozen; a new list
   * when they change.
   */
  readonly lights: readonly PhongLight[];
  /**
   * The `<phong-mesh>` elements that belong to this viewer, in document order. Frozen; a new list
   * when they change.
   */
  readonly meshes: readonly PhongMesh[];
  /** The camera as it is now, wherever the user, `auto-rotate` or `auto` has moved it. */
  readonly camera: CameraState;
  /**
   * Everything requested is there, and shapes have been drawn. False while nothing is requested.
   */
  readonly loaded: boolean;
  /**
   * Texts in place of the element's own, by the English text: `{ 'Try again': 'Nochmal' }`. Texts
   * that are left out are the page's ({@link ViewerClass.texts}), or English. Reading gives those
   * in use; null, the default, if all are English. Anything but an object of strings throws.
   */
  get texts(): ViewerTexts | null;
  set texts(texts: ViewerTexts | null | undefined);
  /**
   * The three.js scene, for objects of your own. After changing it call {@link requestRender}, or
   * {@link refit} if it has new vertices. The standalone file does not contain the shaders of
   * three.js's own materials: objects need a ShaderMaterial or a RawShaderMaterial there.
   */
  readonly scene: Scene;
  /**
   * Most triangles that all meshes together may hold, shared shapes and models counted once and
   * flat ones 4.4 times. A mesh beyond is not shown and reports `too-large`, until it is tried
   * again: by the button of the message, or by setting this. Default and most: 16,777,216. Lower it
   * where strangers write the markup.
   */
  get maxTriangles(): number;
  set maxTriangles(triangles: number | null | undefined);
  /**
   * Most bytes that vertices and images may take together, by an estimate for the page and the GPU
   * process; the limits of files, images and draws shrink with it. As {@link maxTriangles};
   * default and most: 950,000,000. Where one page shows several viewers of strangers, give each its
   * share.
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
   * Draws one frame, for changes to {@link scene} that the element cannot see. Keeps target and
   * radius and measures nothing: geometries are taken to have the bounds they had.
   */
  requestRender(): void;
  /**
   * Measures the scene again and draws one frame: for new vertices in a geometry of {@link scene},
   * and for a new framing where `target` or `radius` is `auto` and the user has not moved the
   * camera.
   */
  refit(): void;
  /**
   * The picture now, at exactly `width` × `height` pixels. Rejects with `RangeError` for invalid
   * sizes.
   */
  toBlob(options?: PictureOptions): Promise<Blob>;
  /**
   * Explains the fragment that the picture shows at `x`, `y`, in float64: CSS pixels from its top
   * left corner, inside any border, like `offsetX` and `offsetY`. The fragment is the one at the
   * centre of the device pixel there, or with `exact` the one at that very point. Blended surfaces
   * are explained without what lies behind them, textures without mipmaps. Null where nothing is
   * hit, where an object of your own is nearest (its lines and points are ignored), and while the
   * viewer has no box on the page. Rejects unless x and y are finite numbers.
   */
  shadeAt(x: number, y: number, options?: ShadeOptions): Promise<FragmentExplanation | null>;
  /**
   * Explains a point of the scene, in world space, as {@link shadeAt} does a pixel: the surface
   * there, drawn, hidden or outside the picture. Null if no surface is within a two-hundredth of the
   * eye's distance from it. Rejects unless it is three finite numbers.
   */
  explain(point: readonly [number, number, number]): Promise<FragmentExplanation | null>;
  /**
   * The scene as markup with the camera as it is now. Loaded at the same size, it gives the same
   * picture.
   */
  toHTML(): string;
  /** Back to the last declared camera. */
  resetCamera(): void;
}

/** What `toBlob` makes. */
export interface PictureOptions {
  /** Pixels, whole, at least 1. Default: the canvas's own size, at least 1. */
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

/** Edits one value of viewers, lights or meshes, anywhere on the page. */
export interface PhongControl extends HTMLElement, ControlProperties {
  readonly localName: 'phong-control';
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

declare global {
  interface HTMLElementTagNameMap {
    'phong-light': PhongLight;
    'phong-mesh': PhongMesh;
    'phong-viewer': PhongViewer;
    'phong-compare': PhongCompare;
    'phong-control': PhongControl;
  }
}
