import { describe, expect, it } from 'vitest';
import type { ListedDifference } from './compare-messages.ts';
import { filterDifferences, kindOptions, nextDifference, rowsAround } from './difference-choice.ts';

const COUNTS = { topic: '/a', same: 0, different: 0, missing: 0, additional: 0 };

describe('the page of a comparison', () => {
  const listed = (
    topic: string,
    timeMs: number,
    kind: ListedDifference['kind'] = 'different',
  ): ListedDifference => ({ kind, topic, timeMs, path: '', recorded: '1', today: '2' });
  const ALL = [listed('/a', 0, 'missing'), listed('/a', 5), listed('/b', 5), listed('/a', 9)];

  it('lists the differences of one output and of one kind', () => {
    const timesOf = (topic: string | undefined, kind: ListedDifference['kind'] | 'all') =>
      filterDifferences(ALL, { topic, kind }).map(({ timeMs }) => timeMs);
    expect(timesOf('/a', 'all')).toEqual([0, 5, 9]);
    expect(timesOf('/a', 'different')).toEqual([5, 9]);
    expect(timesOf(undefined, 'missing')).toEqual([0]);
    expect(kindOptions([{ ...COUNTS, different: 1 }])).toEqual([]);
    const kinds = kindOptions([{ ...COUNTS, different: 1, missing: 2 }]);
    expect(kinds.map(({ value }) => value)).toEqual(['all', 'different', 'missing']);
  });

  it('goes to the next difference, also to one of the same moment, and to the first after the last', () => {
    expect(nextDifference(ALL, undefined, 0)).toBe(ALL[1]);
    expect(nextDifference(ALL, ALL[1], 5)).toBe(ALL[2]);
    expect(nextDifference(ALL, ALL[3], 9)).toBe(ALL[0]);
    expect(nextDifference(ALL, ALL[1], 7)).toBe(ALL[3]);
    expect(nextDifference([], undefined, 7)).toBeUndefined();
  });

  it('shows a part of a long list around the difference that was gone to', () => {
    const many = Array.from({ length: 1000 }, (_, index) => listed('/a', index));
    const partAt = (current: ListedDifference | undefined) => {
      const { before, rows, after } = rowsAround(many, current);
      return [before, rows.length, after];
    };
    expect(partAt(undefined)).toEqual([0, 200, 800]);
    expect(partAt(many[500])).toEqual([400, 200, 400]);
    expect(partAt(many[999])).toEqual([800, 200, 0]);
    expect(rowsAround(ALL, ALL[3])).toEqual({ before: 0, rows: ALL, after: 0 });
  });
});
