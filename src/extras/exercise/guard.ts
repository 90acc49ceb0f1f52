// Makes a learner's GLSL safe to compile and to run. Neither a compiler nor a frame can be stopped, so
// the code has a limit, with functions and macros put in where they are used, and each loop counts what
// its turns do. What a compiler refuses by itself is left to it.
import type { ViewerText } from '../../viewer/extra.js';

/** Why there is no verdict. */
export interface Fault {
  /** A key of the page's texts, or what a compiler says. */
  readonly text: string;
  readonly values: Readonly<Record<string, string | number>>;
  /** Counted from 1; null where it is no one line's. */
  readonly line: number | null;
}

const MOST_CHARACTERS = 20_000;

/**
 * Tokens of all code, with a copy of a function or macro wherever it is named: compilers put them in.
 * Its own text counts too, so a function may have 20,000, which take a compiler two seconds.
 */
const MOST_CODE = 40_000;

/** Words of the code that a matrix stands for, and a power. */
const MATRIX = 16;

/** The same where loops repeat them: one pixel takes a tenth of a second at most in software. */
const REPEATED = 8;

interface Token {
  readonly text: string;
  readonly line: number;
  /** How many tokens on the bracket is that closes it; 0 for all others. */
  span: number;
}

/** A function or a macro of the learner's. */
interface Definition {
  readonly name: string;
  readonly tokens: readonly Token[];
  /** How often a macro writes what it is given; null for what is given nothing, or a function. */
  readonly copies: number | null;
}

/** Ends a run without a verdict. */
export class Refused extends Error {
  readonly faults: readonly Fault[];

  constructor(faults: readonly Fault[]) {
    super(faults[0]?.text);
    this.faults = faults;
  }
}

export const refused = (
  text: ViewerText,
  line: number | null = null,
  values: Fault['values'] = {},
) => new Refused([{ text, values, line }]);

/** What a driver may be given, each line in its place. Throws {@link Refused}. */
export function guarded(source: string): string {
  if (source.length > MOST_CHARACTERS) {
    throw refused('The text is too long: at most {most} characters.', null, {
      most: MOST_CHARACTERS,
    });
  }
  // With every kind of space that editors and web pages put in, and a mark at the beginning.
  const spaced = source.replace(/\r\n?/g, '\n').replace(/[^\S\n]/g, ' ');
  return withStops(withoutComments(spaced).split('\n'));
}

function withoutComments(source: string): string {
  const uncommented = source.replace(
    /\/\/[^\n]*|\/\*[^]*?\*\//g,
    (comment) => ` ${comment.replace(/[^\n]/g, '')}`,
  );
  // A macro may go on in the next line. What follows keeps its line.
  const bare = uncommented.replace(
    /^(?:.*\\\n)+.*/gm,
    (lines) => lines.replaceAll('\\\n', '') + lines.replace(/.*/g, ''),
  );
  for (const [i, line] of bare.split('\n').entries()) {
    const [found] = FORBIDDEN.exec(line) ?? [];
    if (found !== undefined) {
      // Some are invisible, or look like a letter.
      const code = found.codePointAt(0)!.toString(16).toUpperCase().padStart(4, '0');
      throw refused(NOT_ALLOWED, i + 1, { part: `${found} (U+${code})` });
    }
  }
  return bare;
}

/** Characters that GLSL does not have, an open comment, and what the program around it uses. */
const FORBIDDEN = /[^ -~]|["'$@\\`]|\/\*|\bexercise\w*/u;

const TOKEN =
  /[A-Za-z_]\w*|0[xX][\da-fA-F]+[uU]?|(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[uUfF]?|<<=|>>=|[-+*/%&|^<>=!]=|\+\+|--|<<|>>|&&|\|\||\^\^|\S/g;

const tokensOf = (text: string, line: number) =>
  Array.from(text.match(TOKEN) ?? [], (token) => ({ text: token, line, span: 0 }));

const NOT_ALLOWED = 'This is not allowed here: {part}';
const DEFINE =
  'Of the lines that begin with # only #define is allowed, without a loop or a block in it.';
export const TOO_MUCH = 'The function does too much: loops and calls are limited.';

function withStops(lines: readonly string[]): string {
  const definitions: Definition[] = [];
  const tokens: Token[] = [];
  for (const [i, line] of lines.entries()) {
    if (!line.includes('#')) {
      tokens.push(...tokensOf(line, i + 1));
      continue;
    }
    const [, name = 'if', list, rest = ''] =
      /^\s*#\s*define\s+([A-Za-z_]\w*)(\([^)]*\))?(.*)$/.exec(line) ?? [];
    const body = tokensOf(rest, i + 1);
    // Our part of a loop and of an index keeps its meaning.
    const isPlain = !body.some(({ text }) => /^(for|while|do|struct|[{};#])$/.test(text));
    if (!isPlain || /^(if|else|break|int)$/.test(name)) throw refused(DEFINE, i + 1);
    match(body);
    const parameters: readonly string[] = list?.match(/\w+/g) ?? [];
    const copies = body.filter(({ text }) => parameters.includes(text)).length;
    definitions.push({ name, tokens: body, copies: list === undefined ? null : copies });
  }
  match(tokens);
  const macros = definitions.map(({ name }) => name);
  let open = 0;
  for (let i = 0; i < tokens.length; i++) {
    const { text, line, span } = tokens[i]!;
    if (span === 0) continue;
    const end = i + span;
    if (text === '{') {
      const isFunction = tokens[i - 1]?.text === ')';
      const name = tokens[(isFunction ? open : i) - 1]?.text ?? '';
      // A macro could be the name of another function.
      if (
        !/^\w/.test(name) ||
        macros.includes(name) ||
        !(isFunction || tokens[i - 2]?.text === 'struct')
      ) {
        throw refused(NOT_ALLOWED, line, { part: text });
      }
      if (isFunction) {
        definitions.push({ name, tokens: tokens.slice(i + 1, end), copies: null });
      }
    }
    open = i;
    i = end;
  }
  const codeOf = counterFor(tokens, definitions);
  codeOf(tokens);
  // Each line by itself, with what ends a loop and keeps an array short.
  const out = lines.map((line) => (line.includes('#') ? line : ''));
  const closers = new Map<number, string>();
  for (const [i, { text, line, span }] of tokens.entries()) {
    const next = tokens[i + 1]?.text;
    const isIndex = text === '[' && next !== ']';
    if (/^(while|do)$/.test(text) || (text === 'for' && next !== '(')) {
      throw refused('A loop must be a for.', line);
    }
    if (text === 'for') {
      const head = i + 1 + tokens[i + 1]!.span;
      const block = tokens[head + 1];
      // What a turn does; without braces all that follows may be in it.
      const end = block?.text === '{' ? head + 1 + block.span : tokens.length;
      const turn = codeOf(tokens.slice(i + 1, end));
      closers.set(head, `) if (exerciseStop(${line}, ${turn})) break; else`);
    } else if (isIndex) {
      // 16,000 elements take a compiler a minute: an array has 63 at most, and none of a larger size.
      closers.set(i + span, '), 64) & 63]');
    }
    out[line - 1]! += ` ${closers.get(i) ?? (isIndex ? '[min(int(' : text)}`;
  }
  return out.join('\n');
}

/** Counts a part of the code, with a copy of each definition wherever it is named. */
function counterFor(
  tokens: readonly Token[],
  definitions: readonly Definition[],
): (part: readonly Token[]) => number {
  const has = (word: RegExp) => tokens.some(({ text }) => word.test(text));
  const weight = has(/^mat\d/) ? MATRIX : has(/^for$/) ? REPEATED : 1;
  let code = 0;
  const read = (part: readonly Token[], inside: readonly Definition[]) => {
    for (const [i, { text, line }] of part.entries()) {
      code += text === 'pow' ? MATRIX * weight : weight;
      if (code > MOST_CODE) throw refused(TOO_MUCH, line);
      for (const one of definitions.filter(({ name }) => name === text)) {
        const { copies } = one;
        // A macro that is given to another one could be put in without being counted.
        if (copies !== null && part[i + 1]?.text !== '(') throw refused(DEFINE, line);
        // Of overloads only a compiler knows which one is called. It refuses recursion.
        if (inside.includes(one)) continue;
        read(one.tokens, [...inside, one]);
        for (let n = 1; n < (copies ?? 0); n++) {
          read(part.slice(i + 1, i + 2 + part[i + 1]!.span), inside);
        }
      }
    }
  };
  return (part) => {
    code = 0;
    read(part, []);
    return code;
  };
}

/** Finds the spans. A block in brackets could hide a function from the count. */
function match(tokens: readonly Token[]) {
  const open: number[] = [];
  for (const [i, { text }] of tokens.entries()) {
    const around = open.slice(-2).map((k) => tokens[k]!.text);
    if (/\(\)$|\[\]$|(^|\{)\{\}$/.test(`${around.join('')}${text}`)) {
      const first = open.pop()!;
      tokens[first]!.span = i - first;
    } else if (/^[()[\]{}]$/.test(text)) {
      open.push(i);
    }
  }
  if (open.length === 0) return;
  // Blocks are open around the fault.
  const wrong = open.find((k) => tokens[k]!.text !== '{') ?? open.at(-1)!;
  throw refused('Braces or brackets do not match.', tokens[wrong]!.line);
}
