/** Position in a text, line and column from 1. */
export interface TextPlace {
  readonly line: number;
  readonly column: number;
}

/** Position and reason of a syntax error in a JSON text. */
export interface SyntaxProblem extends TextPlace {
  readonly sentence: string;
}

/** Positions of the members in a JSON text, by path (`position.x`, `elements[2]`). */
export interface JsonPlaces {
  readonly offsets: ReadonlyMap<string, number>;
  readonly problem: SyntaxProblem | undefined;
}

const NUMBER = /-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y;
// eslint-disable-next-line no-control-regex -- JSON does not allow them bare
const STRING = /"(?:[^"\\\u0000-\u001f]|\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4}))*"/y;
const WORD = /true|false|null/y;
const SPACE = /[ \t\r\n]*/y;
/** Deepest nesting, above that of any message. */
const MAX_DEPTH = 64;

class Misfit extends Error {
  readonly offset: number;
  constructor(offset: number, sentence: string) {
    super(sentence);
    this.offset = offset;
  }
}

/** Scans a text for positions only; `JSON.parse` provides the values. */
export function jsonPlaces(text: string): JsonPlaces {
  const offsets = new Map<string, number>();
  let at = 0;

  const take = (pattern: RegExp): string | undefined => {
    pattern.lastIndex = at;
    const [found] = pattern.exec(text) ?? [];
    at += found?.length ?? 0;
    return found;
  };
  const skip = (): void => void take(SPACE);
  const eat = (letter: string): boolean => {
    skip();
    if (text[at] !== letter) return false;
    at++;
    return true;
  };
  const misfit = (expected: string): never => {
    const found = at >= text.length ? 'the end' : JSON.stringify(text[at]);
    throw new Misfit(Math.min(at, text.length), `Expected ${expected}, found ${found}.`);
  };

  function readValue(path: string, depth: number): void {
    skip();
    if (!offsets.has(path)) offsets.set(path, at);
    if (depth > MAX_DEPTH) misfit('less nesting');
    if (text[at] === '{') readObject(path, depth);
    else if (text[at] === '[') readList(path, depth);
    else if (text[at] === '"') void (take(STRING) ?? misfit('the end of this text, a "'));
    else if (take(NUMBER) === undefined && take(WORD) === undefined) misfit('a value');
  }
  function readObject(path: string, depth: number): void {
    at++;
    if (eat('}')) return;
    do {
      skip();
      const start = at;
      const key = take(STRING) ?? misfit('a name in double quotes');
      const name = JSON.parse(key) as string;
      const member = path === '' ? name : `${path}.${name}`;
      offsets.set(member, start);
      if (!eat(':')) misfit('a colon');
      readValue(member, depth + 1);
    } while (eat(','));
    if (!eat('}')) misfit('a comma or }');
  }
  function readList(path: string, depth: number): void {
    at++;
    if (eat(']')) return;
    let index = 0;
    do readValue(`${path}[${index++}]`, depth + 1);
    while (eat(','));
    if (!eat(']')) misfit('a comma or ]');
  }

  try {
    readValue('', 0);
    skip();
    if (at < text.length) misfit('nothing more');
    return { offsets, problem: undefined };
  } catch (error) {
    if (!(error instanceof Misfit)) throw error;
    return { offsets, problem: { ...placeAt(text, error.offset), sentence: error.message } };
  }
}

/** Converts an offset in a text to line and column. */
export function placeAt(text: string, offset: number): TextPlace {
  const before = text.slice(0, offset);
  const line = before.split('\n').length;
  return { line, column: offset - before.lastIndexOf('\n') };
}
