// What GLTFLoader imports as three.js in the standalone file. It reads one function of the object
// MathUtils, which would keep all of them in the file that every page fetches: 0.5 kB.

export * from 'three';

export const MathUtils = { radToDeg: (/** @type {number} */ radians) => (radians * 180) / Math.PI };
