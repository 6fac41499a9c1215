import { fromJson, toJson, type AuditEntry, type JsonObject } from '@ubii/proto';

/** Characters of a line at most: whatever is longer is none of ours. */
const MAX_CHARACTERS = 8_192;

/** An entry as one line of JSON, as the audit log is kept [EX-92]. */
export function lineOfAuditEntry(entry: AuditEntry): string {
  return JSON.stringify(toJson('ubii.extension.AuditEntry', entry));
}

/** An entry as it was kept; undefined when the line is none, as one that was cut off. */
export function auditEntryFromLine(line: string): AuditEntry | undefined {
  if (line.length > MAX_CHARACTERS) return undefined;
  try {
    const entry = fromJson('ubii.extension.AuditEntry', JSON.parse(line) as JsonObject);
    return Number.isFinite(entry.number) && Number.isFinite(entry.timeMs) ? entry : undefined;
  } catch {
    return undefined;
  }
}
