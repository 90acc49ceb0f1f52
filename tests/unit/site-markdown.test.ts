// Do pages and descriptions become the HTML that the site needs: escaped text, anchors as GitHub
// has them, pictures from marked blocks, links that fit the site, and entries for the search?
import { expect, test } from 'vitest';
import {
  anchorOf,
  blocksHtml,
  escapeHtml,
  inlineHtml,
  markdownPage,
} from '../../.ci/site/markdown.js';
import { movedHtml } from '../../.ci/site/pages.js';
import { entriesOf } from '../../.ci/site/search.js';

const page = (text: string) => markdownPage(text, (href) => (href === 'gone.md' ? null : href));

test('what looks like HTML in a description is text, in code too', () => {
  expect(inlineHtml('a < b & `<phong-light position="0">`')).toBe(
    'a &lt; b &amp; <code>&lt;phong-light position=&quot;0&quot;&gt;</code>',
  );
  expect(blocksHtml('<b>a</b>')).toBe('<p>&lt;b&gt;a&lt;/b&gt;</p>');
  expect(escapeHtml(`<img src="x">`)).toBe('&lt;img src=&quot;x&quot;&gt;');
});

test.each(['javascript:alert(1)', 'data:text/html,x', 'vbscript:x'])('no link to %s', (address) => {
  expect(inlineHtml(`[x](${address})`)).not.toContain('<a');
});

test('a page has a title, a description, and sections with the anchors of GitHub', () => {
  const { title, description, sections } = page(
    '# A `<page>`\n\nWhat it\nsays.\n\n## Errors, and `att`\n',
  );
  expect(title).toBe('A <code>&lt;page&gt;</code>');
  expect(description).toBe('What it says.');
  expect(sections).toEqual([
    { id: 'errors-and-att', level: 2, title: 'Errors, and <code>att</code>' },
  ]);
  expect(anchorOf('Kc · d²')).toBe('kc--d²');
});

test('a marked block is a picture without styles of its own, above its markup', () => {
  const { html } = page(
    '# A\n\n```html live\n<phong-viewer alt="x" style="width: 1px"></phong-viewer>\n```\n',
  );
  const [, id] = /<figure class="wide live" id="([^"]+)"><phong-viewer alt="x">/.exec(html) ?? [];
  expect(html).toContain(`data-of="#${id} > *"`);
});

test('other blocks are text', () => {
  expect(page('# A\n\n```html\n<b>x</b>\n```\n').html).toContain('&lt;b&gt;x&lt;/b&gt;');
});

test('names in tables of an element can be linked to, and break after underscores', () => {
  const { html } = page(
    '# A\n\n## `<phong-light>`\n\n| event | meaning |\n| --- | --- |\n| `load` | `A_B` |\n',
  );
  expect(html).toContain('<code id="phong-light-load-event">load</code>');
  expect(html).toContain('A_<wbr />B');
});

test('a link that leads nowhere on the site is text', () => {
  expect(page('# A\n\n[b](gone.md) [c](c.md)').html).toContain(
    '<span>b</span> <a href="c.md">c</a>',
  );
});

test('an earlier address leads to the new one', () => {
  expect(movedHtml('guide/spots/', 'guide/light/#spots')).toContain(
    'content="0; url=../../guide/light/#spots"',
  );
});

test('each section and each name is an entry of the search, without markup', () => {
  const html = `<main><h1>Reference</h1><p>All.</p>
    <h2 id="phong-light"><code>&lt;phong-light&gt;</code></h2><phong-viewer alt="x"></phong-viewer>
    <table><tr><td><code id="phong-light-axis">axis</code></td><td>Where a spot points.</td></tr></table></main>`;
  expect(entriesOf({ path: 'guide/reference/', html })).toEqual([
    { address: 'guide/reference/', title: 'Reference', page: '', text: 'All.' },
    {
      address: 'guide/reference/#phong-light',
      title: '<phong-light>',
      page: 'Reference',
      text: '',
    },
    {
      address: 'guide/reference/#phong-light-axis',
      title: 'axis',
      page: 'phong-light, Reference',
      text: 'Where a spot points.',
    },
  ]);
});
