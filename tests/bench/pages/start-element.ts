// A page with the element, three lights and a box: all that its author wrote is the markup and this import.
import 'phong-viewer';
import { pictureDrawn } from './first-picture.js';

const viewer = document.querySelector('phong-viewer')!;
await viewer.ready;
pictureDrawn(viewer.shadowRoot!.querySelector('canvas')!.getContext('webgl2')!);
