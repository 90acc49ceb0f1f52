// How does a CommonJS script that Emscripten made become a module? The factory that it exports is
// the module's default export. No source map: the script is a compiler's output, and its map would
// be three times its size.

// What the script expects around it. Its `require` is called only where `process` exists; defining
// it here keeps bundlers from resolving the calls. Without `__filename` of our own, webpack would
// take it for Node's.
const prologue = `
const module = { exports: {} };
const exports = module.exports;
const __dirname = '';
const __filename = undefined;
const require = (name) => globalThis.process.getBuiltinModule(name);
`;

export const scriptAsModule = (
  code: string,
): { readonly code: string; readonly map: { readonly mappings: '' } } => ({
  code: `${prologue}${code}\nexport default module.exports;\n`,
  map: { mappings: '' },
});
