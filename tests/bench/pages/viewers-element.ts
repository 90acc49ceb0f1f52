// ?count=64: so many viewers, a box each, all on screen.
import { pictureShown } from './first-picture.js';
import 'phong-viewer';

const count = Number(new URLSearchParams(location.search).get('count'));
document.body.innerHTML = '<phong-viewer geometry="box"></phong-viewer>'.repeat(count);
await Promise.all([...document.querySelectorAll('phong-viewer')].map((viewer) => viewer.ready));
pictureShown();
