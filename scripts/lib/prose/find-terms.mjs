import { TextlintKernel } from '@textlint/kernel';
import terminology from 'textlint-rule-terminology';

import { lineCounter } from './lines.mjs';
import { blank } from './passages.mjs';

/**
 * A word that is not used here.
 *
 * @typedef {object} Term
 * @property {string} avoid regular expression of whole words; a space is any white space
 * @property {string} write what to write instead
 * @property {import('./files.mjs').Place[]} [in] where it is not used; everywhere when left out
 */

/**
 * Something to write differently.
 *
 * @typedef {object} Finding
 * @property {number} start offset in the file
 * @property {string} advice one sentence
 */

const kernel = new TextlintKernel();

/** Plugin of textlint that turns passages into a document. */
const plugin = {
  Processor: class {
    #passages;

    constructor({ passages }) {
      this.#passages = passages;
    }

    availableExtensions() {
      return ['.passages'];
    }

    processor() {
      return {
        preProcess: (source) => documentOf(source, this.#passages),
        postProcess: (messages, filePath) => ({ messages, filePath }),
      };
    }
  },
};

/**
 * Finds words of the list with textlint.
 *
 * @param {string} source
 * @param {readonly import('./passages.mjs').Passage[]} passages of the source, all of one place
 * @param {readonly Term[]} terms
 * @returns {Promise<Finding[]>}
 */
export async function findTerms(source, passages, terms) {
  const { messages } = await kernel.lintText(source, {
    ext: '.passages',
    plugins: [{ pluginId: 'passages', plugin, options: { passages } }],
    rules: [{ ruleId: 'terminology', rule: terminology, options: optionsOf(terms) }],
  });
  return messages.map(({ message, range: [start] }) => ({
    start,
    advice: message
      .replace(/\s+/g, ' ')
      .replace(/^Incorrect term: (“.*?”), use (“.*”) instead$/, '$1: write $2.'),
  }));
}

/** @param {readonly Term[]} terms */
function optionsOf(terms) {
  return {
    defaultTerms: false,
    terms: terms.map(({ avoid, write }) => [`(?:${avoid.replaceAll(' ', '\\s+')})`, write]),
  };
}

/** https://textlint.org/docs/txtnode */
function documentOf(source, passages) {
  const locate = lineCounter(source);
  const nodeOf = (type, start, text, children) => ({
    type,
    raw: text,
    range: [start, start + text.length],
    loc: { start: locate(start), end: locate(start + text.length) },
    ...(children === undefined ? { value: text } : { children }),
  });
  let text = blank(source);
  for (const passage of passages) {
    const { start } = passage;
    text = text.slice(0, start) + passage.text + text.slice(start + passage.text.length);
  }
  const children = passages.map((passage) =>
    nodeOf('Paragraph', passage.start, passage.text, [nodeOf('Str', passage.start, passage.text)]),
  );
  return { text, ast: nodeOf('Document', 0, text, children) };
}
