// Types of what the build makes of the package's manifest and of imports of markup as text (.ci/site/plugin.ts).
interface ImportMeta {
  /** Vite's import of all files that a pattern names. */
  glob<T>(pattern: string, options: Readonly<Record<string, string | boolean>>): Record<string, T>;
}

declare module 'virtual:attributes' {
  /** The documented attributes by tag. */
  const attributes: Readonly<Record<string, readonly string[]>>;
  export default attributes;
}

declare module 'virtual:html-data' {
  interface Described {
    readonly name: string;
    readonly description?: string | { readonly value: string };
  }
  interface Attribute extends Described {
    readonly values?: readonly Described[];
    /** `v`: the attribute has no value. */
    readonly valueSet?: string;
  }
  interface Tag extends Described {
    readonly attributes: readonly Attribute[];
  }
  /** The elements as editors know them. */
  const tags: readonly Tag[];
  export default tags;
}

declare module '*.html?raw' {
  const text: string;
  export default text;
}
