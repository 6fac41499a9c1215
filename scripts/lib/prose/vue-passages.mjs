import { createRequire } from 'node:module';

import { inRoot } from '../repository.mjs';
import { commentPassages, fill, isProse, withoutNames } from './passages.mjs';
import { typescriptPassages } from './typescript-passages.mjs';

const { parse } = createRequire(inRoot('apps/frontend/package.json'))('vue/compiler-sfc');

/** Attributes that people read or hear. */
const readAttribute = /^(aria-label|alt|title|label|placeholder|hint|text|summary|heading|unit)$/;

/** https://github.com/vuejs/core/blob/main/packages/compiler-core/src/ast.ts: `NodeTypes` */
const type = { element: 1, text: 2, interpolation: 5, attribute: 6, directive: 7 };

/**
 * Finds what people read in a component: texts of the template, comments, and texts of the script.
 *
 * @param {string} source
 * @returns {import('./passages.mjs').Passage[]}
 */
export function vuePassages(source) {
  const { descriptor } = parse(source, { sourceMap: false, ignoreEmpty: true });
  const { script, scriptSetup, styles, template } = descriptor;
  return [
    ...[script, scriptSetup]
      .filter((block) => block)
      .flatMap((block) => shifted(typescriptPassages(block.content), block.loc.start.offset)),
    ...styles.flatMap((block) => shifted(commentPassages(block.content), block.loc.start.offset)),
    ...(template?.ast === undefined ? [] : passagesOf(template.ast, source)),
  ];
}

/** @returns {import('./passages.mjs').Passage[]} of an element and all in it */
function passagesOf(element, source) {
  return [
    ...(element.props ?? []).flatMap((property) => propertyPassages(property)),
    ...sentencesOf(element.children ?? [], source),
    ...(element.children ?? []).flatMap((child) => {
      if (child.type === type.element) return passagesOf(child, source);
      if (child.type === type.interpolation) return expressionPassages(child.content);
      return [];
    }),
  ];
}

function propertyPassages(property) {
  if (property.type === type.directive) return expressionPassages(property.exp);
  if (property.value === undefined) return [];
  const { content, loc } = property.value;
  if (!readAttribute.test(property.name) && !isProse(content)) return [];
  if (['class', 'd', 'viewBox', 'style', 'transform'].includes(property.name)) return [];
  const start = loc.start.offset + loc.source.indexOf(content[0] ?? '');
  return [{ start, text: withoutNames(content), kind: 'text' }];
}

/** Texts beside interpolations belong to one sentence. */
function sentencesOf(children, source) {
  const sentences = [];
  let sentence;
  for (const child of children) {
    const { start, end } = child.loc;
    const isText = child.type === type.text;
    if (!isText && child.type !== type.interpolation) {
      sentence = undefined;
      continue;
    }
    const text = source.slice(start.offset, end.offset);
    if (sentence === undefined) {
      sentence = { start: start.offset, text: '', kind: 'text' };
      sentences.push(sentence);
    }
    sentence.text += isText ? withoutNames(text.replace(/&\w+;/g, fill)) : fill(text);
  }
  return sentences.filter(({ text }) => /\p{L}/u.test(text));
}

/** Texts of an expression: it is read as a script of its own. */
function expressionPassages(expression) {
  if (expression?.loc === undefined) return [];
  const prefix = '(';
  return shifted(
    typescriptPassages(`${prefix}${expression.loc.source})`),
    expression.loc.start.offset - prefix.length,
  );
}

function shifted(passages, by) {
  return passages.map((passage) => ({ ...passage, start: passage.start + by }));
}
