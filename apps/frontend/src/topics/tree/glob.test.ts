import { globToRegExpSource } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { compileGlob } from './glob.ts';

/** The protocol's reading of the pattern, extended by the rules of the search. */
function expected(glob: string): RegExp {
  const body = globToRegExpSource(glob).slice(1, -1);
  const start = glob.startsWith('/') || glob.startsWith('**') ? '^' : '(?:^|/)';
  return new RegExp(`${start}${body}(?:/|$)`);
}

describe('compileGlob', () => {
  it.each([
    ['/mara/*/acceleration', '/mara/smart-device/acceleration', true],
    ['/mara/*', '/mara/smart-device/acceleration', true], // what lies below as well
    ['/mara/*/acceleration', '/mara/acceleration', false],
    ['/mara/**/x', '/mara/a/b/x', true],
    ['**/acceleration', '/mara/smart-device/acceleration', true],
    ['acc*', '/mara/smart-device/acceleration', true],
    ['acc*', '/mara/smart-device/linear_acceleration', false],
    ['*acc*', '/mara/smart-device/linear_acceleration', true],
    ['smart-*', '/mara/smart-device/acceleration', true],
    ['touch_?', '/mara/touch_1', true],
    ['touch_?', '/mara/touch_12', false],
    ['a?b', '/a/b', false],
    ['*.x', '/a/b.x', true],
    ['*.x', '/a/bxx', false],
    ['/*', 'mara/x', false],
  ])('%s on %s: %s', (glob, topic, selected) => {
    expect(compileGlob(glob)(topic)).toBe(selected);
  });

  it('reads globs as the protocol does', () => {
    let seed = 1;
    const random = (below: number) => {
      seed = (seed * 48271) % 2147483647;
      return seed % below;
    };
    const word = (letters: readonly string[], length: number) =>
      Array.from({ length }, () => letters[random(letters.length)]!).join('');
    for (let i = 0; i < 20_000; i++) {
      const glob = word(['a', 'b', '/', '*', '**', '?'], 1 + random(6)).replace(/\*{3,}/g, '**');
      const topic = word(['a', 'b', '/'], 1 + random(8));
      expect(`${glob} ${topic} ${compileGlob(glob)(topic)}`).toBe(
        `${glob} ${topic} ${expected(glob).test(topic)}`,
      );
    }
  });

  it('ends on patterns that send regular expressions into the woods', () => {
    const topic = `/${'a'.repeat(1000)}`;
    expect(compileGlob(`${'*a'.repeat(40)}*b`)(topic)).toBe(false);
    expect(compileGlob(`${'**a'.repeat(40)}**b`)(topic)).toBe(false);
  });
});
