import { describe, expect, it } from 'vitest';
import type { PatternCompiler } from '../../core/ports/pattern-compiler.ts';

/** What every pattern compiler does. */
export function patternCompilerSuite(name: string, createCompiler: () => PatternCompiler): void {
  const matches = (source: string, text: string): boolean =>
    createCompiler().compile(source).test(text);

  describe(`${name}, a PatternCompiler`, () => {
    it.each([
      ['/info/*', '/info/session/start'],
      ['b/c', '/a/b/c/d'],
      ['^/a/[^/]+/c$', '/a/b/c'],
      ['.*', '/a'],
      ['', '/a'],
      ['/(x|y)/', '/x/'],
      ['^/\\d{2}/\\w+$', '/12/abc'],
      ['^/[0-9a-f]{8}-[0-9a-f]{4}', '/0123abcd-ef01/x'],
      ['^/ä/🙂?$', '/ä/🙂'],
    ])('finds %j in %j [TD-20]', (source, text) => {
      expect(matches(source, text)).toBe(true);
    });

    it.each([
      ['^b', '/a/b'],
      ['/A', '/a'],
      ['^/a/[^/]+/c$', '/a/b/b/c'],
      ['^/a.b$', '/a/b/b'],
    ])('does not find %j in %j [TD-20]', (source, text) => {
      expect(matches(source, text)).toBe(false);
    });

    it('gives the same answer each time', () => {
      const pattern = createCompiler().compile('a');
      expect([pattern.test('/a'), pattern.test('/a'), pattern.test('/b')]).toEqual([
        true,
        true,
        false,
      ]);
    });

    it.each(['(', '[a', 'a**', '(?=a)', '(?<!a)b', '(a)\\1', '\\', '*a'])(
      'refuses %j with a reason [TD-21]',
      (source) => {
        expect(() => createCompiler().compile(source)).toThrow(/\S/);
      },
    );
  });
}
