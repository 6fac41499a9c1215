import { readFileSync, readdirSync } from 'node:fs';

import { inRoot } from './repository.mjs';

const SPEC = /^docs\/spec\/.+\.md$/;
const TEXT = /\.(js|md|mjs|proto|ts|vue)$/;
const NOT_SOURCES = /^(\..*|node_modules|dist|generated|test-results)$/;
/** A rule that a guide adds, in a block `diff`. */
const ADDITION = /^\+- \*\*([A-Z]{2}-\d+)\*\*/gm;
/** Groups of which a test has to quote each rule. */
const TESTED_GROUPS = ['EC'];
/** Rules of those groups that nothing in the program follows yet. */
/** @type {ReadonlySet<string>} */
const WITHOUT_TEST = new Set();
const TEST = /\.test\.(mjs|ts)$/;
const DEFINITION = /^- \*\*([A-Z]{2}-\d+)\*\*/gm;

/**
 * Compares the rules of `docs/spec` with the ids that code, tests and documentation quote.
 *
 * @returns {string[]} one sentence for each problem
 */
export function findRuleProblems() {
  return ruleProblems(
    textFiles('').map((path) => ({ path, text: readFileSync(inRoot(path), 'utf8') })),
  );
}

/** @param {string} folder relative to the root @returns {string[]} paths with `/` */
function textFiles(folder) {
  return readdirSync(inRoot(folder), { withFileTypes: true })
    .filter(({ name }) => !NOT_SOURCES.test(name))
    .flatMap((entry) => {
      const path = folder === '' ? entry.name : `${folder}/${entry.name}`;
      if (entry.isDirectory()) return textFiles(path);
      return entry.isFile() && TEXT.test(path) ? [path] : [];
    });
}

/**
 * @param {readonly { path: string, text: string }[]} files
 * @param {ReadonlySet<string>} withoutTest rules of tested groups that are excused from a test
 * @returns {string[]} one sentence for each id that is defined twice, not at all, or without a test that it needs
 */
export function ruleProblems(files, withoutTest = WITHOUT_TEST) {
  /** @type {Map<string, string>} */
  const pages = new Map();
  const problems = [];
  for (const { path, text } of files.filter(({ path }) => SPEC.test(path))) {
    for (const [, id = ''] of text.matchAll(DEFINITION)) {
      const other = pages.get(id);
      if (other !== undefined) problems.push(`${path} defines ${id} again; ${other} has it.`);
      pages.set(id, path);
    }
  }
  const groups = [...new Set([...pages.keys()].map((id) => id.slice(0, 2)))];
  if (groups.length === 0) return ['No rules were found in docs/spec.'];
  const quoted = new RegExp(`\\b(?:${groups.join('|')})-\\d+\\b`, 'g');
  for (const { path, text } of files) {
    const added = new Set([...text.matchAll(ADDITION)].map(([, id]) => id));
    const isKnown = (/** @type {string} */ id) => pages.has(id) || added.has(id);
    const unknown = new Set(text.match(quoted)?.filter((id) => !isKnown(id)));
    for (const id of unknown) problems.push(`${path} quotes ${id}, which docs/spec does not have.`);
  }
  return [...problems, ...untestedRules(pages, files, withoutTest)];
}

/**
 * @param {ReadonlyMap<string, string>} pages page of each rule
 * @param {readonly { path: string, text: string }[]} files
 * @param {ReadonlySet<string>} withoutTest rules that are excused
 * @returns {string[]} one sentence for each rule that has to be tested and is not
 */
function untestedRules(pages, files, withoutTest) {
  const tested = new Set(
    files
      .filter(({ path }) => TEST.test(path))
      .flatMap(({ text }) => [...text.matchAll(/\[([A-Z]{2}-\d+)\]/g)].map(([, id]) => id)),
  );
  return [...pages].flatMap(([id, page]) => {
    if (!TESTED_GROUPS.includes(id.slice(0, 2))) return [];
    if (!tested.has(id)) return withoutTest.has(id) ? [] : [`No test quotes ${id} of ${page}.`];
    if (!withoutTest.has(id)) return [];
    return [`A test quotes ${id} of ${page}: remove it from WITHOUT_TEST in documented-rules.mjs.`];
  });
}
