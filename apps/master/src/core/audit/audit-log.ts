import {
  fromJson,
  toJson,
  type AuditEntry,
  type JsonObject,
  type AuditLogRequest,
  type AuditLog as AuditLogMessage,
  type Init,
} from '@ubii/proto';
import { TokenBucket, type Clock } from '@ubii/timing';
import type { Limits } from '../limits/index.ts';
import type { AuditStore } from '../ports/audit-store.ts';

/** Characters of a line at most: whatever is longer is none of ours. */
const MAX_CHARACTERS = 8_192;

/** An entry as one line of JSON, as the audit log is kept [EX-92]. */
function lineOfAuditEntry(entry: AuditEntry): string {
  return JSON.stringify(toJson('ubii.extension.AuditEntry', entry));
}

/** An entry as it was kept; undefined when the line is none, as one that was cut off. */
function auditEntryFromLine(line: string): AuditEntry | undefined {
  if (line.length > MAX_CHARACTERS) return undefined;
  try {
    const entry = fromJson('ubii.extension.AuditEntry', JSON.parse(line) as JsonObject);
    return Number.isFinite(entry.number) && Number.isFinite(entry.timeMs) ? entry : undefined;
  } catch {
    return undefined;
  }
}

/** Seconds of entries of one caller that may come at once. */
const BURST_SECONDS = 60;
/** Callers whose rate is remembered; of more, that of the one that was quiet for longest is forgotten. */
const KNOWN_CALLERS = 1_000;
/** Allowance for all callers of one kind of access together, as a multiple of that for one caller. */
const CALLERS_OF_ONE_WAY = 8;
const DEFAULT_COUNT = 100;
const MAX_COUNT = 500;

/** An entry without the members that the log adds. */
type AuditNote = Omit<AuditEntry, 'number' | 'timeMs' | 'leftOut'>;

/** Dependencies of an audit log. */
interface AuditContext {
  readonly clock: Clock;
  readonly limits: Limits;
  readonly audit: AuditStore;
}

interface CallerRate {
  readonly bucket: TokenBucket;
  leftOut: number;
}

/** Actions of admins and participants, kept over restarts of the master [EX-90] [EX-92]. */
export class AuditLog {
  readonly #context: AuditContext;
  /** Oldest first. */
  readonly #entries: AuditEntry[] = [];
  readonly #rates = new Map<string, CallerRate>();
  #lastNumber = 0;

  constructor(context: AuditContext) {
    this.#context = context;
    for (const line of context.audit.read()) {
      const entry = auditEntryFromLine(line);
      // Whatever stands in a file: numbers grow.
      if (entry === undefined || entry.number <= this.#lastNumber) continue;
      this.#lastNumber = entry.number;
      this.#push(entry);
    }
  }

  /** Adds an entry, unless the caller or its invitation exceeds the rate limit [EX-94]. */
  add(note: AuditNote): void {
    const { clock, limits, audit } = this.#context;
    const { auditEntriesPerSecond: perSecond } = limits;
    const way = note.grantId || String(note.way);
    const rate = this.#rateOf(`caller ${note.clientId || way}`, perSecond);
    // Else one who joins again and again would push out what others did.
    const ofWay = this.#rateOf(`way ${way}`, CALLERS_OF_ONE_WAY * perSecond);
    const nowMs = clock.monotonicMs();
    if (!rate.bucket.take(1, nowMs) || !ofWay.bucket.take(1, nowMs)) {
      rate.leftOut++;
      return;
    }
    const { leftOut } = rate;
    rate.leftOut = 0;
    const entry = { ...note, number: ++this.#lastNumber, timeMs: clock.nowMs(), leftOut };
    this.#push(entry);
    audit.append(lineOfAuditEntry(entry));
  }

  /** A page of entries, the newest first [EX-93]. */
  read({
    before,
    count,
    clientId,
    grantId,
    service,
    text,
  }: AuditLogRequest): Init<AuditLogMessage> {
    const most = count > 0 ? Math.min(count, MAX_COUNT) : DEFAULT_COUNT;
    const words = text.toLowerCase().split(/\s+/).filter(Boolean);
    const entries: AuditEntry[] = [];
    for (let i = this.#entries.length - 1; i >= 0; i--) {
      const entry = this.#entries[i]!;
      const fits =
        (before === 0 || entry.number < before) &&
        (clientId === '' || entry.clientId === clientId) &&
        (grantId === '' || entry.grantId === grantId) &&
        entry.service.includes(service) &&
        hasWords(entry, words);
      if (!fits) continue;
      if (entries.length === most) return this.#page(entries, true);
      entries.push(entry);
    }
    return this.#page(entries, false);
  }

  #page(entries: AuditEntry[], more: boolean): Init<AuditLogMessage> {
    return { entries, more, kept: this.#entries.length };
  }

  #push(entry: AuditEntry): void {
    this.#entries.push(entry);
    if (this.#entries.length > this.#context.limits.auditEntries) this.#entries.shift();
  }

  #rateOf(caller: string, perSecond: number): CallerRate {
    const { clock } = this.#context;
    const known = this.#rates.get(caller);
    this.#rates.delete(caller);
    const bucket = () => new TokenBucket(perSecond, clock.monotonicMs(), BURST_SECONDS * perSecond);
    const rate = known ?? { bucket: bucket(), leftOut: 0 };
    this.#rates.set(caller, rate); // the newest last
    const [quietest] = this.#rates.keys();
    if (this.#rates.size > KNOWN_CALLERS) this.#rates.delete(quietest!);
    return rate;
  }
}

function hasWords(entry: AuditEntry, words: readonly string[]): boolean {
  if (words.length === 0) return true;
  const { service, object, error, clientName, clientId, grantLabel } = entry;
  const text = [service, object, error, clientName, clientId, grantLabel].join(' ').toLowerCase();
  return words.every((word) => text.includes(word));
}
