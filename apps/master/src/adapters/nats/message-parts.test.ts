import { describe, expect, it } from 'vitest';

import { formatPart, parsePart, PartJoiner, type PartFacts } from './message-parts.ts';

const facts = (message: number, offset: number, totalBytes = 4): PartFacts => ({
  message,
  offset,
  totalBytes,
});
const of = (...bytes: number[]): Uint8Array => Uint8Array.from(bytes);

describe('[CU-52] the header of a part', () => {
  it('is read as it is written', () => {
    expect(parsePart(formatPart(facts(7, 2)))).toEqual(facts(7, 2));
  });

  it.each(['', '1 2', '1 2 3 4', '-1 2 3', '1 x 3', '1 2 99999999999'])('is not %j', (text) => {
    expect(parsePart(text)).toBeUndefined();
  });
});

describe('[CU-52] parts of a message', () => {
  it('are joined, those of several senders at once', () => {
    const joiner = new PartJoiner(100);
    expect(joiner.add('a', facts(1, 0), of(1, 2))).toBeUndefined();
    expect(joiner.add('b', facts(1, 0), of(5, 6))).toBeUndefined();
    expect([...joiner.add('a', facts(1, 2), of(3, 4))!]).toEqual([1, 2, 3, 4]);
    expect([...joiner.add('b', facts(1, 2), of(7, 8))!]).toEqual([5, 6, 7, 8]);
    expect(joiner.heldBytes).toBe(0);
  });

  it('cost their own message only when one is missing', () => {
    const joiner = new PartJoiner(100);
    joiner.add('a', facts(1, 0), of(1, 2));
    expect(joiner.add('a', facts(2, 0), of(9, 9))).toBeUndefined();
    expect([...joiner.add('a', facts(2, 2), of(9, 9))!]).toEqual([9, 9, 9, 9]);
    expect(joiner.add('a', facts(3, 2), of(1, 1))).toBeUndefined();
    joiner.add('a', facts(4, 0, 6), of(1, 2));
    expect(joiner.add('a', facts(4, 4, 6), of(5, 6))).toBeUndefined();
    expect(joiner.add('a', facts(4, 2, 6), of(3, 4))).toBeUndefined();
    expect(joiner.heldBytes).toBe(0);
  });

  it('that do not fit their message are dropped', () => {
    const joiner = new PartJoiner(100);
    joiner.add('a', facts(1, 0), of(1, 2));
    expect(joiner.add('a', facts(1, 2), of(3, 4, 5))).toBeUndefined();
    joiner.add('a', facts(1, 0), of(1, 2));
    expect(joiner.add('a', facts(1, 2, 5), of(3, 4, 5))).toBeUndefined();
    expect(joiner.heldBytes).toBe(0);
  });

  it('take a bounded amount of memory, also with unknown senders', () => {
    const joiner = new PartJoiner(100);
    joiner.add('large', facts(1, 0, 101), of(1));
    expect(joiner.heldBytes).toBe(0);
    for (let n = 0; n < 50; n += 1) joiner.add(`sender ${n}`, facts(1, 0, 100), of(1));
    expect(joiner.heldBytes).toBe(400);
    expect(joiner.add('sender 0', facts(1, 1, 100), new Uint8Array(99))).toBeUndefined();
    expect(joiner.add('sender 49', facts(1, 1, 100), new Uint8Array(99))).toHaveLength(100);
    joiner.drop('sender 48');
    expect(joiner.heldBytes).toBe(200);
  });
});
