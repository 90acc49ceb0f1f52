// Reads a learner's GLSL before anything is compiled: whether `shade` is there, and whether a
// driver can be trusted with it. A frame that runs cannot be stopped, so each loop has to have
// bounds that can be read, and what all of them do together has a limit.

/** What keeps a function from being run. `text` is a key of the page's texts. */
export interface Fault {
  readonly text: FaultText;
  readonly values?: Readonly<Record<string, string>>;
  /** Counted from 1; null where it is no one line's. */
  readonly line: number | null;
}

export type FaultText =
  | 'The text is too long: at most {most} characters.'
  | 'A comment is not closed.'
  | 'Of the lines that begin with # only #define is allowed, without a loop or a block in it.'
  | 'This character is not allowed here: {character}'
  | 'Braces or brackets do not match.'
  | 'A loop must be a for with numbers as bounds, and leave its variable alone, so that it ends.'
  | 'Loops inside each other may run {most} times at most.'
  | 'The function does too much: loops and calls are limited.'
  | 'A function calls itself: {name}. GLSL has no recursion.'
  | 'Leave out {name}: it is there already.'
  | 'There is no function shade. Write vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye).'
  | 'shade has other parameters. Write vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye).';

const MOST_CHARACTERS = 20_000;

/** Of loops inside each other. */
const MOST_TURNS = 10_000;

/** Turns and calls together; one pixel takes about a millisecond in software. */
const MOST_COST = 100_000;

const MOST_ELEMENTS = 1024;

interface Token {
  readonly text: string;
  readonly line: number;
}

/** A function of the learner's, or a macro, which counts as one. */
interface Body {
  readonly tokens: readonly Token[];
  readonly line: number;
}

class Refused extends Error {
  readonly fault: Fault;

  constructor(text: FaultText, line: number | null, values: Fault['values'] = {}) {
    super(text);
    this.fault = { text, line, values };
  }
}

/** The text without its comments, each line in its place, or what is wrong with it. */
export function checked(source: string): { readonly glsl: string } | { readonly fault: Fault } {
  try {
    if (source.length > MOST_CHARACTERS) {
      throw new Refused('The text is too long: at most {most} characters.', null, {
        most: String(MOST_CHARACTERS),
      });
    }
    const glsl = withoutComments(source.replace(/\r\n?/g, '\n'));
    new Reading(glsl).check();
    return { glsl };
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
    const [character] = /[^\t\f\v -~]|["'$@\\`]/.exec(line) ?? [];
    if (character !== undefined) {
      throw new Refused('This character is not allowed here: {character}', i + 1, { character });
    }
  }
  return bare;
}

const TOKEN =
  /[A-Za-z_]\w*|0[xX][\da-fA-F]+[uU]?|(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[uUfF]?|<<=|>>=|[-+*/%&|^<>=!]=|\+\+|--|\S/g;

const tokensOf = (text: string, line: number): Token[] =>
  Array.from(text.match(TOKEN) ?? [], (token) => ({ text: token, line }));

const isName = (text: string | undefined): boolean => text !== undefined && /^[A-Za-z_]/.test(text);

const LOOP =
  'A loop must be a for with numbers as bounds, and leave its variable alone, so that it ends.';
const DEFINE =
  'Of the lines that begin with # only #define is allowed, without a loop or a block in it.';

/** Built-in functions that write to an argument. */
const WRITERS = /^(out|inout|modf|frexp|\w+(Carry|Borrow|Extended))$/;

const OPEN: Readonly<Record<string, string>> = { '(': ')', '[': ']', '{': '}' };

class Reading {
  readonly #tokens: Token[] = [];
  readonly #bodies = new Map<string, Body[]>();
  /** Each with its parameters. */
  readonly #macros = new Map<string, ReadonlySet<string>>();
  /** Numbers by name: constants that nothing else is called like. */
  readonly #numbers = new Map<string, number>();
  /** The partner of each brace and bracket, by index. */
  readonly #partner: number[] = [];
  readonly #costs = new Map<string, { turns: number; cost: number } | null>();

  constructor(glsl: string) {
    for (const [i, line] of glsl.split('\n').entries()) {
      if (line.includes('#')) {
        this.#readDefine(line, i + 1);
      } else {
        this.#tokens.push(...tokensOf(line, i + 1));
      }
    }
  }

  check(): void {
    this.#match();
    this.#readConstants();
    const shades = this.#readFunctions();
    if (!this.#bodies.has('shade')) {
      throw new Refused(
        'There is no function shade. Write vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye).',
        null,
      );
    }
    for (const [name, [body]] of this.#bodies) {
      if (/^(main|Light|Material)$/.test(name)) {
        throw new Refused('Leave out {name}: it is there already.', body!.line, { name });
      }
      this.#costOf(name);
    }
    if (!shades.includes('Light Material vec3 vec3 vec3')) {
      throw new Refused(
        'shade has other parameters. Write vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye).',
        this.#bodies.get('shade')![0]!.line,
      );
    }
  }

  #readDefine(line: string, number: number): void {
    const [, name, rest = ''] = /^\s*#\s*define\s+([A-Za-z_]\w*)(.*)$/.exec(line) ?? [];
    const tokens = tokensOf(rest, number);
    if (
      name === undefined ||
      tokens.some(({ text }) => /^(for|while|do|[{};#]|main|shade)$/.test(text))
    ) {
      throw new Refused(DEFINE, number);
    }
    if (name === 'shade' || this.#macros.has(name)) throw new Refused(DEFINE, number);
    const [list = ''] = /^\([^)]*\)/.exec(rest) ?? [];
    this.#macros.set(name, new Set(list.match(/\w+/g)));
    this.#bodies.set(name, [{ tokens: tokens.slice(tokensOf(list, 0).length), line: number }]);
    const value = rest.trim().replace(/^\((.*)\)$/, '$1');
    if (/^-?[\d.]/.test(value) && tokensOf(value.replace('-', ''), 0).length === 1) {
      this.#numbers.set(name, parseFloat(value));
    }
  }

  #match(): void {
    const open: number[] = [];
    for (const [i, { text, line }] of this.#tokens.entries()) {
      if (text in OPEN) {
        open.push(i);
      } else if (/[)\]}]/.test(text)) {
        const last = open.pop();
        if (last === undefined || OPEN[this.#tokens[last]!.text] !== text) {
          throw new Refused('Braces or brackets do not match.', line);
        }
        this.#partner[last] = i;
        this.#partner[i] = last;
      }
    }
    if (open.length > 0) {
      throw new Refused('Braces or brackets do not match.', this.#tokens[open.at(-1)!]!.line);
    }
  }

  #readConstants(): void {
    const named = new Map<string, number>();
    for (const [i, { text, line }] of this.#tokens.entries()) {
      if (isName(text) && isName(this.#text(i - 1)) && this.#text(i - 1) !== 'return') {
        named.set(text, (named.get(text) ?? 0) + 1);
        if (this.#text(i - 2) === 'const' && this.#text(i + 1) === '=') {
          const value = this.#number(i + 2, 1);
          if (value !== null && this.#text(i + 3) === ';') {
            this.#numbers.set(text, value);
          }
        }
      }
      const size = text === '[' && this.#partner[i] === i + 2 ? this.#number(i + 1, 1) : null;
      if (size !== null && size > MOST_ELEMENTS) {
        throw new Refused('The function does too much: loops and calls are limited.', line);
      }
    }
    for (const [name, count] of named) {
      if (count > 1 || this.#macros.has(name)) {
        this.#numbers.delete(name);
      }
    }
  }

  /** Fills the bodies. Returns the types of the parameters of each `vec3 shade`. */
  #readFunctions(): string[] {
    const shades: string[] = [];
    for (let i = 0; i < this.#tokens.length; i++) {
      const { text, line } = this.#tokens[i]!;
      if (text === '(' && this.#text(this.#partner[i]! + 1) !== '{') {
        i = this.#partner[i]!;
      }
      if (text !== '{') continue;
      const end = this.#partner[i]!;
      const isFunction = this.#text(i - 1) === ')';
      const at = isFunction ? this.#partner[i - 1]! - 1 : i - 1;
      const name = this.#text(at) ?? '';
      if (!isName(name) || (!isFunction && this.#text(i - 2) !== 'struct')) {
        throw new Refused('Braces or brackets do not match.', line);
      }
      if (this.#macros.has(name)) throw new Refused(DEFINE, line);
      const body = { tokens: this.#tokens.slice(i + 1, end), line };
      this.#bodies.set(name, [...(this.#bodies.get(name) ?? []), body]);
      if (name === 'shade' && this.#text(at - 1) === 'vec3') {
        shades.push(this.#typesBetween(at + 1, i - 1));
      }
      i = end;
    }
    return shades;
  }

  #typesBetween(open: number, close: number): string {
    const words = this.#tokens.slice(open + 1, close).map(({ text }) => text);
    return words
      .filter((word) => !/^(in|const|highp|mediump|lowp)$/.test(word))
      .join(' ')
      .split(' , ')
      .map((parameter) => parameter.replace(/ \w+$/, ''))
      .join(' ');
  }

  #text(i: number): string | undefined {
    return this.#tokens[i]?.text;
  }

  /** The number that `length` tokens from `i` on are; null where they are none. */
  #number(i: number, length: number, tokens: readonly Token[] = this.#tokens): number | null {
    const words = tokens.slice(i, i + length).map(({ text }) => text);
    const sign = words[0] === '-' ? -1 : 1;
    const [word = '', ...rest] = sign < 0 ? words.slice(1) : words;
    if (rest.length > 0) return null;
    const known = this.#numbers.get(word);
    if (known !== undefined) return sign * known;
    // Octal numbers look like decimal ones.
    if (!/^[\d.]/.test(word) || /^0\d/.test(word)) return null;
    return sign * (/^0x/i.test(word) ? parseInt(word) : parseFloat(word));
  }

  /** Most turns of loops inside each other, calls included, and all that a call does. */
  #costOf(name: string): { turns: number; cost: number } {
    const known = this.#costs.get(name);
    const bodies = this.#bodies.get(name)!;
    if (known === null) {
      throw new Refused(
        'A function calls itself: {name}. GLSL has no recursion.',
        bodies[0]!.line,
        {
          name,
        },
      );
    }
    if (known !== undefined) return known;
    this.#costs.set(name, null);
    const all = { turns: 1, cost: 1 };
    for (const { tokens } of bodies) {
      const { turns, cost } = this.#costIn(tokens);
      all.turns = Math.max(all.turns, turns);
      all.cost += cost;
    }
    this.#costs.set(name, all);
    return all;
  }

  #costIn(tokens: readonly Token[]): { turns: number; cost: number } {
    const all = { turns: 1, cost: 0 };
    const plus = (
      { turns, cost }: { turns: number; cost: number },
      line: number,
      times = 1,
      copies = 1,
    ) => {
      all.turns = Math.max(all.turns, times * turns);
      all.cost += times * copies * (1 + cost);
      if (all.turns > MOST_TURNS) {
        const most = MOST_TURNS.toLocaleString('en');
        throw new Refused('Loops inside each other may run {most} times at most.', line, { most });
      }
      if (all.cost > MOST_COST) {
        throw new Refused('The function does too much: loops and calls are limited.', line);
      }
    };
    for (let i = 0; i < tokens.length; i++) {
      const { text, line } = tokens[i]!;
      if (text === 'while' || text === 'do') throw new Refused(LOOP, line);
      if (text === 'for') {
        const close = closing(tokens, i + 1);
        const end = statementEnd(tokens, close + 1);
        const body = tokens.slice(close + 1, end + 1);
        const times = this.#turns(tokens.slice(i + 2, close), body);
        if (times === null) throw new Refused(LOOP, line);
        plus(this.#costIn(body), line, Math.max(times, 1));
        i = end;
      } else if (this.#bodies.has(text) && tokens[i - 1]?.text !== '.') {
        plus(this.#costOf(text), line);
        if (!this.#macros.has(text)) continue;
        // A macro repeats what it is given, and macros in it do so again.
        const copies = this.#copiesOf(text);
        const isCall = tokens[i + 1]?.text === '(';
        if (!isCall && copies > 1) throw new Refused(DEFINE, line);
        if (isCall) {
          const end = closing(tokens, i + 1);
          plus(this.#costIn(tokens.slice(i + 2, end)), line, 1, copies);
          i = end;
        }
      }
    }
    return all;
  }

  /** Most copies that a macro makes of what it is given; it is no part of itself. */
  #copiesOf(name: string): number {
    const parameters = this.#macros.get(name);
    if (parameters === undefined) return 1;
    const words = this.#bodies.get(name)![0]!.tokens.map(({ text }) => text);
    const own = words.filter((word) => parameters.has(word)).length;
    return words.reduce((copies, word) => copies * this.#copiesOf(word), Math.max(own, 1));
  }

  /** How often a loop runs; null where that cannot be read from its head. */
  #turns(head: readonly Token[], body: readonly Token[]): number | null {
    const words = head.map(({ text }) => text);
    const first = words.indexOf(';');
    const second = words.indexOf(';', first + 1);
    const [type, name, equals] = words;
    if (!/^(int|uint|float)$/.test(type ?? '') || equals !== '=' || !isName(name)) return null;
    const from = this.#number(3, first - 3, head);
    const [variable, comparison = ''] = words.slice(first + 1);
    const to = this.#number(first + 3, second - first - 3, head);
    const step = this.#step(head.slice(second + 1), name!);
    if (from === null || to === null || step === null || variable !== name) return null;
    if (this.#isWritten(name!, body)) return null;
    const isUp = step > 0;
    const isEnding = isUp ? /^<=?$/.test(comparison) : /^>=?$/.test(comparison) && type !== 'uint';
    // A step that float32 cannot add would never end.
    const largest = Math.max(Math.abs(from), Math.abs(to)) + Math.abs(step);
    const isAdded = Math.abs(Math.fround(largest + Math.abs(step)) - largest) > Math.abs(step) / 2;
    if (!isEnding || !isAdded || largest > 1e6) return null;
    return Math.max(Math.ceil((to - from) / step) + (comparison.endsWith('=') ? 1 : 0), 0);
  }

  #step(tokens: readonly Token[], name: string): number | null {
    const words = tokens.map(({ text }) => text);
    const by = this.#number(2, words.length - 2, tokens);
    if (words.length === 2) {
      const sign = words.find((word) => word !== name);
      const isStep = words.includes(name) && (sign === '++' || sign === '--');
      return isStep ? (sign === '++' ? 1 : -1) : null;
    }
    if (words[0] !== name || by === null || !/^[+-]=$/.test(words[1] ?? '')) return null;
    return words[1] === '+=' ? by : -by;
  }

  /** Whether the loop's variable may change in the body, macros included. */
  #isWritten(name: string, body: readonly Token[]): boolean {
    const writers = this.#tokens.some(({ text }) => WRITERS.test(text));
    const inMacro = [...this.#macros.keys()].some((macro) =>
      this.#bodies
        .get(macro)!
        .some(({ tokens }) =>
          tokens.some(({ text }) => text === name || /^(\+\+|--|.*[^<>=!]=|=|<<=|>>=)$/.test(text)),
        ),
    );
    if (inMacro || this.#macros.has(name)) return true;
    return body.some(({ text }, i) => {
      if (text !== name) return false;
      const before = body[i - 1]?.text ?? '';
      const after = body[i + 1]?.text ?? '';
      const isArgument = /^[(,]$/.test(before) && /^[),]$/.test(after);
      return (
        /^(\+\+|--)$/.test(before) ||
        /^(\+\+|--|=|[-+*/%&|^]=|<<=|>>=)$/.test(after) ||
        (writers && isArgument)
      );
    });
  }
}

/** The index of the bracket that closes the one at `open`. */
function closing(tokens: readonly Token[], open: number): number {
  let depth = 0;
  for (let i = open; i < tokens.length; i++) {
    const { text } = tokens[i]!;
    if (text in OPEN) {
      depth++;
    } else if (/^[)\]}]$/.test(text) && --depth === 0) {
      return i;
    }
  }
  return tokens.length - 1;
}

/** The last token of the statement that begins at `start`. */
function statementEnd(tokens: readonly Token[], start: number): number {
  const text = tokens[start]?.text;
  if (text === '{') return closing(tokens, start);
  if (text === 'for' || text === 'if' || text === 'switch' || text === 'while') {
    const end = statementEnd(tokens, closing(tokens, start + 1) + 1);
    return tokens[end + 1]?.text === 'else' ? statementEnd(tokens, end + 2) : end;
  }
  const end = tokens.findIndex((token, i) => i >= start && token.text === ';');
  return end < 0 ? tokens.length - 1 : end;
}
