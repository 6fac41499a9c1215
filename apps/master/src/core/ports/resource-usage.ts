/** Resources that the process used during an interval. */
export interface UsageMeasurement {
  /** Share of one core used by all threads, percent: 100 is one core. */
  readonly cpuPercent: number;
  /** Share of the time in which the thread of the master was busy, percent. At 100 everything waits. */
  readonly busyPercent: number;
  /** Event-loop delay, 99th percentile, milliseconds. */
  readonly delayMs: number;
}

/** Measures the resources that the process uses. */
export interface ResourceUsage {
  /** Returns the usage since the previous call; zeros at the first call. For one caller. */
  measure(): UsageMeasurement;
  /** Resident memory, bytes. */
  memoryBytes(): number;
  /** Cores of the machine, at least 1. */
  readonly processors: number;
}
