import { globToRegExpSource } from '@ubii/proto';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compileGlob } from './glob.ts';
import { Re2Patterns } from './re2/index.ts';

describe('compileGlob()', () => {
  it.each([
    ['/a/*/c', '/a/b/c', true],
    ['/a/*/c', '/a/b/b/c', false],
    ['/a/*', '/a/', true],
    ['/a/**', '/a/b/c', true],
    ['/a/**/z', '/a/b/c/z', true],
    ['/a/**/z', '/a/z', false],
    ['/a/?', '/a/b', true],
    ['/a/?', '/a//', false],
    ['/a/?', '/a/🙂', true],
    ['/a', '/a/b', false],
    ['/a', '/x/a', false],
    ['/a.b', '/axb', false],
    ['***', '/a/b', true],
    ['', '', true],
    ['', 'a', false],
    ['/a(b)[c]{d}+$^|\\', '/a(b)[c]{d}+$^|\\', true],
  ])('%j on %j: %j [TD-62]', (glob, topic, expected) => {
    expect(compileGlob(glob)(topic)).toBe(expected);
  });

  it('selects what the expression for the master selects [TD-62]', () => {
    const patterns = new Re2Patterns();
    const glob = fc.array(fc.constantFrom('a', 'b', '/', '*', '**', '?', '.', '🙂'), {
      maxLength: 10,
    });
    const topic = fc.array(fc.constantFrom('a', 'b', '/', '.', '🙂'), { maxLength: 14 });
    fc.assert(
      fc.property(glob, topic, (tokens, letters) => {
        const source = tokens.join('');
        const text = letters.join('');
        const expected = patterns.compile(globToRegExpSource(source)).test(text);
        expect(compileGlob(source)(text)).toBe(expected);
      }),
      { numRuns: 2000 },
    );
  });

  it('ends with many stars, which stall others [TD-21]', () => {
    expect(compileGlob(`${'**a'.repeat(300)}b`)('a'.repeat(1000))).toBe(false);
  });
});
