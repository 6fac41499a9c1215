import { readFileSync } from 'node:fs';

import rules from '../../eslint.config.js';

/** Rules of Vue find something in a file of TypeScript only if it imports Vue or something for it. */
const IMPORTS_VUE = /['"](vue|@vue\/[\w-]+|@vueuse\/[\w-]+|vue-[\w-]+)['"]/;

/** ESLint for what oxlint cannot check: components, scripts, and TypeScript with Vue. The rest: `oxlint.config.mjs`. */
export default [
  ...rules,
  {
    ignores: [
      /** @param {string} file */
      (file) => /\.[cm]?ts$/.test(file) && !IMPORTS_VUE.test(readFileSync(file, 'utf8')),
    ],
  },
];
