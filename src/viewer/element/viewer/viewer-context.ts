// What the parts of one viewer share: its values, its picture, and signals of what has happened.
import { sizeOnPage } from '../../scene/gpu/atlas-copies.js';
import type { FieldStore } from '../../../phong/fields/field-store.js';
import { Signal } from '../../../phong/fields/signal.js';
import { LightSet } from '../../../phong/light/light-set.js';
import type { Picture } from '../../scene/picture.js';
import { Viewport, ViewportSignals } from '../../scene/viewport.js';
import type { CameraSource, PhongLight, PhongViewer } from '../elements.js';
import type { ViewerValues } from '../fields/viewer-fields.js';
import type { ElementView } from '../page/visibility.js';

export interface CameraMove {
  readonly source: CameraSource;
  /** Another viewer's camera has moved this one. */
  readonly linked: boolean;
}

/** Given at once, in the task in which it happens. */
export class ViewerSignals extends ViewportSignals {
  /** Lights and meshes must be in document order now: a frame begins. */
  readonly orderNeeded = new Signal();
  /** The lights that the `light-change` names that is about to be dispatched. */
  readonly lightsReported = new Signal<readonly PhongLight[]>();
  /** Meshes came, went, changed places or were written to. */
  readonly meshesChanged = new Signal();
  readonly cameraMoved = new Signal<CameraMove>();
  /** Place on the page, visibility or size have changed. */
  readonly viewChanged = new Signal<ElementView>();
  /** Something that `ready` waits for has ended, in whichever way. */
  readonly ended = new Signal();
}

export class ViewerContext {
  readonly viewer: PhongViewer;
  readonly store: FieldStore<ViewerValues>;
  readonly signals = new ViewerSignals();
  readonly lightSet = new LightSet();
  readonly viewport: Viewport;
  readonly picture: Picture;

  /** `holder` will hold the canvas, and nothing else. */
  constructor(viewer: PhongViewer, store: FieldStore<ViewerValues>, holder: HTMLElement) {
    this.viewer = viewer;
    this.store = store;
    this.viewport = new Viewport(holder, this.lightSet, this.signals);
    this.picture = this.viewport.picture;
    this.signals.viewChanged.listen((view) => this.#follow(view));
  }

  get values(): Readonly<ViewerValues> {
    return this.store.values;
  }

  #follow({ pixelWidth, pixelHeight, painted, near, visible, printsAt }: ElementView) {
    this.viewport.resize(sizeOnPage({ width: pixelWidth, height: pixelHeight }));
    this.viewport.visible = visible;
    this.viewport.near = this.values.loading === 'eager' ? painted : near;
    if (printsAt === null) return;
    this.signals.orderNeeded.emit();
    this.viewport.finish();
    this.viewport.converge(printsAt);
  }
}
