// Can every kind of project resolve the package's entries and their types? Are the types right? Asks arethetypeswrong
// and publint about the packed tarball. Both come from the registry, so it is slow: @release.

import { test } from '@playwright/test';
import { useFreshProject } from './fresh-project.js';

test.describe('the packed tarball @release', () => {
  const project = useFreshProject(['@arethetypeswrong/cli@^0.18', 'publint@^0.3']);

  test('has no wrong types, except that require() gets ES modules', () => {
    project().run('npx attw phong-viewer-*.tgz --ignore-rules cjs-resolves-to-esm');
  });

  test('has a manifest that publint finds nothing to say about', () => {
    project().run('npx publint run phong-viewer-*.tgz --strict');
  });
});
