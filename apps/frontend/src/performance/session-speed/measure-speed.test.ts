import type { ModuleStatistics, SessionStatistics } from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { isAbandoned } from '../run/test-session.ts';
import { measureSpeed, type SpeedSession } from './measure-speed.ts';
import type { SpeedParameters } from './speed-parameters.ts';
import { speedSession, speedTopics } from './speed-session.ts';

const PARAMETERS: SpeedParameters = {
  iterations: 1000,
  instances: 2,
  mode: 'frequency',
  hertz: 50,
  seconds: 2,
};

/** Simulates two modules at 50 Hz with a run time of 2 ms and statistics every 250 ms. */
function setup(change: Partial<SpeedParameters> = {}, runsHz = 50) {
  const parameters = { ...PARAMETERS, ...change };
  const clock = new FakeClock();
  const stop = new AbortController();
  const done: string[] = [];
  const session: SpeedSession = {
    onStatistics: (fn) =>
      void clock.every(250, () => {
        const runs = (clock.monotonicMs() / 1000) * runsHz;
        const module = { runs, runsPerSecond: runsHz, runP50Ms: 2, runP95Ms: 3 };
        const modules = Array.from(
          { length: parameters.instances },
          () => ({ overruns: 0, errors: 0, restarts: 0, ...module }) as ModuleStatistics,
        );
        fn({
          modules,
          timeMs: clock.nowMs(),
          passesPerSecond: 0,
          passP50Ms: 0,
          passP95Ms: 0,
        } as SessionStatistics);
      }),
    onDuration: (fn) => void clock.every(20, () => fn(1.5)),
    onEcho: (fn) => (echo = fn),
    stamp: (stamp) => void clock.after(7, () => echo(stamp)),
    remove: async () => void done.push('removed'),
  };
  let echo: (stamp: number) => void = () => undefined;
  const world = {
    start: async () => {
      done.push('started');
      return session;
    },
  };
  const run = { clock, signal: stop.signal, report: () => undefined };
  return { clock, stop, done, findings: measureSpeed(parameters, world, run) };
}

describe('session speed', () => {
  it('counts runs, and removes the session', async () => {
    const { clock, done, findings } = setup();
    await clock.advance(6000);
    const { figures, notes } = await findings;
    const value = (key: string) => figures.find((one) => one.key === key)!.value;
    expect(value('runs')).toBeCloseTo(100);
    expect(value('runs.each')).toBeCloseTo(50);
    expect(value('additions')).toBeCloseTo(0.1);
    expect(value('run.p50')).toBe(2);
    expect(value('work.p50')).toBe(1.5);
    expect(value('echo.p50')).toBe(7);
    expect(notes).toEqual([]);
    expect(done).toEqual(['started', 'removed']);
  });

  it('sends the next stamp when the last is back, with trigger on input', async () => {
    const { clock, findings } = setup({ mode: 'triggerOnInput' });
    await clock.advance(6000);
    const { histograms } = await findings;
    const echoes = histograms.find(({ key }) => key === 'echo')!.counts.reduce((a, b) => a + b);
    expect(echoes).toBeGreaterThan(280); // 2 s at 7 ms each.
  });

  it('says when a node cannot keep the frequency', async () => {
    const { clock, findings } = setup({}, 20);
    await clock.advance(6000);
    expect((await findings).notes[0]).toContain('ran 40 times');
  });

  it('removes the session when it is stopped', async () => {
    const { clock, done, findings, stop } = setup();
    await clock.advance(1500);
    stop.abort();
    await clock.advance(10);
    await findings;
    expect(done).toEqual(['started', 'removed']);
  });
});

describe('the temporary session', () => {
  const topics = speedTopics('me');
  const facts = {
    ownerId: 'page',
    nodeId: 'node',
    topics,
    module: { name: 'load-generator' },
    uuid: () => `${next++}`,
  };
  let next = 1;

  it('has so many load generators on the node', () => {
    const session = speedSession({ ...PARAMETERS, instances: 3 }, facts);
    expect(session.processingModules).toHaveLength(3);
    expect(session.processingModules![2]).toMatchObject({
      name: 'load-generator',
      nodeId: 'node',
      processingMode: { frequency: { hertz: 50 } },
    });
    expect(new Set(session.processingModules!.map(({ id }) => id)).size).toBe(3);
    expect(session.ioMappings!.map(({ outputMappings }) => outputMappings!.length)).toEqual([
      2, 0, 0,
    ]);
  });

  it('is abandoned when its page is gone', () => {
    const { tags } = speedSession(PARAMETERS, facts) as { tags: string[] };
    expect(isAbandoned({ tags }, (id) => id === 'page')).toBe(false);
    expect(isAbandoned({ tags }, () => false)).toBe(true);
    expect(isAbandoned({ tags: ['example'] }, () => false)).toBe(false);
  });
});
