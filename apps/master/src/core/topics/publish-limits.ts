import type { LimitName } from '../limits/index.ts';

/** A limit that holds for a client, with its name for messages. */
export interface HeldLimit {
  readonly name: LimitName;
  readonly value: number;
}

/** Limits of what one client publishes. [TD-70] */
export interface PublishLimits {
  readonly frameBytes: HeldLimit;
  readonly frameRecords: HeldLimit;
  readonly recordFields: HeldLimit;
  readonly recordsPerSecond: HeldLimit;
  readonly bytesPerSecond: HeldLimit;
}
