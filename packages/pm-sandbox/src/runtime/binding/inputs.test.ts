import { decodeRecord, encodeRecord, ModuleEventKind } from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { SandboxRecord } from '../../ports/sandbox.ts';
import { EMPTY_RESULT, inputValues } from '../../testing/fake-sandboxes.ts';
import { createModuleWorld, ioMapping, type ModuleSketch } from '../../testing/module-world.ts';
import { MuxList } from './mux-slot.ts';
import { SessionPatterns } from './session-patterns.ts';

const ON_INPUT = { triggerOnInput: { minDelayMs: 0, allInputsNeedUpdate: false } };
const UUID_A = '6a2e3f80-1111-4aaa-8bbb-0123456789ab';
const UUID_B = '7B2E3F80-2222-4AAA-9BBB-0123456789AB';

/** A world in which every run ends at once. */
function createWorld(limits = {}, parts: Parameters<typeof createModuleWorld>[2] = {}) {
  const world = createModuleWorld(limits, [], parts);
  world.sandboxes.onRun = () => EMPTY_RESULT;
  const values = () => inputValues(world.sandboxes.last.lastCall);
  return { ...world, values };
}

const oneInput = (from: object | string, format = 'double'): ModuleSketch => ({
  mode: ON_INPUT,
  inputs: { x: format },
  from: { x: from },
});

describe('an input mapped to a topic', () => {
  it('[PM-30] holds the newest record as a whole', async () => {
    const world = createWorld();
    await world.begin(oneInput('/x', 'vector2'));
    world.topics.put('/x', 'vector2', { x: 1, y: 2 });
    await world.clock.endTurn();
    const input = world.sandboxes.last.lastCall?.inputs[0];
    const bytes = input && 'record' in input ? input.record?.bytes : undefined;
    expect(bytes && decodeRecord(bytes)).toMatchObject({ topic: '/x', value: { x: 1, y: 2 } });
  });

  it('[PM-30] holds nothing after the value was deleted', async () => {
    const world = createWorld();
    await world.begin({ ...oneInput('/x'), mode: { frequency: { hertz: 10 } } });
    world.topics.put('/x', 'double', 1);
    await world.clock.advance(100);
    expect(world.values()).toEqual({ x: 1 });
    world.topics.delete('/x');
    await world.clock.advance(100);
    expect(world.values()).toEqual({ x: undefined });
  });

  it('[PM-31] keeps the newest record that fits, and reports others once', async () => {
    const world = createWorld();
    await world.begin(oneInput('/x', 'vector2'));
    world.topics.put('/x', 'vector2', { x: 1, y: 2 });
    await world.clock.endTurn();
    for (let i = 0; i < 3; i++) {
      world.topics.put('/x', 'string', 'no');
      world.topics.putEmpty('/x');
      await world.clock.advance(2000);
    }
    expect(world.sandboxes.last.calls).toHaveLength(1);
    expect(world.values()).toEqual({ x: { x: 1, y: 2 } });
    expect(world.events).toMatchObject([
      {
        kind: ModuleEventKind.ERROR,
        message:
          'Input "x": a record on /x was left out: it has string, but the input expects vector2.',
      },
    ]);
  });

  it('[PM-31] takes numbers of any format where a number is declared', async () => {
    const world = createWorld();
    await world.begin(oneInput('/x', 'int32'));
    for (const format of ['double', 'float', 'int32'] as const) {
      world.topics.put('/x', format, 4);
      await world.clock.endTurn();
      expect(world.values()).toEqual({ x: 4 });
    }
    expect(world.events).toEqual([]);
  });

  it('[PM-3] takes any record when its data format is unknown', async () => {
    const world = createWorld();
    await world.begin(oneInput('/x', 'whatever.this.is'));
    world.topics.put('/x', 'string', 'yes');
    await world.clock.endTurn();
    expect(world.values()).toEqual({ x: 'yes' });
  });

  it('hands the same objects again while nothing changes', async () => {
    const world = createWorld();
    await world.begin({ ...oneInput('/x'), mode: { frequency: { hertz: 10 } } });
    world.topics.put('/x', 'double', 1);
    await world.clock.advance(200);
    const [, second, third] = world.sandboxes.last.calls;
    expect(second?.inputs[0]).toBe(third?.inputs[0]);
  });

  it('never gives away a buffer it needs again', async () => {
    const world = createWorld();
    const bytes = encodeRecord({ topic: '/x', format: 'double', value: 1 });
    world.topics.subscribe = (_selector, listener) => {
      listener.onRecord({ topic: '/x', bytes, valueField: 3, publisherId: 'c', isOwned: true });
      return () => {};
    };
    await world.begin(oneInput('/x'));
    const input = world.sandboxes.last.lastCall?.inputs[0];
    expect(input).toEqual({ name: 'x', record: { bytes } });
  });
});

describe('an input with a default', () => {
  const sketch: ModuleSketch = {
    mode: { frequency: { hertz: 10 } },
    inputs: { x: 'double', gain: 'double' },
    from: { x: '/x' },
    defaults: { x: '{"double":1}', gain: '{"double":2}' },
  };

  it('[PM-5] has it while nothing is connected, and until the first record', async () => {
    const world = createWorld();
    await world.begin(sketch);
    expect(world.values()).toEqual({ x: 1, gain: 2 });
    world.topics.put('/x', 'double', 5);
    await world.clock.advance(100);
    expect(world.values()).toEqual({ x: 5, gain: 2 });
    world.runtime.remap(
      'pm-1',
      ioMapping({ ...sketch, from: { gain: { constant: { double: 7 } } } }),
    );
    await world.clock.advance(100);
    expect(world.values()).toEqual({ x: 1, gain: 7 });
  });

  it('[PM-5] is triggered by records only', async () => {
    const world = createWorld();
    await world.begin({ ...sketch, mode: ON_INPUT });
    await world.clock.advance(100);
    expect(world.sandboxes.last.calls).toHaveLength(0);
    world.topics.put('/x', 'double', 5);
    await world.clock.endTurn();
    expect(world.values()).toEqual({ x: 5, gain: 2 });
  });

  it('[PM-5] has none when it is none of its format, which is reported', async () => {
    const world = createWorld();
    await world.begin({ ...sketch, defaults: { gain: '{"string":"much"}' } });
    expect(world.values()).toEqual({ x: undefined });
    expect(world.events).toMatchObject([
      { message: 'Input "gain": the default is string, but the input expects double.' },
    ]);
  });
});

describe('an input mapped to a constant', () => {
  it('[PM-34] has it from the start', async () => {
    const world = createWorld();
    await world.begin(oneInput({ constant: { vector2: { x: 1 } } }, 'vector2'));
    expect(world.values()).toEqual({ x: { x: 1, y: 0 } });
  });

  it.each([
    [{ vector2: { x: 'far' } }, /cannot be read/],
    [{ vector3: { x: 1 } }, /is vector3, but the input expects vector2/],
    [{ nonsense: 1 }, /no member of a data format/],
    [5, /must be an object/],
  ])(
    '[PM-34] is empty when %j is none of its format, which is reported',
    async (constant, message) => {
      const world = createWorld();
      await world.begin({
        ...oneInput({ constant }, 'vector2'),
        mode: { frequency: { hertz: 10 } },
      });
      expect(world.values()).toEqual({ x: undefined });
      expect(world.events).toMatchObject([{ message: expect.stringMatching(message) }]);
    },
  );
});

describe('an input mapped to a muxer', () => {
  it('[PM-40] [PM-41] lists the newest record of each topic, in order of first appearance', async () => {
    const world = createWorld();
    await world.begin(oneInput({ topicSelector: '/p[0-9]/x' }));
    for (const [topic, value] of [
      ['/p2/x', 1],
      ['/p1/x', 2],
      ['/p2/x', 3],
      ['/p/x', 4],
    ] as const) {
      world.topics.put(topic, 'double', value, topic);
    }
    await world.clock.endTurn();
    expect(world.values()).toEqual({
      x: [
        ['/p2/x', 3],
        ['/p1/x', 2],
      ],
    });
  });

  it('[PM-40] is an empty list when there is nothing', async () => {
    const world = createWorld();
    await world.begin({ ...oneInput({ topicGlob: '/*' }), mode: { frequency: { hertz: 10 } } });
    expect(world.sandboxes.last.lastCall?.inputs).toEqual([{ name: 'x', elements: [] }]);
  });

  it('[PM-41] prefers a glob to an expression, and a profile to both', async () => {
    const world = createWorld();
    await world.begin(oneInput({ topicGlob: '/g/*', topicSelector: '/r/' }));
    world.topics.put('/r/1', 'double', 1);
    world.topics.put('/g/1', 'double', 2, 'ada');
    await world.clock.endTurn();
    expect(world.values()).toEqual({ x: [['ada', 2]] });
    const device = { clientId: 'ada', deviceId: 'd1', deviceName: 'pad' };
    const topic = world.topics.addComponent({ ...device, name: 'x', format: 'double' });
    await world.begin({
      ...oneInput({ topicGlob: '/g/*', topicSelector: '/r/', component: { name: 'x' } }),
      id: 'pm-2',
    });
    world.topics.put(topic, 'double', 3, 'ada');
    await world.clock.endTurn();
    expect(inputValues(world.sandboxes.of('pm-2').lastCall)).toEqual({ x: [['ada', 3]] });
  });

  it.each([
    ['int32', 'double', ['i']],
    ['ubii.dataStructure.Vector2', 'double', ['v']],
    ['', 'double', ['d', 'i']],
    ['', '', ['d', 'i', 's', 'v']],
  ])(
    '[PM-42] with data type "%s" and input "%s" lets through %j',
    async (dataType, format, ids) => {
      const world = createWorld();
      const mux = { topicGlob: '/*', dataType, identitySource: 'MUX_IDENTITY_CLIENT_ID' };
      await world.begin(oneInput(mux, format));
      world.topics.put('/d', 'double', 1, 'd');
      world.topics.put('/i', 'int32', 1, 'i');
      world.topics.put('/s', 'string', 's', 's');
      world.topics.put('/v', 'vector2', { x: 1, y: 1 }, 'v');
      await world.clock.endTurn();
      expect((world.values().x as [string][]).map(([id]) => id)).toEqual(ids);
      expect(world.events).toEqual([]);
    },
  );

  it('[PM-49] says when each record came, also of those that a later run gets', async () => {
    const world = createWorld();
    const startMs = world.clock.nowMs();
    world.topics.put('/a', 'double', 1, 'a');
    await world.begin(oneInput({ topicGlob: '/*' }));
    await world.clock.advance(40);
    world.topics.put('/b', 'double', 2, 'b');
    await world.clock.endTurn();
    await world.clock.advance(300);
    world.topics.put('/a', 'double', 3, 'a');
    await world.clock.endTurn();
    const received = world.sandboxes.last.calls.map(({ inputs: [input] }) =>
      (input as { elements: readonly SandboxRecord[] }).elements.map(
        ({ receivedAtMs }) => receivedAtMs! - startMs,
      ),
    );
    expect(received).toEqual([[0], [0, 40], [340, 40]]);
    expect(world.sandboxes.last.lastCall!.masterTimeMs).toBe(startMs + 340);
  });

  it('[PM-44] forgets topics whose value is deleted; they come back at the end', async () => {
    const world = createWorld();
    world.topics.put('/a', 'double', 1, 'a');
    world.topics.put('/b', 'double', 2, 'b');
    await world.begin(oneInput({ topicGlob: '/*' }));
    world.topics.delete('/a');
    world.topics.put('/b', 'double', 3, 'b');
    await world.clock.endTurn();
    world.topics.put('/a', 'double', 4, 'a');
    await world.clock.endTurn();
    expect(world.sandboxes.last.calls.map(inputValues)).toEqual([
      {
        x: [
          ['a', 1],
          ['b', 2],
        ],
      },
      { x: [['b', 3]] },
      {
        x: [
          ['b', 3],
          ['a', 4],
        ],
      },
    ]);
  });

  it('[PM-44] lists so many topics at most, and reports that there are more', async () => {
    const world = createWorld({ maxMuxElements: 2 });
    await world.begin(oneInput({ topicGlob: '/*' }));
    for (const topic of ['/a', '/b', '/c', '/d']) world.topics.put(topic, 'double', 1);
    world.topics.put('/a', 'double', 2);
    await world.clock.advance(1000);
    expect(world.values().x).toHaveLength(2);
    const message = 'Input "x": more than 2 topics match; the others are left out.';
    expect(world.events).toMatchObject([{ message, suppressed: 0 }, { message }]);
  });

  it('[PM-71] leaves topics out while matching took too long, and takes them with their next record', async () => {
    let spentMs = 0;
    const clock = new (class extends FakeClock {
      override monotonicMs(): number {
        return super.monotonicMs() + spentMs;
      }
    })();
    const match = (text: string): string[] => {
      spentMs += 5;
      return [text];
    };
    const slow = { compile: () => ({ test: () => true, match }) };
    const limits = { patternMatchMs: 5, patternMatchMsPerSecond: 1 };
    const world = createWorld(limits, { clock, patterns: slow });
    await world.begin(oneInput({ topicGlob: '/*', identityMatchPattern: '[a-z]$' }));
    for (const topic of ['/a', '/b']) world.topics.put(topic, 'double', 1);
    await world.clock.endTurn();
    expect(world.values()).toEqual({ x: [['/a', 1]] });
    const message = 'Input "x": matching "[a-z]$" takes too long; topics are left out.';
    expect(world.events).toMatchObject([{ message }]);
    await world.clock.advance(1000);
    world.topics.put('/b', 'double', 2);
    await world.clock.endTurn();
    expect(world.values()).toEqual({
      x: [
        ['/a', 1],
        ['/b', 2],
      ],
    });
  });

  it('[PM-71] has a budget for each session, so that none spends that of another', async () => {
    const limits = { patternMatchMs: 1, patternMatchMsPerSecond: 0 };
    let nowMs = 0;
    const clock = { monotonicMs: () => nowMs };
    const slow = { compile: () => ({ test: () => (nowMs += 1) > 0, match: () => undefined }) };
    const patterns = new SessionPatterns(slow, clock, limits);
    const [one, other] = [patterns.of('one').compile('x'), patterns.of('other').compile('x')];
    expect(one.test('/a')).toBe(true);
    expect(() => one.test('/b')).toThrow('takes too long');
    expect(() => patterns.of('one').compile('y').test('/a')).toThrow('takes too long');
    expect(other.test('/b')).toBe(true);
  });

  it.each([
    ['a pattern that refuses', { topicGlob: '/*', identityMatchPattern: '(' }],
    ['a selector that is refused', { topicSelector: '(' }],
    ['nothing', { id: 'mux-1' }],
  ])('is reported, and the module runs without it, with %s', async (_, mux) => {
    const world = createWorld();
    await world.begin({ ...oneInput(mux), mode: { frequency: { hertz: 10 } } });
    expect(world.sandboxes.last.lastCall?.inputs).toEqual([]);
    expect(world.events).toMatchObject([{ message: expect.stringMatching(/^Input "x": /) }]);
  });

  it('[PM-44] agrees with a simple list', () => {
    const topic = fc.constantFrom('/a', '/b', '/c', '/d');
    const step = fc.record({ topic, isGone: fc.boolean(), isRead: fc.boolean() });
    fc.assert(
      fc.property(fc.array(step, { maxLength: 60 }), (steps) => {
        const rule = { ofRecord: () => undefined, ofTopic: (of: string) => of };
        const list = new MuxList(rule, 3);
        let model: { topic: string; bytes: Uint8Array }[] = [];
        steps.forEach((next, index) => {
          const bytes = Uint8Array.of(index);
          const known = model.find((element) => element.topic === next.topic);
          if (next.isGone) {
            list.delete(next.topic);
            model = model.filter((element) => element !== known);
          } else {
            const record = { topic: next.topic, bytes, valueField: 3, publisherId: '' };
            expect(list.set(record)).toBe(known !== undefined || model.length < 3);
            if (known !== undefined) known.bytes = bytes;
            else if (model.length < 3) model.push({ topic: next.topic, bytes });
          }
          if (!next.isRead) return;
          const expected = model.map((element) => ({
            bytes: element.bytes,
            identity: element.topic,
          }));
          expect(list.read()).toEqual(expected);
          expect(list.read()).toBe(list.read());
        });
      }),
    );
  });
});

describe('[PM-43] the identity of an element', () => {
  it.each<[string, object, string, string | undefined]>([
    ['what the pattern matches', { identityMatchPattern: 'p[0-9]' }, '/p7/x', 'p7'],
    ['its group', { identityMatchPattern: '/(\\w+)/(\\w+)', identityGroup: 2 }, '/a/b/x', 'b'],
    ['nothing where the pattern does not match', { identityMatchPattern: 'q' }, '/p7/x', undefined],
    [
      'nothing without that group',
      { identityMatchPattern: 'p', identityGroup: 3 },
      '/p',
      undefined,
    ],
    ['the client', { identitySource: 'MUX_IDENTITY_CLIENT_ID' }, '/p7/x', 'ada'],
    ['no device', { identitySource: 'MUX_IDENTITY_DEVICE_ID' }, '/p7/x', undefined],
    ['the topic', { identitySource: 'MUX_IDENTITY_TOPIC' }, '/p7/x', '/p7/x'],
    ['deduced: the client', {}, `/${UUID_A}/x`, 'ada'],
  ])('is %s', async (_, mux, topic, identity) => {
    const world = createWorld();
    await world.begin(oneInput({ topicGlob: '**', ...mux }));
    world.topics.put(topic, 'double', 1, 'ada');
    await world.clock.endTurn();
    expect(world.values()).toEqual({ x: [[identity, 1]] });
  });

  it.each([
    [`/x/${UUID_A}/${UUID_B}`, UUID_A],
    [`/${UUID_B}`, UUID_B],
    ['/no/id', '/no/id'],
  ])('is deduced from the topic %s when the publisher is unknown', async (topic, id) => {
    const world = createWorld();
    await world.begin(oneInput({ topicGlob: '**' }));
    world.topics.put(topic, 'double', 1, '');
    await world.clock.endTurn();
    expect(world.values()).toEqual({ x: [[id, 1]] });
  });

  it('is the device that has the component', async () => {
    const world = createWorld();
    const device = { clientId: 'ada', deviceId: 'd1', deviceName: 'pad' };
    const topic = world.topics.addComponent({ ...device, name: 'x', format: 'double' });
    const component = { messageFormat: 'double' };
    await world.begin(oneInput({ component, identitySource: 'MUX_IDENTITY_DEVICE_ID' }));
    world.topics.put(topic, 'double', 1, 'ada');
    await world.clock.endTurn();
    expect(world.values()).toEqual({ x: [['d1', 1]] });
  });
});

describe('[PM-62] other mappings while it runs', () => {
  const TWO: ModuleSketch = {
    mode: ON_INPUT,
    inputs: { a: 'double', b: 'double' },
    from: { a: '/a', b: { topicGlob: '/b/*' } },
  };

  it('keep the subscriptions and values that did not change', async () => {
    const world = createWorld();
    let subscribed = 0;
    const { subscribe } = world.topics;
    world.topics.subscribe = (...args) => {
      subscribed++;
      return subscribe.apply(world.topics, args);
    };
    world.topics.put('/a', 'double', 1);
    world.topics.put('/b/1', 'double', 2, 'ada');
    world.topics.put('/c', 'double', 3);
    await world.begin(TWO);
    world.runtime.remap(
      'pm-1',
      ioMapping({ from: { a: '/a', b: { topicGlob: '/b/*', id: 'new' } } }),
    );
    await world.clock.endTurn();
    expect(subscribed).toBe(2);
    expect(world.sandboxes.last.calls).toHaveLength(1);
    world.runtime.remap('pm-1', ioMapping({ from: { a: '/c', b: { topicGlob: '/b/*' } } }));
    await world.clock.endTurn();
    expect(subscribed).toBe(3);
    expect(world.topics.subscriptionCount).toBe(2);
    expect(world.values()).toEqual({ a: 3, b: [['ada', 2]] });
    expect(world.sandboxes.last.lastCall?.triggers).toEqual(['a']);
  });

  it('leave no subscription behind', async () => {
    const world = createWorld();
    await world.begin(TWO);
    world.runtime.remap('pm-1', ioMapping({}));
    expect(world.topics.subscriptionCount).toBe(0);
    world.topics.put('/a', 'double', 1);
    await world.clock.endTurn();
    expect(world.sandboxes.last.calls).toHaveLength(0);
  });
});
