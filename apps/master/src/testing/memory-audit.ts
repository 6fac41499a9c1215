import type { AuditStore } from '../core/ports/audit-store.ts';

/** An audit log in memory, which may be given to a second run of the master. */
export class MemoryAudit implements AuditStore {
  readonly lines: string[] = [];

  read(): readonly string[] {
    return [...this.lines];
  }

  append(line: string): void {
    this.lines.push(line);
  }

  settled(): Promise<void> {
    return Promise.resolve();
  }
}
