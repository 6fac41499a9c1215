import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fillPath, matchPath, parseSides, toFilter, toGlob } from './address-path.ts';

function through(foreign: string, topic: string, address: string): string | undefined {
  const sides = parseSides(foreign, topic, 'in');
  const captures = matchPath(sides.foreign, address);
  return captures && fillPath(sides.topic, captures);
}

describe('patterns with placeholders [BR-3]', () => {
  it.each([
    ['sensors/+/temp', '/mqtt/{1}/temp', 'sensors/kitchen/temp', '/mqtt/kitchen/temp'],
    ['+/+/state', '/{2}/of/{1}', 'a/b/state', '/b/of/a'],
    ['zigbee/#', '/zigbee/{1}', 'zigbee/lamp/on', '/zigbee/lamp/on'],
    ['room/+', '/room-{1}-now', 'room/2', '/room-2-now'],
    ['fixed', '/fixed', 'fixed', '/fixed'],
  ])('%s -> %s: %s is %s', (foreign, topic, address, expected) => {
    expect(through(foreign, topic, address)).toBe(expected);
  });

  it.each([
    ['sensors/+/temp', 'sensors/temp'],
    ['sensors/+/temp', 'sensors/a/b/temp'],
    ['sensors/+/temp', 'sensors//temp'],
    ['zigbee/#', 'zigbee'],
    ['fixed', 'fixed/more'],
  ])('%s does not select %s', (foreign, address) => {
    expect(through(foreign, '/x', address)).toBeUndefined();
  });

  it('goes both ways', () => {
    const { foreign, topic } = parseSides('home/+/+', '/rooms/{2}/{1}', 'both');
    const captures = matchPath(topic, '/rooms/lamp/hall');
    expect(captures && fillPath(foreign, captures)).toBe('home/hall/lamp');
    expect([toFilter(foreign), toGlob(topic)]).toEqual(['home/+/+', '/rooms/*/*']);
  });

  it('takes wildcards of topics for what leaves', () => {
    const { foreign, topic } = parseSides('out/{1}', '/garden/**', 'out');
    const captures = matchPath(topic, '/garden/a/b');
    expect(captures && fillPath(foreign, captures)).toBe('out/a/b');
    expect(toGlob(topic)).toBe('/garden/**');
  });

  it.each([
    ['a/+', '/x/*', 'out', 'Both patterns have wildcards'],
    ['a/#/b', '/x/{1}', 'in', '"#" may only be the last level'],
    ['a/b+', '/x', 'in', 'mixes a wildcard with text'],
    ['a/+', '/x/{2}', 'in', 'has the placeholder {2}, but the other pattern has only 1'],
    ['a/+', '/x', 'both', '`foreign` needs {1}, which `topic` does not capture'],
    ['a/+', '/x/{1}/{1}', 'in', 'has the placeholder {1} twice'],
    ['a/#', '/x/{1}/y', 'in', 'has to be the whole last level'],
    ['a/+', '/x/{1}{1}', 'in', 'has two placeholders'],
    ['a/{x}', '/x', 'in', 'has braces'],
  ] as const)('refuses %s with %s (%s)', (foreign, topic, direction, reason) => {
    expect(() => parseSides(foreign, topic, direction)).toThrow(reason);
  });

  it('comes back to the same address, whatever is captured', () => {
    const level = fc.string({ minLength: 1 }).filter((text) => !/[/+#*?{}]/.test(text));
    const { foreign, topic } = parseSides('a/+/b/#', '/x/{2}', 'in');
    const both = parseSides('a/+/b/+', '/x/{2}/y-{1}', 'both');
    fc.assert(
      fc.property(level, level, (one, two) => {
        const address = `a/${one}/b/${two}`;
        const captures = matchPath(both.foreign, address)!;
        const back = matchPath(both.topic, fillPath(both.topic, captures))!;
        expect(fillPath(both.foreign, back)).toBe(address);
        expect(fillPath(topic, matchPath(foreign, `${address}/${one}`)!)).toBe(`/x/${two}/${one}`);
      }),
    );
  });
});
