// How much of a GLSL program's text is at work: the code that `main` reaches once all preprocessor conditions are
// decided.

/** The bodies of the functions that `main` reaches, its own included. */
export function reachedCode(text: string): string {
  const bodies = functionsOf(preprocess(text).code);
  const reached = new Set<string>();
  const reach = (name: string): void => {
    const body = bodies.get(name);
    if (body === undefined || reached.has(name)) return;
    reached.add(name);
    for (const [, callee] of body.matchAll(/\b([A-Za-z_]\w*)\s*\(/g)) reach(callee!);
  };
  reach('main');
  return [...reached].map((name) => bodies.get(name)!.replace(/\s+/g, ' ')).join('\n');
}

interface Decided {
  /** Object-like macros alone. */
  readonly defines: ReadonlyMap<string, string>;
  /** The text without directives, with macros expanded. */
  readonly code: string;
}

function preprocess(text: string): Decided {
  const defines = new Map<string, string>();
  const lines: string[] = [];
  /** For each open #if: whether this branch is active, and whether an earlier one was. */
  const open: { live: boolean; done: boolean }[] = [];
  const alive = (): boolean => open.every(({ live }) => live);
  for (const line of text.replace(/\/\*[^]*?\*\/|\/\/[^\n]*/g, ' ').split('\n')) {
    const [, directive, rest = ''] = /^\s*#\s*(\w+)\s*(.*?)\s*$/.exec(line) ?? [];
    if (directive === undefined) {
      if (alive()) lines.push(replaced(line, defines));
      continue;
    }
    const top = open.at(-1);
    if (directive === 'ifdef') begin(defines.has(rest));
    else if (directive === 'ifndef') begin(!defines.has(rest));
    else if (directive === 'if') begin(alive() && decide(rest, defines));
    else if (directive === 'elif' && top) turn(top, !top.done && decide(rest, defines));
    else if (directive === 'else' && top) turn(top, !top.done);
    else if (directive === 'endif') open.pop();
    else if (directive === 'define' && alive()) {
      const [, name = '', value = ''] = /^(\w+)\s*(.*)$/.exec(rest) ?? [];
      defines.set(name, value);
    } else if (directive === 'undef' && alive()) defines.delete(rest);
  }
  return { defines, code: lines.join('\n') };

  function begin(live: boolean): void {
    open.push({ live, done: live });
  }

  function turn(branch: { live: boolean; done: boolean }, live: boolean): void {
    branch.live = live;
    branch.done ||= live;
  }
}

function replaced(line: string, defines: ReadonlyMap<string, string>): string {
  return line.replace(/\b[A-Za-z_]\w*\b/g, (name) => defines.get(name) ?? name);
}

/**
 * `defined(X)`, `!`, comparisons of numbers, macros or one bit of a mask, joined by && or ||, without further brackets.
 */
function decide(condition: string, defines: ReadonlyMap<string, string>): boolean {
  const masked = condition.replace(/\((\w+) & (\w+)\)/g, (_, mask: string, bit: string) =>
    String(valueOf(mask, defines) & valueOf(bit, defines)),
  );
  const plain = masked.replace(/defined\s*\(?\s*(\w+)\s*\)?/g, (_, name: string) =>
    defines.has(name) ? '1' : '0',
  );
  return plain.split('||').some((all) => all.split('&&').every((one) => compare(one, defines)));
}

function compare(text: string, defines: ReadonlyMap<string, string>): boolean {
  const [, left = '', operator, right = ''] =
    /^([^=!<>]*)(?:(==|!=|<=|>=|<|>)(.*))?$/.exec(text.trim()) ?? [];
  if (text.trim().startsWith('!')) return !compare(text.trim().slice(1), defines);
  const [a, b] = [valueOf(left, defines), valueOf(right, defines)];
  if (operator === undefined) return a !== 0;
  if (operator === '==') return a === b;
  if (operator === '!=') return a !== b;
  if (operator === '<') return a < b;
  if (operator === '>') return a > b;
  return operator === '<=' ? a <= b : a >= b;
}

function valueOf(text: string, defines: ReadonlyMap<string, string>): number {
  const word = text.replace(/[()]/g, '').trim();
  const value = defines.get(word);
  return value === undefined ? Number(word) || 0 : valueOf(value, defines);
}

/** Each function's name and body; of overloads, all bodies together. */
function functionsOf(code: string): Map<string, string> {
  const bodies = new Map<string, string>();
  const heads = /\b[A-Za-z_]\w*\s+([A-Za-z_]\w*)\s*\(([^(){};]*)\)\s*\{/g;
  for (let head = heads.exec(code); head !== null; head = heads.exec(code)) {
    let depth = 1;
    let end = heads.lastIndex;
    for (; depth > 0 && end < code.length; end++) {
      if (code[end] === '{') depth += 1;
      if (code[end] === '}') depth -= 1;
    }
    const [, name = ''] = head;
    bodies.set(name, (bodies.get(name) ?? '') + code.slice(heads.lastIndex, end));
    heads.lastIndex = end;
  }
  return bodies;
}
