import { describe, expect, it } from 'vitest';
import {
  DEFAULT_PATTERN_LIMITS,
  type CompiledPattern,
  type PatternCompiler,
} from '../pattern-compiler.ts';
import { MATCHES, REFUSED, SLOW_ELSEWHERE, TOO_LARGE } from './pattern-table.ts';

/** Acceptance tests of pattern compilers, with the default limits. */
export function patternCompilerSuite(
  name: string,
  createCompiler: () => PatternCompiler | Promise<PatternCompiler>,
): void {
  const compile = async (source: string): Promise<CompiledPattern> =>
    (await createCompiler()).compile(source);

  describe(`${name}, a PatternCompiler`, () => {
    it.each(MATCHES)('finds %j in %j: %j [TD-20] [TD-60]', async (source, text, match) => {
      const pattern = await compile(source);
      expect(pattern.match(text)).toEqual(match);
      expect(pattern.test(text)).toBe(match !== undefined);
    });

    it('gives the same answer each time', async () => {
      const pattern = await compile('a');
      const texts = ['/a', '/a', '/b', '/a'];
      expect(texts.map((text) => pattern.test(text))).toEqual([true, true, false, true]);
      expect(texts.map((text) => pattern.match(text)?.[0])).toEqual(['a', 'a', undefined, 'a']);
    });

    it.each(REFUSED)('refuses %j with a reason [TD-21]', async (source, reason) => {
      await expect(compile(source)).rejects.toThrow(reason);
    });

    it.each(TOO_LARGE)('refuses what would cost too much: %s [TD-21]', async (source) => {
      await expect(compile(source)).rejects.toThrow(/too large/);
    });

    it('refuses what is too long [TD-61]', async () => {
      const { length } = DEFAULT_PATTERN_LIMITS;
      await expect(compile(`[${'a'.repeat(length - 2)}]`)).resolves.toBeDefined();
      await expect(compile(`[${'a'.repeat(length - 1)}]`)).rejects.toThrow(/more than 1024/);
    });

    it.each(SLOW_ELSEWHERE)('ends with %j, which stalls others [TD-21]', async (source) => {
      const pattern = await compile(source);
      const text = `${'a'.repeat(1000)}!`;
      expect(pattern.test(text)).toBe(false);
      expect(pattern.match(text)).toBeUndefined();
    });
  });
}
