// The functions that run inside the page. Playwright sends a function as text, without what its module imports: the
// build replaces each of these by one that carries its imports (.ci/in-page.ts).
export { changeByCss, otherElement, whyIncomplete } from './check-in-page.js';
export { judgeInPage } from './judge-in-page.js';
export { settleInPage } from './settle-in-page.js';
