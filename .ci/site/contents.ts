// Which pages does the site have, in what order are they read, and where did pages of earlier
// addresses go? Paths are relative to the site's root and end with a slash. Knows no page's text.

export interface Entry {
  readonly path: string;
  readonly label: string;
}

/** The header's navigation, on every page. */
export const sections: readonly Entry[] = [
  { path: 'lesson/', label: 'Lesson' },
  { path: 'guide/light/', label: 'Guide' },
  { path: 'examples/', label: 'Examples' },
  { path: 'playground/', label: 'Playground' },
  { path: 'guide/reference/', label: 'Reference' },
  { path: 'guide/install/', label: 'Install' },
];

/** The guide: a page for each demo/guide/NAME.md, in the order in which they are read. */
export const guide: readonly Entry[] = [
  { path: 'guide/light/', label: 'Light' },
  { path: 'guide/see/', label: 'See light' },
  { path: 'guide/lessons/', label: 'Write a lesson' },
  { path: 'guide/exercises/', label: 'Write it yourself' },
  { path: 'guide/camera/', label: 'Camera and panel' },
  { path: 'guide/models/', label: 'Shapes and models' },
  { path: 'guide/install/', label: 'Install' },
  { path: 'guide/reliability/', label: 'Accuracy and errors' },
  { path: 'guide/core/', label: 'Without the elements' },
  { path: 'guide/vectors/', label: 'Test vectors' },
  { path: 'guide/reference/', label: 'Reference' },
];

/** What the contents list of the guide names below its own pages, and the footer. */
export const others: readonly Entry[] = [
  { path: 'lesson/', label: 'Lesson' },
  { path: 'examples/', label: 'Examples' },
  { path: 'playground/', label: 'Playground' },
  { path: 'models/', label: 'Twenty models' },
  { path: 'bench/', label: 'Bench' },
];

/** Where what was at an address is now. */
export const moved: Readonly<Record<string, string>> = {
  'api/': 'guide/reference/',
  'article/': 'guide/light/',
  'bunny/': 'guide/models/',
  'explain/': 'guide/see/#a-point-explained',
  'guide/': 'guide/light/',
  'guide/accuracy/': 'guide/reliability/',
  'guide/frameworks/': 'guide/install/#frameworks',
  'guide/lights/': 'guide/light/#lights-in-markup',
  'guide/materials/': 'guide/models/#materials',
  'guide/speed/': 'guide/reliability/#speed',
  'guide/spots/': 'guide/light/#spots',
  'install/': 'guide/install/',
  'lights/': 'guide/light/#many-lights',
  'releases/': '',
  'shapes/': 'guide/models/#shapes',
};
