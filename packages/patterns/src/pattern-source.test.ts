import { describe, expect, it } from 'vitest';
import { compilerOf, LazyPatterns, lazyPatterns, readyPatterns } from './pattern-source.ts';
import { Re2Patterns } from './re2/index.ts';

describe('lazyPatterns()', () => {
  it('has no compiler before it is loaded, and then always the same', async () => {
    const source = lazyPatterns();
    expect(source.compiler).toBeUndefined();
    expect(() => compilerOf(source).compile('a')).toThrow('not loaded yet');
    const [first, second] = await Promise.all([source.load(), source.load()]);
    expect(second).toBe(first);
    expect(source.compiler).toBe(first);
    expect(compilerOf(source).compile('a').test('a')).toBe(true);
  });
});

describe('LazyPatterns', () => {
  it('tries again after it failed', async () => {
    let attempts = 0;
    const source = new LazyPatterns(() => {
      attempts += 1;
      return attempts === 1 ? Promise.reject(new Error('no network')) : Promise.resolve(patterns);
    });
    const patterns = new Re2Patterns();
    await expect(source.load()).rejects.toThrow('no network');
    await expect(source.load()).resolves.toBe(patterns);
  });
});

describe('readyPatterns()', () => {
  it('has its compiler from the start', async () => {
    const patterns = new Re2Patterns();
    const source = readyPatterns(patterns);
    expect(source.compiler).toBe(patterns);
    await expect(source.load()).resolves.toBe(patterns);
  });
});
