import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import type { Findings } from '../measure/findings.ts';
import type { Progress } from '../measure/test-run.ts';
import {
  measureRoundTrip,
  type EchoTopic,
  type RoundTripParameters,
} from './measure-round-trip.ts';

const PARAMETERS: RoundTripParameters = { ways: ['immediate'], rateHz: 100, seconds: 2 };

/** Simulates a master that echoes after a delay; `undefined`: never. */
function setup(delayMs: (sequence: number) => number | undefined, parameters = PARAMETERS) {
  const clock = new FakeClock();
  const stop = new AbortController();
  const reports: Progress[] = [];
  let echo: (sequence: number) => void = () => undefined;
  const topic: EchoTopic = {
    publish(sequence) {
      const delay = delayMs(sequence);
      if (delay !== undefined) clock.after(delay, () => echo(sequence));
    },
    onEcho: (fn) => (echo = fn),
  };
  const run = { clock, signal: stop.signal, report: (one: Progress) => void reports.push(one) };
  const findings = measureRoundTrip(parameters, topic, run);
  return { clock, stop, reports, findings, echoAgain: (sequence: number) => echo(sequence) };
}
const figure = (findings: Findings, key: string) =>
  findings.figures.find((one) => one.key === key)?.value;

describe('round trip', () => {
  it('times each record until it is back', async () => {
    const { clock, findings, reports } = setup((sequence) => (sequence % 10 === 9 ? 20 : 2));
    await clock.advance(10_000);
    const found = await findings;
    expect(figure(found, 'immediate.p50')).toBe(2);
    expect(figure(found, 'immediate.p95')).toBe(20);
    expect(figure(found, 'immediate.sent')).toBe(200);
    expect(figure(found, 'immediate.returned')).toBe(200);
    expect(figure(found, 'immediate.lost')).toBe(0);
    expect(found.histograms[0]!.counts.reduce((a, b) => a + b)).toBe(200);
    expect(found.notes).toEqual([]);
    expect(reports.map(({ share }) => share)).toEqual(
      reports.map(({ share }) => share).sort((a, b) => a - b),
    );
    expect(clock.timerCount).toBe(0);
  });

  it('calls lost what does not come back', async () => {
    const { clock, findings } = setup((sequence) => (sequence % 4 === 0 ? undefined : 1));
    await clock.advance(10_000);
    expect(figure(await findings, 'immediate.lost')).toBe(50);
  });

  it('counts a record once', async () => {
    const { clock, findings, echoAgain } = setup(() => 1);
    await clock.advance(1000);
    for (let sequence = 0; sequence < 50; sequence++) echoAgain(sequence);
    await clock.advance(9000);
    expect(figure(await findings, 'immediate.returned')).toBe(200);
  });

  it('measures both ways, one after the other', async () => {
    const { clock, findings } = setup(() => 1, {
      ...PARAMETERS,
      ways: ['immediate', 'aggregated'],
    });
    await clock.advance(10_000);
    const found = await findings;
    expect(figure(found, 'immediate.sent')).toBe(200);
    expect(figure(found, 'aggregated.sent')).toBe(200);
    expect(found.curves).toHaveLength(2);
  });

  it('can be stopped, gives what it has, and calls nothing lost', async () => {
    const { clock, findings, stop } = setup(() => 5);
    await clock.advance(1300);
    stop.abort();
    await clock.advance(0);
    const found = await findings;
    expect(figure(found, 'immediate.sent')).toBeGreaterThan(50);
    expect(figure(found, 'immediate.lost')).toBeUndefined();
    // Only the pending echoes have timers left.
    await clock.advance(10);
    expect(clock.timerCount).toBe(0);
  });
});
