// Which folders does the control panel have, and which change refreshes which? It writes through the elements' public properties only
// and requests no frames. Loaded on demand. Must not know how anything is drawn.
import { GUI } from 'lil-gui';
import type { ViewerTexts } from '../element/fields/texts.js';
import type { CreatePanel, Panel, PanelChange } from '../element/viewer/panel-api.js';
import type { PhongLight } from '../element/phong-light.js';
import type { PhongMesh } from '../element/phong-mesh.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import { historyOf, valuesOf } from '../element/viewer/history.js';
import { ButtonRow } from './button-row.js';
import { CameraFolder } from './camera-folder.js';
import { ChildEditor } from './child-editor.js';
import { ChildFolders } from './child-folders.js';
import { CopyButton } from './copy-html.js';
import { FullScreenButton } from './full-screen.js';
import { addGroup, withoutAnimation, type Folder } from './folder.js';
import { label, relabel } from './label.js';
import { LightFolder } from './light-folder.js';
import { MeshFolder, ownSurfaceFolder } from './mesh-folder.js';
import { chooseModel } from './model-choice.js';
import { newLight } from './new-light.js';
import { adoptStyles } from './panel-styles.js';
import { addButton, type Edit } from './rows.js';
import { savePicture } from './save-picture.js';
import { SceneRange } from './scene-range.js';
import { shadingFolder } from './shading-folder.js';
import { showFolder } from './show-folder.js';
import { listenForUndo } from './undo-keys.js';

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
  readonly #show: Folder;
  readonly #surface: ReturnType<typeof ownSurfaceFolder>;
  readonly #copy: CopyButton;
  readonly #fullScreen: FullScreenButton;
  readonly #dropStyles: () => void;
  readonly #stopWaiting: () => void;
  readonly #stopHistory: () => void;
  #meshList: readonly PhongMesh[] = [];
  /** Those that the panel is written in. */
  #texts: ViewerTexts | null;

  constructor(viewer: PhongViewer, place: HTMLElement, root: ShadowRoot) {
    this.#viewer = viewer;
    this.#texts = viewer.texts;
    this.#dropStyles = adoptStyles(root);
    const gui = newRoot(place);
    this.#gui = gui;
    this.#fullScreen = new FullScreenButton(gui.$title, viewer);
    this.#range = new SceneRange(viewer);
    this.#stopHistory = addUndo(gui, viewer);
    this.#lightGroup = addGroup(gui, 'Lights');
    this.#lights = new ChildFolders(
      this.#lightGroup,
      (light) => new LightFolder(this.#lightGroup, light, viewer, this.#range, lights),
    );
    const lights = new ChildEditor(viewer, this.#lightGroup, this.#lights, () => viewer.lights);
    addButton(this.#lightGroup, 'add light', () => {
      const light = document.createElement('phong-light');
      Object.assign(light, newLight(viewer.lights.length, this.#range.center, this.#range.reach));
      lights.add(light, () => {
        viewer.append(light);
      });
    });
    const edit: Edit = (write, gesture) => {
      historyOf(viewer).edit(valuesOf(viewer), write, gesture);
    };
    this.#camera = new CameraFolder(gui, viewer, this.#range);
    this.#shading = shadingFolder(gui, viewer, edit);
    this.#show = showFolder(gui, viewer, edit);
    this.#surface = ownSurfaceFolder(gui, viewer, edit);
    this.#meshGroup = addGroup(gui, 'Meshes').close();
    this.#meshes = new ChildFolders(
      this.#meshGroup,
      (mesh) => new MeshFolder(this.#meshGroup, mesh, viewer, this.#range, meshes),
    );
    const meshes = new ChildEditor(viewer, this.#meshGroup, this.#meshes, () => viewer.meshes);
    const files = new ButtonRow(gui, 'Files');
    files.add('open model…', () => {
      chooseModel((file) => {
        edit(() => (viewer.src = file), null);
      });
    });
    files.add('save PNG', () => {
      void savePicture(viewer);
    });
    this.#copy = new CopyButton(files, () => viewer.toHTML());
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
    if (change !== 'camera') this.#show.update();
    if (change !== 'viewer') return;
    if (this.#texts !== this.#viewer.texts) this.#relabel();
    this.#shading.update();
    this.#surface.update();
  }

  #relabel(): void {
    this.#texts = this.#viewer.texts;
    relabel(this.#gui.domElement);
  }

  dispose(): void {
    this.#viewer.removeEventListener('load', this.#loaded);
    this.#stopWaiting();
    this.#stopHistory();
    this.#copy.dispose();
    this.#fullScreen.dispose();
    this.#gui.destroy();
    this.#dropStyles();
  }

  /** A folder was opened: refreshes rows that have become visible. */
  #refreshVisible(): void {
    this.#lights.refreshVisible();
    this.#meshes.refreshVisible();
    for (const folder of [this.#camera.folder, this.#shading, this.#show, this.#surface.folder])
      folder.refreshVisible();
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
}

/** Buttons and keys for undo and redo. The returned function stops following the history. */
function addUndo(gui: GUI, viewer: PhongViewer): () => void {
  const history = historyOf(viewer);
  const row = new ButtonRow(gui, 'Undo');
  const undo = row.add('undo', () => history.undo());
  const redo = row.add('redo', () => history.redo());
  undo.setAttribute('aria-keyshortcuts', 'Control+Z Meta+Z');
  redo.setAttribute('aria-keyshortcuts', 'Control+Shift+Z Meta+Shift+Z Control+Y');
  const update = (): void => {
    undo.setAttribute('aria-disabled', String(!history.canUndo));
    redo.setAttribute('aria-disabled', String(!history.canRedo));
  };
  update();
  listenForUndo(gui.domElement, history);
  return history.listen(update);
}

function newRoot(place: HTMLElement): GUI {
  const gui = withoutAnimation(new GUI({ container: place, injectStyles: false }));
  // A press between the controls must focus the panel: otherwise the picture gets the focus and reacts to keys.
  gui.domElement.tabIndex = -1;
  gui.domElement.setAttribute('role', 'group');
  label(gui.domElement, (say) => {
    const title = say('Controls');
    gui.title(title);
    gui.domElement.setAttribute('aria-label', title);
  });
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
