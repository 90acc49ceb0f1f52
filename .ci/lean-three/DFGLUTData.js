// A table for three.js's physical materials.

export const getDFGLUT = () => null;
