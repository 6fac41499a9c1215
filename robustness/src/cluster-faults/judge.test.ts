import { describe, expect, it } from 'vitest';

import { Reception, type ReceptionRow } from './clients/reception.ts';
import { judge, type PhaseFacts } from './judge.ts';

const ROW: ReceptionRow = {
  topic: '/a',
  home: 'http://two',
  moved: false,
  received: 5,
  missing: 0,
  again: 0,
  disorder: 0,
};
const FACTS: PhaseFacts = {
  publishers: [{ topic: '/a', home: 'http://one', moved: false, last: 9 }],
  receptions: [],
  indexOf: (url) => ['http://one', 'http://two'].indexOf(url),
  mayLose: () => false,
  noticed: new Set(),
};

function violations(row: Partial<ReceptionRow>, facts: Partial<PhaseFacts> = {}) {
  return judge({ ...FACTS, ...facts, receptions: [{ ...ROW, ...row }] }).violations;
}

describe('records of a phase of a run', () => {
  it('that are out of order, or twice, are faults', () => {
    expect(violations({})).toEqual([]);
    expect(violations({ disorder: 1, moved: true })).toHaveLength(1);
    expect(violations({ again: 1 })).toHaveLength(1);
    // The value that stands, for a subscription that was made again.
    expect(violations({ again: 1, moved: true })).toEqual([]);
  });

  it('[CU-7] that are missing are a fault, unless their masters were apart or a client was', () => {
    expect(violations({ missing: 3 })).toHaveLength(1);
    expect(violations({ missing: 3, moved: true })).toEqual([]);
    expect(violations({ missing: 3 }, { mayLose: () => true })).toEqual([]);
    expect(violations({ missing: 3 }, { noticed: new Set([1]) })).toEqual([]);
    expect(violations({ missing: 3 }, { noticed: new Set([0]) })).toHaveLength(1);
  });

  it('that do not leave their master are never missing', () => {
    const atOne = { missing: 1, home: 'http://one' };
    expect(violations(atOne, { mayLose: () => true, noticed: new Set([0, 1]) })).toHaveLength(1);
  });
});

describe('what a client received of a topic', () => {
  it('is counted by the numbers', () => {
    const reception = new Reception('/a');
    for (const number of [7, 8, 8, 11, 9, 12]) reception.handle(number);
    expect(reception.take()).toEqual({ received: 6, missing: 2, again: 1, disorder: 1 });
    expect(reception.last).toBe(12);
    reception.handle(13);
    expect(reception.take()).toEqual({ received: 1, missing: 0, again: 0, disorder: 0 });
  });
});
