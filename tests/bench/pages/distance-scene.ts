// A white directional light on a sphere, for a look at how far each peer's picture is from the equation: numbers that every
// peer can be given as they are. No ambient light; nowhere is the sum above 1. Colours are whole 255ths, since A-Frame and CSS take no others.
import type { Vec3 } from '../../../src/math/vector.js';

export const SPHERE = { radius: 0.5, around: 256, down: 128 } as const;
/** On the z axis, looking at the origin: the sphere fills four fifths of a square picture. */
export const EYE_Z = 1.6;
export const FOV = 45;
/** Edge of the picture, pixels. */
export const SIZE = 256;
/** To the light. */
export const TO_LIGHT: Vec3 = [1, 1.5, 2];
export const KD: Vec3 = [153, 127, 76];
export const KS: Vec3 = [76, 76, 76];
export const SHININESS = 32;

/** `#rrggbb` of whole 255ths. */
export const hex = (color: Vec3): string => `#${color.map((c) => c.toString(16).padStart(2, '0')).join('')}`;

/**
 * MeshPhongMaterial's highlight is specular · (n/2 + 1)/4 · (N·H)^n · (N·L) · light/π · Fresnel's term (BRDF_BlinnPhong of its
 * shader chunk lights_phong_pars_fragment, whose 1/π the light's factor π takes away): the specular colour, 0 to 1, that gives the lobe the
 * height Ks at its top where N·L is 1.
 */
export const specularForLobe = (ks: number, exponent: number): number => ks / 255 / ((exponent / 2 + 1) / 4);

/** (N·H)^4n is nearest to (R·V)^n around the highlight's middle, where the angle of H is half of R's. */
export const LOBE_WIDTHS = 4;
