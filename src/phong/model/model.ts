// What a mesh shows, a built-in shape or a loaded model of any format, and why a model cannot be
// shown.
import type { BufferGeometry, Matrix4, Mesh, Object3D } from 'three';
import type { Sides } from '../material/back-faces.js';
import type { BaseLook } from '../material/file-surface.js';
import type { SurfaceValues } from '../material/material-values.js';
import type { GeometrySize } from '../geometry/geometry-size.js';
import type { ShapeValues } from './mesh-fields.js';

/** What a mesh shows. Readers of files and built-in shapes make it, the scene draws it. */
export interface Content {
  /** Empty only in {@link NO_CONTENT}. */
  readonly parts: readonly ContentPart[];
  /** Null if nothing in it moves. */
  readonly motion: Motion | null;
  /** Features of the file that the equation has no place for, by the file's own names. */
  readonly dropped?: ReadonlySet<string>;
  /**
   * Images and material libraries that are missing or broken, by the names in the model: it is
   * shown without them.
   */
  readonly missing?: readonly string[];
  /**
   * Frees geometries and textures and closes their images. Call once for each mesh that shows it.
   */
  dispose(): void;
}

export const NO_CONTENT: Content = { parts: [], motion: null, dispose: () => undefined };

/** A geometry and how it looks, as far as its file or shape says. */
export interface ContentPart {
  /** Its name in the file; may be empty. */
  readonly name: string;
  /**
   * Attributes: `position` (float, finite); `normal` (float, unit length or zero); for each map of
   * the look the texture coordinates of its channel (`uv`, `uv1`, …); `tangent` (unit, w ±1) for a
   * normal map; `color` (as the look says, 3 or 4 components, 0 to 1) if it has vertex colours.
   * Indexed or not. Parts can share geometries or attributes. Vertices that {@link Motion} changes
   * have `DynamicDrawUsage`.
   */
  readonly geometry: BufferGeometry;
  /** Part to mesh, float64, in the file's units. {@link Motion} changes it. */
  readonly matrix: Matrix4;
  readonly look: BaseLook;
  /** `closed` for opaque closed shapes, `double` unless a glTF file says `single`. */
  readonly sides: Sides;
  /** Ka, Kd, Ks and the exponent from formats that have them; HTML's units. */
  readonly surface: Partial<SurfaceValues>;
}

/** The animations of a content. */
export interface Motion {
  /** At least one, in the file's order. Can be empty or repeat. */
  readonly names: readonly string[];
  /**
   * Steps that a pose takes at most, of some 20 ns: each vertex once and once for each morph target
   * that moves it, joints and tracks.
   */
  readonly work: number;
  /**
   * Length in seconds of the animation with this name; of the first one if the name is empty or
   * unknown.
   */
  durationOf(name: string): number;
  /**
   * Writes a pose into the parts' matrices and geometries, bounds of the latter included. After its
   * end an animation begins again. Null: the file's own pose, without animation. Never throws.
   */
  pose(name: string | null, seconds: number): void;
  /**
   * How far the model comes in the poses at the keys of an animation, all parts together; null
   * where it has no vertices. Found with the first call, in slices, by posing it. @throws the
   * signal's reason after an abort.
   */
  reach(name: string, signal: AbortSignal): Promise<GeometrySize | null>;
  /** What {@link reach} has found; undefined before that. */
  knownReach(name: string): GeometrySize | null | undefined;
  /** Goes on from the pose at 0 seconds, which is there already. */
  play(values: AnimationValues, shown: AnimatedContent): PlayedAnimation;
}

export type AnimationValues = Readonly<Pick<ShapeValues, 'autoplay' | 'animationName'>>;

/** What an animation moves. */
export interface AnimatedContent {
  readonly parts: readonly { readonly mesh: Mesh; readonly source: ContentPart }[];
  readonly root: Object3D | null;
  /** `reshaped`: `auto` is to frame something else. */
  readonly picture: { reshaped(): void };
}

/** The pose that a mesh's content shows: that of an animation at a time, or its own. */
export interface PlayedAnimation {
  /** It would play if motion were allowed. */
  readonly plays: boolean;
  /** Steps of each pose. */
  readonly work: number;
  /** Starts another animation, or ends the present one, if the values say so. */
  update(values: AnimationValues): void;
  advance(seconds: number): void;
  /** Brings the parts into the present pose. */
  pose(): void;
  dispose(): void;
}

type ModelErrorCode = 'load-failed' | 'bad-model' | 'too-large' | 'csp' | 'no-scene';

interface ModelErrorOptions extends ErrorOptions {
  /** What the page's author can do: sentences. */
  readonly advice?: string;
  /** What who chose the file can do. Default: the same. */
  readonly ownAdvice?: string;
  readonly logged?: boolean;
}

/** Why a model cannot be shown. Its message is for the page's author: the fact, then the advice. */
export class ModelError extends Error {
  override readonly name = 'ModelError';
  readonly code: ModelErrorCode;
  /** For everyone who sees the page. */
  readonly fact: string;

  /** For who chose the file. */
  readonly ownMessage: string;

  /** The browser has written a line of its own to the console. */
  readonly logged: boolean;

  constructor(code: ModelErrorCode, fact: string, options: ModelErrorOptions = {}) {
    const { advice = '', ownAdvice = advice, logged = code === 'csp' } = options;
    super(`${fact} ${advice}`.trimEnd(), options);
    this.code = code;
    this.fact = fact;
    this.ownMessage = `${fact} ${ownAdvice}`.trimEnd();
    this.logged = logged;
  }
}
