import { parse } from '@textlint/markdown-to-ast';

/**
 * Finds the prose of a Markdown file: all but code, addresses and HTML.
 *
 * @param {string} source
 * @returns {import('./passages.mjs').Passage[]}
 */
export function markdownPassages(source) {
  const passages = [];
  const visit = (node) => {
    if (node.type === 'Str') {
      const [start, end] = node.range;
      passages.push({ start, text: source.slice(start, end), kind: 'text' });
    }
    for (const child of node.children ?? []) visit(child);
  };
  visit(parse(source));
  return passages;
}
