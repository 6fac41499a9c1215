import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { SleepWatch } from './sleep-watch.ts';

function setup() {
  const clock = new FakeClock();
  let wakes = 0;
  const watch = new SleepWatch(clock, () => (wakes += 1));
  watch.start();
  return { clock, watch, wakes: () => wakes };
}

describe('SleepWatch [CL-41]', () => {
  it('notices a sleep in which the monotonic clock stood still', async () => {
    const { clock, wakes } = setup();
    await clock.advance(10_000);
    clock.setWall(60_000);
    expect(wakes()).toBe(0);
    await clock.advance(500);
    expect(wakes()).toBe(1);
    await clock.advance(10_000);
    expect(wakes()).toBe(1);
  });

  it('notices timers that stood still', async () => {
    const { clock, wakes } = setup();
    await clock.sleep(60_000);
    expect(wakes()).toBe(1);
  });

  it('takes the late timers of a hidden page, and a clock that is set back, for no sleep', async () => {
    const { clock, wakes } = setup();
    await clock.sleep(1_500);
    clock.setWall(-3_600_000);
    await clock.advance(5_000);
    expect(wakes()).toBe(0);
  });

  it('watches no more when it is stopped', async () => {
    const { clock, watch, wakes } = setup();
    watch.start();
    watch.stop();
    await clock.sleep(60_000);
    expect(wakes()).toBe(0);
    expect(clock.timerCount).toBe(0);
  });
});
