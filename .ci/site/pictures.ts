// The bench's whole pictures on the site's bench page: for each stack that has measured them, a
// chart of error over time for each picture, and a table. Results in, HTML out.

import { panelPoints, panelSvg } from '../../tests/bench/picture-chart.mjs';
import {
  CODES,
  FULL,
  full,
  MULTISAMPLED,
  pictureTime,
  pictureValue,
  PLAIN,
  RMSE,
  SERIES,
  SSAA,
  ssaa,
  TAA,
  taa,
} from '../../tests/bench/pictures.mjs';
import type { BenchResult } from '../../tests/bench/results.mjs';
import { type PICTURES, pictureSubject } from '../../tests/bench/subjects.mjs';
import { escapeHtml } from './markdown.js';

const STACKS: Readonly<Record<string, string>> = {
  software: 'Software rendering',
  'h200-vulkan': 'NVIDIA H200, Vulkan',
  'h200-opengl': 'NVIDIA H200, OpenGL',
};

/** Rows of the table, and what the reader sees of their names. */
const ROWS: readonly (readonly [side: string, label: string])[] = [
  [PLAIN, 'plain picture'],
  ...FULL.map(
    (samples) => [full(samples), `antialias="full", ${String(samples)} samples`] as const,
  ),
  [MULTISAMPLED, MULTISAMPLED],
  ...SSAA.slice(-2).map(
    (samples) => [ssaa(samples), `SSAARenderPass, ${String(samples)} samples`] as const,
  ),
  ...[TAA[0]!, TAA[16]!, TAA[32]!].map(
    (count) => [taa(count), `TAARenderPass, ${String(count)} accumulated`] as const,
  ),
];

/** One section for each stack; empty where nothing has been measured. */
export const picturesHtml = (results: readonly BenchResult[]): string =>
  results
    .filter((result) => panelPoints(result).length > 0)
    .map(stackHtml)
    .join('\n');

function stackHtml(result: BenchResult): string {
  const points = panelPoints(result);
  const name = STACKS[result.stack] ?? result.stack;
  const names = [...new Set(points.map(({ picture }) => picture))];
  const panels = names.map(
    (picture) =>
      `<figure>${panelSvg(points, picture)}<figcaption>${escapeHtml(picture)}</figcaption></figure>`,
  );
  return `<section class="front recorded">
    <h3>${escapeHtml(name)}</h3>
    <ul class="series">${SERIES.map(({ series }) => `<li>${escapeHtml(series)}</li>`).join('')}</ul>
    <div class="panels">${panels.join('\n')}</div>
    ${tableHtml(result, name, names)}
  </section>`;
}

function tableHtml(
  result: BenchResult,
  name: string,
  names: readonly (keyof typeof PICTURES)[],
): string {
  const rows = ROWS.map(([side, label]) => {
    const cells = names.map(
      (picture) => `<td>${cellText(result, pictureSubject(picture), side)}</td>`,
    );
    return `<tr><th scope="row">${escapeHtml(label)}</th>${cells.join('')}</tr>`;
  });
  const head = names.map((picture) => `<th scope="col">${escapeHtml(picture)}</th>`).join('');
  return `<div class="scroll" role="region" tabindex="0" aria-label="${escapeHtml(name)}: error and time">
    <table class="numbers">
      <thead><tr><th scope="col">RMSE, time</th>${head}</tr></thead>
      <tbody>${rows.join('\n')}</tbody>
    </table></div>`;
}

function cellText(result: BenchResult, subject: string, side: string): string {
  const error = pictureValue(result, subject, RMSE.triangles, side);
  const time = pictureTime(result, subject, side);
  if (error === undefined || time === undefined) return '–';
  const codes = pictureValue(result, subject, RMSE.triangles, side + CODES);
  const errors = [error, ...(codes === undefined ? [] : [codes])]
    .map((x) => x.toFixed(2))
    .join(' or ');
  return `${errors}, ${time < 10 ? time.toFixed(1) : time.toFixed(0)}`;
}
