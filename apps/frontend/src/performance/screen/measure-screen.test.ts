import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { measureScreen, type ScreenWorld } from './measure-screen.ts';

const FRAME_MS = 16;

/** Simulates a screen with frames every 16 ms, and a master with a latency of 3 ms. */
function setup({ loses = () => false }: { loses?: (value: number) => boolean } = {}) {
  const clock = new FakeClock();
  const stop = new AbortController();
  const drawn: number[] = [];
  let receive: (value: number) => void = () => undefined;
  const world: ScreenWorld = {
    publish(value) {
      if (!loses(value)) clock.after(3, () => receive(value));
    },
    onValue: (fn) => (receive = fn),
    draw: (value) => void drawn.push(value),
    nextFrame: (fn) => void clock.after(FRAME_MS - (clock.monotonicMs() % FRAME_MS), fn),
    random: () => 0.5,
  };
  const run = { clock, signal: stop.signal, report: () => undefined };
  const findings = measureScreen({ rateHz: 20, seconds: 2 }, world, run);
  return { clock, stop, findings, drawn };
}

describe('topic to screen', () => {
  it('is the way to the page and the wait for the frame', async () => {
    const { clock, findings, drawn } = setup();
    await clock.advance(6000);
    const { figures } = await findings;
    const value = (key: string) => figures.find((one) => one.key === key)!.value;
    expect(value('received.p50')).toBe(3);
    expect(value('total.max')).toBeLessThanOrEqual(3 + FRAME_MS);
    expect(value('total.p50')).toBeGreaterThanOrEqual(3);
    expect(value('frame.p50')).toBe(FRAME_MS);
    expect(value('drawn')).toBe(value('sent'));
    expect(value('lost')).toBe(0);
    expect(drawn).toEqual([...drawn].sort((a, b) => a - b));
  });

  it('counts what is never drawn', async () => {
    const { clock, findings } = setup({ loses: (value) => value % 2 === 0 });
    await clock.advance(6000);
    const { figures } = await findings;
    expect(figures.find(({ key }) => key === 'lost')!.value).toBeGreaterThan(15);
  });

  it('can be stopped, and then draws no more', async () => {
    const { clock, stop, findings } = setup();
    await clock.advance(1000);
    stop.abort();
    await clock.advance(2000);
    expect((await findings).figures.some(({ key }) => key === 'lost')).toBe(false);
    expect(clock.timerCount).toBe(0);
  });
});
