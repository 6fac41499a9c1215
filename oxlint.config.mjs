import { fileURLToPath } from 'node:url';

import eslint from './eslint.config.js';
import { MORE_IN_ESLINT, shortName } from './scripts/lib/lint-rules.mjs';

/**
 * The rules of `eslint.config.js` for oxlint, which takes a tenth of the time: those that need one file, for TypeScript.
 * What oxlint does not have stays with ESLint: `scripts/lib/eslint-rest.config.mjs`.
 */

const SOURCES = ['**/*.{ts,mts,cts}'];
const TYPESCRIPT = '@typescript-eslint/';
/** The parser refuses what these find. */
const SYNTAX_ERRORS = ['no-dupe-args', 'no-octal'];

const isOff = (setting) => ['off', 0].includes([setting].flat()[0]);
const used = new Set(
  eslint.flatMap(({ rules = {} }) => Object.keys(rules).filter((name) => !isOff(rules[name]))),
);

function rulesOf(settings) {
  const names = Object.keys(settings).filter(
    (name) => used.has(name) && !name.startsWith('vue/') && !SYNTAX_ERRORS.includes(name),
  );
  const entries = names
    // oxlint has one rule for both
    .filter((name) => !names.includes(`${TYPESCRIPT}${name}`))
    .flatMap((name) => {
      const setting = withAllBelow(settings[name]);
      const own = [name.replace(TYPESCRIPT, 'typescript/'), setting];
      return MORE_IN_ESLINT.has(name) ? [own, [`ubii/${shortName(name)}`, setting]] : [own];
    });
  return Object.fromEntries(entries);
}

/** For ESLint, the name of a package stands for all below it as well. */
function withAllBelow(setting) {
  const [level, ...options] = [setting].flat();
  const translated = options.map((option) => {
    if (option.patterns === undefined) return option;
    const patterns = option.patterns.map(({ group, ...others }) => ({
      group: group.flatMap((name) => [name, `${name}/**`]),
      ...others,
    }));
    return { ...option, patterns };
  });
  return [level, ...translated];
}

export default {
  plugins: ['typescript'],
  jsPlugins: [fileURLToPath(new URL('./scripts/lib/lint-rules.mjs', import.meta.url))],
  categories: { correctness: 'off' },
  env: { builtin: true, browser: true },
  ignorePatterns: [
    '**/*.{js,mjs,cjs,vue}',
    ...eslint.flatMap(({ ignores = [], ...others }) =>
      Object.keys(others).length === 0 ? ignores : [],
    ),
  ],
  overrides: eslint
    .map(({ files = SOURCES, ignores = [], rules = {} }) => ({
      files: files.flat(),
      excludeFiles: ignores,
      rules: rulesOf(rules),
    }))
    .filter(({ rules }) => Object.keys(rules).length > 0),
};
