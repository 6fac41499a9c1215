import { mib } from '@ubii/harness';

import { QUANTITIES, type Quantity } from './measure.ts';
import type { SoakResult } from './soak.ts';

/** Quantities that were more at rest at the end than after the warm-up, or in the last quarter than in the first. */
export function findGrown({ growth, quiet: [first, last] }: SoakResult): readonly Quantity[] {
  return (Object.keys(QUANTITIES) as Quantity[]).filter((quantity) => {
    const { relative, absolute, isBytes } = QUANTITIES[quantity];
    const more = last[quantity] - first[quantity];
    const tolerated = Math.max(absolute, isBytes ? relative * first[quantity] : 0);
    return growth.get(quantity)!.isGrown || more > tolerated;
  });
}

/** The figures as a table. */
export function formatSoak(result: SoakResult): string {
  const { growth, quiet, counters, failures } = result;
  const grown = findGrown(result);
  const rows = (Object.keys(QUANTITIES) as Quantity[]).map((quantity) => {
    const { title, isBytes } = QUANTITIES[quantity];
    const text = (value: number): string => (isBytes ? mib(value) : String(Math.round(value)));
    const { quarters, tolerated, isRising } = growth.get(quantity)!;
    const cells = [...quarters, quiet[0][quantity], quiet[1][quantity], tolerated].map(text);
    const verdict = grown.includes(quantity) ? 'GROWN' : isRising ? 'rises, within' : 'as before';
    return [title, ...cells, verdict];
  });
  const head = ['', ...['1st', '2nd', '3rd', '4th'].map((name) => `${name} quarter`)];
  head.push('rest before', 'rest after', 'tolerated', '');
  const widths = head.map((_, at) => Math.max(...[head, ...rows].map((row) => row[at]!.length)));
  const lines = [head, ...rows].map((row) =>
    row
      .map((cell, at) => (at === 0 ? cell.padEnd(widths[at]!) : cell.padStart(widths[at]!)))
      .join('  ')
      .trimEnd(),
  );
  const counts = [...counters.counts].map(([what, count]) => `${count} ${what}`);
  const problems = [...counters.problems].map(([what, count]) => `  ${count} × ${what}`);
  return [
    ...lines,
    counts.join(', '),
    ...(problems.length > 0 ? ['Went wrong:', ...problems] : ['Nothing went wrong.']),
    ...(failures.length > 0 ? ['The master logged:', ...failures.slice(0, 12)] : []),
  ].join('\n');
}
