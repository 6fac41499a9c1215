import { TokenBucket } from '@ubii/timing';
import { firstCharacters, oneLine } from '@ubii/words';
import type { Limits } from '../limits/index.ts';
import type { LogFields } from '../ports/log.ts';

/** Names of levels, from worst to best. */
export type LevelName = 'error' | 'warn' | 'info' | 'debug';

/** Fields of one line [EX-37]. */
const MAX_FIELDS = 20;
/** Burst size, as seconds of the average rate. */
const BURST_SECONDS = 30;

/** A line of the log as it may be written. */
export interface BoundedLine {
  readonly message: string;
  readonly fields: LogFields;
}

/** Limits a log: lines of bounded size, and a number of bytes per second for each level. [EX-72] */
export class LogBudget {
  readonly #limits: Limits;
  readonly #buckets: { readonly [L in LevelName]: TokenBucket };
  #latestMs: number;
  #leftOut = 0;

  /** @param nowMs Milliseconds of any clock, as in every method. It may jump back. */
  constructor(limits: Limits, nowMs: number) {
    this.#limits = limits;
    this.#latestMs = nowMs;
    const bucket = () =>
      new TokenBucket(limits.logBytesPerSecond, nowMs, BURST_SECONDS * limits.logBytesPerSecond);
    this.#buckets = { error: bucket(), warn: bucket(), info: bucket(), debug: bucket() };
  }

  /** The line as it may be written; undefined when there is no room for it, which is counted. */
  admit(
    level: LevelName,
    message: string,
    fields: LogFields | undefined,
    nowMs: number,
  ): BoundedLine | undefined {
    this.#latestMs = Math.max(this.#latestMs, nowMs);
    const line = this.#bound(message, fields);
    if (this.#buckets[level].take(bytesOf(line), this.#latestMs)) return line;
    this.#leftOut++;
    return undefined;
  }

  /** Returns the number of lines omitted since the last call. */
  takeLeftOut(): number {
    const leftOut = this.#leftOut;
    this.#leftOut = 0;
    return leftOut;
  }

  #bound(message: string, fields: LogFields = {}): BoundedLine {
    const { logCharacters, stackCharacters } = this.#limits;
    const kept = Object.entries(fields)
      .filter(([, value]) => value !== undefined)
      .slice(0, MAX_FIELDS)
      .map(([name, value]) => {
        if (typeof value !== 'string') return [name, value] as const;
        const text =
          name === 'stack'
            ? firstCharacters(value, stackCharacters)
            : oneLine(value, logCharacters);
        return [name, text] as const;
      });
    return { message: oneLine(message, logCharacters), fields: Object.fromEntries(kept) };
  }
}

/** Size of a written line: three bytes for each unit of its texts at most. */
function bytesOf({ message, fields }: BoundedLine): number {
  let length = message.length;
  for (const [name, value] of Object.entries(fields)) length += name.length + String(value).length;
  return 3 * length;
}
