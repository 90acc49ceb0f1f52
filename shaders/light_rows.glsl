// lightRow(i): row i of the packed lights. The layout's defines say what a row holds. With
// STORAGE_OWN the program has a lightRow of its own before this text.

#if LIGHT_STORAGE == STORAGE_UNIFORMS
uniform highp vec4 uLightRows[LIGHT_ROWS];
vec4 lightRow(int i) {
  return uLightRows[i];
}
#elif LIGHT_STORAGE == STORAGE_TEXTURE
uniform highp sampler2D uLightTexture;
uniform highp vec2 uLightTextureScale; // 1 / its width, 1 / its height
vec4 lightRow(int i) {
  // A texel's centre, with nearest filtering and one level: exact. SwiftShader draws a picture with
  // 8 lights in 0.63 of the time that texelFetch takes.
  vec2 texel = vec2(float(i & ((1 << TEXTURE_ROWS_LOG2) - 1)), float(i >> TEXTURE_ROWS_LOG2)) + 0.5;
  return texture(uLightTexture, texel * uLightTextureScale);
}
#elif LIGHT_STORAGE == STORAGE_INLINED
// A macro, so that each literal index reads its literal row at compile time.
const vec4 INLINED_ROWS[] = LIGHT_ROW_LITERALS;
#define lightRow(i) INLINED_ROWS[i]
#endif
