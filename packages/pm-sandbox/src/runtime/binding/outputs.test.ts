import {
  decodeRecord,
  encode,
  encodeRecord,
  ModuleEventKind,
  timestampFromMs,
  type DataFormat,
} from '@ubii/proto';
import { readRecordHead, recordValueField } from '@ubii/proto/wire';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { SandboxOutput } from '../../ports/sandbox.ts';
import { EMPTY_RESULT, sandboxOutput, sandboxValue } from '../../testing/fake-sandboxes.ts';
import { createModuleWorld, ioMapping, type ModuleSketch } from '../../testing/module-world.ts';
import { expiryOf, RecordCompletion } from './record-completion.ts';

const ONCE = { triggerOnInput: { minDelayMs: 0, allInputsNeedUpdate: false } };
const OUT: ModuleSketch = { outputs: { out: 'double' }, to: { out: '/out' } };

/** A module that puts out what the test says each time. */
async function createWorld(sketch: ModuleSketch, limits = {}) {
  const world = createModuleWorld(limits);
  await world.begin({ mode: ONCE, inputs: { go: 'double' }, ...sketch, from: { go: '/go' } });
  const putOut = async (...outputs: SandboxOutput[]) => {
    world.sandboxes.onRun = () => ({ ...EMPTY_RESULT, outputs });
    world.topics.put('/go', 'double', 1);
    await world.clock.endTurn();
  };
  const publishedOn = () => world.topics.published.map(({ topic }) => topic);
  const messages = () => world.events.map(({ message }) => message);
  return { ...world, putOut, publishedOn, messages };
}

/** A list output: element i has the value i. */
function list(
  name: string,
  ...elements: { params?: string[]; identity?: string }[]
): SandboxOutput {
  return {
    name,
    elements: elements.map(({ params, identity }, index) => ({
      value: sandboxValue('double', index),
      params,
      identity,
      index,
    })),
  };
}

describe('a picture that a module puts out', () => {
  const image = { width: 1, height: 1, dataFormat: 0, data: new Uint8Array([7]) } as const;
  const NOW_MS = 1_700_000_000_000;
  const input = (expiryMs: number) => ({
    bytes: encodeRecord({ topic: '/camera', format: 'image2D', value: image, expiryMs }),
  });

  it.each([
    ['as long as the longest of its inputs that expire', [1500, 0, 3000], 3000],
    ['without end when none of them does', [0, 0], 0],
  ])('stands %s [PM-37]', (_what, inputsMs, expectedMs) => {
    const [first, ...others] = inputsMs.map(input);
    const expiry = expiryOf([
      { name: 'image', record: first },
      { name: 'nothing', record: undefined },
      { name: 'more', elements: others },
    ]);
    const completion = new RecordCompletion('node-1');
    const value = { ...sandboxValue('image2D', image), hasTimestamp: false };
    const record = completion.complete(value, completion.origin('/picture'), NOW_MS, expiry);
    expect(readRecordHead(record)).toMatchObject({ topic: '/picture', expiryMs: expectedMs });
    expect(decodeRecord(record)).toMatchObject({ format: 'image2D', timestampMs: NOW_MS });
  });
});

describe('an output mapped to a topic', () => {
  it('[PM-32] is published with topic, timestamp and the id of the node', async () => {
    const world = await createWorld(OUT);
    await world.clock.advance(1234.5);
    await world.putOut(sandboxOutput('out', 'double', 0));
    expect(world.topics.published).toEqual([
      {
        topic: '/out',
        format: 'double',
        value: 0,
        clientId: 'node-1',
        timestampMs: world.clock.nowMs(),
      },
    ]);
    expect(world.runtime.statistics()[0]).toMatchObject({ outputs: 1, outputsRefused: 0 });
  });

  it('[PM-32] keeps the timestamp the module gave', async () => {
    const world = await createWorld(OUT);
    const bytes = encode('ubii.topicData.TopicDataRecord', {
      double: 1,
      timestamp: timestampFromMs(1_700_000_000_000),
    });
    await world.putOut({ name: 'out', value: { bytes, valueField: 3, hasTimestamp: true } });
    expect(world.topics.published).toMatchObject([{ timestampMs: 1_700_000_000_000 }]);
  });

  it('[PM-32] says its own topic and client even if the value brought others', async () => {
    const world = await createWorld(OUT);
    const bytes = encodeRecord({ topic: '/forged', format: 'double', value: 1, clientId: 'eve' });
    await world.putOut({ name: 'out', value: { bytes, valueField: 3, hasTimestamp: false } });
    expect(world.topics.published).toMatchObject([{ topic: '/out', clientId: 'node-1' }]);
  });

  it('[PM-33] is published though others of the run were refused', async () => {
    const world = await createWorld(OUT);
    const fault = { kind: 'output', phase: 'onProcessing', message: 'output "b": no' } as const;
    world.sandboxes.onRun = () => ({
      ...EMPTY_RESULT,
      faults: [fault],
      outputs: [sandboxOutput('out', 'double', 1)],
    });
    world.topics.put('/go', 'double', 1);
    await world.clock.endTurn();
    expect(world.publishedOn()).toEqual(['/out']);
    expect(world.events).toMatchObject([
      { kind: ModuleEventKind.REFUSED, phase: 'onProcessing', message: 'output "b": no' },
    ]);
    expect(world.runtime.statistics()[0]).toMatchObject({ outputs: 1, outputsRefused: 1 });
  });

  it('[PM-35] is published in the order of the declared outputs, unmapped ones are dropped', async () => {
    const world = await createWorld({
      outputs: { a: 'double', b: 'double', c: 'double' },
      to: { c: '/c', a: '/a' },
    });
    await world.putOut(
      sandboxOutput('c', 'double', 1),
      sandboxOutput('b', 'double', 2),
      sandboxOutput('a', 'double', 3),
    );
    expect(world.publishedOn()).toEqual(['/a', '/c']);
    expect(world.events).toEqual([]);
  });

  it('goes to several topics when it is mapped to them', async () => {
    const world = await createWorld(OUT);
    const outputMappings = [
      { outputName: 'out', topic: '/one' },
      { outputName: 'out', topic: '/two' },
    ];
    world.runtime.remap('pm-1', { ...ioMapping({ from: { go: '/go' } }), outputMappings });
    await world.putOut(sandboxOutput('out', 'double', 1));
    expect(world.publishedOn()).toEqual(['/one', '/two']);
  });

  it('[PM-62] goes elsewhere at once when it is mapped there', async () => {
    const world = await createWorld(OUT);
    world.runtime.remap('pm-1', ioMapping({ from: { go: '/go' }, to: { out: '/new' } }));
    await world.putOut(sandboxOutput('out', 'double', 1));
    expect(world.publishedOn()).toEqual(['/new']);
  });

  it('[PM-47] is refused on a topic only the master publishes on', async () => {
    const world = await createWorld({ ...OUT, to: { out: '/info/x' } });
    await world.putOut(sandboxOutput('out', 'double', 1));
    expect(world.publishedOn()).toEqual([]);
    expect(world.messages()).toEqual(['Output "out": only the master can publish on /info/x.']);
  });

  it('is refused when it is a list, or when the port refuses it', async () => {
    const world = await createWorld(OUT);
    await world.putOut(list('out', {}, {}));
    world.topics.publish = () => 'no room';
    await world.putOut(sandboxOutput('out', 'double', 1));
    expect(world.publishedOn()).toEqual([]);
    expect(world.messages()).toEqual([
      'Output "out" is a single value: write it without { elements: [ … ] }.',
      'Cannot publish on /out: no room',
    ]);
    expect(world.runtime.statistics()[0]).toMatchObject({ outputs: 0, outputsRefused: 3 });
  });

  it('[PM-55] is refused beyond so many records a second', async () => {
    const world = await createWorld(OUT, { maxOutputsPerSecond: 10 });
    for (let i = 0; i < 30; i++) await world.putOut(sandboxOutput('out', 'double', i));
    expect(world.publishedOn()).toHaveLength(10);
    await world.clock.advance(1000);
    for (let i = 0; i < 30; i++) await world.putOut(sandboxOutput('out', 'double', i));
    expect(world.publishedOn()).toHaveLength(20);
    expect(world.runtime.statistics()[0]).toMatchObject({ outputs: 20, outputsRefused: 40 });
    expect(world.events[0]).toMatchObject({
      kind: ModuleEventKind.REFUSED,
      message: 'Output "out": more than 10 records per second. Further records are dropped.',
    });
  });

  it('[PM-55] is refused beyond so many bytes a second', async () => {
    const world = await createWorld(
      { outputs: { out: 'string' }, to: { out: '/out' } },
      { maxOutputBytesPerSecond: 1000 },
    );
    for (let i = 0; i < 3; i++) await world.putOut(sandboxOutput('out', 'string', 'x'.repeat(400)));
    await world.putOut(sandboxOutput('out', 'string', 'small'));
    expect(world.publishedOn()).toHaveLength(3);
    expect(world.messages()).toEqual([
      'Output "out": more than 1000 bytes per second. Further records are dropped.',
    ]);
  });
});

describe('an output mapped to a demuxer', () => {
  const demuxed = (outputTopicFormat: string): ModuleSketch => ({
    outputs: { out: 'double' },
    to: { out: { outputTopicFormat } },
  });

  it('[PM-45] [PM-46] spreads its elements over topics', async () => {
    const world = await createWorld(demuxed('/{{#0}}/x'));
    await world.putOut(list('out', { params: ['a'] }, { identity: 'b' }, { params: ['a'] }));
    expect(world.topics.published).toMatchObject([
      { topic: '/a/x', value: 0 },
      { topic: '/b/x', value: 1 },
      { topic: '/a/x', value: 2 },
    ]);
  });

  it('[PM-47] refuses elements without a topic a client may publish on, and publishes the others', async () => {
    const world = await createWorld(demuxed('{{#0}}'));
    await world.putOut(
      list('out', {}, { params: ['/ok'] }, { params: [''] }, { params: ['/info/x'] }),
    );
    expect(world.publishedOn()).toEqual(['/ok']);
    expect(world.messages()).toEqual([
      'Output "out", element 0: the topic needs the parameter 0, outputTopicParams has none.',
      'Output "out", element 2: the topic is empty.',
      'Output "out", element 3: only the master can publish on /info/x.',
    ]);
  });

  it('reports only some of many refused elements, and counts all', async () => {
    const world = await createWorld(demuxed('/{{#0}}'));
    await world.putOut(list('out', ...Array.from({ length: 1000 }, () => ({}))));
    expect(world.events).toHaveLength(2);
    expect(world.messages().at(-1)).toBe('Output "out": 997 more elements have no valid topic.');
    expect(world.runtime.statistics()[0]?.outputsRefused).toBe(1000);
  });

  it('is refused when it is no list', async () => {
    const world = await createWorld(demuxed('/{{#0}}'));
    await world.putOut(sandboxOutput('out', 'double', 1));
    expect(world.messages()).toEqual([
      'Output "out" is a list: write { elements: [ … ] }, not a single value.',
    ]);
  });
});

describe('completing a record', () => {
  it('[PM-32] gives what encoding the whole record would give', () => {
    const completion = new RecordCompletion('node-1');
    const value = fc.oneof(
      fc.record({ format: fc.constant<DataFormat>('string'), value: fc.string() }),
      fc.record({ format: fc.constant<DataFormat>('double'), value: fc.double({ noNaN: true }) }),
      fc.record({ format: fc.constant<DataFormat>('bool'), value: fc.boolean() }),
    );
    fc.assert(
      fc.property(fc.string(), value, fc.nat(1e12), (topic, { format, value: inner }, ms) => {
        const nowMs = 1e12 + ms;
        const put = sandboxValue(format, inner as never);
        const bytes = completion.complete(put, completion.origin(topic), nowMs);
        const whole = { topic, format, value: inner, timestampMs: nowMs, clientId: 'node-1' };
        const expected = encodeRecord(whole as Parameters<typeof encodeRecord>[0]);
        expect(decodeRecord(bytes)).toEqual(decodeRecord(expected));
        expect(recordValueField(bytes)).toBe(put.valueField);
      }),
    );
  });
});
