// The source without an extra: without its folder, its rows in the table of extras, and the extras
// that depend on it.

import { readdirSync, readFileSync } from 'node:fs';
import { join, posix } from 'node:path';
import ts from 'typescript';
import { EXTRAS, layers } from '../../.ci/layers.mjs';
import { repository } from './repository.mjs';

export const TABLE = 'src/viewer/extras.ts';

/** `extra`, and those that may import it, in turn. */
export function withDependents(extra: string): ReadonlySet<string> {
  const gone = new Set([extra]);
  for (const each of gone) {
    for (const other of EXTRAS) {
      const { layers: plain = [], lazy = [] } = layers[`extras/${other}`] ?? {};
      if ([...plain, ...lazy].includes(`extras/${each}`)) {
        gone.add(other);
      }
    }
  }
  return gone;
}

/** The table without the rows of these extras, and without the imports that only they used. */
export function tableWithout(gone: ReadonlySet<string>): string {
  const code = readFileSync(join(repository, TABLE), 'utf8');
  const file = ts.createSourceFile(TABLE, code, ts.ScriptTarget.Latest, true);
  const isGone = (node: ts.Node) =>
    [...gone].some((name) => node.getText().includes(`'../extras/${name}/`));
  const cuts: ts.Node[] = [];
  /** Types of the tables of texts that go. */
  const types: string[] = [];
  for (const statement of file.statements) {
    if (ts.isImportDeclaration(statement) && isGone(statement)) {
      cuts.push(statement);
      types.push(`typeof ${statement.importClause?.name?.text ?? ''};`);
    } else if (ts.isModuleDeclaration(statement)) {
      const [tables] = (statement.body as ts.ModuleBlock).statements as unknown as [
        ts.InterfaceDeclaration,
      ];
      cuts.push(
        ...tables.members.filter((member) => types.some((type) => member.getText().includes(type))),
      );
    } else if (ts.isExpressionStatement(statement) && ts.isCallExpression(statement.expression)) {
      const { expression: called, arguments: rows } = statement.expression;
      const isList = /\.push$/.test(called.getText());
      const isLeft = isList && rows.some((row) => !isGone(row));
      cuts.push(...(isLeft ? [...rows] : [statement]).filter(isGone));
    }
  }
  let left = code;
  for (const node of cuts.reverse()) {
    const comma = left[node.end] === ',' ? 1 : 0;
    left = left.slice(0, node.getStart()) + left.slice(node.end + comma);
  }
  const uses = (name: string) => left.match(new RegExp(`\\b${name}\\b`, 'g'))?.length ?? 0;
  return left.replace(/import \{([^}]*)\} from ('[^']*');\n/g, (_line, names: string, from) => {
    const used = names.split(',').filter((name) => uses(name.trim()) > 1);
    return used.length === 0 ? '' : `import {${used.join()}} from ${String(from)};\n`;
  });
}

const parsed = new Map<string, ts.SourceFile | undefined>();

const inFolders = (gone: ReadonlySet<string>) => (path: string) =>
  [...gone].some((name) => path.includes(`src/extras/${name}/`));

/**
 * What in src/ without these extras imports a file that is not there. Such an import is the only way
 * in which a file can need another, but for what a file declares for all.
 */
export function brokenImports(gone: ReadonlySet<string>): readonly string[] {
  const isGone = inFolders(gone);
  const files = (readdirSync(join(repository, 'src'), { recursive: true }) as string[])
    .map((name) => posix.join('src', name))
    .filter((path) => path.endsWith('.ts') && !isGone(path));
  return files.flatMap((path) => {
    const code = path === TABLE ? tableWithout(gone) : readFileSync(join(repository, path), 'utf8');
    return ts
      .preProcessFile(code)
      .importedFiles.map(({ fileName }) => fileName)
      .filter((specifier) => specifier.startsWith('.'))
      .map((specifier) => posix.join(posix.dirname(path), specifier.replace(/\?.*$/, '')))
      .filter((target) => isGone(target))
      .map((target) => `${path} imports ${target}`);
  });
}

/**
 * What the compiler says of src/ without these extras; `only`: of this file, the types that it uses
 * included.
 */
export function typeErrors(gone: ReadonlySet<string>, only?: string): readonly string[] {
  const config = ts.readConfigFile(join(repository, 'tsconfig.json'), (path) =>
    readFileSync(path, 'utf8'),
  ).config as object;
  const { options, fileNames } = ts.parseJsonConfigFileContent(
    { ...config, include: ['src'] },
    ts.sys,
    repository,
  );
  const isGone = inFolders(gone);
  const host = ts.createCompilerHost(options);
  const { fileExists, getSourceFile } = host;
  host.fileExists = (path) => !isGone(path) && fileExists(path);
  host.getSourceFile = (path, version, ...rest) => {
    if (path.endsWith(TABLE)) return ts.createSourceFile(path, tableWithout(gone), version, true);
    if (!parsed.has(path)) {
      parsed.set(path, getSourceFile(path, version, ...rest));
    }
    return parsed.get(path);
  };
  const roots = fileNames.filter((path) => !isGone(path));
  const program = ts.createProgram(roots, options, host);
  const file = only === undefined ? undefined : program.getSourceFile(join(repository, only));
  return ts
    .getPreEmitDiagnostics(program, file)
    .map(({ file, messageText }) =>
      [file?.fileName.slice(repository.length), ts.flattenDiagnosticMessageText(messageText, '\n')]
        .filter((part) => part !== undefined)
        .join(': '),
    );
}
