import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import type { Deferred } from '../callbacks/deferred.ts';
import { Probe } from './probe.ts';

function setup(usualTripMs?: number) {
  const clock = new FakeClock();
  const questions: Deferred<void>[] = [];
  const deaths: number[] = [];
  const probe = new Probe({
    clock,
    ask: (answered) => questions.push(answered),
    usualTripMs: () => usualTripMs,
    handleDead: (waitedMs) => deaths.push(waitedMs),
  });
  return { clock, questions, deaths, probe };
}

describe('a probe of a link that seems open [CL-42]', () => {
  it('is content with the answer to its question', async () => {
    const { clock, questions, deaths, probe } = setup();
    probe.start();
    await clock.advance(900);
    questions[0]!.resolve();
    await clock.advance(10_000);
    expect(deaths).toEqual([]);
    expect(clock.timerCount).toBe(0);
  });

  it.each([
    [undefined, 1_000],
    [3, 1_000],
    [400, 1_600],
    [9_000, 2_000],
  ])('with a usual round trip of %s ms gives up after %d ms', async (tripMs, waitMs) => {
    const { clock, deaths, probe } = setup(tripMs);
    probe.start();
    await clock.advance(waitMs - 1);
    expect(deaths).toEqual([]);
    await clock.advance(1);
    expect(deaths).toEqual([waitMs]);
  });

  it('does not believe frames that were on their way before', async () => {
    const { clock, deaths, probe } = setup();
    probe.start();
    probe.handleFrame();
    await clock.advance(200);
    probe.handleFrame();
    await clock.advance(800);
    expect(deaths).toHaveLength(1);
  });

  it('asks again while frames go on coming: the answer waits behind them', async () => {
    const { clock, questions, deaths, probe } = setup();
    probe.start();
    await clock.advance(600);
    probe.handleFrame();
    await clock.advance(400);
    expect(deaths).toEqual([]);
    expect(questions).toHaveLength(2);
    await clock.advance(1_000);
    expect(deaths).toHaveLength(1);
  });

  it('asks one question at a time, and an earlier answer is none to the later one', async () => {
    const { clock, questions, deaths, probe } = setup();
    probe.start();
    probe.start();
    expect(questions).toHaveLength(1);
    probe.cancel();
    probe.start();
    questions[0]!.resolve();
    await clock.advance(1_000);
    expect(deaths).toHaveLength(1);
  });

  it('asks again when the deadline was slept through', async () => {
    const { clock, questions, deaths, probe } = setup();
    probe.start();
    await clock.sleep(60_000);
    expect(deaths).toEqual([]);
    expect(questions).toHaveLength(2);
    questions[1]!.resolve();
    await clock.advance(10_000);
    expect(deaths).toEqual([]);
  });
});
