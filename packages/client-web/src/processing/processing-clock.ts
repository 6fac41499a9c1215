import type { Clock } from '@ubii/pm-sandbox';
import type { MasterTime } from '../core/time/master-time.ts';
import { systemClock } from '../system-clock.ts';

/** The system's time and event loop. */
export const processingClock: Clock = {
  nowMs: () => systemClock.nowMs(),
  monotonicMs: () => systemClock.monotonicMs(),
  every: (intervalMs, fn) => systemClock.every(intervalMs, fn),
  after: (delayMs, fn) => systemClock.after(delayMs, fn),
  // A frame, a message of a worker and a timer each are a turn of their own here.
  atEndOfTurn: (fn) => queueMicrotask(fn),
};

/** A clock with the master's time of day. */
export function inMasterTime(clock: Clock, masterTime: MasterTime): Clock {
  return {
    nowMs: () => masterTime.nowMs(),
    monotonicMs: () => clock.monotonicMs(),
    every: (intervalMs, fn) => clock.every(intervalMs, fn),
    after: (delayMs, fn) => clock.after(delayMs, fn),
    atEndOfTurn: (fn) => clock.atEndOfTurn(fn),
  };
}
