export { clockSuite, preciseClockSuite, type ClockSuiteWorld } from './clock-suite.ts';
export { FakeClock, settle } from './fake-clock.ts';
