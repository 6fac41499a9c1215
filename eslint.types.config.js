import vue from 'eslint-plugin-vue';
import ts from 'typescript-eslint';
import vueParser from 'vue-eslint-parser';
import plain from './eslint.config.js';

const [{ ignores }] = plain;

/** The rules of .oxlintrc.json for components, which oxlint reads without their types, and one of Vue. */
export default [
  { ignores },
  {
    files: ['**/*.vue'],
    plugins: { '@typescript-eslint': ts.plugin, vue },
    linterOptions: { reportUnusedDisableDirectives: 'off' },
    languageOptions: {
      parser: vueParser,
      parserOptions: {
        parser: ts.parser,
        extraFileExtensions: ['.vue'],
        projectService: true,
        tsconfigRootDir: import.meta.dirname,
      },
    },
    rules: {
      '@typescript-eslint/no-floating-promises': 'error',
      '@typescript-eslint/no-misused-promises': 'error',
      '@typescript-eslint/await-thenable': 'error',
      '@typescript-eslint/switch-exhaustiveness-check': [
        'error',
        { considerDefaultExhaustiveForUnions: true },
      ],
      'vue/return-in-computed-property': 'error',
    },
  },
];
