import type { ModuleFault } from '../ports/module-fault.ts';

/** Message of QuickJS for destructuring undefined or null, which does not name the value. */
const NO_OBJECT = /^TypeError: cannot convert to object$/;
/** `const { x, y } = inputs.point.vector3` */
const DESTRUCTURING = /\b(?:const|let|var)\s+(\{[^{}=]*\})\s*=\s*([^;\n]+)/g;

/**
 * Names the value that members were taken from, and its line: QuickJS gives the place of what ran before.
 *
 * @param source of the callback
 */
export function explainDestructuring(fault: ModuleFault, source: string): ModuleFault {
  const { kind, line = 1, message } = fault;
  if (kind !== 'threw' || !NO_OBJECT.test(message)) return fault;
  for (const { index, 1: pattern = '', 2: from = '' } of source.matchAll(DESTRUCTURING)) {
    const lines = source.slice(0, index).split('\n');
    if (lines.length < line) continue;
    const place = { line: lines.length, column: (lines.at(-1)?.length ?? 0) + 1 };
    const taken = pattern.replace(/\s+/g, ' ');
    return {
      ...fault,
      ...place,
      message: `${from.trim()} has no value, so ${taken} cannot be taken from it. (${message})`,
    };
  }
  return fault;
}
