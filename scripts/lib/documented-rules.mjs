import { readFileSync, readdirSync } from 'node:fs';

import { inRoot } from './repository.mjs';

const SPEC = /^docs\/spec\/.+\.md$/;
const TEXT = /\.(js|md|mjs|proto|ts|vue)$/;
const NOT_SOURCES = /^(\..*|node_modules|dist|generated|test-results)$/;
/** A rule that a guide adds, in a block `diff`. */
const ADDITION = /^\+- \*\*([A-Z]{2}-\d+)\*\*/gm;
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
 * @returns {string[]} one sentence for each id that is defined twice or not at all
 */
export function ruleProblems(files) {
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
  return problems;
}
