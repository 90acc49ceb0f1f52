// The helpers of a viewer's lights: their marks, names and handles. Marks are computed again only
// after changes.
import { sameValue } from '../../../phong/fields/field-store.js';
import {
  type ExtraHost,
  fieldsOf,
  lightName,
  lightNameText,
  type PhongLight,
} from '../../../viewer/extra.js';
import { distanceAlong } from '../../explain/pick.js';
import { boxAround, type Drawing } from '../drawing/label-layout.js';
import type { Projection } from '../drawing/projection.js';
import { Handles } from './handles.js';
import { type LightMarks, lightMarks, type PlacedLight, type SceneBall } from './light-marks.js';
import { isBehind, type RayTest, RayTests } from './occlusion.js';

/** Between a light's place and its name, CSS pixels. */
const GAP = 12;

export const LIGHT_NAME = 'light-name';

/** Opacity of the name of a light that is off. */
const DIMMED = 0.75;

const axesOf = (
  lights: readonly (readonly [PhongLight, PlacedLight])[],
): Map<PhongLight, RayTest<number>> =>
  new Map(
    lights.flatMap(([light, { spot, place }]) =>
      spot === null ? [] : [[light, (shapes) => distanceAlong(shapes, place, spot.axis)]],
    ),
  );

export class LightHelpers {
  readonly #host: ExtraHost;
  readonly #handles: Handles;
  readonly #hidden: RayTests<PhongLight, boolean>;
  /** Distances along the axes of spots to the first surface. */
  readonly #surfaces: RayTests<PhongLight, number>;
  /** With what they were computed from. */
  readonly #marks = new WeakMap<
    PhongLight,
    { readonly seen: readonly unknown[]; readonly marks: LightMarks }
  >();

  /** `changed` is called when marks look different although nothing was drawn. */
  constructor(host: ExtraHost, place: HTMLElement, changed: () => void) {
    this.#host = host;
    this.#handles = new Handles(host, place, this.#surfaceOf);
    this.#hidden = new RayTests(host, changed);
    this.#surfaces = new RayTests(host, changed);
  }

  /**
   * Shows the handles, and gives what to draw. `isFrame`: a frame was drawn, in which a mesh may
   * have moved.
   */
  show(view: Projection, scene: SceneBall, isFrame: boolean): Drawing {
    const { lights } = this.#host.viewer;
    const marks = this.#marksOf(lights, view, scene);
    this.#handles.show(lights, marks, view, scene);
    if (isFrame) {
      const tested = lights.map((light, i) => [light, marks[i]!.placed] as const);
      this.#hidden.follow(
        () => new Map(tested.map(([light, { place }]) => [light, isBehind(place, view)])),
      );
      this.#surfaces.follow(() => axesOf(tested));
    }
    return this.#drawing(lights, marks);
  }

  /** The same for another size, without handles. */
  drawingAt(view: Projection, scene: SceneBall): Drawing {
    const { lights } = this.#host.viewer;
    return this.#drawing(lights, this.#marksOf(lights, view, scene));
  }

  hide(): void {
    this.#handles.hide();
    this.#hidden.stop();
    this.#surfaces.stop();
  }

  /** Distance along a spot's axis, as last known; Infinity before that. */
  readonly #surfaceOf = (light: PhongLight): number => this.#surfaces.answer(light) ?? Infinity;

  #marksOf(lights: readonly PhongLight[], view: Projection, scene: SceneBall): LightMarks[] {
    return lights.map((light) => {
      const { values } = fieldsOf(light).store;
      const isHidden = this.#hidden.answer(light) === true;
      const surface = this.#surfaceOf(light);
      const seen = [view, isHidden, surface, ...Object.values(values)];
      const before = this.#marks.get(light);
      if (before !== undefined && sameValue(before.seen, seen)) return before.marks;
      const marks = lightMarks(values, view, scene, isHidden, surface);
      this.#marks.set(light, { seen, marks });
      return marks;
    });
  }

  #drawing(lights: readonly PhongLight[], marks: readonly LightMarks[]): Drawing {
    const { texts } = this.#host.viewer;
    return {
      list: marks.flatMap(({ list }) => list),
      names: lights.map((light, i) => {
        const { store } = fieldsOf(light);
        const { values } = store;
        return {
          text: lightNameText(texts, lightName(store, i, texts), values),
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
