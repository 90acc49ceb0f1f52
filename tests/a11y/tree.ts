// What assistive technology gets of a page: Chromium's own accessibility tree, read through its
// debugger.

import type { Page } from '@playwright/test';

interface AccessibleNode {
  readonly role: string;
  readonly name: string;
  readonly description: string;
  /** Other properties that are set, such as `focusable` and `keyshortcuts`. */
  readonly properties: Readonly<Record<string, unknown>>;
}

/** Roles of text and of boxes without a meaning. */
const PLAIN = /^(none|generic|StaticText|InlineTextBox|ListMarker|RootWebArea)$/;

/** All nodes of the page with a role, in reading order. */
export async function accessibleNodes(page: Page): Promise<AccessibleNode[]> {
  const session = await page.context().newCDPSession(page);
  const { nodes } = await session.send('Accessibility.getFullAXTree');
  await session.detach();
  const byId = new Map(nodes.map((node) => [node.nodeId, node]));
  const inOrder: AccessibleNode[] = [];
  const visit = (id: string): void => {
    const node = byId.get(id);
    if (node === undefined) return;
    const role = String(node.role?.value);
    if (!node.ignored && !PLAIN.test(role)) {
      inOrder.push({
        role,
        name: String(node.name?.value ?? ''),
        description: String(node.description?.value ?? ''),
        properties: Object.fromEntries(
          (node.properties ?? []).map(({ name, value }) => [name, value.value as unknown]),
        ),
      });
    }
    node.childIds?.forEach(visit);
  };
  const root = nodes[0];
  if (root !== undefined) {
    visit(root.nodeId);
  }
  return inOrder;
}

/** The only node with this role. */
export async function accessibleNode(page: Page, role: string): Promise<AccessibleNode> {
  const all = await accessibleNodes(page);
  const [found, second] = all.filter((node) => node.role === role);
  if (found === undefined || second !== undefined) {
    throw new Error(
      `${second === undefined ? 'No' : 'More than one'} ${role} among ${all.map((node) => node.role).join(', ')}`,
    );
  }
  return found;
}
