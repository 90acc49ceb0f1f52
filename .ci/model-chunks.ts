// Which chunks hold the code that several readers of models, several views, or panel and controls
// share? Without these groups each shared file would be a request of its own. None of them may be
// the target of an import() by `lazyCode`: such a chunk could not be fetched again after a failure.

export const modelChunks = [
  // With a class of three.js that skinned models and exercises need.
  {
    name: 'model-shared',
    test: /\/textures\/DataTexture\.js$|\/src\/(phong\/model\/model-budget|extras\/models\/(slices|limits|encodings|mesh-animation|model-reader|image|stl\/stl-kind|decoders\/decoder-thread|ktx2\/decode-ktx2))\.ts$/,
  },
  // What helpers, comparison and <phong-probe> have in common with the panel. Before its rows, which
  // would take it with them.
  {
    name: 'followed-drag',
    test: /\/src\/(phong\/camera\/followed-drag|viewer\/element\/page\/copy-text)\.ts$/,
  },
  {
    name: 'round-number',
    test: /\/src\/(viewer\/element\/viewer\/history|phong\/math\/round-number)\.ts$/,
  },
  // What <phong-control>, <phong-probe> and <phong-exercise> have in common.
  { name: 'extra-element', test: /\/src\/viewer\/element\/extra-element\.ts$/ },
  // What <phong-control> has in common with the panel.
  {
    name: 'panel-rows',
    test: /\/src\/extras\/panel\/(?!(panel|flat-rows|control|control-fields|control-rows)\.ts)[^/]+\.ts$|\/lil-gui\//,
  },
  {
    name: 'model-triangles',
    test: /\/src\/extras\/models\/(left-out|(text|triangles)\/[^/]+)\.ts$/,
  },
];
