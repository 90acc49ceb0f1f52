// The values that a <phong-probe> declares, as its users see them. Types only.
import type { Vec3 } from '../../../phong/math/vector.js';
import type { Inputs, ValuesOf } from './properties.js';

export interface ProbeProperties {
  /** Id of the viewer whose point is explained. Default empty. */
  get for(): string;
  set for(value: Accepted['for']);
  /**
   * `table`: the sum light by light. `formula`: the equation with its numbers. `ask`: the same as
   * questions. Null, the default: `ask` where {@link ask} says what, else `table`.
   */
  get as(): 'table' | 'formula' | 'ask' | null;
  set as(value: Accepted['as']);
  /**
   * World-space point on a surface. Null, the default: the point under the mouse, or pinned by a
   * press (questions: pinned only), before that the viewer's `probe-at`, or the middle of the
   * picture.
   */
  get at(): Vec3 | null;
  set at(value: Accepted['at']);
  /**
   * What is asked: `sum`, or `ambient`, `diffuse` or `specular`, of all lights or of one by its name
   * or id. Empty, the default: everything.
   */
  get ask(): string;
  set ask(value: Accepted['ask']);
  /**
   * Another point of the surface and other coefficients for each text. Empty, the default: those of
   * the scene.
   */
  get seed(): string;
  set seed(value: Accepted['seed']);
  /** Name of its answers in a form. Default empty. */
  get name(): string;
  set name(value: Accepted['name']);
  /** An empty answer is invalid in a form. Default false. */
  get required(): boolean;
  set required(value: Accepted['required']);
}

export type ProbeValues = ValuesOf<ProbeProperties>;
type Accepted = Inputs<ProbeValues>;
