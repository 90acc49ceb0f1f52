// What a shader file is to TypeScript: its text.

declare module '*.glsl?raw' {
  const text: string;
  export default text;
}
