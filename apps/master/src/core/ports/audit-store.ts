/** Where the audit log is kept between runs: lines of text, the oldest of which go when there are too many. */
export interface AuditStore {
  /** Lines that earlier runs kept, oldest first, without their ends. A line that was cut off may be among them. */
  read(): readonly string[];
  /** Keeps a line, without its end, some time later. Never throws, and never waits. */
  append(line: string): void;
  /** Fulfilled when all lines are kept, or could not be. */
  settled(): Promise<void>;
}
