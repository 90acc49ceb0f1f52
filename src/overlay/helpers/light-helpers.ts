// The helpers of a viewer's lights: their marks and names, and their handles. Marks of a light are computed again only
// where the light, the view or what hides it has changed.
import { sameValue } from '../../fields/field-store.js';
import type { LightValues } from '../../light/light-state.js';
import { fieldsOf } from '../../element/internals.js';
import type { PhongLight } from '../../element/elements.js';
import { numberedName } from '../../element/phong-light.js';
import { lightNameText } from '../../element/viewer/description.js';
import type { ExtraHost } from '../../element/viewer/extras.js';
import type { Vec3 } from '../../math/vector.js';
import { distanceAlong } from '../../scene/snapshot/pick.js';
import type { SceneSnapshot } from '../../scene/snapshot/scene-snapshot.js';
import { boxAround, type Drawing } from '../drawing/label-layout.js';
import type { Projection, Ray } from '../drawing/projection.js';
import { Handles } from './handles.js';
import { type LightMarks, lightMarks } from './light-marks.js';
import { isBehind, RayTests } from './occlusion.js';
import type { SceneBall } from './placed-light.js';

/** What a light's marks were computed from. */
interface KnownLight {
  readonly values: LightValues;
  readonly view: Projection;
  readonly hidden: boolean;
  readonly surface: number;
  readonly marks: LightMarks;
}

/** Between a light's place and its name, CSS pixels. */
const GAP = 12;

/** The part of lights' names. */
export const LIGHT_NAME = 'light-name';

/** Opacity of the name of a light that is off. */
const DIMMED = 0.75;

export class LightHelpers {
  readonly #host: ExtraHost;
  readonly #handles: Handles;
  readonly #hidden: RayTests<PhongLight, Vec3, boolean>;
  /** Where the axes of spots meet a surface. */
  readonly #surfaces: RayTests<PhongLight, Ray, number>;
  readonly #known = new Map<PhongLight, KnownLight>();

  /** `changed` is called when marks look different although nothing was drawn. */
  constructor(host: ExtraHost, place: HTMLElement, changed: () => void) {
    this.#host = host;
    this.#handles = new Handles(host, place, this.#surfaceOf);
    this.#hidden = new RayTests(host, isBehind, changed);
    const distance = ({ origin, direction }: Ray, _: Projection, shapes: SceneSnapshot): number =>
      distanceAlong(shapes, origin, direction);
    this.#surfaces = new RayTests(host, distance, changed);
  }

  /** Shows the handles, and gives what to draw. `isFrame`: a frame was drawn. */
  show(view: Projection, scene: SceneBall, isFrame: boolean): Drawing {
    const { lights } = this.#host.children;
    const changed: PhongLight[] = [];
    const present = new Set(lights);
    for (const light of this.#known.keys()) if (!present.has(light)) this.#known.delete(light);
    for (const light of lights) {
      const { values } = fieldsOf(light).store;
      const hidden = this.#isHidden(light);
      const surface = this.#surfaceOf(light);
      const known = this.#known.get(light);
      const isSame = known?.view === view && sameValues(known.values, values);
      if (isSame && known.hidden === hidden && known.surface === surface) continue;
      if (!isSame) changed.push(light);
      const marks = lightMarks(values, view, scene, hidden, surface);
      this.#known.set(light, { values: { ...values }, view, hidden, surface, marks });
    }
    const marks = lights.map((light) => this.#known.get(light)!.marks);
    this.#handles.show(lights, marks, view, scene);
    const places = new Map(lights.map((light, i) => [light, marks[i]!.placed.place]));
    // A frame for another reason than a light: a mesh may have moved.
    const asked = isFrame && changed.length === 0 ? lights : changed;
    this.#hidden.follow(view, places, asked);
    const axes = new Map<PhongLight, Ray>();
    lights.forEach((light, i) => {
      const { spot, place } = marks[i]!.placed;
      if (spot !== null) axes.set(light, { origin: place, direction: spot.axis });
    });
    this.#surfaces.follow(view, axes, asked);
    return this.#drawing(lights, marks);
  }

  /** The same for another size, without handles. */
  drawingAt(view: Projection, scene: SceneBall): Drawing {
    const { lights } = this.#host.children;
    const marks = lights.map((light) =>
      lightMarks(fieldsOf(light).store.values, view, scene, this.#isHidden(light), this.#surfaceOf(light)),
    );
    return this.#drawing(lights, marks);
  }

  hide(): void {
    this.#handles.hide();
    this.#hidden.stop();
    this.#surfaces.stop();
    this.#known.clear();
  }

  /** Distance along a spot's axis, as last known; Infinity before that. */
  readonly #surfaceOf = (light: PhongLight): number => this.#surfaces.answer(light) ?? Infinity;

  #isHidden(light: PhongLight): boolean {
    return this.#hidden.answer(light) === true;
  }

  #drawing(lights: readonly PhongLight[], marks: readonly LightMarks[]): Drawing {
    const { texts } = this.#host.viewer;
    return {
      list: marks.flatMap(({ list }) => list),
      names: lights.map((light, i) => {
        const { values } = fieldsOf(light).store;
        return {
          text: lightNameText(texts, values.name || numberedName(i, texts), values),
          center: marks[i]!.handles[0]!.at,
          gap: GAP,
          part: LIGHT_NAME,
          opacity: values.active ? 1 : DIMMED,
        };
      }),
      covered: marks.flatMap(({ handles }) => handles.map(({ at }) => boxAround(at, GAP / 2))),
    };
  }
}

function sameValues(a: Readonly<LightValues>, b: Readonly<LightValues>): boolean {
  for (const key in a) if (!sameValue(a[key as keyof LightValues], b[key as keyof LightValues])) return false;
  return true;
}
