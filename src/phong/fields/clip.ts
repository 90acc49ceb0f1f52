// Cuts texts from outside (attributes, files, addresses) for messages: enough stays to recognise
// them, and never so much that the page suffers. Chromium 156 takes 28 s to lay out a word of
// 100,000 Arabic letters, which join.

/** Longest text that a message repeats, in UTF-16 units. */
const LONGEST = 100;

/** Longest message. The longest of our own sentences has 250 characters and repeats two texts. */
const LONGEST_MESSAGE = 500;

/**
 * The first `longest` characters and an ellipsis, or all of a shorter text. Cuts no surrogate pair.
 */
export function clip(text: string, longest = LONGEST): string {
  return text.length > longest
    ? text.slice(0, longest).replace(/[\ud800-\udbff]$/, '') + '...'
    : text;
}

/**
 * A whole message. Texts inside that were not clipped are recognised as words that are too long.
 */
export function clipMessage(message: string): string {
  const clipped = message.replace(/\S+/g, (word) => clip(word));
  return clip(clipped, LONGEST_MESSAGE);
}

/** Names beyond these are counted only. */
const MOST_LISTED = 10;

/** The first names, clipped, and how many more there are. */
export function listed(names: readonly string[]): string {
  const more = names.length - MOST_LISTED;
  const shown = names.slice(0, MOST_LISTED).map((name) => clip(name));
  return shown.join(', ') + (more > 0 ? ` and ${String(more)} more` : '');
}
