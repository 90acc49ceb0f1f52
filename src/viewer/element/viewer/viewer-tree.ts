// The parts of a viewer's shadow tree that others draw into.

/** Elements that the viewer's parts are built on. They stay as long as the viewer. */
export interface ViewerTree {
  /** The picture, without the panel. */
  readonly surface: HTMLElement;
  /** Over the picture; the pointer goes through it. Its room is its last child. */
  readonly layer: HTMLElement;
  /** In the layer: what dividers, labels and panel leave of the picture. */
  readonly room: HTMLElement;
  /** In the room: what a notice leaves of it. The place of legends and boxes. */
  readonly free: HTMLElement;
  readonly panel: HTMLElement;
}
