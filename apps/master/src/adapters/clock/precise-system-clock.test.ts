import { describe, expect, it } from 'vitest';
import { preciseClockSuite } from '@ubii/timing/testing';
import { FineTime, PreciseSystemClock } from './precise-system-clock.ts';
import { RecordingLog } from '../../testing/index.ts';

const EPOCH_MS = 1_767_225_600_000;

/** A machine whose clocks are read in time steps of their own. */
function setup() {
  let trueMs = 0.3;
  let setMs = 0;
  const machine = {
    pass: (ms: number) => (trueMs += ms),
    set: (ms: number) => (setMs += ms),
    get wallMs() {
      return EPOCH_MS + setMs + trueMs;
    },
  };
  const fine = new FineTime(
    () => Math.floor(machine.wallMs),
    () => (trueMs += 0.001),
  );
  return { machine, fine };
}

describe('the time with fractions', () => {
  it('is that of the system, to a few microseconds', () => {
    const { machine, fine } = setup();
    for (const ms of [0, 0.4, 0.7, 12.34, 1000.5]) {
      machine.pass(ms);
      expect(Math.abs(fine.nowMs() - machine.wallMs)).toBeLessThan(0.02);
    }
  });

  it('follows a clock that is set, forwards and back', () => {
    const { machine, fine } = setup();
    fine.nowMs();
    for (const ms of [5_000.25, -86_400_000.5, 0.4, -0.6]) {
      machine.set(ms);
      machine.pass(3.1);
      expect(Math.abs(fine.nowMs() - machine.wallMs)).toBeLessThan(1.01);
    }
  });

  it('follows a clock that runs at another speed', () => {
    const { machine, fine } = setup();
    for (let i = 0; i < 2_000; i += 1) {
      machine.pass(7.77);
      machine.set(7.77 * 500e-6);
      const errorMs = Math.abs(fine.nowMs() - machine.wallMs);
      expect(errorMs).toBeLessThan(1.01);
    }
  });
});

preciseClockSuite('PreciseSystemClock', () => ({
  clock: new PreciseSystemClock(new RecordingLog()),
  passTime: () => undefined,
}));

it('a turn ends after what was promised in it', async () => {
  const clock = new PreciseSystemClock(new RecordingLog());
  const order: string[] = [];
  await new Promise<void>((resolve) => {
    clock.atEndOfTurn(() => {
      order.push('end');
      resolve();
    });
    void Promise.resolve().then(() => order.push('promised'));
  });
  expect(order).toEqual(['promised', 'end']);
});

it('a task that fails is logged and stops no other', async () => {
  const log = new RecordingLog();
  const clock = new PreciseSystemClock(log);
  await new Promise<void>((resolve) => {
    clock.atEndOfTurn(() => {
      throw new Error('first fails');
    });
    clock.atEndOfTurn(resolve);
  });
  expect(log.lines).toMatchObject([{ level: 'error', fields: { reason: 'Error: first fails' } }]);
});
