// CSS colours as texts: those in sRGB, with their codes, and those that are refused.

export const COLORS = {
  '#fc8': [255, 204, 136],
  '#FFCC8880': [255, 204, 136],
  RebeccaPurple: [102, 51, 153],
  'rgb(10 20 30 / 50%)': [10, 20, 30],
  'hsl(120 100% 50%)': [0, 255, 0],
  'hwb(0 0% 0%)': [255, 0, 0],
  'color(srgb 1 0.5 0)': [255, 127.5, 0],
  'oklch(0 0 0)': [0, 0, 0],
  transparent: [0, 0, 0],
} as const;

export const BAD_COLORS = [
  'currentColor',
  'color-mix(in srgb, currentColor, red)',
  'nocolor',
  '#12',
  'rgb(1,2',
  'inherit',
  'var(--x)',
  'red; blue',
  'url(x)',
  'color(display-p3 1 0 0)',
  'oklch(0.7 0.4 140)',
  'color(srgb 1.5 0 0)',
];
