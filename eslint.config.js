// The lint rules: typescript-eslint's strict set with types, the layers of src/ (.ci/layers.mjs), and house rules.

import { defineConfig } from 'eslint/config';
import tseslint from 'typescript-eslint';
import { layersRule } from './.ci/layers.mjs';

const domGlobals = [
  'window',
  'document',
  'navigator',
  'customElements',
  'requestAnimationFrame',
  'cancelAnimationFrame',
  'devicePixelRatio',
  'HTMLElement',
  'Element',
  'Event',
  'PointerEvent',
  'KeyboardEvent',
  'WheelEvent',
];

export default defineConfig(
  {
    ignores: [
      'dist/',
      'site/',
      'dist-harness/',
      'dist-bench/',
      'truths/',
      'test-results/',
      'playwright-report/',
      'tests/fixtures/',
      'demo/assets/',
    ],
  },
  {
    files: ['**/*.ts'],
    extends: [tseslint.configs.strict],
    rules: {
      // Indexed reads inside counted loops: the bound is the check.
      '@typescript-eslint/no-non-null-assertion': 'off',
      '@typescript-eslint/no-extraneous-class': ['error', { allowEmpty: true }],
      '@typescript-eslint/no-unused-vars': ['error', { argsIgnorePattern: '^_', varsIgnorePattern: '^_' }],
      '@typescript-eslint/consistent-type-imports': 'error',
    },
  },
  {
    // Rules that need types take most of the time: of them, tests keep the one that finds a forgotten `await`.
    files: ['tests/**/*.ts'],
    languageOptions: { parserOptions: { projectService: true, tsconfigRootDir: import.meta.dirname } },
    rules: { '@typescript-eslint/no-floating-promises': 'error' },
  },
  {
    files: ['src/**/*.ts'],
    extends: [tseslint.configs.strictTypeCheckedOnly],
    languageOptions: { parserOptions: { projectService: true, tsconfigRootDir: import.meta.dirname } },
    rules: {
      // There are no enums.
      '@typescript-eslint/no-unsafe-enum-assignment': 'off',
      // three.js objects are told apart by their flags (`isMesh`), not by their class.
      '@typescript-eslint/no-unsafe-class-instance-assignment': 'off',
      '@typescript-eslint/no-unnecessary-type-parameters': 'off',
      '@typescript-eslint/restrict-template-expressions': ['error', { allowNumber: true, allowBoolean: true }],
      '@typescript-eslint/no-confusing-void-expression': ['error', { ignoreArrowShorthand: true }],
      '@typescript-eslint/prefer-readonly': 'error',
    },
  },
  {
    files: ['**/*.{js,mjs}'],
    languageOptions: { sourceType: 'module', parser: tseslint.parser },
  },
  {
    rules: {
      eqeqeq: 'error',
      'no-var': 'error',
      'prefer-const': 'error',
      'object-shorthand': 'error',
    },
  },
  {
    files: ['src/**/*.ts'],
    plugins: { house: { rules: { layers: layersRule } } },
    rules: {
      'house/layers': 'error',
      // Longer than this, a file has more than one subject. Shorter files are not better: what changes together stays
      // together.
      'max-lines': ['error', { max: 345, skipBlankLines: true, skipComments: true }],
      'no-console': ['error', { allow: ['warn'] }],
      'no-restricted-syntax': [
        'error',
        {
          selector: ':matches(PropertyDefinition, MethodDefinition)[accessibility="private"]',
          message: 'Private members are #private.',
        },
        { selector: 'TSParameterProperties, TSEnumDeclaration', message: 'Only syntax that can be erased.' },
      ],
    },
  },
  {
    files: ['src/{math,fields,light,reference,camera}/**/*.ts'],
    ignores: ['src/camera/orbit-input.ts', 'src/camera/*-input.ts'],
    rules: {
      'no-restricted-globals': ['error', ...domGlobals.map((name) => ({ name, message: 'This layer knows no DOM.' }))],
    },
  },
  {
    files: ['src/element/**/*.ts'],
    rules: {
      // Accessors come from the table of fields; an interface of the same name tells TypeScript of them.
      '@typescript-eslint/no-unsafe-declaration-merging': 'off',
    },
  },
  {
    files: ['src/**/*.d.ts'],
    rules: {
      // An ambient module cannot import from a relative path.
      '@typescript-eslint/consistent-type-imports': 'off',
    },
  },
  {
    files: ['tests/**/*.ts'],
    rules: {
      // Playwright fixtures without dependencies are written `async ({}, use) => …`.
      'no-empty-pattern': 'off',
      '@typescript-eslint/unbound-method': 'off',
    },
  },
);
