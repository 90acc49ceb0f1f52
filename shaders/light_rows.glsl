// Where packed lights are read from: lightRow(i) gives row i. The layout's defines say what stands in a row. With
// STORAGE_OWN the program has a lightRow of its own, before this text.

#if LIGHT_STORAGE == STORAGE_BLOCK
#ifndef LIGHT_BLOCK_ROWS
#define LIGHT_BLOCK_ROWS BLOCK_ROWS
#endif
layout(std140) uniform LightRows {
  highp vec4 uLightRows[LIGHT_BLOCK_ROWS];
};
vec4 lightRow(int i) {
  return uLightRows[i];
}
#elif LIGHT_STORAGE == STORAGE_TEXTURE
uniform highp sampler2D uLightTexture;
vec4 lightRow(int i) {
  return texelFetch(uLightTexture, ivec2(i & ((1 << TEXTURE_ROWS_LOG2) - 1), i >> TEXTURE_ROWS_LOG2), 0);
}
#endif
