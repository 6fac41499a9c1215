import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { JsonScan, type JsonScanLimits } from './json-scan.ts';

const NO_LIMITS = { depth: Infinity, values: Infinity };

function scan(text: string, limits: JsonScanLimits = NO_LIMITS, pieceBytes = Infinity) {
  const bytes = new TextEncoder().encode(text);
  const found = new JsonScan('topic');
  let excess: string | undefined;
  for (let end = 0; end < bytes.length && excess === undefined;) {
    end = Math.min(bytes.length, end + pieceBytes);
    excess = found.scan(bytes, end, limits);
  }
  return { text: found.text, values: found.values, excess, pos: found.pos };
}

function count(value: unknown): number {
  if (typeof value !== 'object' || value === null) return 1;
  return Object.values(value).reduce<number>((sum, each) => sum + count(each), 1);
}

describe('JsonScan [SV-43]', () => {
  it.each([
    ['{"topic":"/a"}', '/a'],
    ['{ "x" : [1,{"topic":"/no"}], "topic" : "/a" , "y":"topic"}', '/a'],
    ['{"topic":"/a","topic":"/b"}', '/b'],
    ['{"topic":"/a","topic":null}', undefined],
    ['{"topic":"/a","topic":["/b"]}', undefined],
    ['{"topic":"/a","topic":{"topic":"/b"}}', undefined],
    ['{"\\u0074opic":"/a"}', '/a'],
    ['{"topic":"\\u002fa\\"b"}', '/a"b'],
    ['{"x":"topic","y":"/b"}', undefined],
    ['["topic","/a"]', undefined],
    ['[{"topic":"/a"}]', undefined],
    ['{"topi\\u0063":"/ä"}', '/ä'],
    ['"topic"', undefined],
    ['{"topics":"/a"}', undefined],
    ['', undefined],
  ])('finds the topic of %s', (text, topic) => {
    expect(scan(text).text).toBe(topic);
    expect(scan(text, NO_LIMITS, 1).text).toBe(topic);
  });

  it('finds what JSON.parse finds, and counts no fewer values, in pieces of any size', () => {
    const members = fc.array(
      fc.tuple(fc.constantFrom('topic', 'x', 'topi', '"', '\\'), fc.jsonValue()),
    );
    fc.assert(
      fc.property(members, fc.integer({ min: 1, max: 9 }), (list, pieceBytes) => {
        const text = `{${list.map(([key, value]) => `${JSON.stringify(key)}: ${JSON.stringify(value)}`).join()}}`;
        const json = JSON.parse(text) as Record<string, unknown>;
        const found = scan(text, NO_LIMITS, pieceBytes);
        expect(found.text).toBe(typeof json['topic'] === 'string' ? json['topic'] : undefined);
        expect(found.values).toBeGreaterThanOrEqual(count(json));
      }),
      { numRuns: 500 },
    );
  });

  it('stops where there is too much', () => {
    expect(scan('{"u":[[[1]]]}', { ...NO_LIMITS, depth: 3 })).toMatchObject({
      excess: 'depth',
      pos: 7,
    });
    expect(scan('[1,2,3,4]', { ...NO_LIMITS, values: 4 })).toMatchObject({ excess: 'values' });
    expect(scan('"[[[,,,"', { depth: 0, values: 1 }).excess).toBeUndefined();
  });
});
