// The control panel: its folders, and which change refreshes which. It writes declared values and
// the camera, and requests no frames. Loaded on demand.
import { GUI } from 'lil-gui';
import { GUI_FOLDERS } from '../../phong/fields/viewer-words.js';
import { addStyles, PANEL_PLACE, type PhongMesh, type PhongViewer } from '../../viewer/extra.js';
import controls from './controls.css?inline';
import { addFiles } from './files-row.js';
import { addFlatRows } from './flat-rows.js';
import { ChildFolders, Folder, withoutAnimation } from './folders.js';
import { explain, label, relabel } from './label.js';
import { LIGHTS, newLight } from './light-rows.js';
import { MESHES } from './mesh-rows.js';
import panelStyles from './panel.css?inline';
import { addButton, rowsIn, type ViewerFolder } from './rows.js';
import { SceneRange } from './travel.js';
import { addUndo } from './undo.js';
import { VIEWER_ROWS } from './viewer-rows.js';

export { takeRows } from './viewer-rows.js';

/**
 * In viewers narrower than this, the panel starts closed, because it would hide the picture.
 * `text`: in font sizes; `column`: upper limit in CSS pixels, the width from which the panel stands
 * beside the picture.
 */
const WIDE = { text: 40, column: PANEL_PLACE.wide } as const;

const CHANGES = ['lights', 'camera', 'viewer', 'meshes'] as const;
type Change = (typeof CHANGES)[number];

interface Content {
  readonly update: (change: Change) => void;
  /** A folder was opened. */
  refreshVisible(): void;
  dispose(): void;
}

/**
 * Builds the panel inside `place`. Its styles go to `root`, the viewer's shadow root, so that they
 * follow it into other documents.
 */
export function createPanel(viewer: PhongViewer, place: HTMLElement, root: ShadowRoot) {
  const removeStyles = addStyles(root, panelStyles + controls);
  const gui = newRoot(place);
  const range = new SceneRange(viewer);
  const content = contentOf(viewer, gui, range);
  let { texts } = viewer;
  let isWaiting = false;
  const update = (change: Change) => {
    // Shapes and models come later, and their size with them. Lights can change in each frame, and
    // bring no size.
    if (change !== 'camera' && change !== 'lights' && !isWaiting && !viewer.loaded) {
      isWaiting = true;
      void viewer.ready.then(() => {
        isWaiting = false;
        range.expire();
        (['lights', 'camera', 'meshes'] as const).forEach(content.update);
      });
    }
    content.update(change);
  };
  gui.onOpenClose(() => {
    // lil-gui calls before it has marked the folder as open.
    queueMicrotask(() => {
      content.refreshVisible();
      markOpen(place, gui);
    });
  });
  const stopWaiting = openIfWide(gui, viewer);
  CHANGES.forEach(update);
  markOpen(place, gui);
  return {
    update(change: Change) {
      if (texts !== viewer.texts) {
        ({ texts } = viewer);
        relabel(gui.domElement);
        content.update('lights');
        content.update('meshes');
      }
      update(change);
    },
    dispose() {
      stopWaiting();
      content.dispose();
      gui.destroy();
      removeStyles();
    },
  };
}

/** All folders, or only the rows that `gui` lists. */
function contentOf(viewer: PhongViewer, gui: GUI, range: SceneRange): Content {
  const { gui: listed } = viewer;
  if (typeof listed === 'boolean') return addFolders(viewer, gui, range, ['lights', 'camera']);
  const folders = GUI_FOLDERS.filter((name) => listed.includes(name));
  if (folders.length === listed.length) return addFolders(viewer, gui, range, folders);
  const update = addFlatRows(gui, viewer, range, listed);
  return { update, refreshVisible: update, dispose: () => undefined };
}

type GuiFolder = (typeof GUI_FOLDERS)[number];

/** `open`: the folders that are open at first. */
function addFolders(
  viewer: PhongViewer,
  gui: GUI,
  range: SceneRange,
  open: readonly GuiFolder[],
): Content {
  const stops = [addFullScreen(gui.$title, viewer), addUndo(gui, viewer)];
  const folderOf = (title: ViewerFolder) =>
    new Folder(
      gui,
      title,
      { element: viewer, viewer, range, title: () => title },
      rowsIn(title, VIEWER_ROWS),
    );
  const lights = new ChildFolders(gui, 'Lights', viewer, range, LIGHTS);
  addButton(lights.group, 'add light', () => {
    const light = document.createElement('phong-light');
    Object.assign(light, newLight(viewer.lights.length, range.center, range.reach));
    lights.add(light, () => viewer.append(light));
  });
  const camera = folderOf('Camera');
  const shading = folderOf('Shading');
  const show = folderOf('Show');
  /** The surface of the viewer's own `src` or `geometry`; hidden if it has neither. */
  const surface = folderOf('Material');
  const meshes = new ChildFolders(gui, 'Meshes', viewer, range, MESHES);
  const updateFiles = addFiles(gui, viewer);
  const groups = {
    lights: lights.group,
    camera: camera.gui,
    shading: shading.gui,
    show: show.gui,
    meshes: meshes.group,
  } satisfies Record<GuiFolder, GUI>;
  for (const name of GUI_FOLDERS) {
    groups[name].open(open.includes(name));
  }
  show.gui.show(Object.keys(rowsIn('Show', VIEWER_ROWS)).length > 0);
  let meshList: readonly PhongMesh[] = [];
  return {
    update(change) {
      if (change === 'lights') {
        lights.update();
      } else if (change === 'meshes') {
        if (viewer.meshes !== meshList) {
          range.expire();
        }
        meshList = viewer.meshes;
        meshes.group.show(meshList.length > 0);
        meshes.update();
      } else {
        camera.update();
      }
      if (change !== 'camera') {
        show.update();
      }
      if (change !== 'viewer') return;
      updateFiles();
      shading.update();
      surface.gui.show(viewer.geometry !== null || viewer.src !== '');
      surface.update();
    },
    refreshVisible() {
      for (const each of [lights, meshes, camera, shading, show, surface]) {
        each.refreshVisible();
      }
    },
    dispose() {
      for (const stop of stops) {
        stop();
      }
    },
  };
}

function newRoot(place: HTMLElement): GUI {
  const gui = withoutAnimation(new GUI({ container: place, injectStyles: false }));
  // A press between the controls must focus the panel: otherwise the picture gets the focus and
  // reacts to keys.
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
const markOpen = (place: HTMLElement, gui: GUI): boolean =>
  place.toggleAttribute(PANEL_PLACE.open, !gui._closed);

/**
 * Opens or closes the panel by the viewer's width. A viewer without a size, such as one in a closed
 * dialog, decides when it first has one; until then the panel is closed. The returned function
 * stops waiting for that.
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
    if (hasDecided()) {
      observer.disconnect();
    }
  });
  observer.observe(viewer);
  return () => observer.disconnect();
}

/** A button after `title`, where the browser has full screen. The returned function removes it. */
function addFullScreen(title: HTMLElement, viewer: PhongViewer): () => void {
  if (!viewer.ownerDocument.fullscreenEnabled) return () => undefined;
  const button = document.createElement('button');
  button.type = 'button';
  button.className = 'full-screen';
  const isOn = () => viewer.matches(':fullscreen');
  const update = (): void => explain(button, isOn() ? 'Leave full screen' : 'Full screen');
  button.addEventListener('click', () => {
    // The browser may refuse. Then the page stays as it is.
    (isOn() ? viewer.ownerDocument.exitFullscreen() : viewer.requestFullscreen()).catch(
      () => undefined,
    );
  });
  viewer.addEventListener('fullscreenchange', update);
  title.after(button);
  update();
  return () => {
    viewer.removeEventListener('fullscreenchange', update);
    button.remove();
  };
}
