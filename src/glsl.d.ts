// Declares imported shader files as their text.

declare module '*.glsl?raw' {
  const text: string;
  export default text;
}
