import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { findKnee, type LoadStep } from './knee.ts';
import { rampOf, type LoadParameters } from './load-parameters.ts';
import { measureLoad, type LoadClient } from './measure-load.ts';

const PARAMETERS: LoadParameters = {
  sizeBytes: 100,
  clients: 2,
  receivers: 'one',
  fromHz: 100,
  toHz: 1600,
  factor: 2,
  secondsPerStep: 1,
};

/** Simulates a master with a latency of 2 ms up to a rate, and a growing queue above it. */
function setup(limitHz: number, parameters = PARAMETERS) {
  const clock = new FakeClock();
  const stop = new AbortController();
  let freeMs = 0;
  const listeners: ((publisher: number, sequence: number) => void)[] = [];
  const clients: LoadClient[] = Array.from({ length: parameters.clients }, (_, index) => ({
    publish(sequence) {
      freeMs = Math.max(freeMs, clock.monotonicMs()) + 1000 / limitHz;
      const receivers = parameters.receivers === 'all' ? listeners : [listeners[index]!];
      clock.after(freeMs + 2 - clock.monotonicMs(), () =>
        receivers.forEach((take) => take(index, sequence)),
      );
    },
    onRecord: (fn) => (listeners[index] = fn),
  }));
  const run = { clock, signal: stop.signal, report: () => undefined };
  const world = { clients, masterCpuPercent: async () => 95 };
  return { clock, stop, findings: measureLoad(parameters, world, run) };
}

describe('message load', () => {
  it('ramps until latency rises, and finds the knee', async () => {
    const { clock, findings } = setup(500);
    await clock.advance(60_000);
    const { figures, curves, notes } = await findings;
    expect(curves[0]!.x.values).toEqual([100, 200, 400, 800, 1600]);
    expect(curves[0]!.mark).toMatchObject({ x: 400 });
    expect(figures.find(({ key }) => key === 'knee')!.value).toBeCloseTo(400, -1);
    expect(notes[0]).toContain('The master was the limit');
    expect(clock.timerCount).toBe(0);
  });

  it('says so when there is no knee', async () => {
    const { clock, findings } = setup(100_000);
    await clock.advance(60_000);
    const { notes, figures } = await findings;
    expect(notes[0]).toContain('No knee up to 1600');
    expect(figures.find(({ key }) => key === 'lost')!.value).toBe(0);
  });

  it('counts deliveries to all', async () => {
    const { clock, findings } = setup(100_000, { ...PARAMETERS, clients: 3, receivers: 'all' });
    await clock.advance(60_000);
    const { figures } = await findings;
    expect(figures.find(({ key }) => key === 'peak')!.value).toBeCloseTo(4800, -2);
    expect(figures.find(({ key }) => key === 'lost')!.value).toBe(0);
  });

  it('can be stopped, and gives the steps it has', async () => {
    const { clock, stop, findings } = setup(100_000);
    await clock.advance(2500);
    stop.abort();
    await clock.advance(10);
    expect((await findings).curves[0]!.x.values).toEqual([100, 200]);
  });
});

describe('ramp', () => {
  it('ends at the highest rate', () => {
    expect(rampOf({ ...PARAMETERS, fromHz: 100, toHz: 1000, factor: 3 })).toEqual([
      100, 300, 900, 1000,
    ]);
    expect(rampOf({ ...PARAMETERS, fromHz: 100, toHz: 100 })).toEqual([100]);
  });
});

describe('knee', () => {
  const step = (change: Partial<LoadStep>): LoadStep => ({
    wantedHz: 100,
    sentHz: 100,
    deliveredHz: 100,
    lostShare: 0,
    p50Ms: 1,
    p95Ms: 2,
    p99Ms: 3,
    lagP95Ms: 0,
    masterCpuPercent: 10,
    ...change,
  });

  it('is no hiccup of one step', () => {
    const knee = findKnee([step({}), step({ p95Ms: 50 }), step({}), step({})]);
    expect(knee.firstBad).toBeUndefined();
  });

  it('is the browser when it cannot publish that fast', () => {
    const knee = findKnee([step({}), step({ sentHz: 50 }), step({ sentHz: 40 })]);
    expect(knee).toMatchObject({ lastGood: 0, firstBad: 1, trouble: 'browser', isBrowser: true });
  });

  it('is the browser when its own lateness explains the latency', () => {
    const knee = findKnee([step({}), step({ p95Ms: 60, lagP95Ms: 50 }), step({ p95Ms: 90 })]);
    expect(knee).toMatchObject({ trouble: 'latency', isBrowser: true });
  });

  it('is where records are lost', () => {
    const knee = findKnee([step({}), step({ lostShare: 0.1 }), step({ lostShare: 0.2 })]);
    expect(knee).toMatchObject({ lastGood: 0, trouble: 'losses', isBrowser: false });
  });

  it('may be in the first step', () => {
    expect(findKnee([step({ lostShare: 1 }), step({ lostShare: 1 })]).lastGood).toBe(-1);
  });
});
