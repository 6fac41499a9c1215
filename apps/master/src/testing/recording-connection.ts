import type { ErrorMessage } from '@ubii/proto';
import type { TimedPong } from '@ubii/proto/wire';
import type { ClientConnection } from '../core/ports/client-connection.ts';
import type { CloseReason } from '../core/ports/close-reason.ts';
import type { RecordBatch } from '../core/ports/record-batch.ts';

/** Frames in the order in which a peer would receive them. */
export type Sent =
  | { readonly kind: 'record'; readonly record: Uint8Array }
  | { readonly kind: 'list'; readonly records: readonly Uint8Array[] }
  | { readonly kind: 'error'; readonly error: ErrorMessage }
  | { readonly kind: 'frame'; readonly frame: Uint8Array }
  | { readonly kind: 'PING' }
  | { readonly kind: 'PONG'; readonly timed?: TimedPong }
  | { readonly kind: 'close'; readonly reason: CloseReason; readonly explanation?: string };

/** A pipe without another end: keeps what it is given, and can be told to take nothing. */
export class RecordingConnection implements ClientConnection {
  readonly sent: Sent[] = [];
  /** Batches as they were handed over. */
  readonly batches: RecordBatch[] = [];
  #queuedBytes = 0;
  #isStalled = false;
  #takesLists = false;
  #isClosed = false;
  #isReading = true;

  get queuedBytes(): number {
    return this.#queuedBytes;
  }

  get isClosed(): boolean {
    return this.#isClosed;
  }

  send(batch: RecordBatch): void {
    if (this.#isClosed) return;
    this.batches.push(batch);
    if (this.#takesLists && batch.records.length > 1) {
      this.#add({ kind: 'list', records: batch.records });
    } else {
      for (const record of batch.records) this.#add({ kind: 'record', record });
    }
    if (this.#isStalled) this.#queuedBytes += batch.byteLength;
  }

  sendError(error: ErrorMessage): void {
    this.#add({ kind: 'error', error });
  }

  sendFrame(frame: Uint8Array): void {
    this.#add({ kind: 'frame', frame });
  }

  sendPing(): void {
    this.#add({ kind: 'PING' });
  }

  sendPong(timed?: TimedPong): void {
    this.#add({ kind: 'PONG', ...(timed && { timed }) });
  }

  close(reason: CloseReason, explanation?: string): void {
    this.#add({ kind: 'close', reason, ...(explanation !== undefined && { explanation }) });
    this.#isClosed = true;
  }

  setRecordLists(on: boolean): void {
    this.#takesLists = on;
  }

  /** Whether the master reads what the client sends. */
  get isReading(): boolean {
    return this.#isReading;
  }

  setReading(on: boolean): void {
    this.#isReading = on;
  }

  /** From now on the system takes nothing; `queuedBytes` beyond any limit makes it wait at once. */
  stall(queuedBytes = Number.MAX_SAFE_INTEGER): void {
    this.#isStalled = true;
    this.#queuedBytes = queuedBytes;
  }

  /** The system took `bytes` of the queue, or all of it, and goes on taking. */
  take(bytes = this.#queuedBytes): void {
    this.#queuedBytes -= bytes;
    this.#isStalled = this.#queuedBytes > 0;
  }

  #add(sent: Sent): void {
    if (!this.#isClosed) this.sent.push(sent);
  }
}
