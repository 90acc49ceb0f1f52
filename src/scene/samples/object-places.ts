// Where the objects of a scene are, for a picture that is drawn over several tasks. The page moves its own objects at
// any time, and reports it afterwards.
import { Matrix4, type Object3D } from 'three';

export class ObjectPlaces {
  readonly #places: readonly Place[];

  /** Takes them as they are now; world matrices must be up to date. */
  constructor(root: Object3D) {
    const places: Place[] = [];
    root.traverse((object) => {
      const { matrixWorld, visible, children } = object;
      places.push({ object, matrixWorld: matrixWorld.clone(), visible, children: [...children] });
    });
    this.#places = places;
  }

  /** Calls `draw` with all objects where they were. Afterwards they are where the page has put them. */
  during(draw: () => void): void {
    this.#swap();
    try {
      draw();
    } finally {
      this.#swap();
    }
  }

  #swap(): void {
    for (const place of this.#places) {
      const { object } = place;
      now.copy(object.matrixWorld);
      object.matrixWorld.copy(place.matrixWorld);
      place.matrixWorld.copy(now);
      [object.visible, place.visible] = [place.visible, object.visible];
      [object.children, place.children] = [place.children, object.children];
    }
  }
}

/** During a drawing: where the page has put the object. */
interface Place {
  readonly object: Object3D;
  readonly matrixWorld: Matrix4;
  visible: boolean;
  children: Object3D[];
}

const now = /* @__PURE__ */ new Matrix4();
