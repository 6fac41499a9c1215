import type { ErrorMessage } from '@ubii/proto';
import type { TimedPong } from '@ubii/proto/wire';
import type { CloseReason } from './close-reason.ts';
import type { RecordBatch } from './record-batch.ts';

/** The live connection of one client, as the adapter of a transport offers it. No method throws, whatever its state. */
export interface ClientConnection {
  /**
   * Hands over records, in order. Where record lists are off (the default), each record is a message of
   * its own; where they are on, the batch is one message.
   */
  send(batch: RecordBatch): void;
  /** Sends a `TopicData` that holds this error. */
  sendError(error: ErrorMessage): void;
  /** Sends one complete encoded `TopicData`. */
  sendFrame(frame: Uint8Array): void;
  /** Asks the client whether it is there. Anything that comes from it then says so; its answer is `handlePong`. */
  sendPing(): void;
  /** Answers a ping of the client, with the master's time if it was asked for. */
  sendPong(timed?: TimedPong): void;
  /** Bytes handed over that the system has not taken yet. */
  readonly queuedBytes: number;
  /**
   * Ends the connection after all that was sent, and tells the client why, as far as the transport can.
   * `handleClose` follows, now or later.
   *
   * @param explanation text for users; cut to what the transport can carry
   */
  close(reason: CloseReason, explanation?: string): void;
  /** Whether a batch may leave as one message. Set before the first batch, may change later. */
  setRecordLists(on: boolean): void;
  /**
   * Whether messages of the client are read; at the beginning they are. While they are not, they wait at the client
   * and in the system; those that were read already may still come. A connection without it has every message handled
   * at once. [TD-71]
   */
  setReading?(on: boolean): void;
}
