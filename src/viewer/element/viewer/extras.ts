// The parts that most viewers do without: helpers, a legend, the probe, linked cameras,
// explanations and files. Each is a chunk that is fetched with its first use (the table is
// viewer/extras.ts). shadeAt copies the
// scene at the call, because it may change meanwhile.
import type { ReactiveController } from 'lit';
import { reportMissing } from '../../model/provided-code.js';
import { MOST_SAMPLES } from '../fields/viewer-fields.js';
import type { Size } from '../../../phong/math/region.js';
import type { PictureOptions } from '../elements.js';
import { pictureCode } from '../extra-code.js';
import type { Visibility } from '../page/visibility.js';
import { lightName, lightOf } from '../phong-light.js';
import type { ViewerCamera } from './camera.js';
import { elementOf } from './children.js';
import {
  type Extra,
  type ExtraHost,
  type ExtraKind,
  extraKinds,
  type ViewerSnapshot,
} from './extra-host.js';
import type { ViewerContext } from './viewer-context.js';
import type { ViewerTree } from './viewer-tree.js';

export class ViewerExtras implements ReactiveController {
  readonly host: ExtraHost;
  readonly #context: ViewerContext;
  readonly #visibility: Visibility;
  /** Null while its code is being fetched. */
  readonly #extras = new Map<ExtraKind, Extra | null>();
  readonly #fetching = new Set<Promise<void>>();
  #tree: ViewerTree | null = null;

  constructor(context: ViewerContext, camera: ViewerCamera, visibility: Visibility) {
    const { signals } = (this.#context = context);
    this.#visibility = visibility;
    const { viewer, values, viewport } = context;
    const treeNow = (): ViewerTree => this.#tree!;
    this.host = {
      viewer,
      values,
      viewport,
      camera,
      names: { placed: [] },
      pin: null,
      get tree() {
        return treeNow();
      },
      size: () => visibility.size,
      snapshot: () => this.snapshot(),
    };
    signals.drawn.listen(() => {
      for (const extra of this.#extras.values()) {
        extra?.update();
      }
    });
    signals.cameraMoved.listen(({ source }) => {
      for (const extra of this.#extras.values()) {
        extra?.cameraMoved?.(source);
      }
    });
  }

  /** One that belongs to the first picture is being fetched. */
  get awaited(): boolean {
    return (
      this.#context.viewport.frames === 0 &&
      [...this.#extras].some(([{ first }, extra]) => first === true && extra === null)
    );
  }

  snapshot(): ViewerSnapshot {
    const { viewer, viewport } = this.#context;
    const { picture, still } = viewport;
    const { width, height, zoom } = this.#visibility.size;
    return {
      // The triangles of the picture that is shown.
      scene:
        this.#visibility.connected && width > 0 && height > 0
          ? picture.snapshot(
              viewport.whole,
              Math.max(still.samples, 1),
              (mesh) => elementOf(mesh) ?? viewer,
            )
          : null,
      width: width * zoom,
      height: height * zoom,
      lights: picture.lighting.lights.lights.map((state, index) => ({
        light: lightOf(state),
        name: lightName(state, index, viewer.texts),
        values: { ...state.values },
      })),
    };
  }

  /** The picture as a file, with what the extras draw over it. Waits for their code. */
  async toBlob(options: PictureOptions): Promise<Blob> {
    const { pending } = this;
    if (pending !== null) {
      await pending;
    }
    const { viewport } = this.#context;
    const { whole } = viewport;
    // Without a box on the page, as large as an element without CSS.
    const width = options.width ?? (whole.width || 300);
    const height = options.height ?? (whole.height || 150);
    requireCounts({ ...options, width, height });
    const picture = await this.#capture({ width, height }, options);
    const markup = options.markup === true ? this.#context.viewer.toHTML() : '';
    const { pictureBlob } = await pictureCode();
    return pictureBlob(picture, options, markup);
  }

  connect(tree: ViewerTree): void {
    this.#tree = tree;
  }

  hostConnected(): void {
    this.apply();
  }

  hostDisconnected(): void {
    for (const kind of this.#extras.keys()) {
      this.#drop(kind);
    }
  }

  apply(): void {
    for (const kind of extraKinds) {
      const extra = this.#extras.get(kind);
      if (!kind.wanted(this.#context.values, this.#context.viewer)) {
        this.#drop(kind);
      } else if (extra === undefined) {
        this.#wait(this.#fetch(kind));
      } else {
        extra?.update();
      }
    }
  }

  /** Resolves once the code that is being fetched is in use; never rejects. Null where none is. */
  get pending(): Promise<unknown> | null {
    return this.#fetching.size === 0 ? null : Promise.all(this.#fetching);
  }

  /** The picture with what the extras show in the task in which it was captured. */
  async #capture(size: Size, options: PictureOptions): Promise<HTMLCanvasElement> {
    const { viewport } = this.#context;
    const { samples } = options;
    const picture =
      samples === undefined ? viewport.capture(size) : await viewport.still.capture(size, samples);
    const extras = extraKinds.flatMap((kind) => this.#extras.get(kind) ?? []);
    if (extras.length === 0) return picture;
    // Apart from the picture: the scene can change while some code is fetched.
    const over = Object.assign(document.createElement('canvas'), size);
    await Promise.all(extras.map(async (extra) => extra.drawOver?.(over, options)));
    picture.getContext('2d')?.drawImage(over, 0, 0);
    return picture;
  }

  #wait(fetched: Promise<void>) {
    this.#fetching.add(fetched);
    void fetched.then(() => {
      this.#fetching.delete(fetched);
      this.#context.viewport.animate(); // the first picture may have waited for it
      this.#context.signals.ended.emit();
    });
  }

  #drop(kind: ExtraKind) {
    const extra = this.#extras.get(kind);
    this.#extras.delete(kind);
    extra?.dispose();
  }

  async #fetch(kind: ExtraKind): Promise<void> {
    const tree = this.#tree;
    if (tree === null) return;
    this.#extras.set(kind, null);
    const code = await kind.load().catch(reportMissing);
    if (this.#extras.get(kind) !== null) return;
    this.#extras.delete(kind);
    if (code === undefined || !this.#context.viewer.isConnected) return;
    const extra = code.create(this.host);
    this.#extras.set(kind, extra);
    extra.update();
  }
}

/** @throws RangeError unless sizes and samples are whole and in their ranges. */
function requireCounts({ width, height, samples }: PictureOptions) {
  for (const [name, value, most] of [
    ['width', width, Infinity],
    ['height', height, Infinity],
    ['samples', samples, MOST_SAMPLES],
  ] as const) {
    if (value === undefined || (Number.isInteger(value) && value >= 1 && value <= most)) continue;
    const range = most === Infinity ? 'from 1' : `from 1 to ${String(most)}`;
    throw new RangeError(`toBlob: ${name} must be a whole number ${range}, got ${String(value)}`);
  }
}
