// The programs of three.js's own materials, which the file does not carry.

export const ShaderLib = new Proxy(
  {},
  {
    get(_, name) {
      throw new Error(
        `phong-viewer.standalone.js carries no shaders of three.js's own materials (${String(name)}): ` +
          'use the ES modules with three.js for objects that need them.',
      );
    },
  },
);
