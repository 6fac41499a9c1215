import { describe, expect, it } from 'vitest';
import { createEngineBench } from '../../testing/engine-bench.ts';
import { mappingOf } from '../../testing/mapping-of.ts';
import type { Mapping } from '../mapping/mapping.ts';
import { BRIDGE_LIMITS } from '../limits.ts';

const inMapping = mappingOf('in', 'sensors/+/temp', '/mqtt/{1}/temp');
const outMapping = mappingOf('out', 'out/{1}', '/garden/*');
const both = mappingOf('both', 'home/+', '/home/{1}', { retained: true });

describe('a bridge between a master and another system', () => {
  it('passes values in both directions, each to its address [BR-2]', () => {
    const bench = createEngineBench();
    bench.engine.setMappings([inMapping, outMapping]);
    expect(bench.patterns()).toEqual([{ glob: '/garden/*' }]);
    bench.receive('sensors/kitchen/temp', '21.5');
    bench.receive('sensors/kitchen/humidity', '3');
    bench.record('/garden/wind', 4);
    expect(bench.published).toEqual([['/mqtt/kitchen/temp', 21.5]]);
    expect(bench.sent).toEqual([['out/wind', '4']]);
    expect(bench.forwarder(0, 'in')).toMatchObject({
      passed: 1,
      refused: 0,
      dropped: 0,
      topics: 1,
      lastValue: { address: '/mqtt/kitchen/temp', text: '21.5' },
    });
  });

  it('counts what is refused, with the reason [BR-33]', () => {
    const bench = createEngineBench();
    bench.engine.setMappings([inMapping, outMapping]);
    bench.receive('sensors/kitchen/temp', 'warm');
    bench.record('/garden/wind', 'strong', 'ada', 'string');
    expect(bench.forwarder(0, 'in')).toMatchObject({
      passed: 0,
      refused: 1,
      lastError: { address: 'sensors/kitchen/temp' },
    });
    expect(bench.forwarder(0, 'in').lastError?.message).toContain('is not JSON');
    expect(bench.forwarder(1, 'out').lastError?.message).toBe('Expected double, got string.');
    bench.answer.sent = { kind: 'dropped', reason: 'The broker is not connected.' };
    bench.record('/garden/wind', 4);
    expect(bench.forwarder(1, 'out')).toMatchObject({ passed: 0, refused: 1, dropped: 1 });
  });

  it('refuses topics of the master, wildcards in addresses, and what is too long [BR-30]', () => {
    const bench = createEngineBench();
    bench.engine.setMappings([mappingOf('in', '#', '{1}'), outMapping]);
    bench.receive('ubii/client/x', '1');
    bench.receive('info/x', '1');
    bench.receive(`a/${'b'.repeat(BRIDGE_LIMITS.addressBytes)}`, '1');
    bench.record('/garden/+', 1);
    bench.record('/garden/#', 1);
    expect(bench.published).toEqual([]);
    expect(bench.sent).toEqual([]);
    expect([bench.forwarder(0, 'in').refused, bench.forwarder(1, 'out').refused]).toEqual([3, 2]);
  });

  it('bounds topics, sizes and the rate of what comes [BR-30]', () => {
    const bench = createEngineBench();
    bench.engine.setMappings([mappingOf('in', 'a/+', '/a/{1}', { maxTopics: 2, maxBytes: 3 })]);
    for (const name of ['x', 'y', 'z', 'x']) bench.receive(`a/${name}`, '1');
    bench.receive('a/x', '1234');
    expect(bench.published.map(([topic]) => topic)).toEqual(['/a/x', '/a/y', '/a/x']);
    expect(bench.forwarder(0, 'in')).toMatchObject({ passed: 3, refused: 2, topics: 2 });
    for (let index = 0; index < BRIDGE_LIMITS.messagesPerSecond; index++) {
      bench.receive('a/x', '1');
    }
    expect(bench.engine.report().overRate).toBe(5);
    bench.clock.advanceSync(1_000);
    bench.receive('a/x', '2');
    expect(bench.published.at(-1)).toEqual(['/a/x', 2]);
  });

  it('samples each topic, and never withholds the newest value [BR-31]', () => {
    const bench = createEngineBench();
    bench.engine.setMappings([mappingOf('in', 'a/+', '/a/{1}', { maxRateHz: 10 })]);
    for (const value of [1, 2, 3]) bench.receive('a/x', String(value));
    bench.receive('a/y', '9');
    expect(bench.published).toEqual([
      ['/a/x', 1],
      ['/a/y', 9],
    ]);
    bench.clock.advanceSync(100);
    expect(bench.published.at(-1)).toEqual(['/a/x', 3]);
    expect(bench.forwarder(0, 'in')).toMatchObject({ passed: 3, dropped: 1 });
    bench.receive('a/x', '4');
    bench.engine.close();
    expect(bench.clock.timerCount).toBe(0);
  });

  it('sends nothing back to where it came from [BR-20] [BR-21] [BR-22]', () => {
    const bench = createEngineBench();
    bench.engine.setMappings([both]);
    bench.record('/home/lamp', 1, 'bridge');
    const add = (id: string, system: string, isGone = false) =>
      bench.bridges.handleClient({
        id,
        tags: [`bridge to ${system}`],
        isGone,
        isConnected: !isGone,
        masterId: undefined,
      });
    add('other', 'the broker');
    add('third', 'elsewhere');
    bench.record('/home/lamp', 2, 'other');
    bench.receive('home/lamp', '3', { isOurs: true });
    expect([bench.sent, bench.published]).toEqual([[], []]);
    expect([bench.forwarder(0, 'out').returned, bench.forwarder(0, 'in').returned]).toEqual([2, 1]);
    bench.record('/home/lamp', 4, 'third');
    add('other', 'the broker', true);
    bench.record('/home/lamp', 5, 'other');
    expect(bench.sent.map(([, text]) => text)).toEqual(['4', '5']);
  });

  it('finds what a system without marks sends back, once for each message [BR-23]', () => {
    const bench = createEngineBench({ returnsMessages: true });
    bench.engine.setMappings([mappingOf('both', 'home/+', '/home/{1}')]);
    bench.record('/home/lamp', 1);
    bench.receive('home/lamp', '1');
    expect(bench.published).toEqual([]);
    bench.receive('home/lamp', '1');
    expect(bench.published).toEqual([['/home/lamp', 1]]);
    bench.record('/home/lamp', 2);
    bench.clock.advanceSync(BRIDGE_LIMITS.echoMs + 1);
    bench.receive('home/lamp', '2');
    expect(bench.published.at(-1)).toEqual(['/home/lamp', 2]);
  });

  it('finds what comes back in single precision [BR-23]', () => {
    const bench = createEngineBench({ returnsMessages: true });
    bench.engine.setMappings([mappingOf('both', 'home/+', '/home/{1}')]);
    bench.record('/home/lamp', 0.1);
    bench.receive('home/lamp', String(Math.fround(0.1)));
    expect(bench.published).toEqual([]);
    expect(bench.forwarder(0, 'in').returned).toBe(1);
  });

  it('a newer value of one side takes the place of one that waits for it [BR-31]', () => {
    const bench = createEngineBench();
    bench.engine.setMappings([{ ...both, maxRateHz: 1 }]);
    bench.record('/home/lamp', 1);
    bench.record('/home/lamp', 2);
    bench.receive('home/lamp', '3');
    bench.clock.advanceSync(2_000);
    expect(bench.sent).toEqual([['home/lamp', '1']]);
    expect(bench.published).toEqual([['/home/lamp', 3]]);
  });

  describe('where both sides have a value when the bridge comes [BR-14]', () => {
    const start = () => {
      const bench = createEngineBench({ isSettled: false });
      bench.engine.setMappings([both, outMapping]);
      return bench;
    };
    const kept = { isKept: true };

    it.each([
      ['before', false],
      ['after', true],
    ])('the kept message counts, also when it comes %s the record', (_name, isLater) => {
      const bench = start();
      if (!isLater) bench.receive('home/lamp', '1', kept);
      bench.record('/home/lamp', 2);
      if (isLater) bench.receive('home/lamp', '1', kept);
      bench.record('/garden/wind', 3);
      bench.engine.handleSettled();
      expect(bench.published).toEqual([['/home/lamp', 1]]);
      expect(bench.sent).toEqual([['out/wind', '3']]);
      // What is set from then on leaves.
      bench.record('/home/lamp', 4, 'ada', 'double', bench.clock.nowMs() + 1);
      expect(bench.sent.at(-1)).toEqual(['home/lamp', '4']);
    });

    it('what the master had before may come late, and does not leave', () => {
      const bench = start();
      bench.receive('home/lamp', '1', kept);
      bench.receive('home/fan', '1', kept);
      bench.engine.handleSettled();
      bench.record('/home/lamp', 2, 'ada', 'double', bench.clock.nowMs() - 1);
      expect(bench.sent).toEqual([]);
      expect(bench.forwarder(0, 'out').returned).toBe(1);
      // Only the first record can be that, and only soon.
      bench.record('/home/lamp', 3, 'ada', 'double', bench.clock.nowMs() - 1);
      bench.clock.advanceSync(10_001);
      bench.record('/home/fan', 4);
      expect(bench.sent).toEqual([
        ['home/lamp', '3'],
        ['home/fan', '4'],
      ]);
    });

    it('a record without a time leaves when the master has taken the kept message before it', () => {
      const bench = start();
      bench.receive('home/lamp', '1', kept);
      bench.receive('home/fan', '1', kept);
      bench.engine.handleSettled();
      // The master sends in the order in which records were published: first what it had, then ours, then what is new.
      bench.record('/home/lamp', 1, 'bridge');
      bench.record('/home/lamp', 2);
      bench.record('/home/fan', 2);
      bench.record('/home/fan', 1, 'bridge');
      expect(bench.sent).toEqual([['home/lamp', '2']]);
      expect(bench.forwarder(0, 'out').returned).toBe(3);
    });

    it('the record counts where nothing is kept, or what another run of a bridge here has sent', () => {
      const bench = start();
      bench.record('/home/lamp', 1);
      bench.record('/home/lamp', 2);
      bench.record('/home/fan', 3);
      bench.receive('home/fan', '9', { ...kept, isOurs: true });
      expect(bench.sent).toEqual([]);
      bench.engine.handleSettled();
      expect(bench.sent).toEqual([
        ['home/lamp', '2'],
        ['home/fan', '3'],
      ]);
      expect(bench.published).toEqual([]);
      // What was kept and comes too late is older than what left.
      bench.receive('home/lamp', '1', kept);
      expect(bench.published).toEqual([]);
    });

    it('the newer one counts where both say their time', () => {
      const bench = start();
      const atMs = bench.clock.nowMs();
      bench.record('/home/lamp', 1, 'ada', 'double', atMs);
      bench.record('/home/fan', 1, 'ada', 'double', atMs);
      bench.receive('home/lamp', '5', { ...kept, timestampMs: atMs - 1 });
      bench.receive('home/fan', '5', { ...kept, timestampMs: atMs + 1 });
      bench.engine.handleSettled();
      expect(bench.published).toEqual([['/home/fan', 5]]);
      expect(bench.sent).toEqual([['home/lamp', '1']]);
    });

    it('after an outage, a kept message that was taken before is no news', () => {
      const bench = start();
      bench.receive('home/lamp', '1', kept);
      bench.receive('home/fan', '1', kept);
      bench.engine.handleSettled();
      bench.engine.handleState({ status: 'waiting', reason: 'outage' });
      bench.clock.advanceSync(60_000);
      bench.record('/home/lamp', 2);
      bench.record('/home/fan', 2);
      bench.receive('home/lamp', '1', kept);
      bench.receive('home/fan', '7', kept);
      bench.engine.handleSettled();
      expect(bench.sent).toEqual([['home/lamp', '2']]);
      expect(bench.published.slice(2)).toEqual([['/home/fan', 7]]);
    });
  });

  it('ends a retained value on the other side, and only its own [BR-13]', () => {
    const bench = createEngineBench();
    bench.engine.setMappings([both, mappingOf('out', 'moment/{1}', '/moment/*')]);
    bench.record('/home/lamp', 1);
    bench.record('/moment/x', 1);
    bench.gone('/home/lamp');
    bench.gone('/moment/x');
    expect(bench.sent.slice(2)).toEqual([['home/lamp', undefined]]);
    bench.receive('home/fan', '1');
    bench.gone('/home/fan');
    bench.receive('home/fan', '');
    expect(bench.published).toEqual([
      ['/home/fan', 1],
      ['/home/fan', undefined],
    ]);
    expect(bench.sent).toHaveLength(3);
  });

  it('asks again for what a system is to keep that has lost it [BR-15]', () => {
    const bench = createEngineBench();
    bench.engine.setMappings([outMapping, both]);
    const [moment, kept] = bench.subscriptions();
    bench.engine.handleState({ status: 'connected', hasForgotten: false });
    expect(bench.subscriptions()).toEqual([moment, kept]);
    bench.engine.handleState({ status: 'connected', hasForgotten: true });
    const [same, again, ...rest] = bench.subscriptions();
    expect([same === moment, again === kept, rest]).toEqual([true, false, []]);
    bench.record('/home/lamp', 1);
    expect(bench.sent).toEqual([['home/lamp', '1']]);
    bench.engine.setMappings([]);
    expect(bench.subscriptions()).toEqual([]);
  });

  it('goes on counting when the mappings change, and ends what they do not say any more [BR-4]', () => {
    const bench = createEngineBench();
    bench.engine.setMappings([inMapping, outMapping]);
    bench.receive('sensors/kitchen/temp', '1');
    bench.engine.setMappings([{ ...inMapping, maxRateHz: 1 }]);
    bench.receive('sensors/kitchen/temp', '2');
    bench.record('/garden/wind', 4);
    expect(bench.forwarder(0, 'in').passed).toBe(2);
    expect([bench.sent, bench.patterns()]).toEqual([[], []]);
  });

  it('leaves alone what does not change: no value is sent again [BR-4]', () => {
    const bench = createEngineBench();
    const copyOf = (mapping: Mapping): Mapping => structuredClone(mapping);
    bench.engine.setMappings([outMapping, { ...both, maxRateHz: 1 }]);
    bench.record('/garden/door', 1);
    bench.record('/home/lamp', 1);
    bench.record('/home/lamp', 2);
    const [first] = bench.subscriptions();
    bench.engine.setMappings([copyOf({ ...both, maxRateHz: 1 }), copyOf(outMapping), inMapping]);
    expect(bench.subscriptions()).toContain(first);
    expect(bench.subscriptions()).toHaveLength(2);
    expect(bench.engine.report().mappings.map(({ name }) => name)).toEqual(
      [both, outMapping, inMapping].map(({ name }) => name),
    );
    // What waits for its time still does.
    bench.clock.advanceSync(1_000);
    expect(bench.sent.at(-1)).toEqual(['home/lamp', '2']);
    bench.engine.setMappings([{ ...outMapping, maxRateHz: 5 }]);
    expect(bench.subscriptions()).toHaveLength(1);
    expect(bench.subscriptions()).not.toContain(first);
    expect(bench.forwarder(0, 'out').passed).toBe(1);
  });

  it('counts what waited for the connection and was dropped [BR-32]', () => {
    const bench = createEngineBench();
    bench.engine.setMappings([outMapping]);
    bench.engine.handleDropped(outMapping, 'Too many messages wait for the connection.');
    bench.engine.handleRefused('no packet');
    expect(bench.forwarder(0, 'out').dropped).toBe(1);
    expect(bench.engine.report()).toMatchObject({ refused: 1, lastRefusal: 'no packet' });
  });
});
