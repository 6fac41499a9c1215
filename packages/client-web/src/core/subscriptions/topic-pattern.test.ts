import { lazyPatterns, readyPatterns } from '@ubii/patterns';
import { Re2Patterns } from '@ubii/patterns/re2';
import { describe, expect, it } from 'vitest';
import { toServerPattern } from './topic-pattern.ts';
import type { TopicPattern } from './topic-pattern.ts';

function matches(pattern: TopicPattern, topic: string): boolean {
  const server = toServerPattern(pattern, PATTERNS);
  if (server.kind !== 'regex') throw new Error('not a pattern over topics');
  return server.matcher.match?.(topic) === true;
}

const PATTERNS = readyPatterns(new Re2Patterns());

describe('toServerPattern()', () => {
  it('turns a glob into a regular expression for the master', () => {
    expect(toServerPattern({ glob: '/*/pointer/**' }, PATTERNS)).toMatchObject({
      kind: 'regex',
      source: '^/[^/]*/pointer/.*$',
    });
  });

  it('matches a glob over whole topics', () => {
    expect(matches({ glob: '/*/pointer' }, '/ada/pointer')).toBe(true);
    expect(matches({ glob: '/*/pointer' }, '/ada/x/pointer')).toBe(false);
    expect(matches({ glob: '/**' }, '/ada/x/pointer')).toBe(true);
    expect(matches({ glob: '/ada?' }, '/ada1')).toBe(true);
  });

  it('matches regular expressions unanchored [TD-20]', () => {
    expect(matches({ regex: 'point' }, '/ada/pointer')).toBe(true);
    expect(matches({ regex: /^point/ }, '/ada/pointer')).toBe(false);
  });

  it('leaves the topics of the master out unless the pattern names them [TD-26]', () => {
    expect(matches({ glob: '/**' }, '/ubii/client/1')).toBe(false);
    expect(matches({ regex: '.*' }, '/ubii/client/1')).toBe(false);
    expect(matches({ glob: '/ubii/client/*' }, '/ubii/client/1')).toBe(true);
    expect(matches({ regex: '/ubii/client' }, '/ubii/client/1')).toBe(true);
    expect(matches({ regex: /^\/ubii\/client/ }, '/ubii/client/1')).toBe(true);
  });

  it('gives equal patterns equal keys', () => {
    const key = (pattern: TopicPattern) => toServerPattern(pattern, PATTERNS).key;
    expect(key({ glob: '/a/*' })).toBe(key({ regex: '^/a/[^/]*$' }));
    expect(key({ regex: /\/a/ })).toBe(key({ regex: '/a' }));
    expect(key({ topic: '/a' })).not.toBe(key({ regex: '/a' }));
    expect(key({ component: { name: 'x', tags: ['t'] } })).toBe(
      key({ component: { tags: ['t'], name: 'x' } }),
    );
  });

  it.each<TopicPattern>([
    { topic: '' },
    { glob: '' },
    { regex: '' },
    { regex: '(' },
    { regex: /a/i },
    { topic: undefined as unknown as string },
  ])('refuses %o', (pattern) => {
    expect(() => toServerPattern(pattern, PATTERNS)).toThrow(TypeError);
  });

  it('says why the master would refuse an expression [TD-21]', () => {
    expect(() => toServerPattern({ regex: /a(?=b)/ }, PATTERNS)).toThrow('look-ahead');
  });

  it('ends with an expression that stalls others [TD-60]', () => {
    expect(matches({ regex: '(a+)+$' }, `/${'a'.repeat(1000)}!`)).toBe(false);
    expect(matches({ glob: `${'**a'.repeat(100)}b` }, `/${'a'.repeat(1000)}`)).toBe(false);
  });

  it('needs no engine for globs, and loads one for an expression [TD-64]', async () => {
    const patterns = lazyPatterns();
    const glob = toServerPattern({ glob: '/*' }, patterns);
    expect(glob).toMatchObject({ matcher: { match: expect.any(Function) } });
    const regex = toServerPattern({ regex: '^/a' }, patterns);
    expect(patterns.compiler).toBeUndefined();
    if (regex.kind !== 'regex' || regex.matcher.match !== undefined) throw new Error('at hand');
    const match = await regex.matcher.load();
    expect([match('/a'), match('/b')]).toEqual([true, false]);
  });
});
