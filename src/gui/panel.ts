// The control panel: its folders, and which change refreshes which. It writes through the elements' public properties
// only and requests no frames. Loaded on demand.
import { GUI } from 'lil-gui';
import { GUI_FOLDERS } from '../element/fields/viewer-fields.js';
import type { ViewerTexts } from '../element/fields/texts.js';
import {
  type CreatePanel,
  OPEN_PANEL,
  type Panel,
  type PanelChange,
  WIDE_PANEL,
} from '../element/viewer/viewer-panel.js';
import type { PhongLight } from '../element/phong-light.js';
import type { PhongMesh } from '../element/phong-mesh.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import { addStyles, removeStyles } from '../element/page/style-sheets.js';
import { ChildEditor } from './child-editor.js';
import { ChildFolders } from './child-folders.js';
import panelColumn from '../element/page/panel-column.css?inline';
import controls from './controls.css?inline';
import { addFiles } from './files-row.js';
import { FlatRows } from './flat-rows.js';
import { addFullScreen } from './full-screen.js';
import { addGroup, Folder, withoutAnimation } from './folder.js';
import { label, relabel } from './label.js';
import { LightFolder } from './light-folder.js';
import { newLight } from './light-values.js';
import { MeshFolder } from './mesh-folder.js';
import panelStyles from './panel.css?inline';
import { addButton, rowsIn } from './rows.js';
import { SceneRange } from './scene-range.js';
import targets from './targets.css?inline';
import { addUndo } from './undo.js';
import { VIEWER_ROWS } from './viewer-folders.js';

/**
 * In viewers narrower than this, the panel starts closed, because it would hide the picture. `text`: in font sizes;
 * `column`: upper limit in CSS pixels, the width from which the panel stands beside the picture.
 */
const WIDE = { text: 40, column: WIDE_PANEL } as const;

/** Added to the viewer's own sheets, so that they follow it into other documents. */
const STYLES = panelColumn + panelStyles + controls + targets;

export const createPanel: CreatePanel = (viewer, place, root) => new ControlPanel(viewer, place, root);

/** What a panel shows below its title. */
interface Content {
  update(change: PanelChange): void;
  /** A folder was opened: refreshes rows that have become visible. */
  refreshVisible(): void;
  /** A model was loaded. */
  loaded(): void;
  dispose(): void;
}

class ControlPanel implements Panel {
  readonly #viewer: PhongViewer;
  readonly #gui: GUI;
  readonly #range: SceneRange;
  readonly #content: Content;
  readonly #root: ShadowRoot;
  readonly #stopWaiting: () => void;
  /** Those that the panel is written in. */
  #texts: ViewerTexts | null;

  constructor(viewer: PhongViewer, place: HTMLElement, root: ShadowRoot) {
    this.#viewer = viewer;
    this.#texts = viewer.texts;
    this.#root = root;
    addStyles(root, STYLES);
    const gui = newRoot(place);
    this.#gui = gui;
    this.#range = new SceneRange(viewer);
    this.#content = contentOf(viewer, gui, this.#range);
    gui.onOpenClose(() => {
      // lil-gui calls before it has marked the folder as open.
      queueMicrotask(() => {
        this.#content.refreshVisible();
        markOpen(place, gui);
      });
    });
    viewer.addEventListener('load', this.#loaded);
    this.#stopWaiting = openIfWide(gui, viewer);
    for (const change of ['lights', 'camera', 'viewer', 'meshes'] as const) this.#content.update(change);
    markOpen(place, gui);
  }

  update(change: PanelChange): void {
    if (change === 'viewer' && this.#texts !== this.#viewer.texts) {
      this.#texts = this.#viewer.texts;
      relabel(this.#gui.domElement);
      this.#content.update('lights');
      this.#content.update('meshes');
    }
    this.#content.update(change);
  }

  dispose(): void {
    this.#viewer.removeEventListener('load', this.#loaded);
    this.#stopWaiting();
    this.#content.dispose();
    this.#gui.destroy();
    removeStyles(this.#root, STYLES);
  }

  readonly #loaded = (): void => {
    this.#range.expire();
    this.#content.loaded();
  };
}

/** All folders, or only the rows that `gui` lists. */
function contentOf(viewer: PhongViewer, gui: GUI, range: SceneRange): Content {
  const { gui: listed } = viewer;
  if (typeof listed === 'boolean') return new Folders(viewer, gui, range, ['lights', 'camera']);
  const folders = GUI_FOLDERS.filter((name) => listed.includes(name));
  if (folders.length === listed.length) return new Folders(viewer, gui, range, folders);
  const rows = new FlatRows(gui, viewer, range, listed);
  const update = (): void => rows.update();
  return { update, refreshVisible: update, loaded: update, dispose: () => undefined };
}

type GuiFolder = (typeof GUI_FOLDERS)[number];

/** The whole panel. */
class Folders implements Content {
  readonly #viewer: PhongViewer;
  readonly #gui: GUI;
  readonly #range: SceneRange;
  readonly #lightGroup: GUI;
  readonly #lights: ChildFolders<PhongLight>;
  readonly #meshGroup: GUI;
  readonly #meshes: ChildFolders<PhongMesh>;
  readonly #camera: Folder<PhongViewer>;
  readonly #shading: Folder<PhongViewer>;
  readonly #show: Folder<PhongViewer>;
  /** The surface of the viewer's own `src` or `geometry`; hidden if it has neither. */
  readonly #surface: Folder<PhongViewer>;
  readonly #files: ReturnType<typeof addFiles>;
  readonly #stops: readonly (() => void)[];
  #meshList: readonly PhongMesh[] = [];

  constructor(viewer: PhongViewer, gui: GUI, range: SceneRange, open: readonly GuiFolder[]) {
    this.#viewer = viewer;
    this.#gui = gui;
    this.#range = range;
    this.#stops = [addFullScreen(gui.$title, viewer), addUndo(gui, viewer)];
    this.#lightGroup = addGroup(gui, 'Lights');
    this.#lights = this.#addLights();
    this.#camera = this.#folder('Camera');
    this.#shading = this.#folder('Shading');
    this.#show = this.#folder('Show');
    this.#surface = this.#folder('Material');
    this.#meshGroup = addGroup(gui, 'Meshes');
    this.#meshes = this.#addMeshes();
    this.#files = addFiles(gui, viewer);
    const groups = {
      lights: this.#lightGroup,
      camera: this.#camera.gui,
      shading: this.#shading.gui,
      show: this.#show.gui,
      meshes: this.#meshGroup,
    } satisfies Record<GuiFolder, GUI>;
    for (const name of GUI_FOLDERS) groups[name].open(open.includes(name));
  }

  #folder(title: 'Camera' | 'Shading' | 'Show' | 'Material'): Folder<PhongViewer> {
    const viewer = this.#viewer;
    const place = { element: viewer, viewer, range: this.#range, title: () => title };
    return new Folder(this.#gui, title, place, rowsIn(title, VIEWER_ROWS));
  }

  #addLights(): ChildFolders<PhongLight> {
    const viewer = this.#viewer;
    const group = this.#lightGroup;
    const folders: ChildFolders<PhongLight> = new ChildFolders(
      group,
      (light) => new LightFolder(group, light, viewer, this.#range, editor),
    );
    const editor = new ChildEditor(viewer, group, folders, () => viewer.lights);
    addButton(group, 'add light', () => {
      const light = document.createElement('phong-light');
      Object.assign(light, newLight(viewer.lights.length, this.#range.center, this.#range.reach));
      editor.add(light, () => viewer.append(light));
    });
    return folders;
  }

  #addMeshes(): ChildFolders<PhongMesh> {
    const viewer = this.#viewer;
    const group = this.#meshGroup;
    const folders: ChildFolders<PhongMesh> = new ChildFolders(
      group,
      (mesh) => new MeshFolder(group, mesh, viewer, this.#range, editor),
    );
    const editor = new ChildEditor(viewer, group, folders, () => viewer.meshes);
    return folders;
  }

  update(change: PanelChange): void {
    if (change === 'lights') this.#lights.update(this.#viewer.lights);
    else if (change === 'meshes') this.#updateMeshes();
    else this.#camera.update();
    if (change !== 'camera') this.#show.update();
    if (change !== 'viewer') return;
    this.#files.update();
    this.#shading.update();
    this.#surface.gui.show(this.#viewer.geometry !== null || this.#viewer.src !== '');
    this.#surface.update();
  }

  refreshVisible(): void {
    this.#lights.refreshVisible();
    this.#meshes.refreshVisible();
    for (const folder of [this.#camera, this.#shading, this.#show, this.#surface]) folder.refreshVisible();
  }

  loaded(): void {
    for (const change of ['lights', 'camera', 'meshes'] as const) this.update(change);
  }

  dispose(): void {
    for (const stop of this.#stops) stop();
    this.#files.dispose();
  }

  #updateMeshes(): void {
    const { meshes } = this.#viewer;
    if (meshes !== this.#meshList) this.#range.expire();
    this.#meshList = meshes;
    this.#meshGroup.show(meshes.length > 0);
    this.#meshes.update(meshes);
  }
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

/** A comparison makes room for it. */
const markOpen = (place: HTMLElement, gui: GUI): boolean => place.toggleAttribute(OPEN_PANEL, !gui._closed);

/**
 * Opens or closes the panel by the viewer's width. A viewer without a size, such as one in a closed dialog, decides
 * when it first has one; until then the panel is closed. The returned function stops waiting for that.
 */
function openIfWide(gui: GUI, viewer: HTMLElement): () => void {
  const hasDecided = (): boolean => {
    const fontSize = parseFloat(getComputedStyle(viewer).fontSize);
    // In a comparison it would cover most of what the dividers leave, unless it stands beside it.
    const beside = getComputedStyle(viewer).getPropertyValue('--phong-dock') !== '';
    gui.open(viewer.clientWidth >= Math.min(beside ? Infinity : WIDE.text * fontSize, WIDE.column));
    return viewer.clientWidth > 0 && viewer.clientHeight > 0;
  };
  const view = viewer.ownerDocument.defaultView;
  if (hasDecided() || view === null) return () => undefined;
  gui.close();
  const observer = new view.ResizeObserver(() => {
    if (hasDecided()) observer.disconnect();
  });
  observer.observe(viewer);
  return () => observer.disconnect();
}
