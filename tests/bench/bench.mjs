// @ts-check
// `npm run bench`: measures real scenes with the element and with plain three.js, in turns, over
// fresh launches of a browser, and writes one result for the stack. See options.mjs for its options
// and subjects.mjs for what it measures.

import { existsSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { setTimeout } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { launchOptions } from '../support/built-pages.mjs';
import { refuse, timeText } from '../support/command-line.mjs';
import { isSoftware, Lab } from './browser.mjs';
import { measureFrames, measureScript } from './measure/frames.mjs';
import { measureModel } from './measure/model.mjs';
import { measurePicture } from './measure/pictures.mjs';
import { measureBytes, measureMoving, measureStill, measureViewers } from './measure/page.mjs';
import { measureStart } from './measure/start.mjs';
import { missedLimits } from './aims.mjs';
import { readOptions } from './options.mjs';
import { pictureTime, RMSE } from './pictures.mjs';
import { addSamples, ratioOf, rowOf, valueOf } from './results.mjs';
import { chosenSubjects, SUBJECTS } from './subjects.mjs';

const here = fileURLToPath(new URL('.', import.meta.url));
/** Longest time of one launch of a subject, in milliseconds. */
const PATIENCE = 240_000;
/** The same where a float64 ray caster has to draw the exact pictures first. */
const PATIENCE_WITH_TRUTH = 2_400_000;
/** Pixels of a whole picture whose error is measured, unless asked otherwise. */
const PICTURE_SIZE = /** @type {const} */ ([400, 300]);
const ROUNDS = 3;
/** Of whole pictures, which take seconds each in software. */
const PICTURE_ROUNDS = 2;
/**
 * More lights than these are drawn with fewer pixels in software, where a frame would last seconds.
 */
const MOST_LIGHTS_AT_SIZE = 32;

/** @param {import('./options.mjs').Options} options */
async function main(options) {
  const names = chosenSubjects(options.only);
  if (names.length === 0) {
    refuse(`No subject contains '${options.only.join('; ')}', --list prints them`);
  }
  if (options.list) return void console.log(names.join('\n'));
  if (options.built !== '' && !existsSync(join(options.built, 'built-from.json'))) {
    refuse(`There are no built pages in ${options.built}`);
  }
  const { buildPages } = await import('./build.mjs');
  if (options.build !== '') return buildPages(resolve(options.build));
  const begun = Date.now();
  let folder = resolve(options.built);
  if (options.built === '') {
    folder = mkdtempSync(join(tmpdir(), 'phong-viewer-bench-'));
    console.log('Building the package and the pages …');
    await buildPages(folder);
  }
  const lab = new Lab(folder, await launchOptions(options.browser, options.arg));
  await lab.open();
  const machine = await lab.machine();
  for (const [key, value] of Object.entries(machine)) {
    console.log(`${key}: ${value}`);
  }
  const isPart = !options.add && (options.quick || options.only.length > 0);
  const out = options.out || (isPart ? '' : join(here, 'results', `${options.stack}.json`));
  const date = new Date(begun).toISOString().slice(0, 10);
  /** @type {import('./results.mjs').BenchResult} */
  const result = (options.add ? readWithout(out, names) : undefined) ?? {
    stack: options.stack,
    machine,
    date,
    launches: options.launches,
    size: options.size ?? (isSoftware(machine.renderer) ? [480, 360] : [1920, 1080]),
    measures: [],
    failures: [],
  };
  /** @type {string[]} */
  const subjects = [];
  const { launches, note } = options;
  if (options.add) {
    (result.added ??= []).push({ subjects, machine, date, launches, note });
  }
  await measureAll(lab, names, options, result, begun, (name) => {
    if (!subjects.includes(name)) {
      subjects.push(name);
    }
    write(out, result);
  });
  await lab.close();
  if (out !== '') {
    console.log(`\n${out}`);
  }
  const faults = result.failures.map(({ subject, message }) => `${subject}: ${message}`);
  if (options.limits) {
    faults.push(...missedLimits(result));
  }
  for (const fault of faults) {
    console.error(fault);
  }
  if (faults.length > 0) {
    process.exitCode = 1;
  }
}

/**
 * All subjects once, then all of them again, so that a run that ends early has launches of each.
 * @param {Lab} lab @param {readonly string[]} names @param {import('./options.mjs').Options}
 * options
 * @param {import('./results.mjs').BenchResult} result @param {number} begun @param {(name: string)
 * => void} save a subject has been measured once more
 */
async function measureAll(lab, names, { launches, minutes, size }, result, begun, save) {
  const parts = Array.from({ length: launches }, () => names).flat();
  const from = Date.now();
  for (const [i, name] of parts.entries()) {
    const average = (Date.now() - from) / Math.max(i, 1);
    if (Date.now() - begun + average > 60_000 * minutes) {
      return void console.log(`Stopped: ${minutes} minutes are over.`);
    }
    const launch = Math.floor(i / names.length);
    try {
      const patience = SUBJECTS[name]?.kind === 'picture' ? PATIENCE_WITH_TRUTH : PATIENCE;
      await withPatience(measure(lab, name, launch, result, size), patience);
    } catch (error) {
      const message = error instanceof Error ? (error.message.split('\n')[0] ?? '') : String(error);
      result.failures.push({ subject: name, message });
    }
    const left = ((Date.now() - from) / (i + 1)) * (parts.length - i - 1);
    console.log(
      `[${i + 1}/${parts.length}, about ${timeText(left / 1000)} left] ${name}: ${summary(result, name)}`,
    );
    save(name);
  }
}

/**
 * @param {import('./subjects.mjs').FrameSubject} subject @param
 * {import('./results.mjs').BenchResult} result @returns {readonly [number, number]}
 */
function sizeOf({ scene }, { machine, size }) {
  const lights = Number(scene.split(':')[1]);
  if (!isSoftware(machine['renderer'] ?? '') || lights <= MOST_LIGHTS_AT_SIZE) return size;
  const shrink = Math.sqrt(MOST_LIGHTS_AT_SIZE / lights);
  return [Math.round(size[0] * shrink), Math.round(size[1] * shrink)];
}

/** @param {Promise<void>} work @param {number} patience milliseconds */
async function withPatience(work, patience) {
  const late = setTimeout(patience, undefined, { ref: false }).then(() => {
    throw new Error(`took longer than ${patience / 1000} s`);
  });
  // Either may fail once it is too late.
  for (const one of [work, late]) {
    one.catch(() => {});
  }
  await Promise.race([work, late]);
}

/**
 * One launch of a subject. `size`: of pictures, if asked for. @param {Lab} lab @param {string} name
 * @param {number} launch @param {import('./results.mjs').BenchResult} result @param {readonly
 * [number, number] | null} size
 */
async function measure(lab, name, launch, result, size) {
  const subject = SUBJECTS[name];
  const options = {
    size: result.size,
    rounds: ROUNDS,
    /** @param {string} measure @param {string} unit @param {Record<string, number>} values */
    add: (measure, unit, values) => addSamples(result, name, measure, unit, values),
  };
  switch (subject?.kind) {
    case 'frames':
      return measureFrames(lab, subject, launch, { ...options, size: sizeOf(subject, result) });
    case 'script':
      return measureScript(lab, subject, options);
    case 'start':
      return measureStart(lab, subject, launch, options);
    case 'model':
      return measureModel(lab, subject, launch, options);
    case 'picture':
      Object.assign(options, { rounds: PICTURE_ROUNDS, size: size ?? PICTURE_SIZE });
      return measurePicture(lab, subject, launch, options);
    case 'viewers':
      return measureViewers(lab, options);
    case 'moving':
      return measureMoving(lab, subject, result, options);
    case 'still':
      return measureStill(lab, subject, { ...options, size: subject.size ?? options.size });
    case 'bytes':
      if (launch === 0) {
        measureBytes(lab, options);
      }
  }
}

/**
 * What is known of a subject so far, in one line. @param {import('./results.mjs').BenchResult}
 * result @param {string} name
 */
function summary(result, name) {
  const failure = result.failures.findLast(({ subject }) => subject === name);
  if (failure !== undefined) return `failed: ${failure.message}`;
  const rows = result.measures.filter(({ subject }) => subject === name);
  if (SUBJECTS[name]?.kind === 'picture') return pictureSummary(result, name);
  return rows
    .map((row) => {
      const sides = Object.keys(row.samples);
      const base = valueOf(row, sides.at(-1)).median.toPrecision(3);
      if (sides.length === 1) return `${row.measure} ${base} ${row.unit}`;
      const ratios = sides.slice(0, -1).map((side) => {
        const label = sides.length > 2 ? `${side} ` : '';
        return `${label}${ratioOf(row, side)?.median.toFixed(2)} (${valueOf(row, side).median.toPrecision(3)})`;
      });
      return `${row.measure} ${ratios.join(', ')} : 1 (${base} ${row.unit})`;
    })
    .join('; ');
}

/**
 * Error and time of each picture. @param {import('./results.mjs').BenchResult} result @param
 * {string} subject
 */
function pictureSummary(result, subject) {
  const errors = rowOf(result, subject, RMSE.triangles);
  return Object.keys(errors?.samples ?? {})
    .map((side) => {
      const time = pictureTime(result, subject, side);
      return `${side} ${errors && valueOf(errors, side).median.toPrecision(2)} in ${time?.toPrecision(3)}`;
    })
    .join('; ');
}

/**
 * A result without these subjects, to be measured again; undefined where there is none.
 * @param {string} file @param {readonly string[]} names @returns
 * {import('./results.mjs').BenchResult | undefined}
 */
function readWithout(file, names) {
  if (!existsSync(file)) return undefined;
  /** @type {import('./results.mjs').BenchResult} */
  const result = JSON.parse(readFileSync(file, 'utf8'));
  const isOther = (/** @type {{ subject: string }} */ { subject }) => !names.includes(subject);
  result.measures = result.measures.filter(isOther);
  result.failures = result.failures.filter(isOther);
  result.added = (result.added ?? []).flatMap(({ subjects, ...one }) => {
    const others = subjects.filter((subject) => !names.includes(subject));
    return others.length === 0 ? [] : [{ ...one, subjects: others }];
  });
  return result;
}

/** @param {string} file @param {import('./results.mjs').BenchResult} result */
function write(file, result) {
  if (file === '') return;
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, `${JSON.stringify(result, null, 1)}\n`);
}

await main(readOptions());
