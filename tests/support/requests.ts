import type { Page } from '@playwright/test';

/** The address of every file that the page requests from now on. */
export function requestsOf(page: Page): readonly string[] {
  const requested: string[] = [];
  page.on('request', (request) => requested.push(request.url()));
  return requested;
}
