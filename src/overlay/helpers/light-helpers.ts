// The helpers of a viewer's lights: their marks and names as a display list, and their handles. Marks of a light are computed again only
// where the light, the view or what hides it has changed. Knows no pointer and no SVG.
import { sameValue } from '../../fields/field-store.js';
import type { LightValues } from '../../light/light-state.js';
import { fieldsOf } from '../../element/internals.js';
import { numberedName, type PhongLight } from '../../element/phong-light.js';
import { lightName } from '../../element/viewer/description.js';
import type { ExtraHost } from '../../element/viewer/extras.js';
import type { Label, Primitive } from '../drawing/display-list.js';
import { boxAround, placeLabels } from '../drawing/label-layout.js';
import type { Projection } from '../drawing/projection.js';
import { shortened, textWidth } from '../drawing/text-width.js';
import { Handles } from './handles.js';
import { type LightMarks, lightMarks } from './light-marks.js';
import { Occlusion } from './occlusion.js';
import type { SceneBall } from './placed-light.js';

/** What a light's marks were computed from. */
interface Known {
  readonly values: LightValues;
  readonly view: Projection;
  readonly hidden: boolean;
  readonly marks: LightMarks;
}

/** Between a light's place and its name, CSS pixels. */
const GAP = 12;

const LABEL = { dimmed: 0.75, color: '#fff' } as const;

export class LightHelpers {
  readonly #host: ExtraHost;
  readonly #handles: Handles;
  readonly #occlusion: Occlusion<PhongLight>;
  readonly #known = new Map<PhongLight, Known>();
  readonly #labels = new Map<PhongLight, Label>();

  /** `changed` is called when marks look different although nothing was drawn. */
  constructor(host: ExtraHost, place: HTMLElement, changed: () => void) {
    this.#host = host;
    this.#handles = new Handles(host, place);
    this.#occlusion = new Occlusion(host, changed);
  }

  /** Shows the handles. The list is what to draw. */
  show(view: Projection, scene: SceneBall): readonly Primitive[] {
    const lights = this.#host.children.lights;
    let changed = lights.length !== this.#known.size;
    for (const light of this.#known.keys()) if (!lights.includes(light)) this.#forget(light);
    for (const light of lights) {
      const { values } = fieldsOf(light).store;
      const hidden = this.#occlusion.isHidden(light);
      const known = this.#known.get(light);
      if (known?.view === view && known.hidden === hidden && sameValues(known.values, values)) continue;
      changed = true;
      const marks = lightMarks(values, view, scene, hidden);
      this.#known.set(light, { values: { ...values }, view, hidden, marks });
    }
    const marks = lights.map((light) => this.#known.get(light)!.marks);
    this.#handles.show(lights, marks, view, scene);
    this.#occlusion.follow(
      view,
      lights.map((light, i) => [light, marks[i]!.placed.place] as const),
      changed,
    );
    return [...marks.flatMap(({ list }) => list), ...this.#labelsOf(lights, marks, view)];
  }

  /** The list alone, for another size. */
  listAt(view: Projection, scene: SceneBall): readonly Primitive[] {
    const { lights } = this.#host.children;
    const marks = lights.map((light) =>
      lightMarks(fieldsOf(light).store.values, view, scene, this.#occlusion.isHidden(light)),
    );
    return [...marks.flatMap(({ list }) => list), ...this.#labelsOf(lights, marks, view)];
  }

  hide(): readonly Primitive[] {
    this.#handles.hide();
    this.#occlusion.stop();
    for (const light of [...this.#known.keys()]) this.#forget(light);
    return [];
  }

  dispose(): void {
    this.#handles.dispose();
    this.#occlusion.stop();
  }

  #forget(light: PhongLight): void {
    this.#known.delete(light);
    this.#labels.delete(light);
  }

  #labelsOf(lights: readonly PhongLight[], marks: readonly LightMarks[], view: Projection): readonly Label[] {
    const { texts } = this.#host.viewer;
    const names = lights.map((light, i) => {
      const { values } = fieldsOf(light).store;
      return shortened(lightName(texts, values.name || numberedName(i, texts), values));
    });
    const places = marks.map(({ handles }) => handles[0]!.at);
    const placed = placeLabels(
      names.map((name, i) => ({ center: places[i]!, gap: GAP, width: textWidth(name) })),
      view,
      marks.flatMap(({ handles }) => handles.map(({ at }) => boxAround(at, GAP / 2))),
    );
    return lights.flatMap((light, i) => {
      const at = placed[i];
      if (!at) return [];
      const known = this.#labels.get(light);
      const text = names[i]!;
      const opacity = light.active ? 1 : LABEL.dimmed;
      if (known?.text === text && known.opacity === opacity && known.at.x === at.x && known.at.y === at.y)
        return [known];
      const label: Label = { kind: 'label', at, text, color: LABEL.color, opacity };
      this.#labels.set(light, label);
      return [label];
    });
  }
}

function sameValues(a: Readonly<LightValues>, b: Readonly<LightValues>): boolean {
  for (const key in a) if (!sameValue(a[key as keyof LightValues], b[key as keyof LightValues])) return false;
  return true;
}
