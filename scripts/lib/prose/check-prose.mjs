import { readFileSync } from 'node:fs';

import { inRoot, readJson } from '../repository.mjs';
import { passagesOf, writtenFiles } from './files.mjs';
import { findMisspelled } from './find-misspelled.mjs';
import { findTerms } from './find-terms.mjs';
import { lineCounter } from './lines.mjs';

/** The table of the glossary names the words that are not used. */
const withoutTerms = new Set(['docs/glossary.md']);

/** Words for the dictionary: no acronyms, and no names of code in the middle of a sentence. */
const words = /(?<![\p{L}\d_#/.-])\p{Lu}?\p{Ll}{2,}(?![\p{L}\d_#/]|\.\p{L})/gu;

/**
 * Checks everything in the repository that people read.
 *
 * @returns {Promise<string[]>} one line for each finding: file, line, word, and what to write instead
 */
export function checkWrittenFiles() {
  const dictionary = readFileSync(inRoot('docs/dictionary.txt'), 'utf8').trim().split('\n');
  return checkProse(writtenFiles(), { terms: readJson(inRoot('docs/terms.json')), dictionary });
}

/**
 * @param {readonly { path: string, source: string }[]} files
 * @param {{ terms: readonly import('./find-terms.mjs').Term[], dictionary: readonly string[] }} rules
 * @returns {Promise<string[]>}
 */
export async function checkProse(files, { terms, dictionary }) {
  const read = files.map((file) => ({ ...file, passages: passagesOf(file.path, file.source) }));
  const misspelled = await findMisspelled(
    read.flatMap(({ passages }) => passages.flatMap(wordsOf)).map(({ word }) => word),
    dictionary,
  );
  const lines = [];
  for (const { path, source, passages } of read) {
    const findings = passages.flatMap(wordsOf).filter(({ word }) => misspelled.has(word));
    const found = [
      ...findings.map(({ start, word }) => ({ start, advice: adviceFor(word, misspelled) })),
      ...(withoutTerms.has(path) ? [] : await termsOf(source, passages, terms)),
    ];
    if (found.length === 0) continue;
    const locate = lineCounter(source);
    found.sort((a, b) => a.start - b.start);
    lines.push(...found.map(({ start, advice }) => `${path}:${locate(start).line} ${advice}`));
  }
  return lines;
}

/** Findings of the word list, by the places each term is for. */
async function termsOf(source, passages, terms) {
  const findings = [];
  for (const place of new Set(passages.map((passage) => passage.place))) {
    findings.push(
      ...(await findTerms(
        source,
        passages.filter((passage) => passage.place === place),
        terms.filter((term) => term.in === undefined || term.in.includes(place)),
      )),
    );
  }
  return findings;
}

/** @param {import('./passages.mjs').Passage} passage */
function wordsOf({ start, text }) {
  return [...text.matchAll(words)].map(({ index, 0: word }) => ({ start: start + index, word }));
}

function adviceFor(word, misspelled) {
  const suggestions = misspelled.get(word).map((one) => `“${one}”`);
  const instead = suggestions.length === 0 ? '' : `write ${suggestions.join(' or ')}, or `;
  return `“${word}” is not in the dictionary: ${instead}add it to docs/dictionary.txt.`;
}
