// WebGL's names of what textures are made of. Compressed formats are left out: no loader here makes such textures.

import * as three from 'three/src/constants.js';

const NAMES = new Map([
  [three.UnsignedByteType, 'UNSIGNED_BYTE'],
  [three.UnsignedShort4444Type, 'UNSIGNED_SHORT_4_4_4_4'],
  [three.UnsignedShort5551Type, 'UNSIGNED_SHORT_5_5_5_1'],
  [three.ByteType, 'BYTE'],
  [three.ShortType, 'SHORT'],
  [three.UnsignedShortType, 'UNSIGNED_SHORT'],
  [three.IntType, 'INT'],
  [three.UnsignedIntType, 'UNSIGNED_INT'],
  [three.UnsignedInt248Type, 'UNSIGNED_INT_24_8'],
  [three.FloatType, 'FLOAT'],
  [three.HalfFloatType, 'HALF_FLOAT'],
  [three.AlphaFormat, 'ALPHA'],
  [three.RGBFormat, 'RGB'],
  [three.RGBAFormat, 'RGBA'],
  [three.DepthFormat, 'DEPTH_COMPONENT'],
  [three.DepthStencilFormat, 'DEPTH_STENCIL'],
  [three.RedFormat, 'RED'],
  [three.RedIntegerFormat, 'RED_INTEGER'],
  [three.RGFormat, 'RG'],
  [three.RGIntegerFormat, 'RG_INTEGER'],
  [three.RGBAIntegerFormat, 'RGBA_INTEGER'],
]);

export const WebGLUtils = function (gl) {
  return { convert: (constant) => gl[NAMES.get(constant) ?? constant] ?? null };
};
