import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { Re2Patterns } from '@ubii/patterns/re2';
import { requiredLiteral } from './required-literal.ts';

describe('requiredLiteral', () => {
  it.each([
    ['^/device/[^/]+$', { text: '/device/', isPrefix: true }],
    ['/device/', { text: '/device/', isPrefix: false }],
    ['^/[^/]+/pointer$', { text: '/pointer', isPrefix: false }],
    ['^/a\\.b\\/c', { text: '/a.b/c', isPrefix: true }],
    ['^/[0-9a-f]{8}/pointer/.*', { text: '/pointer/', isPrefix: false }],
    ['/(one|two)/three', { text: '/three', isPrefix: false }],
    ['/info/*', { text: '/info', isPrefix: false }],
    ['ab?c+d', { text: 'a', isPrefix: false }],
    ['^/ä/🙂/x', { text: '/ä/🙂/x', isPrefix: true }],
  ])('finds what every match of %s contains [TD-22]', (source, expected) => {
    expect(requiredLiteral(source)).toEqual(expected);
  });

  it.each(['', '.*', 'a|b', '(?i)abc', '[abc]', '\\Qa.b\\E', 'a*', '\\x41bc', '^*abc', '(a|b)'])(
    'finds nothing in %j',
    (source) => {
      expect(requiredLiteral(source)).toBeUndefined();
    },
  );

  it('is contained in everything that the pattern matches [TD-22]', () => {
    const compiler = new Re2Patterns();
    const piece = fc.constantFrom(
      ...[
        'a',
        'b',
        '/',
        'ab',
        '.',
        '.*',
        'a*',
        'b+',
        'a?',
        'b{2}',
        'a{0,2}',
        '[ab]',
        '[^/]+',
        '[]a]',
      ],
      ...[
        '(a)',
        '(?:ab)',
        '(a|b)',
        '(a|b)*',
        '(?i)a',
        '(?i:b)',
        '^',
        '$',
        '|',
        '\\d',
        '\\.',
        '\\/',
      ],
      ...['\\b', '\\Qa\\E', '\\x61', '+?', '*?', '(a', ')', '[', '\\', '(?P<n>a)', '\\cA', '🙂'],
    );
    const sources = fc.array(piece, { maxLength: 6 }).map((pieces) => pieces.join(''));
    const texts = fc.string({
      unit: fc.constantFrom('a', 'b', '/', '.', '1', 'A', '🙂'),
      maxLength: 8,
    });
    fc.assert(
      fc.property(
        sources,
        fc.array(texts, { minLength: 5, maxLength: 20 }),
        (source, candidates) => {
          const required = requiredLiteral(source);
          if (required === undefined) return;
          let pattern;
          try {
            pattern = compiler.compile(source);
          } catch {
            return; // Never becomes a pattern.
          }
          for (const text of candidates) {
            if (!pattern.test(text)) continue;
            if (required.isPrefix) expect(text.startsWith(required.text)).toBe(true);
            else expect(text).toContain(required.text);
          }
        },
      ),
      { numRuns: 5_000 },
    );
  });
});
