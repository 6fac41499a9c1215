import { describe, expect, it } from 'vitest';
import { toServerPattern } from './topic-pattern.ts';
import type { TopicPattern } from './topic-pattern.ts';

function matches(pattern: TopicPattern, topic: string): boolean {
  const server = toServerPattern(pattern);
  if (server.kind !== 'regex') throw new Error('not a pattern over topics');
  return server.matches(topic);
}

describe('toServerPattern()', () => {
  it('turns a glob into a regular expression for the master', () => {
    expect(toServerPattern({ glob: '/*/pointer/**' })).toMatchObject({
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
    const key = (pattern: TopicPattern) => toServerPattern(pattern).key;
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
    expect(() => toServerPattern(pattern)).toThrow(TypeError);
  });
});
