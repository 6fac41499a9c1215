import { describe, expect, it } from 'vitest';

import { DEFAULT_LIMITS } from '../../core/limits.ts';
import { patternCompilerSuite } from '../../testing/acceptance/index.ts';
import { Re2Patterns } from './re2-patterns.ts';

patternCompilerSuite('Re2Patterns', () => new Re2Patterns(DEFAULT_LIMITS.patternInstructions));

const patterns = new Re2Patterns(DEFAULT_LIMITS.patternInstructions);

describe('[TD-20] regular expressions of clients', () => {
  it.each([
    ['touch', '/a/touch/b', true],
    ['^/a/.*/touch$', '/a/b/touch', true],
    ['^/a/.*/touch$', '/a/b/touches', false],
    ['Touch', '/touch', false],
    [
      '/[0-9a-f]{8}-([0-9a-f]{4}-){3}[0-9a-f]{12}/x',
      '/01234567-89ab-cdef-0123-456789abcdef/x',
      true,
    ],
    ['\\/a\\/\\d+', '/a/12', true],
    ['(?<device>\\w+)/x', 'phone/x', true],
    ['/py/*', '/p', false],
    ['/py/*', '/py/anything', true],
    ['', 'everything', true],
    ['ä', '/bär', true],
  ])('%s against %s: %s', (source, topic, expected) => {
    expect(patterns.compile(source).test(topic)).toBe(expected);
  });

  it.each(['(?=x)', '(?<!x)y', '(a)\\1', '[', '(', 'a{1001}', '*'])(
    '[TD-21] refuses %s',
    (source) => {
      expect(() => patterns.compile(source)).toThrow(Error);
    },
  );

  it.each([
    '(?:(?:a{0,31}){0,31}b)*'.repeat(40),
    '(.*){1000}',
    '(a?){600}(b?){600}',
    '.{1000}.{1000}',
  ])('[TD-21] refuses what would cost too much: %s', (source) => {
    expect(() => patterns.compile(source)).toThrow(/too large/);
  });

  it('[TD-21] needs time linear in the topic for patterns that stall others', () => {
    // With backtracking each of these takes longer than the age of the universe.
    for (const source of [
      '^(a+)+$',
      '(a*)*b$',
      '^(a|aa)+$',
      '(x+x+)+y',
      '^(([a-z])+.)+[A-Z]([a-z])+$',
    ]) {
      expect(patterns.compile(source).test(`${'a'.repeat(1000)}!`)).toBe(false);
    }
  });
});
