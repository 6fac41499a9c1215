import { spellCheckDocument } from 'cspell-lib';

/**
 * Looks words up in the dictionaries of CSpell, British English and software terms.
 *
 * @param {Iterable<string>} words
 * @param {readonly string[]} ownWords words of this project, in lower case
 * @returns {Promise<Map<string, string[]>>} by misspelled word, as it was given: what may have been meant
 */
export async function findMisspelled(words, ownWords) {
  const locale = 'en-GB';
  const lines = [...new Set(words)];
  const { issues } = await spellCheckDocument(
    { uri: 'file:///words.txt', text: lines.join('\n'), languageId: 'plaintext', locale },
    { noConfigSearch: true, generateSuggestions: true },
    { language: locale, words: [...ownWords], numSuggestions: 3 },
  );
  return new Map(issues.map(({ line, suggestions = [] }) => [line.text.trim(), suggestions]));
}
