import js from '@eslint/js';
import prettier from 'eslint-config-prettier';
import vue from 'eslint-plugin-vue';
import globals from 'globals';
import ts from 'typescript-eslint';
import vueParser from 'vue-eslint-parser';

import ubii, { HAND_WRITTEN_PLURALS, SPREAD_LITERALS } from './scripts/lib/lint-rules.mjs';

/** Imports that the dependency arrows of docs/architecture.md forbid, with what to do instead. */
const noApps = {
  group: [
    '@ubii/master',
    '@ubii/master/*',
    '@ubii/frontend',
    '@ubii/node',
    '@ubii/bridge',
    '@ubii/benchmarks',
    '@ubii/e2e',
    '@ubii/robustness',
  ],
  message:
    'Nobody imports apps, benchmarks, e2e or robustness: move what is needed into a package.',
};
const noClient = {
  group: ['@ubii/client-web', '@ubii/client-web/*'],
  message:
    'The master does not know the client library: speak through the ports of src/core/ports.',
};
const noNode = {
  group: [
    'node:*',
    'fastify',
    '@fastify/*',
    'ws',
    'pino',
    'prom-client',
    'qrcode',
    '@ubii/patterns/re2',
    '@ubii/program',
    '@ubii/timing/system',
  ],
  message: 'The core is pure: take a port in the constructor and implement it in src/adapters.',
};
const noSandboxAdapters = {
  group: ['@ubii/pm-sandbox/*'],
  message: 'The core is pure: sandboxes and files come through ports, adapters make them.',
};
const noModules = {
  group: ['@ubii/modules'],
  message: 'Modules are given to whoever runs them: by apps, in the options.',
};
const noRuntimes = {
  group: ['@ubii/pm-sandbox', '@ubii/pm-sandbox/*'],
  message: 'The wire knows nothing of those who run modules.',
};
const noPlatform = {
  group: [
    ...['node:*', 'esbuild', '@ubii/timing/system'],
    ...['**/node/**', '**/browser/**', '**/module-folder/**'],
  ],
  message:
    'The core of the sandbox is pure: `node`, `browser` and `module-folder` are its adapters.',
};
const noVue = {
  group: ['vue', 'vue-router', 'reka-ui'],
  message: 'Packages do not know the frontend.',
};
const noEngine = {
  group: ['three', 'three/*', '**/view/**', '**/screen/**'],
  message: 'Phones and the network draw nothing in three dimensions: that is the big screen.',
};
const restrict = (...patterns) => ({
  '@typescript-eslint/no-restricted-imports': ['error', { patterns }],
});

export default ts.config(
  {
    ignores: [
      '**/dist/**',
      '**/node_modules/**',
      '**/.cache/**',
      '**/.cache-lan*/**',
      '**/.cache-robustness/**',
      '**/.cache-package/**',
      'packages/*/src/generated/**',
      'e2e/test-results/**',
      'e2e/playwright-report/**',
    ],
  },
  js.configs.recommended,
  ...ts.configs.recommended,
  ...vue.configs['flat/recommended'],
  prettier,
  {
    files: ['**/*.vue'],
    languageOptions: { parser: vueParser, parserOptions: { parser: ts.parser } },
  },
  {
    // The rules that need types are in .oxlintrc.json. Of those here, oxlint.config.mjs takes what oxlint can check.
    files: ['**/*.ts', '**/*.vue'],
    rules: {
      '@typescript-eslint/consistent-type-imports': 'error',
      '@typescript-eslint/no-unused-vars': [
        'error',
        { argsIgnorePattern: '^_', varsIgnorePattern: '^_', ignoreRestSiblings: true },
      ],
      eqeqeq: ['error', 'always', { null: 'ignore' }],
      'no-eval': 'error',
      'no-implied-eval': 'error',
      'no-new-func': 'error',
      'no-undef': 'off',
    },
  },
  {
    files: ['**/*.vue'],
    rules: {
      'vue/multi-word-component-names': ['error', { ignores: ['App'] }],
      'vue/component-api-style': ['error', ['script-setup']],
      'vue/block-order': ['error', { order: ['script', 'template', 'style'] }],
      'vue/define-macros-order': 'error',
      'vue/no-v-html': 'error',
      'vue/require-default-prop': 'off',
      // Takes a complete switch for one without an end. TypeScript does not: `noImplicitReturns`.
      'vue/return-in-computed-property': 'off',
    },
  },
  {
    files: ['**/*.{ts,vue}'],
    ignores: [
      '**/*.test.ts',
      'e2e/**',
      'benchmarks/**',
      'robustness/**',
      'scripts/**',
      '**/*.config.ts',
      'packages/*/examples/**',
      // The default of a client's `onError`.
      'packages/client-web/src/console-errors.ts',
    ],
    rules: { 'no-console': 'error' },
  },
  {
    files: ['**/*.{ts,vue}'],
    ignores: [
      '**/*.test.ts',
      'packages/*/test/**',
      'apps/*/test/**',
      'e2e/**',
      'benchmarks/**',
      'robustness/**',
    ],
    plugins: { ubii },
    rules: { 'ubii/no-native-patterns': 'error', 'ubii/no-hand-written-plurals': 'error' },
  },
  {
    files: ['**/*.vue'],
    rules: { 'vue/no-restricted-syntax': ['error', ...HAND_WRITTEN_PLURALS, ...SPREAD_LITERALS] },
  },
  {
    files: ['**/*.{ts,vue,js,mjs}'],
    plugins: { ubii },
    rules: { 'ubii/no-spread-literals': 'error' },
  },
  { files: ['**/*.test.ts'], rules: { 'vue/one-component-per-file': 'off' } },
  { files: ['packages/**'], rules: restrict(noApps, noVue) },
  {
    files: ['packages/proto/**'],
    rules: restrict(noApps, noVue, noClient, noRuntimes, noModules),
  },
  { files: ['packages/{client-program,client-web}/**'], rules: restrict(noApps, noVue, noModules) },
  {
    files: [
      'packages/{discovery,harness,patterns,pictures,program,recording,timing,words,worker-rpc}/**',
    ],
    rules: restrict(noApps, noVue, noClient, noRuntimes, noModules),
  },
  { files: ['packages/pm-sandbox/**'], rules: restrict(noApps, noVue, noClient, noModules) },
  {
    files: ['packages/pm-sandbox/src/**'],
    ignores: [
      'packages/pm-sandbox/src/{node,browser,module-folder}/**',
      'packages/pm-sandbox/src/testing/**',
      '**/*.test.ts',
    ],
    rules: restrict(noApps, noVue, noClient, noModules, noPlatform),
  },
  { files: ['packages/modules/**'], rules: restrict(noApps, noVue, noClient) },
  {
    files: ['packages/vision/**'],
    // The build writes asset sets as those who load them read them.
    ignores: ['packages/vision/scripts/**'],
    rules: restrict(noApps, noVue, noClient, noRuntimes, noModules),
  },
  {
    files: ['packages/vision/src/**'],
    ignores: ['**/*.test.ts'],
    rules: {
      ...restrict(noApps, noVue, noClient, noRuntimes, noModules, {
        group: ['node:*', 'esbuild'],
        message: 'The package is pure computation: the caller passes files as bytes.',
      }),
      'no-restricted-globals': [
        'error',
        ...['process', 'Buffer', 'fetch', 'document', 'window'].map((name) => ({
          name,
          message: 'The package runs in every kind of worker and has no network access.',
        })),
      ],
    },
  },
  { files: ['apps/{bridge,node}/**'], rules: restrict(noApps) },
  {
    files: ['demos/ubi-party/src/sim/**'],
    ignores: ['**/*.test.ts', '**/testing/**'],
    rules: {
      ...restrict(noApps, noVue, noClient, noRuntimes, noModules, noNode),
      'no-restricted-properties': [
        'error',
        ...['sin', 'cos', 'tan', 'asin', 'acos', 'atan', 'atan2', 'exp', 'log', 'pow', 'hypot']
          .concat('cbrt', 'random')
          .map((property) => ({
            object: 'Math',
            property,
            message: 'Its last bit differs between machines: a round must be the same on all.',
          })),
      ],
    },
  },
  {
    files: ['demos/ubi-party/src/{net,modules,sound}/**'],
    ignores: ['**/*.test.ts', '**/testing/**'],
    rules: restrict(noApps, noVue, noEngine),
  },
  {
    files: ['demos/ubi-party/src/phone/**'],
    rules: restrict(noApps, noEngine),
  },
  { files: ['apps/master/src/adapters/**', 'apps/master/src/*.ts'], rules: restrict(noClient) },
  {
    files: ['apps/master/src/core/**'],
    ignores: ['**/*.test.ts'],
    rules: {
      ...restrict(noNode, noClient, noModules, noSandboxAdapters, {
        group: ['**/adapters/**'],
        message: 'The core never looks into an adapter: add a port.',
      }),
      'no-restricted-globals': [
        'error',
        ...[
          'process',
          'Buffer',
          'setTimeout',
          'setInterval',
          'setImmediate',
          'queueMicrotask',
          'performance',
          'console',
          'fetch',
        ].map((name) => ({ name, message: 'The core is pure: use a port of src/core/ports.' })),
      ],
      'no-restricted-properties': [
        'error',
        { object: 'Date', property: 'now', message: 'Use the Clock port.' },
        { object: 'Math', property: 'random', message: 'Use the IdSource port.' },
      ],
    },
  },
  { files: ['apps/frontend/**', 'robustness/**'], rules: restrict(noApps) },
  {
    files: ['apps/frontend/**/*.{ts,vue}'],
    rules: {
      'no-restricted-properties': [
        'error',
        ...['toLocaleString', 'toLocaleTimeString', 'toLocaleDateString'].map((property) => ({
          property,
          message: 'Use ui/readouts: format-clock.ts, format-number.ts.',
        })),
        { object: 'Intl', property: 'DateTimeFormat', message: 'Use ui/readouts/format-clock.ts.' },
      ],
    },
  },
  {
    files: ['**/*.{js,mjs}'],
    languageOptions: { globals: { ...globals.node } },
  },
);
