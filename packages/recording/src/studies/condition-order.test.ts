import { StudyOrder } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { orderOfConditions, williamsDesign } from './condition-order.ts';

const COUNTS = [1, 2, 3, 4, 5, 6, 7, 8, 31, 32];

/** How often each value occurs. */
function tally(values: readonly (string | number)[]): Set<number> {
  const counts = new Map<string | number, number>();
  for (const value of values) counts.set(value, (counts.get(value) ?? 0) + 1);
  return new Set(counts.values());
}

describe('a Williams design', () => {
  it.each(COUNTS)('of %d has each condition once in each row [ST-10]', (count) => {
    const rows = williamsDesign(count);
    expect(rows).toHaveLength(count % 2 === 0 || count === 1 ? count : 2 * count);
    const all = Array.from({ length: count }, (_, index) => index);
    for (const row of rows) expect([...row].sort((a, b) => a - b)).toEqual(all);
  });

  it.each(COUNTS)('of %d has each condition equally often at each position [ST-10]', (count) => {
    const rows = williamsDesign(count);
    const places = rows.flatMap((row) => row.map((each, place) => `${each} at ${place}`));
    expect(new Set(places).size).toBe(count ** 2);
    expect(tally(places).size).toBe(1);
  });

  it.each(COUNTS.slice(1))('of %d has each pair of neighbours equally often [ST-10]', (count) => {
    const rows = williamsDesign(count);
    const pairs = rows.flatMap((row) => row.slice(1).map((each, i) => `${each} after ${row[i]}`));
    expect(new Set(pairs).size).toBe(count * (count - 1));
    expect(tally(pairs).size).toBe(1);
  });
});

describe('the order of conditions', () => {
  const subject = { studyId: 's', number: 1, visit: '1' };
  const random = (change: Partial<typeof subject> = {}, repetition = 1) =>
    orderOfConditions(StudyOrder.STUDY_ORDER_RANDOM, 12, repetition, { ...subject, ...change });

  it('is that of the study when it is fixed [ST-10]', () => {
    expect(orderOfConditions(StudyOrder.STUDY_ORDER_FIXED, 4, 3, subject)).toEqual([0, 1, 2, 3]);
  });

  it('takes the next row of the design for each participant, and the first one again [ST-10]', () => {
    const balanced = (number: number) =>
      orderOfConditions(StudyOrder.STUDY_ORDER_BALANCED, 4, 1, { ...subject, number });
    expect([1, 2, 3, 4].map(balanced)).toEqual(williamsDesign(4));
    expect(balanced(5)).toEqual(balanced(1));
  });

  it('is the same each time it is shuffled for one participant, visit and repetition [ST-10]', () => {
    expect(random()).toEqual(random());
    expect(random()).toEqual([0, 2, 11, 4, 7, 3, 6, 1, 5, 8, 10, 9]);
    const others = [random({ number: 2 }), random({ visit: '2' }), random({ studyId: 't' })];
    expect(new Set([random(), random({}, 2), ...others].map(String)).size).toBe(5);
  });

  it('has each condition at each position about equally often when it is shuffled [ST-10]', () => {
    const participants = Array.from({ length: 2_400 }, (_, index) => random({ number: index + 1 }));
    const counts = new Map<string, number>();
    for (const order of participants) {
      for (const [place, each] of order.entries()) {
        counts.set(`${each} at ${place}`, (counts.get(`${each} at ${place}`) ?? 0) + 1);
      }
    }
    expect(counts.size).toBe(144);
    // 200 are expected of each; five standard deviations are 68.
    for (const count of counts.values()) expect(Math.abs(count - 200)).toBeLessThan(68);
  });
});
