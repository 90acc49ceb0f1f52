const viewer = document.querySelector('phong-viewer')!;
const lights = viewer.getElementsByTagName('phong-light');

/** Adds a spot on a spiral. The golden angle, about 137.5°, spreads the spots evenly. */
export function add() {
  const turn = lights.length * 2.39996;
  const r = 0.27 * Math.sqrt(lights.length);
  const light = document.createElement('phong-light');
  light.setAttribute(
    'position',
    `${(r * Math.cos(turn)).toFixed(2)} 1.4 ${(r * Math.sin(turn)).toFixed(2)}`,
  );
  light.setAttribute('axis', '0 -1 0');
  light.setAttribute('aperture', '10');
  light.setAttribute('cutoff', '240');
  light.setAttribute('diffuse', `hsl(${(lights.length * 47) % 360} 80% 62%)`);
  viewer.append(light);
}

export function remove() {
  if (lights.length > 1) {
    lights[lights.length - 1]!.remove();
  }
}

export function toggle() {
  for (const light of lights) {
    light.setAttribute('active', String(!light.active));
  }
}
