// Which chunks hold the code that several readers of models share? Without these groups each shared file would be a request of its own.

export const modelChunks = [
  { name: 'model-content', test: /\/src\/scene\/model\/[^/]+\.ts$/ },
  { name: 'model-triangles', test: /\/src\/scene\/model\/(text|triangles)\/[^/]+\.ts$/ },
];
