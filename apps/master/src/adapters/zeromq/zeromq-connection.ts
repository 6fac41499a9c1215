import type { Socket } from 'node:net';
import {
  encodeErrorFrame,
  PING_TEXT,
  PONG_TEXT,
  formatPong,
  type TimedPong,
} from '@ubii/proto/wire';
import type { ErrorMessage } from '@ubii/proto';
import type { FrameParts } from '../output/joined-parts.ts';
import {
  recordListEncoder,
  singleRecordEncoder,
  type MessageHead,
} from '../output/topic-data-encoders.ts';
import { DELIMITER, encodeFrame, frameHeaderSize, writeFrameHeader } from './zmtp-frames.ts';
import type { ClientConnection, CloseReason, RecordBatch } from '../../core/ports/index.ts';
import type { ZmtpPeer } from './greet-peer.ts';

/*
 * Messages from a ROUTER to a DEALER, as existing clients expect them: an empty frame, then the content. [TD-50]
 */

const HEAD: MessageHead = {
  size: (contentBytes) => DELIMITER.length + frameHeaderSize(contentBytes),
  write(target, start, contentBytes) {
    target.set(DELIMITER, start);
    return writeFrameHeader(target, start + DELIMITER.length, contentBytes);
  },
};

const singleMessages = singleRecordEncoder(HEAD);
const listMessages = recordListEncoder(HEAD);

/** A message with an encoded `TopicData`. */
function topicDataMessage(content: Uint8Array): FrameParts {
  return [DELIMITER, encodeFrame(content)];
}

/** A message with an error. [TD-17] */
function errorMessage(error: ErrorMessage): FrameParts {
  return topicDataMessage(encodeErrorFrame(error));
}

/** A message with a heartbeat. @param text ASCII */
function textMessage(text: string): FrameParts {
  return topicDataMessage(Buffer.from(text, 'latin1'));
}

const PING = textMessage(PING_TEXT);
const PONG = textMessage(PONG_TEXT);

/** Reasons after which the client may come back at once, or finds out by itself that it cannot. */
const ENDS_AT_ONCE: ReadonlySet<CloseReason> = new Set(['master is closing', 'deregistered']);

/** Ends a socket once what was written has left; `isHeld`: not before the client has been kept waiting. */
type EndSocket = (isHeld: boolean) => void;

/** One client's DEALER. */
export class ZeroMqConnection implements ClientConnection {
  readonly #socket: Socket;
  readonly #peer: ZmtpPeer;
  readonly #end: EndSocket;
  #state: 'greeted' | 'open' | 'closed' = 'greeted';
  #recordLists = false;
  #isReading = true;

  /** @param peer greeted, and neither taken nor refused yet */
  constructor(socket: Socket, peer: ZmtpPeer, end: EndSocket) {
    this.#socket = socket;
    this.#peer = peer;
    this.#end = end;
  }

  get queuedBytes(): number {
    return this.#socket.writableLength;
  }

  /** Whether messages of the client are read. */
  get isReading(): boolean {
    return this.#isReading;
  }

  /** Takes the peer, unless that has happened, or it was refused. */
  open(): void {
    if (this.#state !== 'greeted') return;
    this.#state = 'open';
    this.#socket.write(this.#peer.acceptance);
  }

  send(batch: RecordBatch): void {
    const encoder = this.#recordLists && batch.count > 1 ? listMessages : singleMessages;
    this.#write(batch.memo(encoder));
  }

  sendError(error: ErrorMessage): void {
    this.#write(errorMessage(error));
  }

  sendFrame(frame: Uint8Array): void {
    this.#write(topicDataMessage(frame));
  }

  sendPing(): void {
    this.#write(PING);
  }

  sendPong(timed?: TimedPong): void {
    this.#write(timed === undefined ? PONG : textMessage(formatPong(timed)));
  }

  /** Refuses a peer with a reason, before it is accepted. [TD-52] */
  close(reason: CloseReason, explanation?: string): void {
    if (this.#state === 'closed') return;
    if (this.#state === 'greeted') {
      this.#socket.write(this.#peer.refusal(explanation ? `${reason}: ${explanation}` : reason));
    }
    this.#state = 'closed';
    this.#end(!ENDS_AT_ONCE.has(reason));
  }

  setRecordLists(on: boolean): void {
    this.#recordLists = on;
  }

  setReading(on: boolean): void {
    this.#isReading = on;
    if (on) this.#socket.resume();
    else this.#socket.pause();
  }

  #write(parts: FrameParts): void {
    this.open();
    if (this.#state === 'closed' || !this.#socket.writable) return;
    if (parts.length === 1) {
      this.#socket.write(parts[0]!);
      return;
    }
    this.#socket.cork();
    for (const part of parts) this.#socket.write(part);
    this.#socket.uncork();
  }
}
