// Everything that trades time for error, and growth, which has a time alone.
import { antialias } from './antialias.js';
import { budget } from './budget.js';
import { growth } from './growth.js';
import { loops } from './floor.js';
import { scale } from './scale.js';
import { shading } from './shading.js';
import type { Axis } from './stand.js';

export const AXES: Readonly<Record<string, Axis>> = { shading, loops, budget, antialias, scale };

/** Opened as axes are. */
export const GROWTHS: Readonly<Record<string, Axis>> = { growth };
