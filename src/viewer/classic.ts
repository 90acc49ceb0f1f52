// Entry of dist/phong-viewer.classic.js, one script that is no module, for pages opened from disk.
// Registers the elements and exports nothing, so the page gets no global.
import './index.js';
