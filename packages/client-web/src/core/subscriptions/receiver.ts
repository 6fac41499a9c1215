import type { ReceivedRecord } from './received-record.ts';
import type { ServerPattern } from './topic-pattern.ts';

/** A subscription of the program, as the table of subscriptions sees it. */
export interface Receiver {
  readonly serverPattern: ServerPattern;
  /** Records of a topic per second; `Infinity` for all. */
  readonly maxRateHz: number;
  /** True when it may take over the buffer of a record that has no other receiver. */
  readonly takesBuffers: boolean;
  /** @param isSole true: the buffer of the record is the receiver's, if it is transferable */
  handleRecord(record: ReceivedRecord, isSole: boolean): void;
  /** The topic no longer has a value. */
  handleGone(topic: string): void;
  /** The master has accepted it. */
  handleAccepted(): void;
  /** Ends it, with the error if there is one. */
  end(error: Error | undefined): void;
  /** The client stopped permanently, but may connect again. */
  failIterators(error: Error): void;
}
