// The parts that most viewers do without: helpers, a legend, the probe, linked cameras. Each is a chunk that is fetched
// with its first use, and removed again.
import type { ReactiveController } from 'lit';
import { lazyCode, reportMissing } from '../../model/lazy-code.js';
import type { ViewerValues } from '../fields/viewer-fields.js';
import type { Viewport } from '../../scene/viewport.js';
import type { CameraSource, PhongViewer } from '../elements.js';
import type { Visibility } from '../page/visibility.js';
import type { ViewerCamera } from './camera.js';
import type { ViewerChildren } from './children.js';
import type { ViewerContext } from './viewer-context.js';
import type { PictureOptions } from './picture-blob.js';
import type { ViewerTree } from './display.js';
import { type ViewerSnapshot, viewerSnapshot } from './viewer-snapshot.js';

/** What an extra sees of its viewer. */
export interface ExtraHost {
  readonly viewer: PhongViewer;
  readonly values: Readonly<ViewerValues>;
  readonly viewport: Viewport;
  readonly camera: ViewerCamera;
  readonly children: ViewerChildren;
  /** `tree.layer` lies over the picture and lets the pointer through. */
  readonly tree: ViewerTree;
  /** The names that helpers have placed over the picture. The probe's keep clear of them. */
  readonly names: { placed: readonly PlacedName[] };
  /** Size of the picture, CSS pixels. 0 × 0 while the viewer has no box. */
  size(): { readonly width: number; readonly height: number };
  snapshot(): ViewerSnapshot;
}

/** CSS pixels of the layer, or of the file that is being drawn. */
export type PlacedName = Readonly<Record<'left' | 'top' | 'right' | 'bottom', number> & { text: string }>;

export interface Extra {
  /** A frame was drawn, or the viewer's own values have changed. */
  update(): void;
  /** The camera moved. The frame that shows it follows. */
  cameraMoved?(source: CameraSource): void;
  /** Draws what lies over the picture as it is in this task, on a canvas of its size. */
  drawOver?(canvas: HTMLCanvasElement, options: PictureOptions): Promise<void> | void;
  dispose(): void;
}

interface Kind {
  readonly wanted: (values: Readonly<ViewerValues>, viewer: PhongViewer) => boolean;
  readonly load: () => Promise<{ readonly create: (host: ExtraHost) => Extra }>;
}

/** Belong to the first picture: it would show another camera. */
const LINKED: Kind = {
  wanted: ({ cameraGroup }, viewer) => cameraGroup !== '' || viewer.parentElement?.localName === 'phong-compare',
  load: lazyCode(() => import('./camera-group.js'), 'linked cameras'),
};

const KINDS: readonly Kind[] = [
  {
    wanted: ({ helpers }) => helpers.length > 0,
    load: lazyCode(() => import('../../overlay/helpers/helpers.js'), 'helpers'),
  },
  {
    wanted: ({ view, viewLight }) => view !== 'shaded' || viewLight !== '',
    load: lazyCode(() => import('../../overlay/legend/legend.js'), 'views'),
  },
  {
    wanted: ({ probe }) => probe !== false,
    load: lazyCode(() => import('../../overlay/probe/probe.js'), 'the probe'),
  },
  {
    wanted: ({ probe, probeAt }) => probe === false && probeAt !== null,
    load: lazyCode(() => import('../../overlay/probe/watch.js'), 'the probe'),
  },
  LINKED,
];

export class ViewerExtras implements ReactiveController {
  readonly #context: ViewerContext;
  readonly #camera: ViewerCamera;
  readonly #children: ViewerChildren;
  readonly #visibility: Visibility;
  readonly #names: ExtraHost['names'] = { placed: [] };
  /** Null while its code is being fetched. */
  readonly #extras = new Map<Kind, Extra | null>();
  readonly #fetching = new Set<Promise<void>>();
  #tree: ViewerTree | null = null;

  constructor(context: ViewerContext, camera: ViewerCamera, children: ViewerChildren, visibility: Visibility) {
    const { signals } = (this.#context = context);
    this.#camera = camera;
    this.#children = children;
    this.#visibility = visibility;
    const { awaited } = signals;
    signals.awaited = () => awaited() || (this.#extras.get(LINKED) === null && context.viewport.stats.frames === 0);
    signals.drawn.listen(() => {
      for (const extra of this.#extras.values()) extra?.update();
    });
    signals.cameraMoved.listen(({ source }) => {
      for (const extra of this.#extras.values()) extra?.cameraMoved?.(source);
    });
  }

  /** The scene as it is now, for what explains it. */
  snapshot(): ViewerSnapshot {
    const { viewer, viewport } = this.#context;
    return viewerSnapshot(viewer, viewport, this.#children, this.#visibility.size);
  }

  connect(tree: ViewerTree): void {
    this.#tree = tree;
  }

  hostConnected(): void {
    this.apply();
  }

  hostDisconnected(): void {
    for (const kind of this.#extras.keys()) this.#drop(kind);
  }

  /** The viewer's values have changed. */
  apply(): void {
    for (const kind of KINDS) {
      const extra = this.#extras.get(kind);
      if (!kind.wanted(this.#context.values, this.#context.viewer)) this.#drop(kind);
      else if (extra === undefined) this.#wait(this.#fetch(kind));
      else extra?.update();
    }
  }

  /** Resolves once the code that is being fetched is in use; never rejects. Null where none is. */
  get pending(): Promise<unknown> | null {
    return this.#fetching.size === 0 ? null : Promise.all(this.#fetching);
  }

  /** What the extras show belongs to this picture, which was captured in this task. */
  async drawOver(picture: HTMLCanvasElement, options: PictureOptions): Promise<void> {
    const extras = KINDS.flatMap((kind) => this.#extras.get(kind) ?? []);
    if (extras.length === 0) return;
    const { width, height } = picture;
    // Apart from the picture: the scene can change while some code is fetched.
    const over = Object.assign(document.createElement('canvas'), { width, height });
    await Promise.all(extras.map(async (extra) => extra.drawOver?.(over, options)));
    picture.getContext('2d')?.drawImage(over, 0, 0);
  }

  #wait(fetched: Promise<void>): void {
    this.#fetching.add(fetched);
    void fetched.then(() => {
      this.#fetching.delete(fetched);
      this.#context.viewport.animate(); // the first picture may have waited for it
      this.#context.signals.ended.emit();
    });
  }

  #drop(kind: Kind): void {
    const extra = this.#extras.get(kind);
    this.#extras.delete(kind);
    extra?.dispose();
  }

  async #fetch(kind: Kind): Promise<void> {
    const tree = this.#tree;
    if (tree === null) return;
    this.#extras.set(kind, null);
    const code = await kind.load().catch(reportMissing);
    if (this.#extras.get(kind) !== null) return;
    this.#extras.delete(kind);
    if (code === undefined || !this.#context.viewer.isConnected) return;
    const { viewer, values, viewport } = this.#context;
    const extra = code.create({
      viewer,
      values,
      viewport,
      tree,
      names: this.#names,
      camera: this.#camera,
      children: this.#children,
      size: () => this.#visibility.size,
      snapshot: () => this.snapshot(),
    });
    this.#extras.set(kind, extra);
    extra.update();
  }
}
