import { describe, expect, it } from 'vitest';
import { createEngineBench } from '../../testing/engine-bench.ts';
import { mappingOf } from '../../testing/mapping-of.ts';
import { BRIDGE_LIMITS } from '../limits.ts';

const { quietMs, evictionsPerSecond } = BRIDGE_LIMITS;

/** A mapping of 3 topics that a flood has filled, before anything else came. */
function floodedBench() {
  const bench = createEngineBench();
  bench.engine.setMappings([mappingOf('in', 'a/+', '/a/{1}', { maxTopics: 3 })]);
  for (const name of ['flood1', 'flood2', 'flood3']) bench.receive(`a/${name}`, '1');
  return bench;
}

describe('a mapping whose addresses a flood has filled', () => {
  it('evicts the one that has been quiet longest, and ends its topic [BR-34]', () => {
    const bench = floodedBench();
    bench.clock.advanceSync(1_000);
    bench.receive('a/flood1', '2');
    bench.clock.advanceSync(quietMs);
    bench.receive('a/lamp', '5');
    expect(bench.published.slice(-2)).toEqual([
      ['/a/flood2', undefined],
      ['/a/lamp', 5],
    ]);
    expect(bench.forwarder(0, 'in')).toMatchObject({
      passed: 5,
      refused: 0,
      evicted: 1,
      topics: 3,
    });
  });

  it('keeps those that had a value in the last minute [BR-34]', () => {
    const bench = floodedBench();
    bench.clock.advanceSync(quietMs - 1);
    bench.receive('a/lamp', '5');
    expect(bench.published).toHaveLength(3);
    expect(bench.forwarder(0, 'in')).toMatchObject({ refused: 1, evicted: 0, topics: 3 });
    expect(bench.forwarder(0, 'in').lastError?.message).toBe(
      'The mapping has made 3 topics. Select fewer addresses, or raise maxTopics.',
    );
  });

  it('evicts at most so many in a second [BR-34]', () => {
    const bench = createEngineBench();
    const maxTopics = 2 * evictionsPerSecond + 1;
    bench.engine.setMappings([mappingOf('in', 'a/+', '/a/{1}', { maxTopics })]);
    for (let index = 0; index < maxTopics; index++) bench.receive(`a/slow${index}`, '1');
    bench.clock.advanceSync(quietMs);
    for (let index = 0; index < maxTopics; index++) bench.receive(`a/new${index}`, '1');
    expect(bench.forwarder(0, 'in')).toMatchObject({
      evicted: evictionsPerSecond,
      topics: maxTopics,
    });
    bench.clock.advanceSync(1_000);
    bench.receive('a/lamp', '5');
    expect(bench.published.at(-1)).toEqual(['/a/lamp', 5]);
  });

  it('keeps a topic whose newest value waits for its time [BR-31] [BR-34]', () => {
    const bench = createEngineBench();
    const mapping = mappingOf('in', 'a/+', '/a/{1}', { maxTopics: 1, maxRateHz: 0.001 });
    bench.engine.setMappings([mapping]);
    bench.receive('a/slow', '1');
    bench.receive('a/slow', '2');
    bench.clock.advanceSync(quietMs);
    bench.receive('a/lamp', '5');
    expect(bench.forwarder(0, 'in')).toMatchObject({ refused: 1, evicted: 0 });
    bench.engine.close();
  });

  it('of the other direction loses its kept value there [BR-34]', () => {
    const bench = createEngineBench();
    const mapping = mappingOf('out', 'a/{1}', '/a/*', { maxTopics: 1, retained: true });
    bench.engine.setMappings([mapping]);
    bench.record('/a/flood', 1);
    bench.clock.advanceSync(quietMs);
    bench.record('/a/lamp', 5);
    expect(bench.sent).toEqual([
      ['a/flood', '1'],
      ['a/flood', undefined],
      ['a/lamp', '5'],
    ]);
    expect(bench.forwarder(0, 'out')).toMatchObject({ evicted: 1, topics: 1 });
  });
});
