import { describe, expect, it } from 'vitest';
import { clockSuite, preciseClockSuite } from './clock-suite.ts';
import { FakeClock } from './fake-clock.ts';

clockSuite('FakeClock', () => {
  const clock = new FakeClock();
  return { clock, passTime: () => clock.advance(100) };
});
preciseClockSuite('FakeClock, without promises', () => {
  const clock = new FakeClock();
  return { clock, passTime: () => clock.advanceSync(100) };
});

describe('FakeClock', () => {
  it('stands still until it is told to move', () => {
    const clock = new FakeClock(5_000);
    expect([clock.nowMs(), clock.monotonicMs()]).toEqual([5_000, 0]);
    clock.advanceSync(10);
    expect([clock.nowMs(), clock.monotonicMs()]).toEqual([5_010, 10]);
  });

  it('calls timers in the order they are due, each at its time', () => {
    const clock = new FakeClock();
    const calls: [string, number][] = [];
    const note = (name: string) => (): void => void calls.push([name, clock.monotonicMs()]);
    clock.after(30, note('late'));
    clock.every(20, note('interval'));
    clock.after(10, note('early'));
    clock.advanceSync(40);
    expect(calls).toEqual([
      ['early', 10],
      ['interval', 20],
      ['late', 30],
      ['interval', 40],
    ]);
    expect(clock.timerCount).toBe(1);
  });

  it('ends the turn of each timer before the next, with what was promised', async () => {
    const clock = new FakeClock();
    const order: string[] = [];
    clock.after(1, () => {
      clock.atEndOfTurn(() => order.push('end'));
      void Promise.resolve().then(() => order.push('promised'));
    });
    clock.after(1, () => order.push('next'));
    await clock.advance(1);
    expect(order).toEqual(['promised', 'end', 'next']);
  });

  it('calls timers late when a turn takes long', () => {
    const clock = new FakeClock();
    const calls: number[] = [];
    clock.after(10, () => calls.push(clock.monotonicMs()));
    clock.spend(25);
    expect(calls).toEqual([]);
    clock.advanceSync(0);
    expect(calls).toEqual([25]);
  });

  it('calls an interval once after a sleep, and then as before', async () => {
    const clock = new FakeClock();
    const calls: number[] = [];
    clock.every(10, () => calls.push(clock.monotonicMs()));
    await clock.sleep(1_000);
    expect(calls).toEqual([1_000]);
    await clock.advance(10);
    expect(calls).toEqual([1_000, 1_010]);
  });

  it('moves the time of day alone when that is set', () => {
    const clock = new FakeClock(5_000);
    clock.after(1, () => expect.unreachable());
    clock.setWall(3_600_000);
    clock.advanceSync(0);
    expect([clock.nowMs(), clock.monotonicMs()]).toEqual([3_605_000, 0]);
  });
});
