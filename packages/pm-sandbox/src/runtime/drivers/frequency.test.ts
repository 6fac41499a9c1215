import { ModuleEventKind } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { EMPTY_RESULT, inputValues } from '../../testing/fake-sandboxes.ts';
import { createModuleWorld } from '../../testing/module-world.ts';

const hertz = (value: number) => ({ frequency: { hertz: value } });

/** Answers each run at once, and notes when it started. */
function createStopwatch(limits = {}) {
  const world = createModuleWorld(limits);
  const startsMs: number[] = [];
  world.sandboxes.onRun = () => {
    startsMs.push(world.clock.monotonicMs());
    return EMPTY_RESULT;
  };
  return { ...world, startsMs };
}

describe('a module with a frequency', () => {
  it('[PM-21] runs first at its start, then every 1/hertz seconds', async () => {
    const { clock, startsMs, begin } = createStopwatch();
    await begin({ mode: hertz(10) });
    await clock.advance(350);
    expect(startsMs).toEqual([0, 100, 200, 300]);
  });

  it.each([
    { startMs: 30, expected: [30, 100, 200, 300] },
    { startMs: 70, expected: [70, 200, 300] },
  ])(
    '[PM-21] joins the moments all others have, at least half an interval after its start at $startMs ms',
    async ({ startMs, expected }) => {
      const { clock, startsMs, begin } = createStopwatch();
      await clock.advance(startMs);
      await begin({ mode: hertz(10) });
      await clock.advance(300 - startMs);
      expect(startsMs).toEqual(expected);
    },
  );

  it('[PM-21] does not drift when its intervals are no whole milliseconds', async () => {
    const { clock, startsMs, begin } = createStopwatch();
    await begin({ mode: hertz(60) });
    await clock.advance(60_001);
    expect(startsMs).toHaveLength(3601);
    expect(startsMs.at(-1)).toBeCloseTo(60_000);
  });

  it('[PM-21] keeps later runs in time when one starts late', async () => {
    const { clock, startsMs, begin } = createStopwatch();
    await begin({ mode: hertz(10) });
    await clock.advance(50);
    clock.spend(70);
    await clock.advance(200);
    expect(startsMs).toEqual([0, 120, 200, 300]);
  });

  it('[PM-21] leaves out what was missed when the thread stood still', async () => {
    const { clock, startsMs, events, begin } = createStopwatch();
    await begin({ mode: hertz(10) });
    clock.spend(550);
    await clock.advance(100);
    expect(startsMs).toEqual([0, 550, 600]);
    expect(events).toEqual([]);
  });

  it.each([undefined, {}, hertz(0), hertz(-5)])('[PM-20] runs at 30 Hz with %j', async (mode) => {
    const { clock, startsMs, begin } = createStopwatch();
    await begin(mode === undefined ? {} : { mode });
    await clock.advance(999);
    expect(startsMs).toHaveLength(30);
  });

  it('[PM-20] runs at most at the highest frequency', async () => {
    const { clock, startsMs, begin } = createStopwatch({ maxFrequencyHz: 20 });
    await begin({ mode: hertz(1000) });
    await clock.advance(999);
    expect(startsMs).toHaveLength(20);
  });

  it('[PM-22] leaves out what is due during a run, counts it once, and stays on its beat', async () => {
    const { clock, sandboxes, runtime, events, begin } = createModuleWorld();
    await begin({ mode: hertz(10) });
    await clock.advance(330);
    expect(sandboxes.last.calls).toHaveLength(1);
    sandboxes.last.finish();
    await clock.advance(69);
    expect(sandboxes.last.calls).toHaveLength(1);
    await clock.advance(1);
    expect(sandboxes.last.calls).toHaveLength(2);
    expect(runtime.statistics()[0]).toMatchObject({ overruns: 1, runs: 2 });
    expect(events).toMatchObject([{ kind: ModuleEventKind.OVERRUN, moduleId: 'pm-1' }]);
  });

  it.each([
    ['the run took too long', 150, 'because the previous run had not finished'],
    ['its node was late', 2, 'because the computer it runs on was too busy'],
  ])('[PM-22] tells at the end of the run that %s', async (_, durationMs, words) => {
    const { clock, sandboxes, events, begin } = createModuleWorld();
    await begin({ mode: hertz(10) });
    await clock.advance(150);
    expect(events).toEqual([]);
    sandboxes.last.finish({ durationMs });
    await clock.advance(1);
    expect(events.map(({ message }) => message)).toEqual([expect.stringContaining(words)]);
  });

  it('[PM-11] tells the time since the start of the run before, first 0', async () => {
    const { clock, sandboxes, begin } = createStopwatch();
    await begin({ mode: hertz(10) });
    await clock.advance(50);
    clock.spend(80);
    await clock.advance(100);
    expect(sandboxes.last.calls.map(({ deltaTimeMs }) => deltaTimeMs)).toEqual([0, 130, 70]);
  });

  it('[PM-21] takes its inputs when a run starts', async () => {
    const { clock, sandboxes, topics, begin } = createStopwatch();
    await begin({ mode: hertz(10), inputs: { x: 'double' }, from: { x: '/x' } });
    topics.put('/x', 'double', 1);
    await clock.advance(50);
    topics.put('/x', 'double', 2);
    await clock.advance(50);
    expect(sandboxes.last.calls.map(inputValues)).toEqual([{ x: undefined }, { x: 2 }]);
  });
});
