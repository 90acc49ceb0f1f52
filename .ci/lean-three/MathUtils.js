// Of the object that holds all of these functions, what a loader asks it for; three's own modules import them one by one.

import { radToDeg } from 'three/src/math/MathUtils.js';

export * from 'three/src/math/MathUtils.js';
export const MathUtils = { radToDeg };
