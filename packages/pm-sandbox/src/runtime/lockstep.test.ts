import { decodeRecord, encodeRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import type { EncodedRecord } from '../ports/topic-port.ts';
import { EMPTY_RESULT, inputValues, sandboxOutput } from '../testing/fake-sandboxes.ts';
import { createModuleWorld, type ModuleSketch } from '../testing/module-world.ts';

const LOCKSTEP = { lockstep: { processRequestEndpoint: '' } };

const sketch = (id: string, topic: string): ModuleSketch => ({
  id,
  mode: LOCKSTEP,
  inputs: { x: 'double' },
  outputs: { out: 'double' },
  from: { x: topic },
  to: { out: `/out/${id}` },
});

function record(topic: string, value: number, publisherId = ''): EncodedRecord {
  const bytes = encodeRecord({ topic, format: 'double', value });
  return { topic, bytes, valueField: 3, publisherId };
}

describe('[PM-27] modules in lockstep', () => {
  it('run only in passes, with the inputs and the delta time of the pass', async () => {
    const { clock, sandboxes, topics, runtime, begin } = createModuleWorld();
    sandboxes.onRun = () => EMPTY_RESULT;
    await begin(sketch('a', '/x'));
    topics.put('/x', 'double', 99);
    await clock.advance(1000);
    expect(sandboxes.last.calls).toHaveLength(0);
    const records = [record('/x', 1), record('/unused', 2)];
    const reply = await runtime.runPass({ instanceIds: ['a'], deltaTimeMs: 16.5, records });
    expect(reply).toEqual({ instanceIds: ['a'], records: [] });
    expect(sandboxes.last.calls).toMatchObject([{ deltaTimeMs: 16.5 }]);
    expect(inputValues(sandboxes.last.lastCall)).toEqual({ x: 1 });
    await runtime.runPass({ instanceIds: ['a'], deltaTimeMs: 1, records: [] });
    expect(inputValues(sandboxes.last.lastCall)).toEqual({ x: undefined });
  });

  it('[SE-41] answer with their outputs in the order of the instances, not published', async () => {
    const { clock, sandboxes, topics, runtime, begin } = createModuleWorld();
    await begin(sketch('a', '/x'));
    await begin(sketch('b', '/x'));
    const pass = runtime.runPass({ instanceIds: ['b', 'a'], deltaTimeMs: 1, records: [] });
    await clock.endTurn();
    sandboxes.of('a').finish({ outputs: [sandboxOutput('out', 'double', 1)] });
    sandboxes.of('b').finish({ outputs: [sandboxOutput('out', 'double', 2)] });
    const reply = await pass;
    expect(reply.instanceIds).toEqual(['b', 'a']);
    expect(reply.records.map(decodeRecord)).toMatchObject([
      { topic: '/out/b', value: 2, clientId: 'node-1' },
      { topic: '/out/a', value: 1, clientId: 'node-1' },
    ]);
    expect(topics.published).toEqual([]);
    expect(runtime.statistics()).toMatchObject([{ outputs: 1 }, { outputs: 1 }]);
  });

  it('leave out instances that fail, are killed, halted, not in lockstep, busy or missing', async () => {
    const { clock, sandboxes, runtime, begin } = createModuleWorld();
    for (const id of ['ok', 'fails', 'killed', 'halted', 'busy']) await begin(sketch(id, '/x'));
    await begin({ ...sketch('free', '/x'), mode: { free: {} } });
    await runtime.halt('halted');
    void runtime.runPass({ instanceIds: ['busy'], deltaTimeMs: 1, records: [] });
    const instanceIds = ['fails', 'killed', 'halted', 'busy', 'free', 'unknown', 'ok'];
    const pass = runtime.runPass({ instanceIds, deltaTimeMs: 1, records: [] });
    sandboxes.of('fails').fail();
    sandboxes.of('killed').kill();
    await clock.endTurn();
    sandboxes.of('ok').finish();
    expect((await pass).instanceIds).toEqual(['ok']);
  });

  it('[SE-40] tell the newest records of all their inputs, each topic once', async () => {
    const { topics, runtime, begin } = createModuleWorld();
    await begin(sketch('a', '/x'));
    await begin({ ...sketch('b', '/x'), from: { x: { topicGlob: '/m/*' } } });
    await begin({ ...sketch('c', '/x'), from: { x: { constant: { double: 1 } } } });
    for (const topic of ['/x', '/m/1', '/m/2', '/x']) topics.put(topic, 'double', 1);
    const inputs = runtime.lockstepInputs(['a', 'b', 'c', 'unknown']);
    expect(inputs.map(({ topic }) => topic)).toEqual(['/x', '/m/1', '/m/2']);
  });

  it('fill muxers from the snapshot, in the order known here', async () => {
    const { sandboxes, topics, runtime, begin } = createModuleWorld();
    sandboxes.onRun = () => EMPTY_RESULT;
    await begin({ ...sketch('a', ''), from: { x: { topicGlob: '/m/*' } } });
    topics.put('/m/2', 'double', 0, 'bob');
    topics.put('/m/1', 'double', 0, 'ada');
    topics.put('/m/3', 'double', 0, 'eve');
    const records = [
      record('/m/1', 1),
      record('/m/2', 2, 'bea'),
      record('/m/4', 4, 'dan'),
      record('/other', 5),
    ];
    await runtime.runPass({ instanceIds: ['a'], deltaTimeMs: 1, records });
    expect(inputValues(sandboxes.last.lastCall)).toEqual({
      x: [
        ['bea', 2],
        ['ada', 1],
        ['dan', 4],
      ],
    });
  });

  it('subscribe to nothing that snapshots bring, where these come from elsewhere', async () => {
    const world = createModuleWorld({}, [], { lockstepInputs: 'given' });
    const { clock, sandboxes, topics, runtime } = world;
    sandboxes.onRun = () => EMPTY_RESULT;
    const device = { clientId: 'ada', deviceId: 'd1', deviceName: 'pad' };
    const topic = topics.addComponent({ ...device, name: 'x', format: 'double' });
    await world.begin({
      ...sketch('a', ''),
      inputs: { x: 'double', many: 'double', pads: 'double' },
      from: {
        x: '/x',
        many: { topicGlob: '/m/*' },
        pads: { component: { name: 'x' }, identitySource: 'MUX_IDENTITY_DEVICE_ID' },
      },
    });
    expect(topics.subscriptionCount).toBe(1);
    topics.put(topic, 'double', 0, 'ada');
    const records = [record('/x', 1), record('/m/1', 2, 'bob'), record(topic, 3)];
    await runtime.runPass({ instanceIds: ['a'], deltaTimeMs: 1, records });
    const values = { x: 1, many: [['bob', 2]], pads: [['d1', 3]] };
    expect(inputValues(sandboxes.last.lastCall)).toEqual(values);
    topics.put('/x', 'double', 7);
    runtime.setMode('a', { frequency: { hertz: 10 } });
    expect(topics.subscriptionCount).toBe(3);
    await clock.endTurn();
    expect(inputValues(sandboxes.last.lastCall)).toMatchObject({ x: 7, many: [] });
    runtime.setMode('a', LOCKSTEP);
    expect(topics.subscriptionCount).toBe(1);
    await runtime.destroy('a');
    expect(topics.subscriptionCount).toBe(0);
  });

  it('start a pass before any of it ends', async () => {
    const { sandboxes, runtime, begin } = createModuleWorld();
    await begin(sketch('a', '/out/b'));
    await begin(sketch('b', '/out/a'));
    void runtime.runPass({ instanceIds: ['a', 'b'], deltaTimeMs: 1, records: [] });
    expect([sandboxes.of('a').isRunning, sandboxes.of('b').isRunning]).toEqual([true, true]);
  });
});
