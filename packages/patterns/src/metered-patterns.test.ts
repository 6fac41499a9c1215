import { describe, expect, it } from 'vitest';
import { MeteredPatterns } from './metered-patterns.ts';
import type { PatternCompiler } from './pattern-compiler.ts';
import { Re2Patterns } from './re2/index.ts';
import { MatchBudgetError } from './remembered.ts';
import { patternCompilerSuite } from './testing/index.ts';

const endless = { spend: () => true };

patternCompilerSuite(
  'MeteredPatterns',
  () => new MeteredPatterns(new Re2Patterns(), { budget: endless, monotonicMs: () => 0 }),
);

/** A compiler whose every match takes `stepMs`, with a budget of so many milliseconds. */
function setup({ stepMs = 1, budgetMs = Infinity, maxTexts = 100 } = {}) {
  const world = { nowMs: 0, leftMs: budgetMs, asked: [] as string[] };
  const slow: PatternCompiler = {
    compile: () => {
      const ask = (text: string) => {
        world.asked.push(text);
        world.nowMs += stepMs;
        return true;
      };
      return { test: ask, match: (text) => (ask(text) ? [text] : undefined) };
    },
  };
  const budget = { spend: (amountMs: number) => (world.leftMs -= amountMs) > 0 };
  const patterns = new MeteredPatterns(slow, {
    budget,
    monotonicMs: () => world.nowMs,
    maxTexts,
  });
  return { world, pattern: patterns.compile('x') };
}

describe('MeteredPatterns', () => {
  it('matches a text once [TD-63]', () => {
    const { world, pattern } = setup();
    for (const text of ['/a', '/b', '/a', '/a']) pattern.match(text);
    for (const text of ['/a', '/a']) pattern.test(text);
    expect(world.asked).toEqual(['/a', '/b', '/a']);
    expect(pattern.match('/b')).toEqual(['/b']);
  });

  it('remembers that a text does not match [TD-63]', () => {
    let asked = 0;
    const never: PatternCompiler = {
      compile: () => ({ test: () => false, match: () => void (asked += 1) as undefined }),
    };
    const pattern = new MeteredPatterns(never, { budget: endless, monotonicMs: () => 0 }).compile(
      'x',
    );
    expect([pattern.match('/a'), pattern.match('/a')]).toEqual([undefined, undefined]);
    expect(asked).toBe(1);
  });

  it('is one pattern for one source', () => {
    const patterns = new MeteredPatterns(new Re2Patterns(), {
      budget: endless,
      monotonicMs: () => 0,
    });
    expect(patterns.compile('a')).toBe(patterns.compile('a'));
    expect(patterns.compile('a')).not.toBe(patterns.compile('b'));
    expect(patterns.compileGlob('/*')).toBe(patterns.compileGlob('/*'));
    expect(patterns.compileGlob('/*')('/a')).toBe(true);
  });

  it('forgets the oldest text at its limit', () => {
    const { world, pattern } = setup({ maxTexts: 2 });
    for (const text of ['/a', '/b', '/c', '/b', '/a']) pattern.test(text);
    expect(world.asked).toEqual(['/a', '/b', '/c', '/a']);
  });

  it('stops when the budget is spent, says so, and goes on when there is some again [TD-63]', () => {
    const { world, pattern } = setup({ stepMs: 10, budgetMs: 15 });
    pattern.test('/a');
    pattern.test('/b');
    expect(() => pattern.test('/c')).toThrow(MatchBudgetError);
    expect(() => pattern.match('/c')).toThrow('matching "x" takes too long');
    expect(pattern.test('/a')).toBe(true);
    expect(world.asked).toEqual(['/a', '/b']);
    world.leftMs = 1;
    expect(pattern.test('/c')).toBe(true);
  });

  it('charges no more than the worst match takes, whatever the clock says', () => {
    const { world, pattern } = setup({ stepMs: 5_000, budgetMs: 100 });
    pattern.test('/a');
    expect(world.leftMs).toBe(70);
  });
});
