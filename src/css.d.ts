// What a style sheet imported as text is to TypeScript.

declare module '*.css?inline' {
  const text: string;
  export default text;
}
