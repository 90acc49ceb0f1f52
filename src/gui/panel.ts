// Which folders does the control panel have, and which change refreshes which? It writes through the elements' public properties only
// and requests no frames. Loaded on demand. Must not know how anything is drawn.
import { GUI } from 'lil-gui';
import type { CreatePanel, Panel, PanelChange } from '../element/viewer/panel-api.js';
import type { PhongLight } from '../element/phong-light.js';
import type { PhongMesh } from '../element/phong-mesh.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import { CameraFolder } from './camera-folder.js';
import { ChildFolders } from './child-folders.js';
import { CopyButton } from './copy-html.js';
import { FullScreenButton } from './full-screen.js';
import { addGroup, withoutAnimation, type Folder } from './folder.js';
import { LightFolder } from './light-folder.js';
import { MeshFolder, ownSurfaceFolder } from './mesh-folder.js';
import { newLight } from './new-light.js';
import { adoptStyles } from './panel-styles.js';
import { addButton } from './rows.js';
import { SceneRange } from './scene-range.js';
import { shadingFolder } from './shading-folder.js';

/** In viewers narrower than this, in CSS pixels, the panel starts closed, because it would hide the picture. */
const WIDE = 480;

export const createPanel: CreatePanel = (viewer, place, root) => new ControlPanel(viewer, place, root);

class ControlPanel implements Panel {
  readonly #viewer: PhongViewer;
  readonly #gui: GUI;
  readonly #range: SceneRange;
  readonly #lightGroup: GUI;
  readonly #lights: ChildFolders<PhongLight>;
  readonly #meshGroup: GUI;
  readonly #meshes: ChildFolders<PhongMesh>;
  readonly #camera: CameraFolder;
  readonly #shading: Folder;
  readonly #surface: ReturnType<typeof ownSurfaceFolder>;
  readonly #copy: CopyButton;
  readonly #fullScreen: FullScreenButton;
  readonly #dropStyles: () => void;
  readonly #stopWaiting: () => void;
  #meshList: readonly PhongMesh[] = [];

  constructor(viewer: PhongViewer, place: HTMLElement, root: ShadowRoot) {
    this.#viewer = viewer;
    this.#dropStyles = adoptStyles(root);
    const gui = newRoot(place);
    this.#gui = gui;
    this.#fullScreen = new FullScreenButton(gui.$title, viewer);
    this.#range = new SceneRange(viewer);
    this.#lightGroup = addGroup(gui, 'Lights');
    addButton(this.#lightGroup, 'add light', () => {
      this.#addLight();
    });
    this.#lights = new ChildFolders(this.#lightGroup, (light) => this.#lightFolder(light));
    this.#camera = new CameraFolder(gui, viewer, this.#range);
    this.#shading = shadingFolder(gui, viewer);
    this.#surface = ownSurfaceFolder(gui, viewer);
    this.#meshGroup = addGroup(gui, 'Meshes').close();
    this.#meshes = new ChildFolders(
      this.#meshGroup,
      (mesh) => new MeshFolder(this.#meshGroup, mesh, this.#range),
    );
    this.#copy = new CopyButton(gui, () => viewer.toHTML());
    for (const change of ['lights', 'camera', 'viewer', 'meshes'] as const) this.update(change);
    gui.onOpenClose(() => {
      this.#refreshVisible();
    });
    viewer.addEventListener('load', this.#loaded);
    this.#stopWaiting = openIfWide(gui, viewer);
  }

  update(change: PanelChange): void {
    if (change === 'light' || change === 'lights') this.#lights.update(this.#viewer.lights);
    else if (change === 'mesh' || change === 'meshes') this.#updateMeshes();
    else this.#camera.update();
    if (change !== 'viewer') return;
    this.#updateTexts();
    this.#shading.update();
    this.#surface.update();
  }

  #updateTexts(): void {
    const title = this.#viewer.texts?.controls ?? 'Controls';
    this.#gui.title(title);
    this.#gui.domElement.setAttribute('aria-label', title);
    this.#fullScreen.update();
  }

  dispose(): void {
    this.#viewer.removeEventListener('load', this.#loaded);
    this.#stopWaiting();
    this.#copy.dispose();
    this.#fullScreen.dispose();
    this.#gui.destroy();
    this.#dropStyles();
  }

  /** A folder was opened: refreshes rows that have become visible. */
  #refreshVisible(): void {
    this.#lights.refreshVisible();
    this.#meshes.refreshVisible();
    for (const folder of [this.#camera.folder, this.#shading, this.#surface.folder]) folder.refreshVisible();
  }

  #updateMeshes(): void {
    const { meshes } = this.#viewer;
    if (meshes !== this.#meshList) this.#range.expire();
    this.#meshList = meshes;
    this.#meshGroup.show(meshes.length > 0);
    this.#meshes.update(meshes);
  }

  readonly #loaded = (): void => {
    this.#range.expire();
    this.#lights.update(this.#viewer.lights);
    this.#camera.update();
    this.#updateMeshes();
  };

  #lightFolder(light: PhongLight): LightFolder {
    return new LightFolder(this.#lightGroup, light, this.#viewer, this.#range, () => {
      this.#removeLight(light);
    });
  }

  /** Appends a light, opens its folder and scrolls to it. */
  #addLight(): void {
    const light = document.createElement('phong-light');
    Object.assign(light, newLight(this.#viewer.lights.length, this.#range.center, this.#range.reach));
    this.#viewer.append(light);
    this.update('lights');
    const folder = this.#lights.folderOf(light);
    if (folder === undefined) return;
    folder.gui.open();
    folder.gui.$title.focus({ preventScroll: true });
    const list = this.#gui.$children;
    list.scrollTop += folder.gui.domElement.getBoundingClientRect().top - list.getBoundingClientRect().top;
  }

  /** Removes a light and moves the focus to the next light's title, or to the last one's. */
  #removeLight(light: PhongLight): void {
    const at = this.#viewer.lights.indexOf(light);
    light.remove();
    this.update('lights');
    const { lights } = this.#viewer;
    const next = lights[at] ?? lights.at(-1);
    const folder = next === undefined ? this.#lightGroup : this.#lights.folderOf(next)?.gui;
    folder?.$title.focus({ preventScroll: true });
  }
}

function newRoot(place: HTMLElement): GUI {
  const gui = withoutAnimation(new GUI({ container: place, injectStyles: false }));
  // A press between the controls must focus the panel: otherwise the picture gets the focus and reacts to keys.
  gui.domElement.tabIndex = -1;
  gui.domElement.setAttribute('role', 'group');
  gui.domElement.dir = getComputedStyle(place).direction; // for rules that CSS has no logical property for
  return gui;
}

/**
 * Opens or closes the panel by the viewer's width. A viewer without a size, such as one in a closed dialog, decides when it
 * first has one; until then the panel is closed. The returned function stops waiting for that.
 */
function openIfWide(gui: GUI, viewer: HTMLElement): () => void {
  const hasDecided = (): boolean => {
    gui.open(viewer.clientWidth >= WIDE);
    return viewer.clientWidth > 0 && viewer.clientHeight > 0;
  };
  const view = viewer.ownerDocument.defaultView;
  if (hasDecided() || view === null) return () => undefined;
  gui.close();
  const observer = new view.ResizeObserver(() => {
    if (hasDecided()) observer.disconnect();
  });
  observer.observe(viewer);
  return () => {
    observer.disconnect();
  };
}
