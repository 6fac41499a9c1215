/**
 * A part of a file that people read.
 *
 * @typedef {object} Passage
 * @property {number} start offset in the file
 * @property {string} text as long as its part of the file; markup is blank, and names in a sentence are #
 * @property {'comment' | 'text' | 'title'} kind titles are those of tests
 */

/** Texts with fewer words are mostly keys and identifiers. */
const MIN_WORDS = 3;

/** Texts in another language than English: styles, paths of pictures, sources of processing modules. */
const code = /[{}<>|]|=>|;\s*\n|\w\(|==|\w\/\w+\/\w/;

/** Whether people read a text, as opposed to a key, an identifier or code. @param {string} text */
export function isProse(text) {
  return !code.test(text) && (text.match(/(?<=^|\s)\p{L}[\p{L}'’-]*/gu)?.length ?? 0) >= MIN_WORDS;
}

/**
 * Finds comments in every language that writes them with slashes.
 *
 * @param {string} searched source without what only looks like a comment
 * @param {string} [source] what the comments are taken from, as long as `searched`
 * @returns {Passage[]}
 */
export function commentPassages(searched, source = searched) {
  return [
    ...searched.matchAll(/(?:(?<=^|\n)[ \t]*\/\/[^\n]*(?:\n|$))+|\/\/[^\n]*|\/\*[\s\S]*?\*\//g),
  ].map(({ index, 0: { length } }) => ({
    start: index,
    text: withoutMarkup(source.slice(index, index + length)),
    kind: 'comment',
  }));
}

/** Blanks the signs of a comment, and names of code in it. @param {string} comment */
function withoutMarkup(comment) {
  return withoutNames(
    comment
      .replace(/^[ \t]*(?:\/\/+|\/\*+|\*(?!\/))|\/\/+|\*+\/$/gm, blank)
      .replace(/@(?:param|property|template|typedef|returns?|type|throws)\s+(?:\{.*?\}+)?/g, fill)
      .replace(/(?<=@(?:param|property|template)#*\s*)\[?[\w$.]+\]?/g, fill),
  );
}

/** Fills addresses, and names that are written as code, so that no phrase goes across them. @param {string} text */
export function withoutNames(text) {
  return text
    .replace(/`[^`]*`/g, fill)
    .replace(/\{@\w+[^}]*\}/g, fill)
    .replace(/\b[a-z]+:\/\/\S+/g, fill)
    .replace(/@\w[\w/-]*/g, fill);
}

/** @param {string} text @returns {string} of the same length and lines */
export function blank(text) {
  return text.replace(/[^\n]/g, ' ');
}

/** @param {string} text @returns {string} of the same length and lines, but no space for the words beside it */
export function fill(text) {
  return text.replace(/[^\n]/g, '#');
}
