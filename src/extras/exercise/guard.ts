// Reads a learner's GLSL before anything is compiled: whether `shade` is there, and whether a
// driver can be trusted with it. Neither a compiler nor a frame that runs can be stopped, so each
// loop has to have bounds that can be read, and the code and what it does have limits. Macros and
// constants are put in first: what is read here is what the driver gets.

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

/** Tokens of all code, with a copy of a function for each call: compilers put them in. */
const MOST_CODE = 20_000;

/** Tokens that one call of `shade` runs; one pixel takes some milliseconds in software. */
const MOST_COST = 2_000_000;

const MOST_ELEMENTS = 64;

/** Macros in the arguments of macros. */
const MOST_DEPTH = 100;

/** Words of the code that a matrix stands for. */
const MATRIX = 16;

interface Token {
  readonly text: string;
  readonly line: number;
}

/** A function of the learner's, or a struct. */
interface Body {
  readonly name: string;
  /** Types of the parameters; null of a struct. */
  readonly types: readonly string[] | null;
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

  constructor(text: FaultText, line: number | null, values: Fault['values'] = {}) {
    super(text);
    this.fault = { text, line, values };
  }
}

/**
 * The text without comments and macros, each line in its place, and how many tokens one call of
 * `shade` runs; or what is wrong with it.
 */
export function checked(
  source: string,
): { readonly glsl: string; readonly cost: number } | { readonly fault: Fault } {
  try {
    if (source.length > MOST_CHARACTERS) {
      throw new Refused('The text is too long: at most {most} characters.', null, {
        most: String(MOST_CHARACTERS),
      });
    }
    const bare = withoutComments(source.replace(/\r\n?/g, '\n'));
    const tokens = withConstants(withoutMacros(bare));
    return { glsl: textOf(tokens), cost: new Reading(tokens).cost() };
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
  readonly #needs = new Map<Body, Needs | null>();
  /** Tokens that one stands for. */
  readonly #weight: number;

  constructor(tokens: readonly Token[]) {
    this.#tokens = tokens;
    this.#weight = tokens.some(({ text }) => /^mat\d/.test(text)) ? MATRIX : 1;
    this.#match();
    this.#bodies = this.#readBodies();
  }

  cost(): number {
    const shades = this.#bodies.filter(({ name }) => name === 'shade');
    if (shades.length === 0) {
      throw new Refused(
        'There is no function shade. Write vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye).',
        null,
      );
    }
    for (const body of this.#bodies) {
      const { name, line } = body;
      if (/^(main|Light|Material)$/.test(name)) {
        throw new Refused('Leave out {name}: it is there already.', line, { name });
      }
      this.#needsOf(body);
    }
    const shade = shades.find(
      ({ types, at }) =>
        types?.join(' ') === 'Light Material vec3 vec3 vec3' && this.#tokens[at]!.text === 'vec3',
    );
    if (shade === undefined) {
      throw new Refused(
        'shade has other parameters. Write vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye).',
        shades[0]!.line,
      );
    }
    return this.#needsOf(shade).cost;
  }

  #match(): void {
    const open: Token[] = [];
    for (const [i, { text, line }] of this.#tokens.entries()) {
      if (depthOf(text) > 0) {
        open.push(this.#tokens[i]!);
      } else if (depthOf(text) < 0 && !/^(\(\)|\[\]|\{\})$/.test(`${open.pop()?.text}${text}`)) {
        throw new Refused(UNMATCHED, line);
      }
      const size = text === '[' ? numberIn(this.#tokens.slice(i + 1, closing(this.#tokens, i))) : 0;
      if (size !== null && size > MOST_ELEMENTS) throw new Refused(TOO_MUCH, line);
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
      const types = text === '(' ? typesIn(tokens.slice(i + 1, close)) : null;
      const key = [name, ...(types ?? [])].join(' ');
      declared.set(key, declared.get(key) ?? at);
      if (types !== null && tokens[close + 1]?.text !== '{') {
        i = close;
        continue;
      }
      if (!isName(name) || (types === null && type !== 'struct'))
        throw new Refused(UNMATCHED, line);
      const start = types === null ? i : close + 1;
      const end = closing(tokens, start);
      const declaredAt = declared.get(key)!;
      bodies.push({ name, types, tokens: tokens.slice(start + 1, end), line, at, declaredAt });
      i = end;
    }
    return bodies;
  }

  #needsOf(body: Body): Needs {
    const { name, line } = body;
    const known = this.#needs.get(body);
    if (known === null) {
      throw new Refused('A function calls itself: {name}. GLSL has no recursion.', line, { name });
    }
    if (known !== undefined) return known;
    this.#needs.set(body, null);
    const needs = this.#needsIn(body, body.tokens);
    this.#needs.set(body, needs);
    return needs;
  }

  /**
   * What a word of `caller` may call: functions that are declared before it and have as many
   * parameters. An overload that calls its name means another one, if there is one: where it means
   * itself all compilers refuse it.
   */
  #calledBy(caller: Body, tokens: readonly Token[], i: number): readonly Body[] {
    const { text } = tokens[i]!;
    if (tokens[i - 1]?.text === '.') return [];
    const named = this.#bodies.filter(
      ({ name, declaredAt }) => name === text && declaredAt <= caller.at,
    );
    if (named.length === 0) return named;
    const args =
      tokens[i + 1]?.text === '('
        ? partsOf(tokens.slice(i + 2, closing(tokens, i + 1))).length
        : -1;
    const called = named.filter(({ types }) => types === null || types.length === args);
    return called.length > 1 ? called.filter((body) => body !== caller) : called;
  }

  #needsIn(caller: Body, tokens: readonly Token[]): Needs {
    let turns = 1;
    let cost = 0;
    let code = 0;
    const plus = (needs: Needs, line: number, times = 1): void => {
      turns = Math.max(turns, times * needs.turns);
      cost += times * needs.cost;
      code += needs.code;
      if (turns > MOST_TURNS) {
        const most = MOST_TURNS.toLocaleString('en');
        throw new Refused('Loops inside each other may run {most} times at most.', line, { most });
      }
      if (cost > MOST_COST || code > MOST_CODE) throw new Refused(TOO_MUCH, line);
    };
    const own = this.#weight * tokens.length;
    plus({ turns: 1, cost: own, code: own }, tokens[0]?.line ?? 1);
    for (let i = 0; i < tokens.length; i++) {
      const { text, line } = tokens[i]!;
      if (text === 'while' || text === 'do') throw new Refused(LOOP, line);
      if (text === 'for') {
        const close = closing(tokens, i + 1);
        const end = statementEnd(tokens, close + 1);
        const body = tokens.slice(close + 1, end + 1);
        const times = this.#turns(tokens.slice(i + 2, close), body);
        if (times === null) throw new Refused(LOOP, line);
        plus(this.#needsIn(caller, body), line, Math.max(times, 1));
        i = end;
      } else {
        const all = this.#calledBy(caller, tokens, i).map((body) => this.#needsOf(body));
        const most = (of: keyof Needs): number => Math.max(...all.map((needs) => needs[of]), 0);
        plus({ turns: most('turns'), cost: most('cost'), code: most('code') }, line);
      }
    }
    return { turns, cost, code };
  }

  /** How often a loop runs; null where that cannot be read from its head. */
  #turns(head: readonly Token[], body: readonly Token[]): number | null {
    const words = head.map(({ text }) => text);
    const first = words.indexOf(';');
    const second = words.indexOf(';', first + 1);
    const [type, name, equals] = words;
    if (!/^(int|uint|float)$/.test(type ?? '') || equals !== '=' || !isName(name)) return null;
    const from = numberIn(head.slice(3, first));
    const [variable, comparison = ''] = words.slice(first + 1);
    const to = numberIn(head.slice(first + 3, second));
    const step = stepIn(head.slice(second + 1), name!);
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

  /** Whether the loop's variable may change in the body. */
  #isWritten(name: string, body: readonly Token[]): boolean {
    const writers = this.#tokens.some(({ text }) => WRITERS.test(text));
    return body.some(({ text }, i) => {
      if (text !== name) return false;
      let [from, to] = [i - 1, i + 1];
      while (body[from]?.text === '(' && body[to]?.text === ')') {
        if (writers) return true;
        from -= 1;
        to += 1;
      }
      const before = body[from]?.text ?? '';
      const after = body[to]?.text ?? '';
      return (
        /^(\+\+|--)$/.test(before) ||
        /^(\+\+|--|=|[-+*/%&|^]=|<<=|>>=)$/.test(after) ||
        (writers && /^[(,]$/.test(before) && /^[),]$/.test(after))
      );
    });
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

/** The number that the tokens are; null where they are none. */
function numberIn(tokens: readonly Token[]): number | null {
  const words = tokens.map(({ text }) => text);
  while (words[0] === '(' && words.at(-1) === ')') {
    words.pop();
    words.shift();
  }
  const sign = words[0] === '-' ? -1 : 1;
  const [word = '', ...rest] = sign < 0 ? words.slice(1) : words;
  // Octal numbers look like decimal ones.
  if (rest.length > 0 || !/^[\d.]/.test(word) || /^0\d/.test(word)) return null;
  return sign * (/^0x/i.test(word) ? parseInt(word) : parseFloat(word));
}

function stepIn(tokens: readonly Token[], name: string): number | null {
  const words = tokens.map(({ text }) => text);
  if (words.length === 2) {
    const sign = words.find((word) => word !== name);
    const isStep = words.includes(name) && (sign === '++' || sign === '--');
    return isStep ? (sign === '++' ? 1 : -1) : null;
  }
  const by = numberIn(tokens.slice(2));
  if (words[0] !== name || by === null || !/^[+-]=$/.test(words[1] ?? '')) return null;
  return words[1] === '+=' ? by : -by;
}

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
  if (text === 'for' || text === 'if' || text === 'switch' || text === 'while') {
    const end = statementEnd(tokens, closing(tokens, start + 1) + 1);
    return tokens[end + 1]?.text === 'else' ? statementEnd(tokens, end + 2) : end;
  }
  const end = tokens.findIndex((token, i) => i >= start && token.text === ';');
  return end < 0 ? tokens.length - 1 : end;
}
