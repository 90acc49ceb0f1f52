// What does a page load that is opened from disk? The entry of dist/phong-viewer.classic.js, a script that is no module.
// Registers the elements and exports nothing, so the page gets no global.
import './index.js';
