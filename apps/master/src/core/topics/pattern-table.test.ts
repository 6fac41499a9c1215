import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { LiteralIndex } from './pattern-table.ts';
import type { RequiredLiteral } from './required-literal.ts';

const anywhere = (text: string): RequiredLiteral => ({ text, isPrefix: false });
const prefix = (text: string): RequiredLiteral => ({ text, isPrefix: true });
const indexOf = (literals: readonly RequiredLiteral[]) => {
  const index = new LiteralIndex<RequiredLiteral>();
  for (const literal of literals) index.add(literal, literal);
  return index;
};

describe('LiteralIndex [TD-22]', () => {
  it('leaves out the many that a topic cannot match', () => {
    const foreign = Array.from({ length: 1000 }, (_, i) => [
      prefix(`/foreign/${i}/`),
      anywhere(`/foreign/${i}/`),
    ]).flat();
    const own = [prefix('/first/'), anywhere('/irst/'), anywhere('irst/1')];
    const found = [...indexOf([...foreign, ...own]).candidates('/first/1')];
    expect(found).toEqual([own[0], own[2]]);
  });

  it('finds items that share a literal, and those without a useful one', () => {
    const index = new LiteralIndex<string>();
    index.add('a', prefix('/device/'));
    index.add('b', prefix('/device/'));
    index.add('c', undefined);
    index.add('d', anywhere('x'));
    expect([...index.candidates('/device/1')].sort()).toEqual(['a', 'b', 'c', 'd']);
    expect([...index.candidates('/dev')].sort()).toEqual(['c', 'd']);
  });

  it('misses no literal that a text contains, whatever was added and deleted', () => {
    const text = fc.string({ unit: fc.constantFrom('a', 'b', '/', '🙂'), maxLength: 9 });
    const literal = fc.record({
      text: text.filter((each) => each !== ''),
      isPrefix: fc.boolean(),
    });
    fc.assert(
      fc.property(fc.array(literal), fc.array(fc.nat(30)), text, (literals, deletions, topic) => {
        const index = indexOf(literals);
        const deleted = new Set(deletions.map((at) => literals[at]));
        for (const each of deleted) if (each !== undefined) index.delete(each, each);
        const found = index.candidates(topic);
        for (const each of literals) {
          const isIn = each.isPrefix ? topic.startsWith(each.text) : topic.includes(each.text);
          if (deleted.has(each)) expect(found.has(each)).toBe(false);
          else if (isIn) expect(found.has(each)).toBe(true);
        }
      }),
    );
  });
});
