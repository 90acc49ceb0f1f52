// How much of a GLSL program's text is at work: the code that `main` reaches once all preprocessor conditions are
// decided.

import { runInNewContext } from 'node:vm';

/** The bodies of the functions that `main` reaches, its own included. */
export function reachedCode(text: string): string {
  const bodies = functionsOf(preprocess(text));
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

/** The text without directives, with object-like macros expanded. */
function preprocess(text: string): string {
  const defines = new Map<string, string>();
  const lines: string[] = [];
  /** For each open #if: whether this branch is active, and whether an earlier one was. */
  const open: { live: boolean; done: boolean }[] = [];
  const alive = (): boolean => open.every(({ live }) => live);
  const expand = (code: string): string =>
    code.replace(/\b[A-Za-z_]\w*/g, (name) => expand(defines.get(name) ?? '') || name);
  /** Conditions of integers have the same meaning in JavaScript. Other names count as 0. */
  const decide = (condition: string): boolean => {
    const decided = condition.replace(/defined\s*\(?\s*(\w+)\s*\)?/g, (_, name: string) => (defines.has(name) ? '1' : '0')); // prettier-ignore
    return Boolean(runInNewContext(expand(decided).replace(/\b[A-Za-z_]\w*/g, '0')) as unknown);
  };
  const begin = (live: boolean): unknown => open.push({ live, done: live });
  const turn = (decideHere: () => boolean): void => {
    const branch = open.at(-1)!;
    branch.live = !branch.done && decideHere();
    branch.done ||= branch.live;
  };
  for (const line of text.replace(/\/\*[^]*?\*\/|\/\/[^\n]*/g, ' ').split('\n')) {
    const [, directive, rest = ''] = /^\s*#\s*(\w+)\s*(.*?)\s*$/.exec(line) ?? [];
    if (directive === 'ifdef') begin(defines.has(rest));
    else if (directive === 'ifndef') begin(!defines.has(rest));
    else if (directive === 'if') begin(alive() && decide(rest));
    else if (directive === 'elif') turn(() => decide(rest));
    else if (directive === 'else') turn(() => true);
    else if (directive === 'endif') open.pop();
    else if (!alive()) continue;
    else if (directive === 'define') {
      const [, name = '', value = ''] = /^(\w+)\s*(.*)$/.exec(rest) ?? [];
      defines.set(name, value);
    } else if (directive === 'undef') defines.delete(rest);
    else if (directive === undefined) lines.push(expand(line));
  }
  return lines.join('\n');
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
