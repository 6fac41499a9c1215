/** What the process takes from the machine. */
export interface ResourceUsage {
  /** Share of one core used since the call before, percent; 0 at the first call. */
  cpuPercent(): number;
  /** Resident memory, bytes. */
  memoryBytes(): number;
}
