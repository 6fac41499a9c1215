/** Characters and keywords after which a slash starts a regular expression instead of a division. */
const BEFORE_REGEXP =
  /(?:^|[([{,;:=!&|?+\-*%~^<>]|\b(?:return|typeof|case|in|of|void|delete|await))$/;

/** Index after a string literal: past the closing quote, or at the end of an unterminated line. */
function endOfString(text: string, start: number): number {
  const quote = text[start];
  for (let at = start + 1; at < text.length; at++) {
    if (text[at] === '\\') at++;
    else if (text[at] === quote) return at + 1;
    else if (text[at] === '\n') return at;
  }
  return text.length;
}

function endOfRegExp(text: string, start: number): number {
  let isInClass = false;
  for (let at = start + 1; at < text.length; at++) {
    const letter = text[at];
    if (letter === '\\') at++;
    else if (letter === '\n') return start + 1;
    else if (letter === '[') isInClass = true;
    else if (letter === ']') isInClass = false;
    else if (letter === '/' && !isInClass) return at + 1;
  }
  return start + 1;
}

/** Index after a template literal, including its expressions. */
function endOfTemplate(text: string, start: number): number {
  for (let at = start + 1; at < text.length; at++) {
    if (text[at] === '\\') at++;
    else if (text[at] === '`') return at + 1;
    else if (text[at] === '$' && text[at + 1] === '{') at = endOfBraces(text, at + 1) - 1;
  }
  return text.length;
}

function endOfBraces(text: string, start: number): number {
  let depth = 0;
  for (let at = start; at < text.length;) {
    const next = endOfToken(text, at, () => '');
    if (next === at + 1) {
      if (text[at] === '{') depth++;
      if (text[at] === '}' && --depth === 0) return next;
    }
    at = next;
  }
  return text.length;
}

/** @param before returns the end of the code in front, which tells a regular expression from a division */
function endOfToken(text: string, at: number, before: () => string): number {
  switch (text[at]) {
    case '"':
    case "'":
      return endOfString(text, at);
    case '`':
      return endOfTemplate(text, at);
    case '/': {
      if (text[at + 1] === '/') {
        const end = text.indexOf('\n', at);
        return end < 0 ? text.length : end;
      }
      if (text[at + 1] === '*') {
        const end = text.indexOf('*/', at + 2);
        return end < 0 ? text.length : end + 2;
      }
      return BEFORE_REGEXP.test(before().trimEnd()) ? endOfRegExp(text, at) : at + 1;
    }
    default:
      return at + 1;
  }
}

const blank = (text: string): string =>
  text.length > 1 ? text.replace(/[^\n]/g, ' ') : text === '\n' ? text : ' ';

/** Longest code in front of a slash that `BEFORE_REGEXP` looks at. */
const MAX_BEFORE = 24;

/**
 * Blanks the contents of brackets, strings, templates, regular expressions and comments, so that only top-level code
 * remains. Length and lines are unchanged. Unclosed elements extend to the end.
 *
 * @param keepsBrackets keeps the contents of brackets
 */
export function maskSource(text: string, keepsBrackets = false): string {
  let mask = '';
  let depth = 0;
  /** Code before the last comment. */
  let kept = '';
  let codeStart = 0;
  for (let at = 0; at < text.length;) {
    const before = (): string =>
      (kept + text.slice(Math.max(codeStart, at - MAX_BEFORE), at)).slice(-MAX_BEFORE);
    const end = endOfToken(text, at, before);
    const token = text.slice(at, end);
    const isLetter = end === at + 1;
    if (isLetter && '([{'.includes(token)) depth++;
    const isOutside = isLetter && (keepsBrackets || depth === 0);
    if (isLetter && ')]}'.includes(token)) depth = Math.max(0, depth - 1);
    mask += isOutside ? token : blank(token);
    if (token.startsWith('//') || token.startsWith('/*')) {
      kept = before();
      codeStart = end;
    }
    at = end;
  }
  return mask;
}
