import { describe, expect, it } from 'vitest';
import { EMPTY_RESULT, inputValues } from '../../testing/fake-sandboxes.ts';
import { createModuleWorld, type ModuleSketch } from '../../testing/module-world.ts';

describe('[PM-25] a module that is triggered by a bool or an event', () => {
  const values = (calls: readonly Parameters<typeof inputValues>[0][]) =>
    calls.map((call) => inputValues(call).a);
  const sketch = (format: string, minDelayMs = 0): ModuleSketch => ({
    mode: { triggerOnInput: { minDelayMs, allInputsNeedUpdate: false } },
    inputs: { a: format, b: 'double' },
    from: { a: '/a', b: '/b' },
  });

  it('runs for each change of a bool within one turn', async () => {
    const { clock, sandboxes, topics, begin } = createModuleWorld();
    sandboxes.onRun = () => EMPTY_RESULT;
    await begin(sketch('bool'));
    for (const value of [false, true, true, false, true]) topics.put('/a', 'bool', value);
    await clock.advance(100);
    expect(values(sandboxes.last.calls)).toEqual([false, true, false, true]);
    expect(sandboxes.last.calls.map(({ triggers }) => triggers)).toEqual(Array(4).fill(['a']));
  });

  it('runs for each event that came during a run', async () => {
    const { clock, sandboxes, topics, runtime, begin } = createModuleWorld();
    await begin(sketch('keyEvent'));
    for (const key of ['x', 'y', 'z']) {
      topics.put('/a', 'keyEvent', { type: 1, key });
      await clock.endTurn();
    }
    for (let run = 0; run < 3; run += 1) {
      sandboxes.last.finish();
      await clock.endTurn();
    }
    expect(values(sandboxes.last.calls)).toMatchObject([{ key: 'x' }, { key: 'y' }, { key: 'z' }]);
    expect(runtime.statistics()[0]).toMatchObject({ runs: 3, waiting: 0 });
  });

  it('takes other inputs as they are at each run', async () => {
    const { clock, sandboxes, topics, begin } = createModuleWorld();
    sandboxes.onRun = () => EMPTY_RESULT;
    await begin(sketch('bool'));
    topics.put('/b', 'double', 1);
    for (const value of [true, false]) topics.put('/a', 'bool', value);
    topics.put('/b', 'double', 2);
    await clock.advance(100);
    expect(sandboxes.last.calls.map(inputValues)).toEqual([
      { a: true, b: 2 },
      { a: false, b: 2 },
    ]);
    expect(sandboxes.last.calls.map(({ triggers }) => triggers)).toEqual([['a', 'b'], ['a']]);
  });

  it('keeps the newest alone with a delay between runs', async () => {
    const { clock, sandboxes, topics, begin } = createModuleWorld();
    sandboxes.onRun = () => EMPTY_RESULT;
    await begin(sketch('bool', 10));
    for (const value of [true, false]) topics.put('/a', 'bool', value);
    await clock.advance(100);
    expect(values(sandboxes.last.calls)).toEqual([false]);
  });

  it('starts with the newest alone', async () => {
    const { clock, sandboxes, topics, runtime, begin } = createModuleWorld();
    sandboxes.onRun = () => EMPTY_RESULT;
    await begin({ ...sketch('bool'), id: 'pm' });
    await runtime.halt('pm');
    for (const value of [true, false]) topics.put('/a', 'bool', value);
    await clock.advance(100);
    runtime.start('pm');
    await clock.advance(100);
    expect(values(sandboxes.last.calls)).toEqual([false]);
  });

  it('forgets the oldest over the limit, and reports it once', async () => {
    const { clock, sandboxes, topics, events, begin } = createModuleWorld({ maxWaitingEvents: 2 });
    await begin(sketch('keyEvent'));
    topics.put('/a', 'keyEvent', { type: 1, key: '0' });
    await clock.endTurn();
    for (const key of ['1', '2', '3', '4']) topics.put('/a', 'keyEvent', { type: 1, key });
    await clock.endTurn();
    for (let run = 0; run < 5; run += 1) {
      sandboxes.last.finish();
      await clock.endTurn();
    }
    expect(values(sandboxes.last.calls)).toMatchObject([{ key: '0' }, { key: '3' }, { key: '4' }]);
    expect(events.map(({ message }) => message)).toEqual([
      expect.stringContaining('more than 2 events waited'),
    ]);
  });

  it('forgets what waits when the value is deleted', async () => {
    const { clock, sandboxes, topics, begin } = createModuleWorld();
    await begin(sketch('bool'));
    topics.put('/b', 'double', 1);
    await clock.endTurn();
    for (const value of [true, false]) topics.put('/a', 'bool', value);
    topics.delete('/a');
    for (let run = 0; run < 3; run += 1) {
      sandboxes.last.finish();
      await clock.endTurn();
    }
    expect(values(sandboxes.last.calls)).toEqual([undefined, undefined]);
  });
});
