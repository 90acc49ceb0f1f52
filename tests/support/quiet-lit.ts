// Node tests get Lit's development build, which greets every run with a warning; this tells it that
// it was heard.

const issued = globalThis as { litIssuedWarnings?: Set<string> };
(issued.litIssuedWarnings ??= new Set()).add('dev-mode');
