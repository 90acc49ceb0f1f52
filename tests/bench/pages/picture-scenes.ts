// The whole pictures whose error is measured, as markup: viewers in equal cells, row by row. Each
// has a light from afar, one nearby and a spot with a hard edge.

export interface PictureScene {
  readonly columns: number;
  readonly rows: number;
  readonly viewers: readonly string[];
}

const LIGHTS = `<phong-light position="1 2 3 0" ambient="30 30 40" diffuse="140 140 130" specular="150 150 150"></phong-light>
  <phong-light position="-2 1 2 1" diffuse="120 80 60" specular="90 60 45" attenuation="1 0 0.05"></phong-light>
  <phong-light position="0.8 1.2 2.4 1" axis="-0.8 -1.2 -2.4" aperture="5" diffuse="50 80 110" specular="60 90 120"></phong-light>`;

const viewer = (attributes: string, meshes = '') =>
  `<phong-viewer alt="" ${attributes}>${LIGHTS}${meshes}</phong-viewer>`;

const one = (attributes: string, meshes = ''): PictureScene => ({
  columns: 1,
  rows: 1,
  viewers: [viewer(attributes, meshes)],
});

const SHAPES = ['sphere', 'torus', 'cylinder', 'cone', 'torus-knot', 'box', 'pyramid', 'teapot'];

export type PictureName = 'sphere' | 'torus' | 'shiny-torus' | 'teapot' | 'glb' | 'nine';

export const PICTURE_SCENES: Readonly<Record<PictureName, PictureScene>> = {
  sphere: one('geometry="sphere"'),
  torus: one('geometry="torus"'),
  'shiny-torus': one('geometry="torus" shininess="2000"'),
  teapot: one(
    '',
    `<phong-mesh geometry="plane" position="0 -0.5 0" scale="1.6" kd="90 110 90"></phong-mesh>
     <phong-mesh geometry="teapot" kd="200 120 70"></phong-mesh>`,
  ),
  // With an exponent of its own: the file's roughness would be another equation.
  glb: one('src="models/checks.glb" shininess="32"'),
  nine: {
    columns: 3,
    rows: 3,
    viewers: [
      ...SHAPES.map((shape) => viewer(`geometry="${shape}"`)),
      viewer('geometry="torus" phi="100"'),
    ],
  },
};
