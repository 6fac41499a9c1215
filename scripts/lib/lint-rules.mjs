import { builtinRules } from 'eslint/use-at-your-own-risk';
import ts from 'typescript-eslint';

/**
 * Rules beside those that ESLint and oxlint have in common, in the form that both read.
 *
 * @typedef {{ readonly selector: string, readonly message: string }} Restriction
 * @typedef {{ readonly sourceCode: { readonly text: string }, report(problem: { node: unknown, message: string }): void }} Context
 * @typedef {{ readonly create: (context: Context) => object }} Rule
 */

/** @type {readonly Restriction[]} [TD-60] */
const NATIVE_PATTERNS = ['NewExpression', 'CallExpression'].map((call) => ({
  selector: `${call}[callee.name="RegExp"][arguments.0.type!="Literal"]`,
  message:
    'A pattern that somebody else wrote can stop the thread: compile it with @ubii/patterns. A pattern of ours may stay, with the reason why it is linear.',
}));

/** @type {readonly Restriction[]} a word or a sentence for one thing, and another for several */
export const HAND_WRITTEN_PLURALS = [
  '[consequent.type="Literal"][consequent.value=/./][alternate.value=/./]',
  '[consequent.type="Literal"][consequent.value=/./][alternate.type="TemplateLiteral"]',
  '[consequent.type="TemplateLiteral"][alternate.value=/./]',
  '[consequent.type="TemplateLiteral"][alternate.type="TemplateLiteral"]',
  '[consequent.value=""][alternate.value=/^e?s$/]',
].map((forms) => ({
  selector: `ConditionalExpression[test.operator="==="][test.right.value=1]${forms}`,
  message: 'Use `plural` or `counted` of @ubii/words.',
}));

/** @type {readonly Restriction[]} */
export const SPREAD_LITERALS = [
  {
    selector: 'ObjectExpression > SpreadElement > ObjectExpression',
    message:
      'Write the members out: the compiler finds no excess member of a literal that is spread.',
  },
];

/** @param {readonly Restriction[]} restrictions @returns {Rule} */
function restrictSyntax(restrictions) {
  return {
    create: (context) =>
      Object.fromEntries(
        restrictions.map(({ selector, message }) => [
          selector,
          /** @param {unknown} node */
          (node) => context.report({ node, message }),
        ]),
      ),
  };
}

/**
 * Rules of ESLint that find more than those of oxlint with the same names, with what a file must contain for them to find
 * anything: without it they would look up the variables of every file, which takes as long as all other rules together.
 *
 * @type {ReadonlyMap<string, RegExp>}
 */
export const MORE_IN_ESLINT = new Map([
  ['no-unsafe-optional-chaining', /\?\./],
  ['preserve-caught-error', /\bcatch\b/],
  ['prefer-const', /\blet\b/],
  ['@typescript-eslint/no-array-constructor', /\bArray\b/],
  ['@typescript-eslint/no-unused-vars', /\btypeof\b/],
  ['@typescript-eslint/prefer-as-const', /\bas\b|<['"\d]/],
]);

/** Name of a rule without that of its plugin. @param {string} name */
export const shortName = (name) => name.slice(name.lastIndexOf('/') + 1);

/** @param {string} name @param {RegExp} pattern @returns {Rule} */
function ruleOfEslint(name, pattern) {
  const short = shortName(name);
  const found = name === short ? builtinRules.get(name) : ts.plugin.rules?.[short];
  const rule = /** @type {Rule} */ (/** @type {unknown} */ (found));
  return {
    ...rule,
    create: (context) => (pattern.test(context.sourceCode.text) ? rule.create(context) : {}),
  };
}

export default {
  meta: { name: 'ubii' },
  rules: {
    'no-native-patterns': restrictSyntax(NATIVE_PATTERNS),
    'no-hand-written-plurals': restrictSyntax(HAND_WRITTEN_PLURALS),
    'no-spread-literals': restrictSyntax(SPREAD_LITERALS),
    ...Object.fromEntries(
      [...MORE_IN_ESLINT].map(([name, pattern]) => [shortName(name), ruleOfEslint(name, pattern)]),
    ),
  },
};
