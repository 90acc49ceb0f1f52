// Markdown to HTML, as far as the change log and the manifest's descriptions use it: headings,
// lists, paragraphs, code, bold text and links. Everything else is text. The result holds no markup
// but its own.

/** Escapes text for HTML, attribute values included. */
export const escapeHtml = (text: string): string =>
  text.replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]!);

/** @param base the address that relative links refer to. */
export function inlineHtml(text: string, base = ''): string {
  return text
    .split(/(`[^`]+`)/)
    .map((part, i) =>
      i % 2 === 1 ? `<code>${escapeHtml(part.slice(1, -1))}</code>` : words(part, base),
    )
    .join('');
}

function words(text: string, base: string): string {
  return escapeHtml(text)
    .replace(/\*\*([^*]+)\*\*/g, '<b>$1</b>')
    .replace(
      /\[([^\]]+)\]\((https?:\/\/[^)\s]*|[\w./#][^):\s]*)\)/g,
      (_, label: string, href: string) => {
        const address = /^https?:/.test(href) ? href : base + href;
        return `<a href="${address}">${label}</a>`;
      },
    );
}

/** Blocks are separated by empty lines; `# Title` becomes `<h1>`. */
export function blocksHtml(text: string, base = ''): string {
  return text
    .trim()
    .split(/\n\s*\n/)
    .map((block) => blockHtml(block, base))
    .join('\n');
}

function blockHtml(block: string, base: string): string {
  const heading = /^(#{1,6}) (.*)$/.exec(block);
  if (heading) {
    const level = String(heading[1]!.length);
    return `<h${level}>${inlineHtml(heading[2]!, base)}</h${level}>`;
  }
  if (!block.startsWith('- ')) return `<p>${inlineHtml(unfolded(block), base)}</p>`;
  const items = block.slice(2).split(/\n- /);
  return `<ul>\n${items.map((item) => `<li>${inlineHtml(unfolded(item), base)}</li>`).join('\n')}\n</ul>`;
}

const unfolded = (text: string): string => text.replace(/\s*\n\s*/g, ' ');
