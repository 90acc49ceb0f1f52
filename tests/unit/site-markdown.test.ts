// Does the site turn the change log and the manifest's descriptions into HTML, and is their own
// markup escaped?
import { expect, test } from 'vitest';
import { blocksHtml, escapeHtml, inlineHtml } from '../../.ci/site/markdown.js';
import { releasesHtml } from '../../.ci/site/generated.js';

test('text is escaped, in code too', () => {
  expect(inlineHtml('a < b & `<phong-light position="0">`')).toBe(
    'a &lt; b &amp; <code>&lt;phong-light position=&quot;0&quot;&gt;</code>',
  );
  expect(escapeHtml(`<img src="x">`)).toBe('&lt;img src=&quot;x&quot;&gt;');
});

test('links and bold text, but not inside code', () => {
  expect(inlineHtml('**new**: [why](src/why.md), `[a](b) **c**`', 'https://x.example/')).toBe(
    '<b>new</b>: <a href="https://x.example/src/why.md">why</a>, <code>[a](b) **c**</code>',
  );
});

test.each(['javascript:alert(1)', 'data:text/html,x', '"onclick="x'])(
  'no link to %s',
  (address) => {
    expect(inlineHtml(`[x](${address})`)).not.toMatch(/<a href="(?!https:\/\/base\/)/);
    expect(inlineHtml(`[x](${address})`, 'https://base/')).not.toMatch(
      /<a href="(javascript|data)/,
    );
  },
);

test('headings, paragraphs and lists with folded lines', () => {
  expect(blocksHtml('## A\n\none\ntwo\n\n- three\n  four\n- five\n')).toBe(
    '<h2>A</h2>\n<p>one two</p>\n<ul>\n<li>three four</li>\n<li>five</li>\n</ul>',
  );
});

test('a version of the change log can be linked to', () => {
  const html = releasesHtml(
    '# Changelog\n\nWords.\n\n## [1.2.0] - 2026-01-02\n\n- x\n',
    'https://x.example',
  );
  expect(html).toContain('<h2 id="1.2.0">1.2.0 - 2026-01-02</h2>');
  expect(html).not.toContain('<h1>');
});
