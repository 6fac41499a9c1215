import type { TextPlace } from '../../text/module-text.ts';

/** Mark at a position of the text. */
export interface CodeMark extends TextPlace {
  readonly severity: 'error' | 'warning';
  readonly message: string;
  /** True when it was found by running the module. */
  readonly isOfRun?: boolean;
}

/** Problem found by TypeScript. */
export interface TypeMark extends CodeMark {
  /** True for syntax errors; false for type errors. */
  readonly isSyntax: boolean;
}

/**
 * Removes duplicates and sorts errors first. Where there is a syntax error, drops the engine's message at the same
 * position and all type errors.
 * @param marks from the checks of the module
 */
export function firstCauses(
  marks: readonly CodeMark[],
  types: readonly TypeMark[],
): readonly CodeMark[] {
  const syntax = types.filter(({ isSyntax }) => isSyntax);
  const own = syntax.length > 0 ? marks.filter((mark) => !isSyntaxError(mark)) : marks;
  const isBroken = syntax.length > 0 || own.some(isSyntaxError);
  const told = isBroken ? syntax : types;
  const wrongLines = new Set(
    [...told, ...own.filter(({ isOfRun }) => !isOfRun)]
      .filter(({ severity }) => severity === 'error')
      .map(({ line }) => line),
  );
  // Drop failures of a run at lines whose error is listed already.
  const all = [...own.filter(({ isOfRun, line }) => !isOfRun || !wrongLines.has(line)), ...told];
  const byPlace = new Map(
    all.map((mark) => [`${mark.line}:${mark.column} ${mark.message}`, mark] as const),
  );
  return [...byPlace.values()].sort(
    (a, b) => a.severity.localeCompare(b.severity) || a.line - b.line || a.column - b.column,
  );
}

/** A run throws errors of this name as well, such as JSON.parse for a text that is no JSON. */
const isSyntaxError = ({ message, isOfRun = false }: CodeMark): boolean =>
  !isOfRun && message.startsWith('SyntaxError');
