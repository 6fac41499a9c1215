import { expect, it } from 'vitest';
import { changedRows } from './changed-rows.ts';
import { jsonRows } from './json-rows.ts';

const rows = (json: never) => jsonRows(json, () => true);

it('says what changed, what is new and what is gone', () => {
  const before = rows({ a: 1, b: { c: 'x' }, d: true } as never);
  const now = rows({ a: 2, b: { c: 'x', e: 5 } } as never);
  const { was, gone } = changedRows(before, now);
  expect([...was]).toEqual([
    ['a', '1'],
    ['b.e', undefined],
  ]);
  expect(gone.map(({ path }) => path)).toEqual(['d']);
});

it('the first value has no changes', () => {
  expect(changedRows(undefined, rows(1 as never)).was.size).toBe(0);
});
