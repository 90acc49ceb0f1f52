// @ts-check
// Describes the elements from their source: attributes with types and defaults, events, methods,
// slots and parts. Docstrings and types come from the TypeScript compiler, domains and defaults
// from the tables of fields. Knows no file format.

import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import ts from 'typescript';

/**
 * @typedef {import('../../src/phong/fields/field.js').Field<unknown>} Field
 * @typedef {{ name: string, description: string }} Named
 * @typedef {Named & { type: string }} Typed
 * @typedef {Typed & { optional: boolean }} Parameter
 * @typedef {Typed & { parameters: Parameter[] }} Method  `type` is the type of the result
 * @typedef {Typed & { attribute: string, field: Field, fallback: string | undefined, choices:
 * string[] }} Value an attribute and its property. `name` and `type` are the property's. `fallback`
 * is the default as the attribute's text; `choices` are the words that its value may contain.
 * @typedef {object} Element
 * @property {string} tag
 * @property {string} className
 * @property {string} description
 * @property {Value[]} values
 * @property {Typed[]} properties  without an attribute
 * @property {Typed[]} ofForms  what a control of forms has besides; the description says it
 * @property {Typed[]} readonly
 * @property {Method[]} methods
 * @property {Typed[]} events
 * @property {Named[]} slots
 * @property {Named[]} parts
 * @property {Named[]} states  custom states, for `:state(…)`
 */

const repository = fileURLToPath(new URL('../..', import.meta.url));
const folder = join(repository, 'src/viewer/element');

/**
 * @param {typeof import('./tables.js')} tables
 * @returns {Element[]}
 */
export function describeElements({ fields, attributeOf, formatValue }) {
  const tags = Object.keys(fields);
  const files = [...tags, 'elements'].map((name) => join(folder, `${name}.ts`));
  const program = ts.createProgram(
    [...files, join(repository, 'src/glsl.d.ts')],
    compilerOptions(),
  );
  const reader = new SourceReader(program.getTypeChecker());
  const common = program.getSourceFile(join(folder, 'elements.ts'));
  return tags.map((tag) => {
    const file = program.getSourceFile(join(folder, `${tag}.ts`));
    const className = tag.replace(/(?:^|-)(\w)/g, (_, letter) => letter.toUpperCase());
    const declaration = file?.statements.find(
      (s) => ts.isClassDeclaration(s) && implementsElement(s, className),
    );
    if (!declaration || !ts.isClassDeclaration(declaration) || !file || !common) {
      throw new Error(
        `src/viewer/element/${tag}.ts: no class that implements ${className}, named ${className.replace('Phong', '')}Element`,
      );
    }
    const parts = reader.classParts(declaration);
    return {
      tag,
      className,
      ...parts,
      properties: parts.properties.filter(({ name }) => !(name in (fields[tag] ?? {}))),
      values: Object.entries(fields[tag] ?? {}).map(([name, field]) => ({
        attribute: attributeOf(name),
        field,
        fallback:
          field.fallback === null
            ? undefined
            : (formatValue(field.fallback, field) ?? absent(field)),
        ...reader.property(declaration, name),
      })),
      events: reader.events([file, common], `${className}EventMap`),
    };
  });
}

/**
 * `class ViewerElement extends … implements PhongViewer`, under whatever name that is imported.
 * @param {ts.ClassDeclaration} declaration
 * @param {string} className
 */
function implementsElement({ heritageClauses, name }, className) {
  const isImplements = (/** @type {ts.HeritageClause} */ clause) =>
    clause.token === ts.SyntaxKind.ImplementsKeyword;
  return (
    name?.text === className.replace('Phong', '') + 'Element' &&
    heritageClauses?.some(isImplements) === true
  );
}

/**
 * The default of an attribute that must be absent for it: false, or an empty list. @param {{ kind:
 * string }} field
 */
const absent = ({ kind }) => (kind === 'presence' || kind === 'flag-or-words' ? 'false' : '');

function compilerOptions() {
  const { config } = ts.readConfigFile(join(repository, 'tsconfig.json'), ts.sys.readFile);
  return ts.convertCompilerOptionsFromJson({ ...config.compilerOptions, types: [] }, repository)
    .options;
}

class SourceReader {
  /** @readonly */
  #checker;

  /** @param {ts.TypeChecker} checker */
  constructor(checker) {
    this.#checker = checker;
  }

  /** @param {ts.ClassDeclaration} declaration @param {string} name */
  property(declaration, name) {
    const owner = this.#checker.getTypeAtLocation(declaration);
    const symbol = owner.getProperty(name);
    if (!symbol) throw new Error(`${declaration.name?.text}: no property ${name}`);
    const type = this.#checker.getTypeOfSymbol(symbol);
    return {
      name,
      description: this.#words(symbol),
      type: this.#text(type),
      choices: this.#choices(type),
    };
  }

  /** @param {ts.ClassDeclaration} declaration */
  classParts(declaration) {
    const described = declaration.members.filter((member) => isOffered(member));
    const getters = described.filter(ts.isGetAccessorDeclaration);
    const settable = new Set(described.filter(ts.isSetAccessorDeclaration).map(nameOf));
    return {
      description: declaration.name ? this.#words(this.#symbol(declaration.name)) : '',
      properties: getters
        .filter((member) => settable.has(nameOf(member)))
        .map((member) => this.#typed(declaration, nameOf(member))),
      ofForms: this.#ofForms(declaration).map((name) => this.#typed(declaration, name)),
      readonly: getters
        .filter((member) => !settable.has(nameOf(member)))
        .map((member) => this.#typed(declaration, nameOf(member))),
      methods: described.filter(ts.isMethodDeclaration).map((member) => this.#method(member)),
      slots: tagged(declaration, 'slot'),
      parts: tagged(declaration, 'csspart'),
      states: tagged(declaration, 'cssState'),
    };
  }

  /**
   * What a control of forms has besides what the platform gives each one: its chunk brings it.
   * @param {ts.ClassDeclaration} declaration
   */
  #ofForms(declaration) {
    return this.#checker
      .getTypeAtLocation(declaration)
      .getProperties()
      .filter(({ valueDeclaration: signature }) => {
        const isOfForms =
          signature &&
          ts.isInterfaceDeclaration(signature.parent) &&
          signature.parent.name.text === 'FormControl';
        return isOfForms && ts.getJSDocCommentsAndTags(signature).length > 0;
      })
      .map(({ name }) => name);
  }

  /** @param {ts.ClassDeclaration} declaration @param {string} member @returns {Typed} */
  #typed(declaration, member) {
    const { name, description, type } = this.property(declaration, member);
    return { name, description, type };
  }

  /** @param {ts.SourceFile[]} files @param {string} map @returns {Typed[]} */
  events(files, map) {
    const found = files
      .flatMap(({ statements }) => [...statements])
      .find((s) => ts.isInterfaceDeclaration(s) && s.name.text === map);
    if (!found || !ts.isInterfaceDeclaration(found)) return [];
    return found.members.map((member) => {
      const type = this.#checker.getTypeAtLocation(member);
      const [detail] = this.#checker.getTypeArguments(/** @type {ts.TypeReference} */ (type));
      const text = detail ? `CustomEvent<${this.#detail(detail)}>` : this.#text(type);
      return {
        name: nameOf(member),
        description: this.#words(this.#symbol(member.name)),
        type: text,
      };
    });
  }

  /** @param {ts.MethodDeclaration} member @returns {Method} */
  #method(member) {
    const signature = this.#checker.getSignatureFromDeclaration(member);
    if (!signature) throw new Error(`${nameOf(member)}: no signature`);
    return {
      name: nameOf(member),
      description: this.#words(this.#symbol(member.name)),
      type: this.#text(signature.getReturnType()),
      parameters: member.parameters.map((parameter) => ({
        name: parameter.name.getText(),
        description: this.#words(this.#symbol(parameter.name)),
        type: this.#text(this.#checker.getTypeAtLocation(parameter)),
        optional: this.#checker.isOptionalParameter(parameter),
      })),
    };
  }

  /** @param {ts.Node | undefined} name @returns {ts.Symbol} */
  #symbol(name) {
    const symbol = name && this.#checker.getSymbolAtLocation(name);
    if (!symbol) throw new Error(`no symbol for ${name?.getText()}`);
    return symbol;
  }

  /**
   * The docstring, one line per paragraph, links as plain names. A getter without one gets that of
   * its type.
   * @param {ts.Symbol} symbol @returns {string}
   */
  #words(symbol) {
    const own = ts.displayPartsToString(symbol.getDocumentationComment(this.#checker));
    if (own === '' && symbol.flags & ts.SymbolFlags.Accessor) {
      const type = this.#checker.getTypeOfSymbol(symbol).symbol;
      return type ? this.#words(type) : '';
    }
    return own.replace(/\{@link (\w+)\}/g, '`$1`').replace(/(?<!\n)\n(?!\n)/g, ' ');
  }

  /** @param {ts.Type} type @returns {string} */
  #text(type) {
    if (type.flags & ts.TypeFlags.Boolean) return 'boolean';
    if (type.isUnion()) {
      const texts = [...new Set(type.types.map((member) => this.#text(member)))];
      const nothing = texts.filter((text) => text === 'null');
      return [...texts.filter((text) => text !== 'null'), ...nothing]
        .join(' | ')
        .replace('false | true', 'boolean');
    }
    const list = this.#listed(type);
    if (list) return `readonly (${this.#text(list)})[]`;
    // A mapped type has a key per text of the viewer: too many to write out.
    const { objectFlags } = /** @type {ts.ObjectType} */ (type);
    if (type.aliasSymbol && objectFlags & ts.ObjectFlags.Mapped) return type.aliasSymbol.name;
    const { NoTruncation, InTypeAlias, UseSingleQuotesForStringLiteralType } = ts.TypeFormatFlags;
    const flags = NoTruncation | InTypeAlias | UseSingleQuotesForStringLiteralType;
    return this.#checker.typeToString(type, undefined, flags);
  }

  /** The type of an event's detail with its properties written out. @param {ts.Type} type */
  #detail(type) {
    const properties = this.#checker.getPropertiesOfType(type);
    if (properties.length === 0) return this.#text(type);
    const texts = properties.map(
      (p) => `${p.name}: ${this.#text(this.#checker.getTypeOfSymbol(p))}`,
    );
    return `{ ${texts.join('; ')} }`;
  }

  /** The union that a list contains; undefined for other types. @param {ts.Type} type */
  #listed(type) {
    if (!this.#checker.isArrayType(type)) return undefined;
    const [item] = this.#checker.getTypeArguments(/** @type {ts.TypeReference} */ (type));
    return item?.isUnion() ? item : undefined;
  }

  /** @param {ts.Type} type @returns {string[]} */
  #choices(type) {
    const union = this.#listed(type) ?? type;
    return (union.isUnion() ? union.types : [union]).flatMap((t) =>
      t.isStringLiteral() ? [t.value] : [],
    );
  }
}

/**
 * Whether a member is for users: public, and not a callback of the platform or of Lit.
 * @param {ts.ClassElement} member
 */
function isOffered(member) {
  if (!member.name || !ts.isIdentifier(member.name) || /Callback$/.test(member.name.text)) {
    return false;
  }
  const flags = ts.getCombinedModifierFlags(member);
  const { Static, Override, Protected, Private } = ts.ModifierFlags;
  return (flags & (Static | Override | Protected | Private)) === 0;
}

/** @param {ts.ClassElement | ts.TypeElement} member @returns {string} */
function nameOf(member) {
  const { name } = member;
  return name && (ts.isIdentifier(name) || ts.isStringLiteral(name)) ? name.text : '';
}

/**
 * `@slot error - words` of a class. @param {ts.ClassDeclaration} declaration @param {string} tag
 * @returns {Named[]}
 */
function tagged(declaration, tag) {
  return ts
    .getJSDocTags(declaration)
    .filter((found) => found.tagName.text === tag)
    .map((found) => {
      const [name = '', ...words] = (ts.getTextOfJSDocComment(found.comment) ?? '').split(
        /(?:^| )- /,
      );
      return { name: name.trim(), description: words.join(' - ') };
    });
}
