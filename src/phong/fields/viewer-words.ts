// Words that a viewer's attributes list, and that the code of their rows and pictures goes through.

/** What `helpers` can draw over the picture. */
export const HELPERS = ['lights', 'axes', 'grid', 'normals', 'bounds'] as const;
export type Helper = (typeof HELPERS)[number];

/** Folders of the panel that `gui` can open. */
export const GUI_FOLDERS = ['lights', 'camera', 'shading', 'show', 'meshes'] as const;
