import type { ComparedTopic, ListedDifference } from './compare-messages.ts';

/** Which differences are listed. */
export interface DifferenceFilter {
  /** Undefined: of all outputs. */
  readonly topic: string | undefined;
  readonly kind: ListedDifference['kind'] | 'all';
}

export const filterDifferences = (
  differences: readonly ListedDifference[],
  { topic, kind }: DifferenceFilter,
): readonly ListedDifference[] =>
  differences.filter(
    (one) => (topic === undefined || one.topic === topic) && (kind === 'all' || one.kind === kind),
  );

const KIND_NAMES: Readonly<Record<ListedDifference['kind'], string>> = {
  different: 'Different',
  missing: 'Missing',
  additional: 'Additional',
};

/** Kinds to choose from; none where all differences are of one kind. */
export function kindOptions(
  topics: readonly ComparedTopic[],
): readonly { readonly value: DifferenceFilter['kind']; readonly text: string }[] {
  const found = (['different', 'missing', 'additional'] as const).filter((kind) =>
    topics.some((topic) => topic[kind] > 0),
  );
  if (found.length < 2) return [];
  const kinds = found.map((value) => ({ value, text: KIND_NAMES[value] }));
  return [{ value: 'all', text: 'All' }, ...kinds];
}

/** The difference after one of a list, else after a moment; the first one again after the last one. */
export function nextDifference(
  listed: readonly ListedDifference[],
  current: ListedDifference | undefined,
  timeMs: number,
): ListedDifference | undefined {
  const place = current === undefined ? -1 : listed.indexOf(current);
  // The playhead may have been moved since.
  if (place >= 0 && Math.abs(listed[place]!.timeMs - timeMs) < 0.5)
    return listed[place + 1] ?? listed[0];
  return listed.find((one) => one.timeMs > timeMs + 0.5) ?? listed[0];
}

/** Rows that a list has at once. */
const MAX_ROWS = 200;

/** The rows of a list, around the one that was gone to, and how many there are before and after. */
export function rowsAround(
  listed: readonly ListedDifference[],
  current: ListedDifference | undefined,
): {
  readonly before: number;
  readonly rows: readonly ListedDifference[];
  readonly after: number;
} {
  const place = current === undefined ? 0 : Math.max(0, listed.indexOf(current));
  const before = Math.max(0, Math.min(place - MAX_ROWS / 2, listed.length - MAX_ROWS));
  const rows = listed.slice(before, before + MAX_ROWS);
  return { before, rows, after: listed.length - before - rows.length };
}
