import type { Clock } from '@ubii/timing';
import type { MasterTime } from '../core/time/master-time.ts';

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
