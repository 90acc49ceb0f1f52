// Finds the panel's folders and rows by their labels, as a user does.

import type { Locator } from '@playwright/test';

const quoted = (text: string) => JSON.stringify(text);

/** The whole panel. */
export const panelOf = (viewer: Locator): Locator => viewer.locator('.lil-root');

/** The part that scrolls. */
export const listOf = (viewer: Locator): Locator => viewer.locator('.lil-root > .lil-children');

export const titleOf = (viewer: Locator, title: string): Locator =>
  viewer.locator(`.lil-title:text-is(${quoted(title)})`);

export const folderOf = (viewer: Locator, title: string): Locator =>
  viewer.locator(`.lil-gui:has(> .lil-title:text-is(${quoted(title)}))`);

/** Opens a folder if it is closed, and returns it. */
export async function opened(viewer: Locator, title: string): Promise<Locator> {
  const button = titleOf(viewer, title);
  if ((await button.getAttribute('aria-expanded')) === 'false') {
    await button.click();
  }
  return folderOf(viewer, title);
}

export const row = (folder: Locator, name: string): Locator =>
  folder.locator(`.lil-controller:has(.lil-name:text-is(${quoted(name)}))`);

type Role = 'textbox' | 'slider' | 'checkbox' | 'combobox' | 'button';
const named = (role: Role) => (folder: Locator, name: string) =>
  folder.getByRole(role, { name, exact: true });

export const field = named('textbox');
export const slider = named('slider');
export const flag = named('checkbox');
export const choice = named('combobox');
export const button = named('button');

/** The picker of a colour row; the row's text field has the row's own name. */
export const picker = (folder: Locator, name: string): Locator =>
  folder.getByLabel(`${name} picker`);

/** Titles of the folders in a folder, from the top. */
export const titlesIn = (folder: Locator): Promise<string[]> =>
  folder.locator('> .lil-children > .lil-gui > .lil-title').allTextContents();
