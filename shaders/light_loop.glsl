// The sum over the lights at one point. Everything is in one shading space; colours of the material are applied by
// the caller, once. Needs light_rows, guard, power, attenuation, spot, diffuse_lobe and one specular lobe.

/** What the lights bring before the material: Σ Ia·decay, Σ Id·att·NoL·decay, Σ Is·att·spec·decay. */
struct LightSums {
  vec3 ambient;
  vec3 diffuse;
  vec3 specular;
};

/** Adds one light's diffuse and specular terms, each times `factor`. L unit, or zero where there is no direction. */
void addLobes(inout LightSums sums, vec3 N, vec3 V, vec3 L, float n, vec3 diffuse, vec3 specular, float factor) {
  float NoL = dot(N, L);
  if (NoL > 0.0) {
#ifdef HAS_DIFFUSE
    sums.diffuse += diffuse * (factor * diffuseLobe(NoL));
#endif
#ifdef HAS_SPECULAR
    sums.specular += specular * (factor * specularLobe(N, L, V, NoL, n));
#endif
  }
}

/** L toward a positional light and its distance d; L is zero where the light is at the fragment. */
vec3 towardLight(vec3 place, vec3 p, out float d) {
  vec3 v = place - p;
  float squared = dot(v, v);
  if (squared < NEAREST_SQUARED) {
    d = 0.0;
    return vec3(0.0);
  }
  float inverse = inversesqrt(squared);
  d = squared * inverse;
  return v * inverse;
}

/**
 * Sums all lights at point p with unit normal N (or zero: then only ambient light stays), unit view vector V toward
 * the eye, and specular exponent n >= 0.
 */
LightSums lightSums(vec3 p, vec3 N, vec3 V, float n) {
  LightSums sums = LightSums(vec3(0.0), vec3(0.0), vec3(0.0));
#ifdef HAS_AMBIENT
  sums.ambient = lightRow(HEADER_AMBIENT).rgb;
#endif
  ivec3 counts = ivec3(lightRow(HEADER_COUNTS).xyz);
  int row = HEADER_ROWS;

#ifdef HAS_DIRECTIONAL
  for (int i = 0; i < counts.x; i++, row += DIRECTIONAL_ROWS) {
    vec3 L = lightRow(row + DIRECTIONAL_DIRECTION).xyz;
    addLobes(sums, N, V, L, n, lightRow(row + DIRECTIONAL_DIFFUSE).rgb, lightRow(row + DIRECTIONAL_SPECULAR).rgb, 1.0);
  }
#endif

#ifdef HAS_POINT
  for (int i = 0; i < counts.y; i++, row += POINT_ROWS) {
    vec4 place = lightRow(row + POINT_POSITION);
    vec4 diffuse = lightRow(row + POINT_DIFFUSE);
    vec4 specular = lightRow(row + POINT_SPECULAR);
    float d;
    vec3 L = towardLight(place.xyz, p, d);
    float factor = 1.0;
#ifdef HAS_ATTENUATION
    factor = attenuation(vec3(place.w, diffuse.w, specular.w), d);
#endif
    addLobes(sums, N, V, L, n, diffuse.rgb, specular.rgb, factor);
  }
#endif

#ifdef HAS_SPOT
  for (int i = 0; i < counts.z; i++, row += SPOT_ROWS) {
    vec4 place = lightRow(row + SPOT_POSITION);
    vec4 axis = lightRow(row + SPOT_AXIS);
    vec4 ambient = lightRow(row + SPOT_AMBIENT);
    float d;
    vec3 L = towardLight(place.xyz, p, d);
    float decay = 1.0;
    if (d > 0.0) { // at the light itself there is no angle: inside any cone, no decay
      float toAxis = quarterSquare(L + axis.xyz); // (1 - c)/2
      float toBack = quarterSquare(L - axis.xyz); // (1 + c)/2
      if (!insideCone(toAxis, toBack, ambient.w)) continue;
      decay = spotDecay(toAxis, toBack, axis.w);
    }
#ifdef HAS_AMBIENT
    sums.ambient += ambient.rgb * decay;
#endif
    vec4 diffuse = lightRow(row + SPOT_DIFFUSE);
    vec4 specular = lightRow(row + SPOT_SPECULAR);
    float factor = decay;
#ifdef HAS_ATTENUATION
    factor *= attenuation(vec3(place.w, diffuse.w, specular.w), d);
#endif
    addLobes(sums, N, V, L, n, diffuse.rgb, specular.rgb, factor);
  }
#endif
  return sums;
}
