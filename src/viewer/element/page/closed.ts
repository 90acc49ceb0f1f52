// Whether an element is in something that a page opens when a visitor asks for it.

/** In a closed `<dialog>` or `<details>`, shadow trees included. Summaries count as inside. */
export function isInClosed(element: Element): boolean {
  const root = element.getRootNode() as Partial<ShadowRoot>;
  return (
    element.closest('dialog:not([open]), details:not([open])') !== null ||
    (root.host !== undefined && isInClosed(root.host))
  );
}
