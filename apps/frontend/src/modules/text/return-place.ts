import { maskSource } from './mask-source.ts';
import {
  placeOf,
  type Callback,
  type TextPlace,
  type TextSection,
  splitText,
} from './module-text.ts';

const RETURN = /\breturn\b/g;
/** Matches a `return` without a value. */
const NO_VALUE = /^return\s*[;}]/;
/** Matches the output at the beginning of a message about a result. */
const OUTPUT = /^Output "([^"]+)"/;
/** Name of a member in an object literal. */
const MEMBER = /(?<![\w$.])[\p{ID_Start}$_][\p{ID_Continue}$]*(?=\s*[:,}])/gu;

/**
 * Returns the position of a callback's result: the last `return` with a value at the top level of its body. `undefined`
 * when it has none, as for an arrow function without a body.
 */
export function returnPlace(text: string, callback: Callback): TextPlace | undefined {
  const section = sectionOf(text, callback);
  const last = section && returnOffset(section.source);
  return last === undefined ? undefined : placeInSection(section!, last);
}

/**
 * Returns the position that produces the result a message is about: the output it names, otherwise the `return`. Runs
 * report no position of a wrong result, and TypeScript reports the name of the callback.
 */
export function resultPlace(
  text: string,
  callback: Callback,
  message: string,
): TextPlace | undefined {
  const section = sectionOf(text, callback);
  const name = OUTPUT.exec(message)?.[1];
  if (section === undefined || name === undefined) return returnPlace(text, callback);
  const from = returnOffset(section.source) ?? 0;
  const found = [...maskSource(section.source, true).matchAll(MEMBER)]
    .filter(([word]) => word === name)
    .map(({ index }) => index);
  const at = found.find((index) => index >= from) ?? found.at(-1);
  return at === undefined ? returnPlace(text, callback) : placeInSection(section, at);
}

const sectionOf = (text: string, callback: Callback): TextSection | undefined =>
  splitText(text).sections.find((one) => one.callback === callback);

/** Returns the offset after the opening brace of a function's body; `undefined` for an arrow function without one. */
export function bodyOffset(source: string): number | undefined {
  const brace = source.indexOf('{', maskSource(source).trimEnd().length);
  return brace < 0 ? undefined : brace + 1;
}

function returnOffset(source: string): number | undefined {
  const body = bodyOffset(source);
  if (body === undefined) return undefined;
  return [...maskSource(source.slice(body)).matchAll(RETURN)]
    .map(({ index }) => body + index)
    .findLast((start) => !NO_VALUE.test(source.slice(start)));
}

function placeInSection({ source, at }: TextSection, offset: number): TextPlace {
  const { line, column } = placeOf(source, offset);
  return line === 1
    ? { line: at.line, column: at.column + column - 1 }
    : { line: at.line + line - 1, column };
}
