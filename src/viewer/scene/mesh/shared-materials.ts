// The materials that draw meshes. Meshes of one picture that look alike share one, so that three.js
// changes neither program nor values between them. One without users is freed after the next
// drawing: its program can pass on.
import {
  DEFAULT_STYLE,
  type Shading,
  type ShadingStyle,
} from '../../../phong/material/material-values.js';
import type { PhongLighting } from '../../../phong/material/lighting.js';
import type { BaseLook } from '../../../phong/material/file-surface.js';
import { PhongMaterial } from '../../../phong/material/phong-material.js';
import { Shared } from '../../model/shared.js';
import type { Appearance } from '../../../phong/model/appearance.js';

interface SharedMaterial {
  readonly material: PhongMaterial;
  appearance: Appearance;
}

export class SharedMaterials {
  readonly #lighting: PhongLighting;
  readonly #byKey = new Shared<SharedMaterial>();
  readonly #byMaterial = new Map<PhongMaterial, SharedMaterial>();
  readonly #unused = new Set<SharedMaterial>();
  #style: ShadingStyle = DEFAULT_STYLE;

  constructor(lighting: PhongLighting) {
    this.#lighting = lighting;
  }

  /** The picture's style: what a mesh does not say for itself. */
  get style(): ShadingStyle {
    return this.#style;
  }

  set style(style: ShadingStyle) {
    this.#style = style;
    this.restyle();
  }

  /** Writes the style to all materials: it has changed, or the picture's view. */
  restyle(): void {
    for (const { material, appearance } of this.#byMaterial.values()) {
      material.setStyle(this.#styleOf(appearance));
    }
  }

  /** Those without users that were not freed yet included. */
  get all(): Iterable<PhongMaterial> {
    return this.#byMaterial.keys();
  }

  /** The shading that a mesh's geometry is for. `own`: the mesh's own shading, if it has one. */
  geometryShading(own: Shading | null): Shading {
    return this.#lighting.packing.view?.separate === true ? 'flat' : (own ?? this.#style.shading);
  }

  /** A material for one more user, who gives it back by {@link release}. */
  acquire(appearance: Appearance): PhongMaterial {
    const shared = this.#byKey.acquire(keyOf(appearance), () => this.#create(appearance));
    this.#unused.delete(shared);
    return shared.material;
  }

  /**
   * For a user of `material` who looks otherwise now. One without other users is rewritten in
   * place.
   */
  exchange(material: PhongMaterial, appearance: Appearance): PhongMaterial {
    const key = keyOf(appearance);
    const shared = this.#byMaterial.get(material);
    if (shared !== undefined && this.#byKey.get(key) === shared) return material;
    if (
      shared?.appearance.look === appearance.look &&
      shared.appearance.sides === appearance.sides &&
      this.#byKey.move(shared, key)
    ) {
      this.#write(shared, appearance);
      return material;
    }
    const next = this.acquire(appearance);
    this.release(material);
    return next;
  }

  release(material: PhongMaterial): void {
    const shared = this.#byMaterial.get(material);
    if (shared !== undefined && this.#byKey.release(shared)) {
      this.#unused.add(shared);
    }
  }

  /** After a drawing: frees the materials without users. */
  sweep(): void {
    if (this.#unused.size === 0) return;
    for (const shared of this.#unused) {
      this.#byKey.forget(shared);
      this.#byMaterial.delete(shared.material);
      shared.material.dispose();
    }
    this.#unused.clear();
  }

  #create(appearance: Appearance): SharedMaterial {
    const material = new PhongMaterial(this.#lighting, appearance.look);
    material.sides = appearance.sides;
    const shared = { material, appearance };
    this.#write(shared, appearance);
    this.#byMaterial.set(material, shared);
    return shared;
  }

  #write(shared: SharedMaterial, appearance: Appearance): void {
    shared.appearance = appearance;
    shared.material.setStyle(this.#styleOf(appearance));
    shared.material.setSurface(appearance.surface);
  }

  #styleOf({ shading, reflection }: Appearance): ShadingStyle {
    const style = this.#style;
    return {
      ...style,
      shading: shading ?? style.shading,
      reflection: reflection ?? style.reflection,
    };
  }
}

function keyOf({ look, sides, surface, shading, reflection }: Appearance): string {
  const { ka, kd, ks, shininess } = surface;
  return [lookKeyOf(look), sides, ...ka, ...kd, ...ks, shininess, shading, reflection].join(' ');
}

const lookKeys = new WeakMap<BaseLook, string>();

/** Files describe equal looks by objects of their own; textures are equal only to themselves. */
function lookKeyOf(look: BaseLook): string {
  let key = lookKeys.get(look);
  if (key === undefined) {
    const values = Object.entries(look).map(([name, value]: [string, unknown]) => [
      name,
      textOf(value),
    ]);
    lookKeys.set(look, (key = values.join(' ')));
  }
  return key;
}

const textOf = (value: unknown): string =>
  (value as { uuid?: string } | null)?.uuid ?? String(value);
