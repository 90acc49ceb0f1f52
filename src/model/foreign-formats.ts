// Well-known formats that cannot be read. For error messages only. Knows beginnings and extensions, no content.

export interface ForeignFormat {
  /** Such as `an FBX file`. */
  readonly what: string;
  /** What to do about it, as a sentence; by default it is to be exported in a supported format. */
  readonly cure?: string;
}

const MAKE_A_MESH = 'Only surfaces can be lit: make a mesh of it, and save that.';

const BLEND: ForeignFormat = { what: 'a Blender file (BLEND)' };
const COLLADA: ForeignFormat = { what: 'a COLLADA file (DAE)' };
const FBX: ForeignFormat = { what: 'an FBX file' };
const IGES: ForeignFormat = { what: 'an IGES file' };
const MAYA: ForeignFormat = { what: 'a Maya file' };
const OFF: ForeignFormat = { what: 'an OFF file' };
const PICTURE: ForeignFormat = { what: 'a picture', cure: 'Check the address.' };
const SPLAT: ForeignFormat = { what: 'a cloud of splats', cure: MAKE_A_MESH };
const STEP: ForeignFormat = { what: 'a STEP file' };
const USD: ForeignFormat = { what: 'a USD file' };
const USDZ: ForeignFormat = { what: 'a USDZ file' };
const VRML: ForeignFormat = { what: 'a VRML file' };
const X3D: ForeignFormat = { what: 'an X3D file' };
const THREE_DS: ForeignFormat = { what: 'a 3D Studio file (3DS)' };
const THREE_MF: ForeignFormat = { what: 'a 3MF file' };
const ZIP: ForeignFormat = { what: 'a ZIP archive', cure: 'Unpack it, and use the model in it.' };
// Many servers answer with a web page when a file is missing.
const WEB_PAGE: ForeignFormat = { what: 'a web page or XML, not a model', cure: 'Check the address.' };

const EXTENSIONS: Readonly<Record<string, ForeignFormat>> = {
  '3dm': { what: 'a Rhino file (3DM)' },
  '3ds': THREE_DS,
  '3mf': THREE_MF,
  abc: { what: 'an Alembic file (ABC)' },
  amf: { what: 'an AMF file' },
  blend: BLEND,
  c4d: { what: 'a Cinema 4D file (C4D)' },
  dae: COLLADA,
  dwg: { what: 'an AutoCAD file (DWG)' },
  dxf: { what: 'a DXF file' },
  fbx: FBX,
  ifc: { what: 'an IFC file' },
  iges: IGES,
  igs: IGES,
  ksplat: SPLAT,
  lwo: { what: 'a LightWave file (LWO)' },
  ma: MAYA,
  max: { what: 'a 3ds Max file (MAX)' },
  mb: MAYA,
  mtl: { what: 'a material library (MTL)', cure: 'Use the OBJ file that it belongs to.' },
  off: OFF,
  pcd: { what: 'a point cloud (PCD)', cure: MAKE_A_MESH },
  skp: { what: 'a SketchUp file (SKP)' },
  sldprt: { what: 'a SolidWorks file (SLDPRT)' },
  splat: SPLAT,
  spz: SPLAT,
  step: STEP,
  stp: STEP,
  usd: USD,
  usda: USD,
  usdc: USD,
  usdz: USDZ,
  vox: { what: 'a MagicaVoxel file (VOX)' },
  vrml: VRML,
  wrl: VRML,
  x: { what: 'a DirectX file (X)' },
  x3d: X3D,
  xyz: { what: 'a point cloud (XYZ)', cure: MAKE_A_MESH },
  zip: ZIP,
};

/** Beginnings that no other format has, as Latin-1. */
const BEGINNINGS: readonly (readonly [text: string, format: ForeignFormat])[] = [
  ['Kaydara FBX Binary', FBX],
  ['; FBX', FBX],
  ['BLENDER', BLEND],
  ['ISO-10303-21', STEP],
  ['#VRML', VRML],
  ['#usda', USD],
  ['PXR-USDC', USD],
  ['OFF\n', OFF],
  ['OFF\r', OFF],
  ['Ogawa', { what: 'an Alembic file (ABC)' }],
  ['3D Geometry File Format', { what: 'a Rhino file (3DM)' }],
  ['xof 0', { what: 'a DirectX file (X)' }],
  ['\x89PNG', PICTURE],
  ['\xff\xd8\xff', PICTURE],
  ['\x1f\x8b', { what: 'a gzip archive', cure: 'Unpack it, and use the model in it.' }],
];

/** Recognised by the first bytes; null if unknown. */
export function foreignContent(bytes: Uint8Array): ForeignFormat | null {
  const start = new TextDecoder('latin1').decode(bytes.subarray(0, 2048));
  const known = BEGINNINGS.find(([text]) => start.startsWith(text));
  if (known) return known[1];
  if (start.startsWith('PK\x03\x04')) return archiveKind(start);
  if (is3ds(bytes)) return THREE_DS;
  // A byte order mark of UTF-8 reads as these three characters.
  const markup = start.replace(/^ï»¿/, '').trimStart();
  if (!markup.startsWith('<')) return null;
  if (/<COLLADA\b/.test(markup)) return COLLADA;
  return /<X3D\b/.test(markup) ? X3D : WEB_PAGE;
}

/** @param extension lower case, without the dot. */
export const foreignExtension = (extension: string): ForeignFormat | null =>
  Object.hasOwn(EXTENSIONS, extension) ? (EXTENSIONS[extension] ?? null) : null;

/** USDZ and 3MF are ZIP archives; the names of their first files tell them apart. */
function archiveKind(start: string): ForeignFormat {
  if (/\.usd[ac]?/.test(start)) return USDZ;
  return /3D\/|3dmodel|\[Content_Types\]/.test(start) ? THREE_MF : ZIP;
}

/** The first chunk of a 3DS file has the number 0x4D4D and the size of the file. */
function is3ds(bytes: Uint8Array): boolean {
  if (bytes.byteLength < 16) return false;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  return view.getUint16(0, true) === 0x4d4d && view.getUint32(2, true) === bytes.byteLength;
}
