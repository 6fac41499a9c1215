import type { Clock } from '@ubii/pm-sandbox';
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
