import ts from 'typescript';

import { blank, commentPassages, fill, isProse, withoutNames } from './passages.mjs';

/** Properties whose value is read by people, however short it is. */
const readProperties = new Set(['description', 'hint', 'label', 'message', 'placeholder', 'title']);

/**
 * Finds comments, and texts that people read, in TypeScript or JavaScript.
 *
 * @param {string} source
 * @returns {import('./passages.mjs').Passage[]}
 */
export function typescriptPassages(source) {
  const file = ts.createSourceFile('source.ts', source, ts.ScriptTarget.Latest, true);
  const literals = literalsOf(file, source);
  let withoutLiterals = '';
  let end = 0;
  for (const literal of literals) {
    if (literal.start < end) continue;
    withoutLiterals += source.slice(end, literal.start) + blank(literal.text);
    end = literal.start + literal.text.length;
  }
  return [
    ...commentPassages(withoutLiterals + source.slice(end), source),
    ...literals
      .filter(({ isRead }) => isRead)
      .map(({ start, text, isTitle }) => ({ start, text, kind: isTitle ? 'title' : 'text' })),
  ];
}

/**
 * Strings, templates and regular expressions, in the order of the file; what is in a template
 * follows it.
 *
 * @param {ts.SourceFile} file @param {string} source
 */
function literalsOf(file, source) {
  const found = [];
  const visit = (node) => {
    if (ts.isTemplateExpression(node) || ts.isStringLiteralLike(node)) {
      const start = node.getStart(file) + 1;
      const text = textOf(node, source.slice(start, node.end - 1), start);
      found.push({ start, text, isRead: isRead(node, text), isTitle: isTitle(node) });
    } else if (node.kind === ts.SyntaxKind.RegularExpressionLiteral) {
      found.push({ start: node.getStart(file), text: node.getText(file), isRead: false });
    }
    ts.forEachChild(node, visit);
  };
  visit(file);
  return found;
}

/** The text of a literal, its expressions filled. */
function textOf(node, inner, start) {
  let text = inner;
  if (ts.isTemplateExpression(node)) {
    for (const { expression } of node.templateSpans) {
      const [from, to] = [expression.pos - 2 - start, expression.end + 1 - start];
      text = text.slice(0, from) + fill(text.slice(from, to)) + text.slice(to);
    }
  }
  return withoutNames(text.replace(/\\(['"`])/g, ' $1').replace(/\\[nt]/g, '  '));
}

function isRead(node, text) {
  const { parent } = node;
  if (ts.isImportDeclaration(parent) || ts.isExportDeclaration(parent)) return false;
  if (isTitle(node) || isProse(text)) return true;
  return (
    ts.isPropertyAssignment(parent) &&
    ts.isIdentifier(parent.name) &&
    readProperties.has(parent.name.text) &&
    /\s|^\p{Lu}\p{Ll}/u.test(text) &&
    isWords(text)
  );
}

/** Whether a text names a test or a step of one. */
function isTitle(node) {
  if (!ts.isCallExpression(node.parent) || node.parent.arguments[0] !== node) return false;
  let callee = node.parent.expression;
  while (ts.isCallExpression(callee) || ts.isPropertyAccessExpression(callee)) {
    callee = callee.expression;
  }
  return ts.isIdentifier(callee) && /^(it|test|describe)$/.test(callee.text);
}

/** Whether a short text consists of words. @param {string} text */
function isWords(text) {
  return /^[\p{L}\d\s#'’“”.,:?!…-]+$/u.test(text);
}
