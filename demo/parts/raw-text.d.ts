// Types imports of a source file as text, for pages that show the script they run.
declare module '*.ts?raw' {
  const text: string;
  export default text;
}
