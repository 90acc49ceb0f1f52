// The scenes to start from, as in the gallery. Their names are in addresses: do not rename them.
import bunny from '../scenes/bunny.html?raw';
import candle from '../scenes/candle.html?raw';
import colours from '../scenes/colours.html?raw';
import dance from '../scenes/dance.html?raw';
import exponents from '../scenes/exponents.html?raw';
import facets from '../scenes/facets.html?raw';
import handles from '../scenes/handles.html?raw';
import moon from '../scenes/moon.html?raw';
import point from '../scenes/point.html?raw';
import room from '../scenes/room.html?raw';
import torch from '../scenes/torch.html?raw';

export interface Example {
  readonly name: string;
  readonly title: string;
  readonly text: string;
}

export const EXAMPLES: readonly Example[] = [
  { name: 'room', title: 'Sun, lamp and spot', text: room },
  { name: 'bunny', title: 'Plaster, by day', text: bunny },
  { name: 'colours', title: 'Red, green and blue', text: colours },
  { name: 'candle', title: 'A flame that fades', text: candle },
  { name: 'exponents', title: 'Twelve exponents', text: exponents },
  { name: 'dance', title: 'Twenty-four spots', text: dance },
  { name: 'moon', title: 'One sun', text: moon },
  { name: 'torch', title: 'A light in the hand', text: torch },
  { name: 'facets', title: 'One colour a face', text: facets },
  { name: 'handles', title: 'Lights to drag', text: handles },
  { name: 'point', title: 'A point explained', text: point },
];
