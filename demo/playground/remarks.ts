// What the package says of a scene, on the console or by events, for the page: the sentence, and
// where in the markup the value stands that it is about. Knows no element.

/** A part of the text. */
export interface Place {
  readonly from: number;
  readonly to: number;
}

interface Remark {
  readonly sentence: string;
  /** Where the value stands; null if the sentence names no value. */
  readonly place: Place | null;
}

/** A scene with more has one cause for most of them. */
const MOST_SHOWN = 20;
/** More are forgotten together. */
const MOST_KEPT = 200;
/** Sentences since the page was opened. An element gives each only once, so they are kept. */
const heard = new Set<string>();
/** Those that name no value are shown until the text changes. */
const current = new Set<string>();

/** @param changed called after each sentence; the console has it too. */
export function hearRemarks(changed: () => void): void {
  const warn = console.warn.bind(console);
  console.warn = (...parts: readonly unknown[]): void => {
    warn(...parts);
    if (heard.size >= MOST_KEPT) {
      heard.clear();
    }
    const sentence = parts.join(' ');
    heard.add(sentence);
    current.add(sentence);
    changed();
  };
}

/** Why files cannot be shown, by their addresses. */
const failed = new Map<string, string>();

/**
 * Hears which files cannot be shown in this part of the page, and which can after all.
 * @param changed called after each.
 */
export function hearFailures(around: Element, changed: () => void): void {
  const hear = (event: Event): void => {
    const { url, message } = (event as CustomEvent<Partial<Failure> | null>).detail ?? {};
    if (typeof url !== 'string') return;
    failed.delete(url);
    if (message !== undefined) {
      failed.set(url, message);
      // The console may have the same sentence.
      current.delete(message);
    }
    changed();
  };
  // These events do not bubble.
  around.addEventListener('error', hear, { capture: true });
  around.addEventListener('load', hear, { capture: true });
}

interface Failure {
  readonly url: string | null;
  readonly message: string;
}

/** Call when the text has changed. */
export const forgetCurrent = (): void => current.clear();

/** What holds of this text, in its order. */
export function remarksOn(text: string): readonly Remark[] {
  const written = valuesIn(text);
  const remarks = [...heard].flatMap((sentence): readonly Remark[] => {
    const about = valueOf(sentence);
    if (about === null) return current.has(sentence) ? [{ sentence, place: null }] : [];
    return written
      .filter(({ tag, attribute, value }) => {
        const same = tag === about.tag && attribute === about.attribute;
        return same && (about.clipped ? value.startsWith(about.value) : value === about.value);
      })
      .map((place) => ({ sentence, place }));
  });
  for (const place of written) {
    if (place.attribute !== 'src' || !URL.canParse(place.value, document.baseURI)) continue;
    const sentence = failed.get(new URL(place.value, document.baseURI).href);
    if (sentence !== undefined) {
      remarks.push({ sentence, place });
    }
  }
  return remarks.sort((a, b) => (a.place?.from ?? 0) - (b.place?.from ?? 0)).slice(0, MOST_SHOWN);
}

/** As sentences write them behind a backslash. */
const ESCAPED: Readonly<Record<string, string>> = { n: '\n', t: '\t' };

interface Value {
  readonly tag: string;
  readonly attribute: string;
  readonly value: string;
}

/** Of `<phong-light> cutoff="-3": …` and `<phong-light diffuse="1"> is …`. */
function valueOf(sentence: string): (Value & { readonly clipped: boolean }) | null {
  const [, tag, attribute, quoted] =
    /^<([\w-]+)>? ([\w-]+)=("(?:[^"\\]|\\.)*")/.exec(sentence) ?? [];
  if (tag === undefined || attribute === undefined || quoted === undefined) return null;
  const value = quoted.slice(1, -1).replaceAll(/\\(.)/g, (_, c: string) => ESCAPED[c] ?? c);
  const clipped = value.endsWith('...');
  return { tag, attribute, value: clipped ? value.slice(0, -3) : value, clipped };
}

const TAG = /<([\w-]+)((?:[^<>"']|"[^"]*"|'[^']*')*)/g;
const ATTRIBUTE = /([\w-]+)\s*=\s*(?:"([^"]*)"|'([^']*)'|([^\s"'>]+))/g;

/** Each value in the tags of a text. */
function valuesIn(text: string): readonly (Value & Place)[] {
  return Array.from(text.matchAll(TAG), ({ index, 1: tag, 2: inside }) =>
    Array.from(inside!.matchAll(ATTRIBUTE), (match) => {
      const from = index + 1 + tag!.length + match.index;
      const [all, attribute, double, single, bare] = match;
      return {
        tag: tag!.toLowerCase(),
        attribute: attribute!.toLowerCase(),
        value: decoded(double ?? single ?? bare ?? ''),
        from,
        to: from + all.length,
      };
    }),
  ).flat();
}

/** With what character references such as `&amp;` stand for. */
function decoded(value: string): string {
  if (!value.includes('&')) return value;
  const html = `<p>${value.replaceAll('<', '&lt;')}`;
  return new DOMParser().parseFromString(html, 'text/html').body.textContent;
}
