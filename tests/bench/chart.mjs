// @ts-check
// A bench run's charts, as SVG text: the same data give the same text. Presentation attributes alone, for pages without styles.

export { frontChart } from './chart/front-chart.mjs';
export { growthChart } from './chart/growth-chart.mjs';
export { PAGE, PRINT } from './chart/svg.mjs';
