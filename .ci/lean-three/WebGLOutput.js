// Output buffers other than the canvas's own, and passes over them: the renderer here is never made with any.

export const WebGLOutput = undefined;
