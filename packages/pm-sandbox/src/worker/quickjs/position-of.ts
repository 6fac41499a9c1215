/**
 * The innermost place in the author's text that a stack of QuickJS tells of; its files are named after
 * the callbacks. [PM-13]
 */
export function positionOf(
  stack: string,
): { readonly line: number; readonly column: number } | undefined {
  const match = /(?:\(|at )on(?:Created|Processing|Halted|Destroyed):(\d+):(\d+)/.exec(stack);
  if (match === null) return undefined;
  const line = Number(match[1]);
  // The text is put into brackets.
  return { line, column: Math.max(1, Number(match[2]) - (line === 1 ? 1 : 0)) };
}
