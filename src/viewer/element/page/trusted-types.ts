// Says what to allow where a page's policy refuses Lit's Trusted Types policy. Lit throws then
// while it is imported, so no element is defined, and nothing of this package runs but this file,
// which the entry imports before Lit.

// In Node there is no document.
const page = typeof document === 'undefined' ? null : document;

/** The browser reports the refusal in a task of its own, after Lit has thrown. */
function refused({ blockedURI, sample, disposition }: SecurityPolicyViolationEvent) {
  if (blockedURI !== 'trusted-types-policy' || sample !== 'lit-html' || disposition !== 'enforce') {
    return;
  }
  litWasImported();
  // Another copy of this package has defined them.
  if (customElements.get('phong-viewer') !== undefined) return;
  console.warn(
    "<phong-viewer>: the page's Content-Security-Policy refuses the Trusted Types policy of Lit, so the elements are not defined. " +
      "Allow it by trusted-types lit-html, or, if the page has another copy of Lit, by trusted-types lit-html 'allow-duplicates'.",
  );
}

page?.addEventListener('securitypolicyviolation', refused);

/** There is nothing to report any more. */
export function litWasImported(): void {
  page?.removeEventListener('securitypolicyviolation', refused);
}
