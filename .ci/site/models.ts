// How do the entries of demo/models/models.json become pairs of pictures: a viewer, and the same
// model in another renderer, drawn by model-pictures.mjs? Text only.

import { escapeHtml } from './markdown.js';

export interface ModelEntry {
  /** Of its section, and the name of its picture. */
  readonly id: string;
  /** Relative to demo/assets/models/. */
  readonly file: string;
  readonly name: string;
  readonly format: string;
  readonly licence: string;
  readonly author: string;
  /** Registry, package and version. */
  readonly source: string;
  /** What the element takes from the file; HTML. */
  readonly carried: string;
  /** What its warning names. */
  readonly dropped: readonly string[];
  /** It is black or a metal. */
  readonly metal?: true;
  /** Where the eye is, in degrees. */
  readonly theta: number;
  readonly phi: number;
}

export interface ModelEntries {
  /** With its version. */
  readonly renderer: string;
  readonly models: readonly ModelEntry[];
}

/** The lights turn with the eye, as those of the other picture do. */
const LIGHTS = `
  <phong-light name="key" space="camera" position="-1 2 2 0" ambient="145 145 145" diffuse="285 285 285" specular="200 200 200"></phong-light>
  <phong-light name="fill" space="camera" position="3 0 1 0" diffuse="140 140 140" specular="100 100 100"></phong-light>`;

/**
 * For black and metal: of such a surface there is nothing but highlights to see
 * (demo/guide/models.md).
 */
const METAL_LIGHTS = `
  <phong-light name="key" space="camera" position="-2 2 1 0" ambient="145" diffuse="255" specular="700"></phong-light>
  <phong-light name="rim" space="camera" position="3 0 1 0" diffuse="120" specular="700"></phong-light>`;

/** Items of a list. */
export const pairsHtml = ({ renderer, models }: ModelEntries): string =>
  models.map((model) => pairHtml(model, renderer)).join('\n');

function pairHtml(model: ModelEntry, renderer: string): string {
  const { id, file, name, theta, phi, format, licence, author, source, carried, dropped, metal } =
    model;
  const missing = dropped.map((part) => `<code>${escapeHtml(part)}</code>`).join(', ');
  return `<li id="${id}">
  <h2>${escapeHtml(name)}</h2>
  <figure class="pair">
    <phong-viewer alt="${escapeHtml(name)}" src="../assets/models/${file}" loading="lazy" color-interpolation="linear" theta="${String(theta)}" phi="${String(phi)}">${metal === true ? METAL_LIGHTS : LIGHTS}
    </phong-viewer>
    <img vite-ignore src="../assets/images/models/${id}.webp" width="480" height="360" loading="lazy" alt="${escapeHtml(name)} in ${escapeHtml(renderer)}" />
    <figcaption>
      <p><b>${escapeHtml(format)}.</b> Carried over: ${carried}.${missing === '' ? '' : ` Left out: ${missing}.`}</p>
      <p>${escapeHtml(licence)}, ${escapeHtml(author)}; ${escapeHtml(source)}</p>
    </figcaption>
  </figure>
</li>`;
}
