import type { ErrorMessage } from '@ubii/proto';
import {
  PING_TEXT,
  encodeErrorFrame,
  encodeRecordListFrame,
  formatPong,
  isBinaryPong,
  recordFrameHeader,
  type TimedPong,
} from '@ubii/proto/wire';
import { handleText } from '../adapters/heartbeat/handle-text.ts';
import { closeFrame, endingOf } from '../adapters/ws/close-codes.ts';
import type {
  CallerFacts,
  ClientClaim,
  ClientConnection,
  CloseReason,
  ConnectionHandle,
  ConnectionHost,
  ConnectionPeer,
  RecordBatch,
} from '../core/ports/index.ts';

/** The client's end of a channel in memory. It speaks as a socket does: messages, texts and close codes. */
export interface MemoryPeer {
  sendBinary(bytes: Uint8Array): void;
  sendText(text: string): void;
  close(code: number, reason: string): void;
  /** Bytes the client has not been given yet. */
  readonly queuedBytes: number;
}

/** The one that opens a channel. */
export interface MemoryDial {
  readonly claim: ClientClaim;
  readonly caller: CallerFacts;
  readonly facts?: ConnectionPeer;
}

/** What the client does with an open channel. */
export interface MemoryChannel {
  handleBinary(bytes: Uint8Array): void;
  handleText(text: string): void;
  /** The client took all that was sent. */
  handleDrain(): void;
  /** @param code what the client closed with; none when the channel broke */
  handleClose(code?: number): void;
}

/**
 * Opens a channel to a master in the same process, without anything between the two.
 *
 * @returns undefined when the master refused it; then the peer may have been closed
 */
export function openMemoryChannel(
  host: ConnectionHost,
  { claim, caller, facts }: MemoryDial,
  peer: MemoryPeer,
): MemoryChannel | undefined {
  if (host.refuseConnection(claim, caller) !== undefined) return undefined;
  const handle = host.openConnection(claim, new MemoryConnection(peer), caller, facts);
  return handle && channelTo(handle);
}

function channelTo(handle: ConnectionHandle): MemoryChannel {
  return {
    handleBinary(bytes) {
      if (isBinaryPong(bytes)) handle.handlePong();
      else handle.handleTopicData(bytes.slice());
    },
    handleText: (text) => handleText(handle, text),
    handleDrain: () => handle.handleDrain(),
    handleClose: (code) => handle.handleClose(endingOf(code)),
  };
}

/** The master's end of a channel in memory. */
class MemoryConnection implements ClientConnection {
  readonly #peer: MemoryPeer;
  #takesLists = false;
  #isClosed = false;

  constructor(peer: MemoryPeer) {
    this.#peer = peer;
  }

  get queuedBytes(): number {
    return this.#peer.queuedBytes;
  }

  send({ records }: RecordBatch): void {
    if (this.#takesLists && records.length > 1) {
      this.sendFrame(encodeRecordListFrame(records));
      return;
    }
    for (const record of records) {
      const header = recordFrameHeader(record.byteLength);
      const frame = new Uint8Array(header.byteLength + record.byteLength);
      frame.set(header);
      frame.set(record, header.byteLength);
      this.sendFrame(frame);
    }
  }

  sendError(error: ErrorMessage): void {
    this.sendFrame(encodeErrorFrame(error));
  }

  sendFrame(frame: Uint8Array): void {
    if (!this.#isClosed) this.#peer.sendBinary(frame);
  }

  sendPing(): void {
    if (!this.#isClosed) this.#peer.sendText(PING_TEXT);
  }

  sendPong(timed?: TimedPong): void {
    if (!this.#isClosed) this.#peer.sendText(formatPong(timed));
  }

  close(reason: CloseReason, explanation?: string): void {
    if (this.#isClosed) return;
    this.#isClosed = true;
    const { code, text } = closeFrame(reason, explanation);
    this.#peer.close(code, text);
  }

  setRecordLists(on: boolean): void {
    this.#takesLists = on;
  }
}
