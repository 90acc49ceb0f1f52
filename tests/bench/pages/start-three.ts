// A page of plain three.js with the same box under the same three lights, by one shader as one writes it by hand.
import { BoxGeometry, Mesh, PerspectiveCamera, Scene, ShaderMaterial, Vector3, WebGLRenderer } from 'three';
import { pictureDrawn } from './first-picture.js';

const material = new ShaderMaterial({
  uniforms: {
    eye: { value: new Vector3() },
    sun: { value: new Vector3(1, 2, 3).normalize() },
    lamp: { value: new Vector3(-2, 1, 2) },
    spot: { value: new Vector3(0, 3, 2) },
    axis: { value: new Vector3(0, -3, -2).normalize() },
  },
  vertexShader: `
    varying vec3 p;
    varying vec3 n;
    void main() {
      p = (modelMatrix * vec4(position, 1.0)).xyz;
      n = mat3(modelMatrix) * normal;
      gl_Position = projectionMatrix * viewMatrix * vec4(p, 1.0);
    }`,
  fragmentShader: `
    uniform vec3 eye, sun, lamp, spot, axis;
    varying vec3 p;
    varying vec3 n;
    vec3 lit(vec3 N, vec3 V, vec3 L, vec3 color) {
      float NoL = max(dot(N, L), 0.0);
      float spec = NoL > 0.0 ? pow(max(dot(reflect(-L, N), V), 0.0), 32.0) : 0.0;
      return color * NoL + 0.5 * spec;
    }
    void main() {
      vec3 N = normalize(n);
      vec3 V = normalize(eye - p);
      vec3 color = vec3(0.08) + lit(N, V, sun, vec3(0.6));
      float d = distance(lamp, p);
      color += lit(N, V, (lamp - p) / d, vec3(0.8, 0.5, 0.25)) / (1.0 + 0.1 * d + 0.05 * d * d);
      vec3 L = normalize(spot - p);
      float c = dot(L, -axis);
      if (c > cos(radians(30.0))) color += pow(0.5 * (c + 1.0), 8.0) * lit(N, V, L, vec3(0.3, 0.5, 0.8));
      gl_FragColor = vec4(color, 1.0);
    }`,
});

const holder = document.getElementById('holder')!;
const renderer = new WebGLRenderer({ antialias: true, alpha: true });
renderer.setPixelRatio(devicePixelRatio);
renderer.setSize(holder.clientWidth, holder.clientHeight);
holder.append(renderer.domElement);
const scene = new Scene();
scene.add(new Mesh(new BoxGeometry(), material));
const camera = new PerspectiveCamera(45, holder.clientWidth / holder.clientHeight, 0.1, 10);
camera.position.set(1.1, 0.8, 1.9);
camera.lookAt(0, 0, 0);
(material.uniforms['eye']!.value as Vector3).copy(camera.position);
renderer.render(scene, camera);
pictureDrawn(renderer.getContext() as WebGL2RenderingContext);
