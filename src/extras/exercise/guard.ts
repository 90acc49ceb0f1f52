// Reads a learner's GLSL before anything is compiled: whether `shade` is there, and whether a
// driver can be trusted with it. Neither a compiler nor a frame that runs can be stopped, so each
// loop has to have bounds that can be read, and the code and what it does have limits. Macros and
// constants are put in first: what is read here is what the driver gets.
import type { ViewerText } from '../../viewer/extra.js';

/** Why there is no verdict. */
export interface Fault {
  /** A key of the page's texts, or what a compiler says. */
  readonly text: string;
  readonly values: Readonly<Record<string, string | number>>;
  /** Counted from 1; null where it is no one line's. */
  readonly line: number | null;
}

export const faultOf = (
  text: ViewerText,
  values: Fault['values'] = {},
  line: number | null = null,
): Fault => ({ text, values, line });

const MOST_CHARACTERS = 20_000;

/** Of loops inside each other. */
const MOST_TURNS = 10_000;

/** Tokens of all code, with a copy of a function for each call: compilers put them in. */
const MOST_CODE = 20_000;

/** Tokens that one call of `shade` runs; one pixel takes some milliseconds in software. */
const MOST_COST = 2_000_000;

const MOST_ELEMENTS = 64;

/** Brackets in brackets, and macros in the arguments of macros. */
const MOST_DEPTH = 100;

/** Words of the code that a matrix stands for. */
const MATRIX = 16;

/** The same of an element of an array: 16,000 of them take a compiler 15 s. */
const ELEMENT = 4;

interface Token {
  readonly text: string;
  readonly line: number;
}

/** A function of the learner's. */
interface Body {
  readonly name: string;
  /** Types of the result and the parameters. */
  readonly types: readonly string[];
  readonly tokens: readonly Token[];
  readonly line: number;
  /** Index of its first token, and of that of its prototype, if it has one. */
  readonly at: number;
  readonly declaredAt: number;
}

interface Macro {
  /** Null for one that is a constant. */
  readonly parameters: readonly string[] | null;
  readonly tokens: readonly Token[];
}

/** What code needs: turns of loops inside each other, tokens that run, and tokens to compile. */
interface Needs {
  readonly turns: number;
  readonly cost: number;
  readonly code: number;
}

class Refused extends Error {
  readonly fault: Fault;

  constructor(text: ViewerText, line: number | null, values: Fault['values'] = {}) {
    super(text);
    this.fault = faultOf(text, values, line);
  }
}

/** The text without comments and macros, each line in its place; or what is wrong with it. */
export function checked(source: string): { readonly glsl: string } | { readonly fault: Fault } {
  try {
    if (source.length > MOST_CHARACTERS) {
      throw new Refused('The text is too long: at most {most} characters.', null, {
        most: MOST_CHARACTERS,
      });
    }
    // With every kind of space that editors and web pages put in, and a mark at the beginning.
    const bare = withoutComments(source.replace(/\r\n?/g, '\n').replace(/[^\S\n]/g, ' '));
    const tokens = withConstants(withoutMacros(bare));
    new Reading(tokens).check();
    return { glsl: textOf(tokens) };
  } catch (error) {
    if (error instanceof Refused) return { fault: error.fault };
    throw error;
  }
}

function withoutComments(source: string): string {
  const bare = source.replace(/\/\/[^\n]*|\/\*[^]*?(?:\*\/|$)/g, (comment, at: number) => {
    if (comment.startsWith('/*') && (comment.length < 4 || !comment.endsWith('*/'))) {
      throw new Refused('A comment is not closed.', source.slice(0, at).split('\n').length);
    }
    return ` ${comment.replace(/[^\n]/g, '')}`;
  });
  for (const [i, line] of bare.split('\n').entries()) {
    const [found] = /[^ -~]|["'$@\\`]/u.exec(line) ?? [];
    if (found !== undefined) {
      // Some are invisible, or look like a letter.
      const character = `${found} (U+${found.codePointAt(0)!.toString(16).toUpperCase().padStart(4, '0')})`;
      throw new Refused('This character is not allowed here: {character}', i + 1, { character });
    }
  }
  return bare;
}

const TOKEN =
  /[A-Za-z_]\w*|0[xX][\da-fA-F]+[uU]?|(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[uUfF]?|<<=|>>=|[-+*/%&|^<>=!]=|\+\+|--|<<|>>|&&|\|\||\^\^|\S/g;

const tokensOf = (text: string, line: number): Token[] =>
  Array.from(text.match(TOKEN) ?? [], (token) => ({ text: token, line }));

function textOf(tokens: readonly Token[]): string {
  const lines: (string | undefined)[] = [];
  for (const { text, line } of tokens) {
    lines[line - 1] = `${lines[line - 1] ?? ''} ${text}`;
  }
  return Array.from(lines, (line = '') => line).join('\n');
}

const isName = (text: string | undefined): boolean => text !== undefined && /^[A-Za-z_]/.test(text);

const LOOP =
  'A loop must be a for with numbers as bounds, and leave its variable alone, so that it ends.';
const DEFINE =
  'Of the lines that begin with # only #define is allowed, without a loop or a block in it.';
const TOO_MUCH = 'The function does too much: loops and calls are limited.';
const UNMATCHED = 'Braces or brackets do not match.';

function withoutMacros(glsl: string): Token[] {
  const macros = new Map<string, Macro>();
  const tokens: Token[] = [];
  for (const [i, line] of glsl.split('\n').entries()) {
    if (!line.includes('#')) {
      tokens.push(...tokensOf(line, i + 1));
      continue;
    }
    const [, name, list, rest = ''] =
      /^\s*#\s*define\s+([A-Za-z_]\w*)(\([^)]*\))?(.*)$/.exec(line) ?? [];
    const body = tokensOf(rest, i + 1);
    const isPlain = !body.some(({ text }) => /^(for|while|do|[{};#]|main|shade)$/.test(text));
    if (name === undefined || macros.has(name) || !isPlain) throw new Refused(DEFINE, i + 1);
    const parameters = list === undefined ? null : (list.match(/\w+/g) ?? []);
    macros.set(name, { parameters, tokens: body });
  }
  return expanded(tokens, macros, []);
}

/** As a preprocessor does it: a macro is not put into itself. */
function expanded(
  tokens: readonly Token[],
  macros: ReadonlyMap<string, Macro>,
  inside: readonly string[],
): Token[] {
  const out: Token[] = [];
  for (let i = 0; i < tokens.length; i++) {
    const { text, line } = tokens[i]!;
    const macro = inside.includes(text) ? undefined : macros.get(text);
    if (macro === undefined || (macro.parameters !== null && tokens[i + 1]?.text !== '(')) {
      out.push(tokens[i]!);
    } else {
      if (inside.length > MOST_DEPTH) throw new Refused(TOO_MUCH, line);
      let given: readonly Token[][] = [];
      if (macro.parameters !== null) {
        const end = closing(tokens, i + 1);
        // An empty name: arguments inside each other count for the depth.
        given = listed(tokens.slice(i + 2, end)).map((part) =>
          expanded(part, macros, [...inside, '']),
        );
        i = end;
      }
      const body = macro.tokens.flatMap((token): readonly Token[] => {
        const k = macro.parameters?.indexOf(token.text) ?? -1;
        return k < 0 ? [token] : (given[k] ?? []);
      });
      const placed = body.map((token) => ({ text: token.text, line }));
      out.push(...expanded(placed, macros, [...inside, text]));
    }
    if (out.length > MOST_CODE) throw new Refused(TOO_MUCH, line);
  }
  return out;
}

/** The parts between commas that no brackets hold. */
function listed(tokens: readonly Token[]): Token[][] {
  const parts: Token[][] = [[]];
  let depth = 0;
  for (const token of tokens) {
    depth += depthOf(token.text);
    if (token.text === ',' && depth === 0) {
      parts.push([]);
    } else {
      parts.at(-1)!.push(token);
    }
  }
  return parts;
}

const partsOf = (tokens: readonly Token[]): Token[][] =>
  listed(tokens).filter(({ length }) => length > 0);

/** Constants in place of their names, but for a name that is declared twice. */
function withConstants(tokens: readonly Token[]): Token[] {
  const isDeclared = (i: number): boolean =>
    isName(tokens[i]!.text) && isName(tokens[i - 1]?.text) && tokens[i - 1]!.text !== 'return';
  const values = new Map<string, string | null>();
  for (const i of tokens.keys()) {
    if (!isDeclared(i)) continue;
    const name = tokens[i]!.text;
    const [equals = '', value = '', end = ''] = tokens.slice(i + 1, i + 4).map(({ text }) => text);
    const isConstant =
      tokens[i - 2]?.text === 'const' && equals === '=' && end === ';' && /^[\d.]/.test(value);
    values.set(name, isConstant && !values.has(name) ? value : null);
  }
  return tokens.map((token, i) => {
    const value = tokens[i - 1]?.text === '.' || isDeclared(i) ? null : values.get(token.text);
    return { ...token, text: value ?? token.text };
  });
}

/** Built-in functions that write to an argument. */
const WRITERS = /^(out|inout|modf|frexp|\w+(Carry|Borrow|Extended))$/;

class Reading {
  readonly #tokens: readonly Token[];
  readonly #bodies: readonly Body[];
  /** What is being read: a function, its caller, and so on; the outermost is first. */
  readonly #callers: Body[] = [];
  #recursive: Body | undefined;
  /** In tokens: overloads that may call each other form many chains. */
  #read = 0;
  /** Tokens that one stands for. */
  readonly #weight: number;

  constructor(tokens: readonly Token[]) {
    this.#tokens = tokens;
    this.#weight = tokens.some(({ text }) => /^mat\d/.test(text)) ? MATRIX : 1;
    this.#match();
    this.#bodies = this.#readBodies();
  }

  check(): void {
    const shades = this.#bodies.filter(({ name }) => name === 'shade');
    if (shades.length === 0) {
      throw new Refused(
        'There is no function shade. Write vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye).',
        null,
      );
    }
    if (this.#bodies.some((body) => this.#needsOf(body) === null)) {
      const { name, line } = this.#recursive!;
      throw new Refused('A function calls itself: {name}. GLSL has no recursion.', line, { name });
    }
    if (!shades.some(({ types }) => types.join(' ') === 'vec3 Light Material vec3 vec3 vec3')) {
      throw new Refused(
        'shade has other parameters. Write vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye).',
        shades[0]!.line,
      );
    }
  }

  #match(): void {
    const open: Token[] = [];
    for (const [i, { text, line }] of this.#tokens.entries()) {
      if (depthOf(text) > 0) {
        open.push(this.#tokens[i]!);
      } else if (depthOf(text) < 0 && !/^(\(\)|\[\]|\{\})$/.test(`${open.pop()?.text}${text}`)) {
        throw new Refused(UNMATCHED, line);
      }
      const isLong = text === '[' && numberIn(this.#tokens[i + 1]?.text) > MOST_ELEMENTS;
      if (isLong || open.length > MOST_DEPTH) throw new Refused(TOO_MUCH, line);
    }
    if (open.length > 0) throw new Refused(UNMATCHED, open.at(-1)!.line);
  }

  #readBodies(): Body[] {
    const tokens = this.#tokens;
    const bodies: Body[] = [];
    const declared = new Map<string, number>();
    for (let i = 0; i < tokens.length; i++) {
      const { text, line } = tokens[i]!;
      if (text !== '(' && text !== '{') continue;
      const close = closing(tokens, i);
      const at = Math.max(i - 2, 0);
      const [type = '', name = ''] = tokens.slice(at, i).map((word) => word.text);
      const isStruct = text === '{' && type === 'struct';
      const isFunction = text === '(' && tokens[close + 1]?.text === '{';
      if (/^(main|Light|Material)$/.test(name) && (isStruct || isFunction)) {
        throw new Refused('Leave out {name}: it is there already.', line, { name });
      }
      const types = [type, ...typesIn(tokens.slice(i + 1, close))];
      const key = [name, ...types].join(' ');
      const declaredAt = declared.get(key) ?? at;
      declared.set(key, declaredAt);
      const end = isFunction ? closing(tokens, close + 1) : close;
      if (isFunction && isName(name)) {
        bodies.push({ name, types, tokens: tokens.slice(close + 2, end), line, at, declaredAt });
      } else if (isFunction || (text === '{' && !isStruct)) {
        throw new Refused(UNMATCHED, line);
      }
      i = end;
    }
    return bodies;
  }

  /** Null where it cannot but call itself. */
  #needsOf(body: Body): Needs | null {
    if (this.#callers.includes(body)) {
      this.#recursive = body;
      return null;
    }
    this.#callers.push(body);
    const needs = this.#needsIn(body.tokens);
    this.#callers.pop();
    return needs;
  }

  /**
   * What the word at `i` may call: functions that are declared before the caller and have as many
   * parameters. Which of several overloads it is only a compiler knows, which refuses recursion.
   */
  #calledAt(tokens: readonly Token[], i: number): readonly Body[] {
    const { text } = tokens[i]!;
    if (tokens[i - 1]?.text === '.' || tokens[i + 1]?.text !== '(') return [];
    const args = partsOf(tokens.slice(i + 2, closing(tokens, i + 1))).length;
    const { at } = this.#callers.at(-1)!;
    return this.#bodies.filter(
      ({ name, types, declaredAt }) =>
        name === text && types.length === args + 1 && declaredAt <= at,
    );
  }

  #needsIn(tokens: readonly Token[]): Needs | null {
    let turns = 1;
    let cost = 0;
    let code = 0;
    const plus = (needs: Needs, line: number, times = 1): void => {
      turns = Math.max(turns, times * needs.turns);
      cost += times * needs.cost;
      code += needs.code;
      if (turns > MOST_TURNS) {
        throw new Refused('Loops inside each other may run {most} times at most.', line, {
          most: MOST_TURNS,
        });
      }
      if (cost > MOST_COST || code > MOST_CODE || this.#read > 10 * MOST_CODE) {
        throw new Refused(TOO_MUCH, line);
      }
    };
    const own = this.#weight * tokens.length;
    this.#read += own;
    plus({ turns: 1, cost: own, code: own }, tokens[0]?.line ?? 1);
    for (let i = 0; i < tokens.length; i++) {
      const { text, line } = tokens[i]!;
      if (text === 'while' || text === 'do') throw new Refused(LOOP, line);
      if (text === '[') {
        const sizes = tokens.slice(i + 1, closing(tokens, i)).map((token) => numberIn(token.text));
        code += ELEMENT * sizes.reduce((product, size) => product * (size || 1), 1);
      }
      if (text === 'for') {
        const close = closing(tokens, i + 1);
        const end = statementEnd(tokens, close + 1);
        const body = tokens.slice(close + 1, end + 1);
        const times = this.#turns(wordsOf(tokens.slice(i + 2, close)), wordsOf(body));
        if (times === null) throw new Refused(LOOP, line);
        const needs = this.#needsIn(body);
        if (needs === null) return null;
        plus(needs, line, Math.max(times, 1));
        i = end;
      } else {
        const called = this.#calledAt(tokens, i);
        const all = called.flatMap((body) => this.#needsOf(body) ?? []);
        if (all.length === 0 && called.length > 0) return null;
        const most = (key: keyof Needs): number => Math.max(0, ...all.map((needs) => needs[key]));
        plus({ turns: most('turns'), cost: most('cost'), code: most('code') }, line);
      }
    }
    return { turns, cost, code };
  }

  /** How often a loop runs; null where that cannot be read from its head. */
  #turns(head: string, body: string): number | null {
    const [, type, name = '', from, comparison = '', to, before, after, short, long, by = '1'] =
      LOOP_HEAD.exec(head) ?? [];
    const sign = before ?? after ?? short ?? long ?? '';
    const [first, last] = [numberIn(from), numberIn(to)];
    const step = numberIn(by) * (sign.startsWith('-') ? -1 : 1);
    const isUp = step > 0;
    const isEnding = comparison.startsWith(isUp ? '<' : '>') && (isUp || type !== 'uint');
    // A step that float32 cannot add would never end.
    const size = Math.abs(step);
    const largest = Math.max(Math.abs(first), Math.abs(last)) + size;
    const isAdded = Math.fround(largest + size) - largest > size / 2;
    if (!isEnding || !isAdded || !(largest <= 1e6) || this.#isWritten(name, body)) return null;
    return Math.max(Math.ceil((last - first) / step) + (comparison.endsWith('=') ? 1 : 0), 0);
  }

  /** Whether the loop's variable may change in the body. */
  #isWritten(name: string, body: string): boolean {
    const writers = this.#tokens.some(({ text }) => WRITERS.test(text));
    let text = ` ${body} `;
    for (let before = ''; !writers && text !== before;) {
      before = text;
      text = text.replaceAll(` ( ${name} ) `, ` ${name} `);
    }
    const given = writers ? `|[(,] ${name} [),]` : '';
    return new RegExp(
      `(\\+\\+|--) ${name} | ${name} (\\+\\+|--|([-+*/%&|^]|<<|>>)?=) ${given}`,
    ).test(text);
  }
}

/** Of parameters, with or without names. */
const typesIn = (parameters: readonly Token[]): string[] =>
  partsOf(parameters.filter(({ text }) => !/^(in|const|highp|mediump|lowp|void)$/.test(text))).map(
    (part) =>
      part
        .slice(0, /out$/.test(part[0]!.text) ? 2 : 1)
        .map(({ text }) => text)
        .join(' '),
  );

const NUMBER = String.raw`(?:\( )*(-? ?[\d.]\S*)(?: \))*`;

/** As `int i = 0; i < 8; i++` with other numbers, or with `i += 2` or `i = i + 2`. */
const LOOP_HEAD = new RegExp(
  String.raw`^(int|uint|float) (\w+) = ${NUMBER} ; \2 ([<>]=?) ${NUMBER} ; (?:(\+\+|--) \2|\2 (\+\+|--)|\2 (?:([+-])=|= \2 ([+-])) ${NUMBER})$`,
);

/** NaN where it is none that is read as decimal: octal ones look so. */
function numberIn(text = ''): number {
  const word = text.replace(/^- ?/, '');
  const size = /^0x/i.test(word) ? parseInt(word) : /^0\d/.test(word) ? NaN : parseFloat(word);
  return word === text ? size : -size;
}

const wordsOf = (tokens: readonly Token[]): string => tokens.map(({ text }) => text).join(' ');

/** What a bracket adds to the depth. */
const depthOf = (text: string): number =>
  /^[([{]$/.test(text) ? 1 : /^[)\]}]$/.test(text) ? -1 : 0;

/** The index of the bracket that closes the one at `open`. */
function closing(tokens: readonly Token[], open: number): number {
  let depth = 0;
  for (let i = open; i < tokens.length; i++) {
    depth += depthOf(tokens[i]!.text);
    if (depth <= 0) return i;
  }
  return tokens.length - 1;
}

/** The last token of the statement that begins at `start`. */
function statementEnd(tokens: readonly Token[], start: number): number {
  const text = tokens[start]?.text;
  if (text === '{') return closing(tokens, start);
  if (text === 'for' || text === 'if' || text === 'switch') {
    const end = statementEnd(tokens, closing(tokens, start + 1) + 1);
    return tokens[end + 1]?.text === 'else' ? statementEnd(tokens, end + 2) : end;
  }
  const end = tokens.findIndex((token, i) => i >= start && token.text === ';');
  return end < 0 ? tokens.length - 1 : end;
}
