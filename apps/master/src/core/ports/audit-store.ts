/** Persistent storage of the audit log: lines of text, of which the oldest are dropped above a limit. */
export interface AuditStore {
  /** Lines that earlier runs kept, oldest first, without their ends. A line that was cut off may be among them. */
  read(): readonly string[];
  /** Keeps a line, without its end, some time later. Never throws, and never waits. */
  append(line: string): void;
  /** Fulfilled when all lines are kept, or could not be. */
  settled(): Promise<void>;
}
