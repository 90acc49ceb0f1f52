// The script about shadeAt in src/API.md, as a strict TypeScript project sees it: readme.test.ts compares the two.
import '../../src/index.js';

const fragment = await document.querySelector('phong-viewer')?.shadeAt(240, 100);
const text = (name = '', rgb = fragment?.color ?? []) => `${name} ${rgb.map((x) => x.toFixed(2)).join(' ')}`;
for (const share of fragment?.shares ?? []) {
  if (share === null) continue; // a light that is not active
  const { name, ambient, diffuse, specular } = share;
  console.log(`${name}: ${text('ambient', ambient)}, ${text('diffuse', diffuse)}, ${text('specular', specular)}`);
}
console.log(text('color:'));
