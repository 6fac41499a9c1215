import { BRIDGE_LIMITS } from '../limits.ts';
import { shown } from '../payload/plain-values.ts';

/** Larger values are shown by their size, and not kept. */
const KEPT_VALUE_BYTES = 4_096;

/** How one direction of a mapping does. [BR-33] */
export interface ForwarderReport {
  readonly passed: number;
  /** Content that does not fit, or an address that may not be used. */
  readonly refused: number;
  /** Over a limit, or replaced by a newer one. */
  readonly dropped: number;
  /** Not sent back to where it came from. */
  readonly returned: number;
  /** Topics, or addresses, that were quiet for longest and made room for new ones. [BR-34] */
  readonly evicted: number;
  /** Topics, or addresses, that the mapping has made. */
  readonly topics: number;
  readonly lastError?: {
    readonly message: string;
    readonly atMs: number;
    readonly address: string;
  };
  readonly lastValue?: { readonly address: string; readonly text: string; readonly atMs: number };
}

/** Counts for one direction of a mapping. */
export class ForwarderCounters {
  #passed = 0;
  #refused = 0;
  #dropped = 0;
  #returned = 0;
  #evicted = 0;
  #lastError: ForwarderReport['lastError'];
  #last: { readonly address: string; readonly value: unknown; readonly atMs: number } | undefined;

  handlePassed(address: string, value: unknown, sizeBytes: number, atMs: number): void {
    this.#passed++;
    const kept = sizeBytes <= KEPT_VALUE_BYTES ? value : `${sizeBytes} bytes`;
    this.#last = { address, value: kept, atMs };
  }

  handleRefused(address: string, message: string, atMs: number): void {
    this.#refused++;
    this.#lastError = { address, message, atMs };
  }

  handleDropped(address: string, message: string, atMs: number): void {
    this.#dropped++;
    this.#lastError = { address, message, atMs };
  }

  /** A newer value took its place: that is no error. */
  handleReplaced(): void {
    this.#dropped++;
  }

  handleReturned(): void {
    this.#returned++;
  }

  handleEvicted(): void {
    this.#evicted++;
  }

  report(topics: number): ForwarderReport {
    const last = this.#last && {
      address: this.#last.address,
      text: shown(this.#last.value, BRIDGE_LIMITS.shownChars),
      atMs: this.#last.atMs,
    };
    return {
      passed: this.#passed,
      refused: this.#refused,
      dropped: this.#dropped,
      returned: this.#returned,
      evicted: this.#evicted,
      topics,
      ...(this.#lastError && { lastError: this.#lastError }),
      ...(last && { lastValue: last }),
    };
  }
}
