import { expect, it } from 'vitest';
import { SentRecords } from './sent-records.ts';

it('counts records per second between two samples', () => {
  const sent = new SentRecords(0);
  for (let count = 0; count < 30; count += 1) sent.note();
  expect(sent.sample(2000)).toEqual({ perSecond: 15, line: [15] });
  expect(sent.sample(3000)).toEqual({ perSecond: 0, line: [15, 0] });
});

it('keeps the newest samples', () => {
  const sent = new SentRecords(0);
  for (let second = 1; second <= 40; second += 1) {
    for (let count = 0; count < second; count += 1) sent.note();
    sent.sample(second * 1000);
  }
  expect(sent.sample(41_000).line).toHaveLength(30);
  expect(sent.sample(42_000).line.slice(-3)).toEqual([40, 0, 0]);
});
