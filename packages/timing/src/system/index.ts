export { SystemClock, systemClock, type SystemClockOptions } from './system-clock.ts';
