import type { ErrorMessage } from '@ubii/proto';
import type { RecordBatch } from './record-batch.ts';

/** One live pipe to one client, as the adapter of a transport offers it. No method throws, whatever the pipe's state. */
export interface ClientConnection {
  /**
   * Hands over records, in order. Where record lists are off (the default), each record is a frame of
   * its own; where they are on, the batch is one frame.
   */
  send(batch: RecordBatch): void;
  /** Sends a `TopicData` that holds this error. */
  sendError(error: ErrorMessage): void;
  /** Sends one complete encoded `TopicData`. */
  sendFrame(frame: Uint8Array): void;
  /** Sends the text `PING`. */
  sendPing(): void;
  /** Sends the text `PONG`, or another text that begins with it. */
  sendPong(text?: string): void;
  /** Bytes handed over that the system has not taken yet. */
  readonly queuedBytes: number;
  /** Closes the pipe with a WebSocket close code. `handleClose` follows, now or later. */
  close(code: number, reason: string): void;
  /** Whether a batch may leave as one frame. Set before the first batch, may change later. */
  setRecordLists(on: boolean): void;
}
