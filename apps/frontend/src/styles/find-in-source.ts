import { expect } from 'vitest';

/** A part of a source file that a check of the sources looks at. */
export interface Find {
  readonly text: string;
  /** `path:line: text` */
  readonly report: string;
}

/**
 * Returns every match of a pattern: its group `name` when it has one. A match that spans lines is reported where it ends.
 *
 * @param pattern with the flag `g`
 */
export function findInSource(path: string, source: string, pattern: RegExp): Find[] {
  return [...source.matchAll(pattern)].map((match) => {
    const line = source.slice(0, match.index + match[0].length).split('\n').length;
    const text = match.groups?.['name'] ?? match[0];
    return { text, report: `${path}:${line}: ${text}` };
  });
}

/** Replaces text by spaces, so that what follows keeps its line. */
export function blank(text: string): string {
  return text.replace(/[^\n]/g, ' ');
}

/** Fails with a list of all finds. */
export function expectNone(finds: readonly Find[]): void {
  const reports = finds.map(({ report }) => report);
  // The list is in the message because reports without a terminal leave out the difference
  expect(reports, `\n${reports.join('\n')}\n`).toEqual([]);
}
