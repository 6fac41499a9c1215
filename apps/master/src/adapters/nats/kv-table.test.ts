import { FakeClock } from '@ubii/timing/testing';
import { expect, it } from 'vitest';

import { Removals } from './kv-table.ts';

const MINUTE_MS = 60_000;

it('[CU-57] removes what is left of a deletion after ten minutes, and tries again when NATS is away', async () => {
  const clock = new FakeClock();
  const forgotten: string[] = [];
  const asked: string[] = [];
  let isAway = true;
  const bucket = {
    forget(rawKey: string, revision: number) {
      asked.push(`${rawKey} ${revision}`);
      return isAway ? Promise.reject(new Error('away')) : Promise.resolve();
    },
  };
  const removals = new Removals(bucket, clock, (rawKey) => forgotten.push(rawKey));
  removals.add('a', 7, clock.nowMs());
  await clock.advance(9 * MINUTE_MS);
  expect(asked).toEqual([]);
  await clock.advance(2 * MINUTE_MS);
  expect([asked, forgotten]).toEqual([['a 7'], []]);
  isAway = false;
  await clock.advance(MINUTE_MS);
  expect([asked, forgotten]).toEqual([['a 7', 'a 7'], ['a']]);
  removals.add('b', 8, clock.nowMs());
  removals.close();
  await clock.advance(20 * MINUTE_MS);
  expect(asked).toHaveLength(2);
});
