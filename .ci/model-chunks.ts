// Which chunks hold the code that several readers of models, or several views, share? Without these groups each shared
// file would be a request of its own. None of them may be the target of an import() by `lazyCode`: such a chunk could
// not be fetched again after a failure.

export const modelChunks = [
  {
    name: 'model-shared',
    test: /\/src\/model\/(slices|model-budget|data-uri|face-normals|image|image-size|owned-model|listed|stl\/stl-kind|text\/utf-16|decoders\/decoder-thread|ktx2\/decode-ktx2)\.ts$/,
  },
  { name: 'model-triangles', test: /\/src\/model\/(left-out|(text|triangles)\/[^/]+)\.ts$/ },
];
