// The equation as the specification writes it, light by light, with the numbers that the attributes have. Rows of a light:
// position; axis and aperture; Ia; Id and cutoff; Is; attenuation. COUNT is the number of lights.

vec3 shadeHere(vec3 p, vec3 normal) {
  vec3 N = normalize(normal);
  vec3 V = normalize(uEye - p);
  vec3 color = vec3(0.0);
  for (int i = 0; i < COUNT; i++) {
    vec4 position = row(6 * i);
    vec4 axis = row(6 * i + 1);
    vec4 ambient = row(6 * i + 2);
    vec4 diffuse = row(6 * i + 3);
    vec4 specular = row(6 * i + 4);
    vec4 k = row(6 * i + 5);
    vec3 L = normalize(position.xyz);
    float att = 1.0;
    if (position.w == 1.0) {
      vec3 v = position.xyz - p;
      float d = length(v);
      L = v / d;
      att = 1.0 / max(k.x + k.y * d + k.z * d * d, 1.0);
    }
    vec3 A = normalize(axis.xyz);
    float c = dot(L, -A);
    if (c < cos(radians(axis.w))) continue;
    float NoL = max(dot(N, L), 0.0);
    vec3 R = 2.0 * dot(N, L) * N - L;
    float spec = dot(N, L) > 0.0 ? pow(max(dot(R, V), 0.0), uShininess) : 0.0;
    float decay = pow((c + 1.0) / 2.0, diffuse.w);
    color += (uKa * ambient.rgb + att * (uKd * diffuse.rgb * NoL + uKs * specular.rgb * spec)) * decay;
  }
  return color;
}
