import { maskSource } from './mask-source.ts';
import { placeOf, type Callback, type TextPlace, splitText } from './module-text.ts';

const RETURN = /\breturn\b/g;
/** What follows a `return` without a value. */
const NO_VALUE = /^return\s*[;}]/;

/**
 * Where a callback returns its result: the last `return` with a value that stands in no block of its
 * body. `undefined` when it has none, as a function without a body.
 */
export function returnPlace(text: string, callback: Callback): TextPlace | undefined {
  const section = splitText(text).sections.find((one) => one.callback === callback);
  if (section === undefined) return undefined;
  const { source, at } = section;
  const body = source.indexOf('{', maskSource(source).trimEnd().length) + 1;
  if (body === 0) return undefined;
  const last = [...maskSource(source.slice(body)).matchAll(RETURN)]
    .map(({ index }) => body + index)
    .findLast((start) => !NO_VALUE.test(source.slice(start)));
  if (last === undefined) return undefined;
  const { line, column } = placeOf(source, last);
  return line === 1
    ? { line: at.line, column: at.column + column - 1 }
    : { line: at.line + line - 1, column };
}
