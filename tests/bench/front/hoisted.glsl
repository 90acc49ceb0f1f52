// The equation with everything that no fragment changes computed once, on the CPU. Rows of a directional light: L, Id, Is; of a
// point light: position and kc, Id and kl, Is and kq; of a spot: the same, then A and the cone's cosine, Ia and cutoff.
// AMBIENT is the sum of the Ia of all other lights. LOBE(t) is the specular lobe of the cosine t.

vec3 shadeHere(vec3 p, vec3 normal) {
  vec3 N = normalize(normal);
  vec3 V = normalize(uEye - p);
  vec3 color = uKa * AMBIENT;
  int at = 0;
  for (int i = 0; i < DIRECTIONALS; i++, at += 3) {
    vec3 L = row(at).xyz;
    float NoL = dot(N, L);
    float spec = NoL > 0.0 ? LOBE(max(dot(2.0 * NoL * N - L, V), 0.0)) : 0.0;
    color += uKd * row(at + 1).rgb * max(NoL, 0.0) + uKs * row(at + 2).rgb * spec;
  }
  for (int i = 0; i < POINTS + SPOTS; i++) {
    bool isSpot = i >= POINTS;
    vec4 place = row(at);
    vec4 diffuse = row(at + 1);
    vec4 specular = row(at + 2);
    vec3 v = place.xyz - p;
    float d = length(v);
    vec3 L = v / d;
    float factor = 1.0;
    if (isSpot) {
      vec4 axis = row(at + 3);
      vec4 ambient = row(at + 4);
      float c = -dot(L, axis.xyz);
      factor = c >= axis.w ? pow((c + 1.0) * 0.5, ambient.w) : 0.0;
      color += uKa * ambient.rgb * factor;
    }
    factor /= max(place.w + d * (diffuse.w + d * specular.w), 1.0);
    float NoL = dot(N, L);
    float spec = NoL > 0.0 ? LOBE(max(dot(2.0 * NoL * N - L, V), 0.0)) : 0.0;
    color += factor * (uKd * diffuse.rgb * max(NoL, 0.0) + uKs * specular.rgb * spec);
    at += isSpot ? 5 : 3;
  }
  return color;
}
