// The rows of a light, the switch beside its folder's title, and the values that the panel writes:
// those of a new light, and those that make a light directional, a point or a spot.
import type { GUI } from 'lil-gui';
import {
  fieldsOf,
  historyOf,
  lightName,
  type PhongLight,
  type PhongViewer,
} from '../../viewer/extra.js';
import { isSpot, kindOf } from '../../phong/light/light-features.js';
import {
  KINDS,
  LIGHT_SPACES,
  type LightKind,
  type LightValues,
} from '../../phong/light/light-state.js';
import type { Vec3, Vec4 } from '../../phong/math/vector.js';
import type { ChildKind, TitleSwitch } from './folders.js';
import { label } from './label.js';
import {
  color,
  edited,
  flag,
  mapped,
  number,
  oneOf,
  type RowContext,
  type Row,
  type RowTable,
  text,
  vector,
} from './rows.js';
import { linear, logarithmic } from './travel.js';

/** Initial end of the brightness slider; 1 is 255. */
const USUAL_BRIGHTNESS = 4;

const valuesIn = (light: PhongLight): Readonly<LightValues> => fieldsOf(light).store.values;
const hasPlace = (light: PhongLight): boolean => valuesIn(light).position[3] === 1;
const hasCone = (light: PhongLight): boolean => isSpot(valuesIn(light));

/** Sliders for a place follow the scene, those for a direction or in camera space surround zero. */
const position: Row<Vec3, PhongLight> = vector('position', ({ element, range }, axis) =>
  hasPlace(element) && valuesIn(element).space === 'world' ? range.place(axis) : range.vector(),
);

/** No field says the kind: position, axis, aperture and cutoff do. */
const kind: Row<unknown, PhongLight> = {
  add: (gui, place) => {
    const { element: light, viewer } = place;
    const change = new KindChange();
    const row = oneOf(
      'kind',
      KINDS,
      'Directional: w = 0. Point: w = 1. Spot: w = 1 with a cone or decay; the other kinds set aperture 180 and cutoff 0.',
    );
    const value = edited(
      viewer,
      light,
      () => kindOf(valuesIn(light)),
      (next) => {
        const { store } = fieldsOf(light);
        Object.assign(
          light,
          change.writesFor(store.values, next, store.given('axis'), aimOf(place)),
        );
      },
    );
    row.add(gui, place, value);
  },
};

/** The point that a new spot is aimed at, in the light's own space. */
function aimOf({ element, viewer }: RowContext<PhongLight>): Vec3 {
  const { target, radius } = viewer.camera;
  return element.space === 'camera' ? [0, 0, -radius] : target;
}

export const LIGHT_ROWS = {
  name: text('name'),
  active: flag('active'),
  kind,
  ambient: color('ambient', USUAL_BRIGHTNESS),
  diffuse: color('diffuse', USUAL_BRIGHTNESS),
  specular: color('specular', USUAL_BRIGHTNESS),
  position: mapped(
    position,
    ([x, y, z]: Vec4): Vec3 => [x, y, z],
    ([x, y, z], [, , , w]) => [x, y, z, w],
  ),
  axis: { ...vector('axis', linear(-1, 1, 0.01)), shown: hasCone },
  aperture: { ...number('aperture °', linear(0, 180, 0.5)), shown: hasCone },
  cutoff: { ...number('cutoff', logarithmic(1, 1000)), shown: hasCone },
  attenuation: {
    ...vector('attenuation', linear(0, 2, 0.01), ['kc constant', 'kl linear', 'kq quadratic']),
    shown: hasPlace,
  },
  space: oneOf('space', LIGHT_SPACES),
} satisfies RowTable<LightValues, PhongLight, 'kind'>;

/** Turns the light on and off without opening the folder. */
function addSwitch(
  { domElement, $title }: GUI,
  light: PhongLight,
  viewer: PhongViewer,
): TitleSwitch {
  const box = document.createElement('input');
  box.type = 'checkbox';
  box.className = 'switch';
  box.addEventListener('change', () =>
    historyOf(viewer).edit(light, () => (light.active = box.checked)),
  );
  $title.after(box);
  return {
    update() {
      const { active } = valuesIn(light);
      box.checked = active;
      domElement.classList.toggle('off', !active);
    },
    rename: (name) =>
      label(box, (say) => box.setAttribute('aria-label', say('{name} active', { name }))),
  };
}

export const LIGHTS: ChildKind<PhongLight> = {
  rows: LIGHT_ROWS,
  children: ({ lights }) => lights,
  // The element's `name` would search through all siblings, which is slow with hundreds of lights.
  title: (light, index, texts) => lightName(fieldsOf(light).store, index, texts),
  addSwitch,
};

type ConeValues = Pick<LightValues, 'aperture' | 'cutoff'>;

/** For a light that becomes a spot for the first time. */
const FIRST_CONE: ConeValues = { aperture: 30, cutoff: 8 };

const NO_CONE: ConeValues = { aperture: 180, cutoff: 0 };

/** Changes the kind of one light. A kind that it had before gets its former values back. */
export class KindChange {
  #formerCone: ConeValues | null = null;

  /**
   * The values to write so that the light becomes this kind; none if it is already. x, y and z
   * stay. A spot gets its former cone back. Without an axis it is aimed at `target`, a point in the
   * light's own space.
   */
  writesFor(
    light: Readonly<LightValues>,
    kind: LightKind,
    axisGiven: boolean,
    target: Vec3,
  ): Partial<LightValues> {
    if (kindOf(light) === kind) return {};
    const [x, y, z] = light.position;
    const position: Vec4 = [x, y, z, kind === 'directional' ? 0 : 1];
    if (kind !== 'spot') {
      if (!isSpot(light)) return { position };
      this.#formerCone = { aperture: light.aperture, cutoff: light.cutoff };
      return { position, ...NO_CONE };
    }
    // Keep the default axis only if it has been in use.
    const chosen = axisGiven || isSpot(light) || this.#formerCone !== null;
    const axis =
      chosen && light.axis.some((n) => n !== 0) ? {} : { axis: aim(light.position, target) };
    const cone = isSpot({ ...light, ...axis }) ? {} : (this.#formerCone ?? FIRST_CONE);
    return { position, ...axis, ...cone };
  }
}

/** The direction from a place to a point, in short numbers; straight down if they coincide. */
function aim([x, y, z]: Vec4, target: Vec3): Vec3 {
  const offset = [target[0] - x, target[1] - y, target[2] - z] as const;
  const longest = Math.max(...offset.map(Math.abs));
  if (longest === 0) return [0, -1, 0];
  const short = (n: number) => Number((n / longest).toFixed(3)) + 0;
  return [short(offset[0]), short(offset[1]), short(offset[2])];
}

/** Points placed around a circle in steps of this angle never come close to one another. */
const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

/** Dimmer than the default, so that a scene that is lit already does not become white. */
const GREY: Vec3 = [140, 140, 140];

/**
 * A point light beside the scene, each at a different place. World space, scene units.
 *
 * `count`: number of lights so far. `reach`: half the range of the sliders around `center`.
 */
export function newLight(count: number, center: Vec3, reach: number): Partial<LightValues> {
  const angle = GOLDEN_ANGLE * (count + 1);
  const distance = reach / 2;
  const near = (offset: number, middle: number) =>
    Number((middle + distance * offset).toPrecision(3));
  return {
    position: [
      near(0.8 * Math.sin(angle), center[0]),
      near(0.6, center[1]),
      near(0.8 * Math.cos(angle), center[2]),
      1,
    ],
    diffuse: GREY,
    specular: GREY,
  };
}
