// The names in a text file of unknown encoding: UTF-8, or what programs wrote before it.

const utf8 = new TextDecoder('utf-8', { fatal: true });

/**
 * What a name may say, the likeliest first; one only if it is UTF-8. Names that differ in a letter
 * stay different. @param cut whether the bytes may end within a character.
 */
export function nameReadings(bytes: Uint8Array, cut = false): readonly string[] {
  try {
    const text = cut
      ? new TextDecoder('utf-8', { fatal: true }).decode(bytes, { stream: true })
      : utf8.decode(bytes);
    return [text.trim()];
  } catch {
    const western = new TextDecoder('windows-1252').decode(bytes).trim();
    try {
      const chinese = new TextDecoder('gbk', { fatal: true }).decode(bytes, { stream: cut }).trim();
      return seemsChinese(bytes) ? [chinese, western] : [western, chinese];
    } catch {
      return [western];
    }
  }
}

/**
 * Chinese characters are two bytes each and seldom alone; those in common use begin with B0 to D7,
 * the small letters of Latin-1 with E0.
 */
function seemsChinese(bytes: Uint8Array): boolean {
  const text = String.fromCharCode(...bytes);
  return Array.from(text.matchAll(/[\x80-\xff]+/g), ([run]) => run).every(
    (run) => run.length % 2 === 0 && (run.length > 2 || /^[\xb0-\xd7]/.test(run)),
  );
}
