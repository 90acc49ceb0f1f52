// Which elements belong to which viewer: lights and meshes to the nearest one around, at any depth,
// across shadow roots and in the slots of components, but not in the viewer's own (slot="error"). A
// viewer that is upgraded later finds them then.

/** Called synchronously. `moved`: the child is still there, but may have another place. */
type Listener = Readonly<Record<'added' | 'removed' | 'moved', (child: HTMLElement) => void>>;

const registries = new WeakMap<Element, ChildRegistry>();

export function registryOf(viewer: Element): ChildRegistry {
  const known = registries.get(viewer);
  if (known !== undefined) return known;
  const registry = new ChildRegistry(viewer);
  registries.set(viewer, registry);
  return registry;
}

/**
 * The registry of the nearest viewer around `element`; null outside any viewer and in the content
 * of its slots.
 */
export function registryAround(element: Element): ChildRegistry | null {
  // By steps, not by selectors: most children are a viewer's own.
  let inner: Element | null = null;
  for (let outer: Element | null = element; outer !== null;) {
    if (outer.localName === 'phong-viewer') {
      return (inner?.getAttribute('slot') ?? '') === '' ? registryOf(outer) : null;
    }
    const { parentElement }: Element = outer;
    // A component shows an element where its slot is. A viewer's own slots do not count.
    const parent: Element | null =
      parentElement?.localName === 'phong-viewer'
        ? parentElement
        : (outer.assignedSlot ?? parentElement);
    inner = parent === null ? null : outer;
    outer = parent ?? shadowTreeOf(outer)?.host ?? null;
  }
  return null;
}

/**
 * The shadow tree that contains `element`, or null. Not by `instanceof`: another window has a class
 * of its own.
 */
function shadowTreeOf(element: Element): ShadowRoot | null {
  const root = element.getRootNode();
  return root.nodeType === Node.DOCUMENT_FRAGMENT_NODE && 'host' in root
    ? (root as ShadowRoot)
    : null;
}

/** What a component shows in its slot; nothing for another element. */
const slotted = (element: Element): readonly Element[] =>
  element.localName === 'slot' ? (element as HTMLSlotElement).assignedElements() : [];

export class ChildRegistry {
  readonly #viewer: Element;
  readonly #children = new Set<HTMLElement>();
  #inOrder: readonly HTMLElement[] | null = null;
  #listener: Listener | null = null;

  constructor(viewer: Element) {
    this.#viewer = viewer;
  }

  /** The viewer listens from its upgrade on. Children that came before are added now. */
  listen(listener: Listener): void {
    this.#listener = listener;
    for (const child of this.inOrder) {
      listener.added(child);
    }
  }

  add(child: HTMLElement): void {
    this.#inOrder = null;
    if (this.#children.has(child)) {
      this.#listener?.moved(child);
    } else {
      this.#children.add(child);
      this.#listener?.added(child);
    }
  }

  delete(child: HTMLElement): void {
    if (!this.#children.delete(child)) return;
    this.#inOrder = null;
    this.#listener?.removed(child);
  }

  get all(): ReadonlySet<HTMLElement> {
    return this.#children;
  }

  /**
   * In document order. Sorted on demand, in one pass over the viewer's tree; a new array after a
   * change.
   */
  get inOrder(): readonly HTMLElement[] {
    return (this.#inOrder ??= sorted(this.#children, this.#viewer));
  }
}

function sorted(children: ReadonlySet<HTMLElement>, viewer: Element): HTMLElement[] {
  const list: HTMLElement[] = [];
  const trees = shadowTrees(children, viewer);
  const visit = (tree: Node) => {
    const walker = document.createTreeWalker(tree, NodeFilter.SHOW_ELEMENT);
    while (walker.nextNode() !== null) {
      take(walker.currentNode as HTMLElement);
    }
  };
  const take = (element: Element) => {
    if (children.has(element as HTMLElement)) {
      list.push(element as HTMLElement);
    }
    const inner = trees.get(element);
    if (inner !== undefined) {
      visit(inner);
    }
    for (const shown of slotted(element)) {
      take(shown);
      visit(shown);
    }
  };
  const ownTree = trees.get(viewer);
  if (ownTree !== undefined) {
    visit(ownTree);
  }
  visit(viewer);
  return list;
}

/** The shadow trees between the viewer and its children, by their hosts. Closed ones too. */
function shadowTrees(
  children: ReadonlySet<HTMLElement>,
  viewer: Element,
): Map<Element, ShadowRoot> {
  const trees = new Map<Element, ShadowRoot>();
  const outermost = viewer.getRootNode();
  for (const child of children) {
    let tree = shadowTreeOf(child);
    while (tree !== null && tree !== outermost && !trees.has(tree.host)) {
      trees.set(tree.host, tree);
      tree = shadowTreeOf(tree.host);
    }
  }
  return trees;
}
