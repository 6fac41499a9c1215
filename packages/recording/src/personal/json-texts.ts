/** Where a text or a number begins. */
const LITERAL = /["\d-]/g;
const NUMBER = /[\d.eE+-]*/y;
/** Characters that JSON begins with, other than numbers and words. */
const BEGINNING = /^\s*["[{]/;

/** Parses a text that is a JSON object, list or text; undefined for all others. */
export function parseJsonText(text: string): unknown {
  if (!BEGINNING.test(text)) return undefined;
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

/**
 * Replaces texts and numbers in a text that is JSON, keys included. All else stays bit for bit.
 *
 * @param replace returns the text or number as it is when it stays
 */
export function replaceInJson(
  json: string,
  replace: (text: string, isNumber: boolean) => string,
): string {
  const parts: string[] = [];
  let done = 0;
  for (let at = nextLiteral(json, 0); at !== undefined;) {
    const isNumber = json[at] !== '"';
    const end = isNumber ? endOfNumber(json, at) : endOfText(json, at);
    const literal = json.slice(at, end);
    const text = isNumber ? literal : (JSON.parse(literal) as string);
    const replaced = replace(text, isNumber);
    if (replaced !== text) {
      parts.push(json.slice(done, at), JSON.stringify(replaced));
      done = end;
    }
    at = nextLiteral(json, end);
  }
  parts.push(json.slice(done));
  return parts.join('');
}

function nextLiteral(json: string, from: number): number | undefined {
  LITERAL.lastIndex = from;
  return LITERAL.exec(json)?.index;
}

function endOfNumber(json: string, at: number): number {
  NUMBER.lastIndex = at;
  return at + NUMBER.exec(json)![0].length;
}

/** Without a pattern: those of texts of megabytes exceed the stack. */
function endOfText(json: string, at: number): number {
  for (let quote = json.indexOf('"', at + 1); ; quote = json.indexOf('"', quote + 1)) {
    let escapes = 0;
    while (json[quote - 1 - escapes] === '\\') escapes++;
    if (escapes % 2 === 0) return quote + 1;
  }
}

/** The texts in a JSON value; keys and numbers are left out. */
export function* textsOfJson(value: unknown): Generator<string> {
  const open = [value];
  while (open.length > 0) {
    const next = open.pop();
    if (typeof next === 'string') yield next;
    else if (typeof next === 'object' && next !== null) {
      for (const inner of Object.values(next)) open.push(inner);
    }
  }
}
