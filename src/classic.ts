// The entry of `dist/phong-viewer.classic.js`, a script that is no module: registers the elements and exports nothing.
import './index.js';
