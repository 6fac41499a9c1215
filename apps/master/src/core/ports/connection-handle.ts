import type { TimedPing } from '@ubii/proto/wire';
import type { ClientEnding } from './close-reason.ts';

/**
 * The master's side of one live connection: the adapter of the transport calls it. No method throws. After
 * `handleClose`, or once another connection of the client took over, calls are ignored.
 */
export interface ConnectionHandle {
  /** Input has arrived: messages follow, in the same turn, until `handleReadEnd`. An adapter that cannot tell leaves both out. */
  handleReadStart(): void;
  /** All messages of the input that has arrived were handed over. */
  handleReadEnd(): void;
  /** One encoded `TopicData`. Takes over `bytes` and their buffer: the caller must not modify them any more. */
  handleTopicData(bytes: Uint8Array): void;
  /** The client asks whether the master is there [EX-6], and with `timed` for its time [TS-2]. */
  handlePing(timed?: TimedPing): void;
  /** The client answers a ping of the master. */
  handlePong(): void;
  /** The system took all that was handed over: `queuedBytes` is small again. Due after it grew beyond `limits.connectionQueuedBytes`. */
  handleDrain(): void;
  /** Input that is none of these, or that the adapter refused, such as a message over the size limit. `reason` is one sentence. Counted as a protocol error. */
  handleProtocolError(reason: string): void;
  /** The connection is closed. */
  handleClose(ending: ClientEnding): void;
}
