// Which pages does the site have, and in what order are they read? Paths are relative to the site's
// root and end with a slash. Knows no page's text.

export interface Entry {
  readonly path: string;
  readonly label: string;
}

/** The header's navigation, on every page. */
export const sections: readonly Entry[] = [
  { path: 'lesson/', label: 'Lesson' },
  { path: 'guide/', label: 'Guide' },
  { path: 'examples/', label: 'Examples' },
  { path: 'playground/', label: 'Playground' },
  { path: 'api/', label: 'API' },
  { path: 'install/', label: 'Install' },
];

/** Links of the footer. */
export const foot: readonly Entry[] = [
  { path: 'bench/', label: 'Bench' },
  { path: 'releases/', label: 'Releases' },
];

/** The short pages of the guide. */
export const guide: readonly Entry[] = [
  { path: 'guide/lights/', label: 'Lights' },
  { path: 'guide/spots/', label: 'Spots' },
  { path: 'guide/camera/', label: 'Camera' },
  { path: 'guide/materials/', label: 'Materials' },
  { path: 'guide/models/', label: 'Models' },
  { path: 'guide/see/', label: 'See light' },
  { path: 'guide/accuracy/', label: 'Accuracy' },
  { path: 'guide/speed/', label: 'Speed' },
  { path: 'guide/frameworks/', label: 'Frameworks' },
];

/** The pages that the guide builds on. */
export const closerLooks: readonly Entry[] = [
  { path: 'article/', label: 'Equation' },
  { path: 'explain/', label: 'Fragment' },
  { path: 'shapes/', label: 'Shapes' },
  { path: 'lights/', label: 'Many lights' },
  { path: 'bunny/', label: 'Bunny' },
  { path: 'models/', label: 'Twenty models' },
];
