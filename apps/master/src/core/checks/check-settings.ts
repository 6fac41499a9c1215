/** Thresholds of the checks of the master, and their consequence [EX-48]. */
export interface CheckSettings {
  /** `off`: nothing is looked for. `warn`: problems and events. `throttle`: noisy publishers are throttled as well. */
  readonly checks: 'off' | 'warn' | 'throttle';
  /** Share of the time above which the master, or the machine, is busy, percent. */
  readonly busyPercent: number;
  /** Share of the master's time that the records of one client may take, percent. */
  readonly publisherPercent: number;
}

export const DEFAULT_CHECKS: CheckSettings = {
  checks: 'warn',
  busyPercent: 80,
  publisherPercent: 40,
};
