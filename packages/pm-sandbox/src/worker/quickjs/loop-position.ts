/** A place in a text, both from 1. */
interface Position {
  readonly line: number;
  readonly column: number;
}

/** From its keyword to its end, places in a text. */
interface Loop {
  readonly start: number;
  readonly end: number;
}

/**
 * Returns the position of the loop in an interrupted function. QuickJS only reports the last call or member access in a
 * function, or without any, the start of the function: if there is a single loop in it, or one after that position,
 * that is the loop.
 *
 * @param at position reported by the engine
 * @returns the position of the loop, or `at` when there is none, or several
 */
export function loopPosition(source: string, at: Position): Position {
  const text = blank(source);
  const start = indexOf(text, at);
  const body = bodyAfter(text, start);
  const loops = body
    ? outerLoops(text, body.start, body.end)
    : loopsAfter(outerLoops(text, 0, text.length), start);
  return loops.length === 1 ? positionAt(text, loops[0]!.start) : at;
}

/** None, when the place is in a loop itself. */
function loopsAfter(loops: readonly Loop[], place: number): readonly Loop[] {
  if (loops.some(({ start, end }) => start <= place && place < end)) return [];
  return loops.filter(({ start }) => start > place);
}

/** The text with comments and the contents of strings blanked, line ends kept. */
function blank(source: string): string {
  return source.replace(
    /\/\/[^\n]*|\/\*[\s\S]*?\*\/|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'|`(?:[^`\\]|\\[\s\S])*`/g,
    (match) => match.replace(/[^\n]/g, ' '),
  );
}

/** Body of the function that begins at a place; undefined when none does, or it has no block. */
function bodyAfter(text: string, start: number): { start: number; end: number } | undefined {
  const head = /^(?:async\b\s*)?(?:function\b\s*\*?\s*)?[\w$]*\s*/.exec(
    text.slice(start, start + 200),
  );
  let next = start + (head?.[0].length ?? 0);
  if (text[next] === '(') next = closing(text, next) + 1;
  const tail = /^\s*(?:=>\s*)?\{/.exec(text.slice(next, next + 200));
  if (tail === null) return undefined;
  const open = next + tail[0].length - 1;
  return { start: open + 1, end: closing(text, open) };
}

/** The loops between two places that are in no other loop. */
function outerLoops(text: string, start: number, end: number): Loop[] {
  const loops: Loop[] = [];
  const keyword = /(?<![\w$.])(for|while|do)(?![\w$:])/g;
  keyword.lastIndex = start;
  for (let match = keyword.exec(text); match !== null; match = keyword.exec(text)) {
    if (match.index >= end) break;
    const loop = { start: match.index, end: loopEnd(text, match.index, match[1]!) };
    loops.push(loop);
    keyword.lastIndex = loop.end;
  }
  return loops;
}

/** The end of a loop: of its block, or of its statement. */
function loopEnd(text: string, start: number, keyword: string): number {
  let next = start + keyword.length;
  if (keyword !== 'do') {
    const open = text.indexOf('(', next);
    if (open < 0) return text.length;
    next = closing(text, open) + 1;
  }
  const block = /^\s*\{/.exec(text.slice(next, next + 200));
  if (block === null) return ending(text, next);
  const end = closing(text, next + block[0].length - 1) + 1;
  if (keyword !== 'do') return end;
  const condition = /^\s*while\s*/.exec(text.slice(end, end + 200));
  return condition === null ? end : end + condition[0].length;
}

function ending(text: string, start: number): number {
  const end = text.indexOf(';', start);
  return end < 0 ? text.length : end;
}

/** The bracket that closes the one at a place; the end of the text when none does. */
function closing(text: string, open: number): number {
  let depth = 0;
  for (let i = open; i < text.length; i++) {
    const character = text[i]!;
    if ('([{'.includes(character)) depth++;
    else if (')]}'.includes(character) && --depth === 0) return i;
  }
  return text.length;
}

function indexOf(text: string, { line, column }: Position): number {
  let start = 0;
  for (let i = 1; i < line; i++) start = text.indexOf('\n', start) + 1;
  return start + column - 1;
}

function positionAt(text: string, index: number): Position {
  const before = text.slice(0, index).split('\n');
  return { line: before.length, column: before.at(-1)!.length + 1 };
}
