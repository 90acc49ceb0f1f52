// `phong-viewer/playwright` as the package has it: functions that run in pages are bundled by the
// build.
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type * as Entry from 'phong-viewer/playwright';
import { outputFolder } from '../../.ci/output-folder.mjs';

const address = pathToFileURL(join(outputFolder('dist'), 'playwright.js')).href;

export const { expect, settled, snapshot } = (await import(address)) as typeof Entry;
