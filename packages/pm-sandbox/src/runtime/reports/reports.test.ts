import { ModuleEventKind, ProcessingModuleStatus } from '@ubii/proto';
import { TokenBucket } from '@ubii/timing';
import { describe, expect, it } from 'vitest';
import { EMPTY_RESULT } from '../../testing/fake-sandboxes.ts';
import { createModuleWorld } from '../../testing/module-world.ts';
import { RunDurations } from './run-statistics.ts';

const TEN_HERTZ = { mode: { frequency: { hertz: 10 } } };

describe('[PM-81] events', () => {
  it('are told at once, equal ones once a second with the number left out', async () => {
    const { clock, sandboxes, events, begin } = createModuleWorld();
    await begin(TEN_HERTZ);
    for (let i = 0; i < 25; i++) {
      sandboxes.last.fail({ message: 'the same', line: 1 });
      await clock.advance(100);
    }
    const times = events.map(({ timeMs, suppressed }) => [timeMs - events[0]!.timeMs, suppressed]);
    expect(times).toEqual([
      [0, 0],
      [900, 8],
      [1900, 9],
    ]);
  });

  it('are told at once when they differ', async () => {
    const { clock, sandboxes, events, begin } = createModuleWorld();
    await begin(TEN_HERTZ);
    for (const fault of [{ line: 1 }, { line: 2 }, { message: 'other' }]) {
      sandboxes.last.fail(fault);
      await clock.advance(100);
    }
    expect(events).toHaveLength(3);
  });

  it('that differ in their numbers are the same mistake', async () => {
    const { clock, sandboxes, events, begin } = createModuleWorld();
    await begin(TEN_HERTZ);
    for (let i = 0; i < 15; i++) {
      sandboxes.last.fail({ message: `"a1": ${i * 0.5} is beyond 10`, line: 1 });
      await clock.advance(100);
    }
    sandboxes.last.fail({ message: '"a2": 1 is beyond 10', line: 1 });
    await clock.endTurn();
    expect(events.map(({ message, suppressed }) => [message, suppressed])).toEqual([
      ['"a1": 0 is beyond 10', 0],
      ['"a1": 4.5 is beyond 10', 8],
      ['"a2": 1 is beyond 10', 0],
    ]);
  });

  it('are told again at once after a quiet second', async () => {
    const { clock, sandboxes, events, begin } = createModuleWorld();
    await begin(TEN_HERTZ);
    for (let i = 0; i < 3; i++) {
      sandboxes.last.fail();
      await clock.advance(100);
      expect(events).toHaveLength(i + 1);
      sandboxes.onRun = () => EMPTY_RESULT;
      sandboxes.last.finish();
      await clock.advance(1000);
      sandboxes.onRun = () => 'pending';
      await clock.advance(100);
    }
    expect(events.map(({ suppressed }) => suppressed)).toEqual([0, 0, 0]);
  });

  it('that differ without end are only counted beyond a number', async () => {
    const world = createModuleWorld({ maxEventsPerSecond: 5 });
    await world.begin(TEN_HERTZ);
    for (let i = 0; i < 9; i++) {
      world.sandboxes.last.fail({ message: `mistake ${'abcdefghi'[i]}` });
      await world.clock.advance(100);
    }
    expect(world.events).toHaveLength(5);
    await world.clock.advance(1000);
    world.sandboxes.last.fail({ message: 'later' });
    await world.clock.endTurn();
    expect(world.events.at(-1)).toMatchObject({ message: 'later' });
    const suppressed = world.events.reduce((sum, event) => sum + event.suppressed, 0);
    expect(suppressed).toBe(4);
  });

  it('that wait are told when the instance ends', async () => {
    const { clock, sandboxes, events, runtime, begin } = createModuleWorld();
    await begin(TEN_HERTZ);
    for (let i = 0; i < 3; i++) {
      sandboxes.last.fail();
      await clock.advance(100);
    }
    sandboxes.last.finish();
    await runtime.destroy('pm-1');
    expect(events.map(({ suppressed }) => suppressed)).toEqual([0, 1]);
    expect(clock.timerCount).toBe(0);
  });

  it('have no longer texts than people read', async () => {
    const { sandboxes, events, begin } = createModuleWorld();
    await begin(TEN_HERTZ);
    sandboxes.last.events.onLog({ level: 'log', text: 'x'.repeat(1e6) });
    expect(events[0]?.message).toHaveLength(4096);
  });
});

describe('console lines of a module', () => {
  it('[PM-14] become events with their level', async () => {
    const { sandboxes, events, begin } = createModuleWorld();
    await begin(TEN_HERTZ);
    sandboxes.last.events.onLog({ level: 'warn', text: 'careful' });
    expect(events).toMatchObject([
      { kind: ModuleEventKind.LOG, level: 'warn', message: 'careful', sessionId: 'session-1' },
    ]);
  });

  it('[PM-55] are left out beyond so many a second, which is reported', async () => {
    const { clock, sandboxes, events, begin } = createModuleWorld({ maxLogLinesPerSecond: 10 });
    await begin(TEN_HERTZ);
    for (let i = 0; i < 30; i++) {
      sandboxes.last.events.onLog({ level: 'log', text: `line ${i}` });
    }
    expect(events.map(({ kind }) => kind)).toEqual([
      ...Array<number>(10).fill(ModuleEventKind.LOG),
      ModuleEventKind.REFUSED,
    ]);
    await clock.advance(1000);
    expect(events.at(-1)).toMatchObject({ kind: ModuleEventKind.REFUSED, suppressed: 18 });
  });
});

describe('[PM-80] statistics', () => {
  it('say how each instance did since they were asked for before', async () => {
    const world = createModuleWorld();
    const durations = [4, 2, 3, 1, 100, 5, 6, 7, 8, 9];
    let run = 0;
    world.sandboxes.onRun = () => ({ ...EMPTY_RESULT, durationMs: durations[run++ % 10]! });
    await world.begin(TEN_HERTZ);
    await world.clock.advance(950);
    const [first] = world.runtime.statistics();
    expect(first).toMatchObject({
      moduleId: 'pm-1',
      moduleName: 'module',
      nodeId: 'node-1',
      status: ProcessingModuleStatus.PROCESSING,
      runs: 10,
      runP50Ms: 5,
      runP95Ms: 100,
    });
    expect(first?.runsPerSecond).toBeCloseTo(10 / 0.95);
    await world.runtime.halt('pm-1');
    await world.clock.advance(250);
    expect(world.runtime.statistics()).toMatchObject([
      {
        status: ProcessingModuleStatus.HALTED,
        runs: 10,
        runsPerSecond: 0,
        runP50Ms: 0,
        runP95Ms: 0,
      },
    ]);
  });

  it('keep the newest durations only', () => {
    const durations = new RunDurations();
    for (let i = 0; i < 10_000; i++) durations.add(i);
    const { p50Ms, p95Ms } = durations.take();
    expect(p50Ms).toBeGreaterThan(9_744);
    expect(p95Ms).toBeGreaterThan(p50Ms);
  });

  it('keep the durations of a module whose runs take longer than a report', () => {
    const durations = new RunDurations();
    expect(durations.take()).toEqual({ p50Ms: 0, p95Ms: 0 });
    durations.add(2400);
    durations.add(2600);
    expect(durations.take()).toEqual({ p50Ms: 2400, p95Ms: 2600 });
    expect(durations.take()).toEqual({ p50Ms: 2400, p95Ms: 2600 });
    durations.add(10);
    expect(durations.take()).toEqual({ p50Ms: 10, p95Ms: 10 });
  });
});

describe('a token bucket', () => {
  it('gives what grew, and a second of it at most', () => {
    const bucket = new TokenBucket(10, 0);
    expect(bucket.take(10, 0)).toBe(true);
    expect(bucket.take(1, 50)).toBe(false);
    expect(bucket.take(1, 100)).toBe(true);
    expect(bucket.take(11, 60_000)).toBe(false);
    expect(bucket.take(10, 60_000)).toBe(true);
  });
});
