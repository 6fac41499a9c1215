import type { TextPlace } from '../text/module-text.ts';

/** Something to be seen at a place of the text. */
export interface CodeMark extends TextPlace {
  readonly severity: 'error' | 'warning';
  readonly message: string;
  /** It was found by running the module. */
  readonly isOfRun?: boolean;
}

/** What TypeScript found. */
export interface TypeMark extends CodeMark {
  /** The text is no JavaScript there; false: a type does not fit. */
  readonly isSyntax: boolean;
}

/**
 * Each mistake once, errors first. Where the text is no JavaScript, what the engine says about the same
 * place and what types say about the rest are left out.
 * @param marks of the checks of the project
 */
export function firstCauses(
  marks: readonly CodeMark[],
  types: readonly TypeMark[],
): readonly CodeMark[] {
  const syntax = types.filter(({ isSyntax }) => isSyntax);
  const own =
    syntax.length > 0 ? marks.filter(({ message }) => !message.startsWith('SyntaxError')) : marks;
  const isBroken =
    syntax.length > 0 || own.some(({ message }) => message.startsWith('SyntaxError'));
  const told = isBroken ? syntax : types;
  const wrongLines = new Set(
    [...told, ...own.filter(({ isOfRun }) => !isOfRun)]
      .filter(({ severity }) => severity === 'error')
      .map(({ line }) => line),
  );
  // A run fails at a line because of the mistake that is told there already.
  const all = [...own.filter(({ isOfRun, line }) => !isOfRun || !wrongLines.has(line)), ...told];
  const byPlace = new Map(
    all.map((mark) => [`${mark.line}:${mark.column} ${mark.message}`, mark] as const),
  );
  return [...byPlace.values()].sort(
    (a, b) => a.severity.localeCompare(b.severity) || a.line - b.line || a.column - b.column,
  );
}
