// Which parameters of a program are never set here, so that the code for them goes: those of three.js's own materials, which
// the standalone file has no shaders for, and those of what lean-three/ leaves out. For three's WebGLPrograms.js, which
// finds the parameters, and WebGLProgram.js, which writes the defines.

/** What only three.js's own materials have; a texture's channel is a parameter of the same name with `Uv`. */
const ofOwnMaterials = [
  ...['aoMap', 'bumpMap', 'displacementMap', 'emissiveMap', 'lightMap', 'metalnessMap', 'roughnessMap'],
  ...['normalMap', 'normalMapObjectSpace', 'normalMapTangentSpace', 'packedNormalMap'],
  ...['envMap', 'envMapMaxLod', 'envMapMode', 'envMapPMREM', 'envMapSize', 'combine'],
  ...[
    'anisotropy',
    'anisotropyMap',
    'diffuseRoughness',
    'diffuseRoughnessMap',
    'dispersion',
    'retroreflection',
  ],
  ...['clearcoat', 'clearcoatMap', 'clearcoatNormalMap', 'clearcoatRoughnessMap'],
  ...['iridescence', 'iridescenceMap', 'iridescenceThicknessMap'],
  ...['sheen', 'sheenColorMap', 'sheenRoughnessMap'],
  ...['specularColorMap', 'specularIntensityMap', 'specularMap'],
  ...['transmission', 'transmissionMap', 'thicknessMap'],
  ...['gradientMap', 'matcap', 'depthPacking', 'useDepthPacking', 'decodeVideoTextureEmissive'],
];

/** What the renderer here is never made with or told to do. */
const ofRenderers = ['logarithmicDepthBuffer', 'reversedDepthBuffer', 'shadowMapEnabled', 'shadowMapType'];

const names = [...ofOwnMaterials, ...ofRenderers];

/** The module with these parameters taken for false. Throws where three.js has no parameter of a name. */
export function withoutUnsetParameters(code: string): string {
  const missing = names.filter((name) => !new RegExp(`\\bparameters\\.${name}(Uv)?\\b`).test(code));
  if (missing.length > 0) throw new Error(`This three.js release has no parameters ${missing.join(', ')}`);
  const unset = `(?:${names.join('|')})(?:Uv)?`;
  const parts = code
    .replace(new RegExp(`^\\s*array\\.push\\( parameters\\.${unset} \\);$`, 'gm'), '')
    .replace(new RegExp(`^\\s*${unset}: .*,$`, 'gm'), '')
    .replace(new RegExp(`\\bparameters\\.${unset}\\b`, 'g'), 'false')
    .replaceAll('parameters.toneMapping !== NoToneMapping', 'false');
  return withoutUnread(withoutUnread(parts));
}

/** Without constants such as HAS_SHEEN that nothing reads any more: each reads of the material. */
const withoutUnread = (code: string): string =>
  code.replace(/^\s*const (HAS_\w+) = .*;$/gm, (line, name: string) =>
    code.split(new RegExp(`\\b${name}\\b`)).length > 2 ? line : '',
  );
