import {
  headerBytesOf,
  MAX_COMMAND_BYTES,
  readFrameHeader,
  ZmtpError,
  type FrameHeader,
} from './zmtp-frames.ts';
import type { ConnectionHandle } from '../../core/ports/index.ts';
import { handleText } from '../heartbeat/handle-text.ts';
import { answerCommand } from './answer-command.ts';

/** Finds the frames in what a socket reads. */
export class FrameReader {
  readonly #maxBytes: number;
  #chunks: Buffer[] = [];
  #size = 0;
  #needed = 1;

  /** @param maxBytes most that the body of a frame of a message may have; a command has at most `MAX_COMMAND_BYTES` */
  constructor(maxBytes: number) {
    this.#maxBytes = maxBytes;
  }

  /**
   * Calls `handle` for each frame that is complete. The body is `bytes` from `start` to `end`, and belongs to the
   * reader.
   *
   * @throws ZmtpError for a frame that is too long, as soon as its header has come, or has unknown flags
   */
  read(
    chunk: Buffer,
    handle: (header: FrameHeader, bytes: Buffer, start: number, end: number) => void,
  ): void {
    this.#chunks.push(chunk);
    this.#size += chunk.length;
    // Joined once a frame, however small the pieces in which it comes.
    if (this.#size < this.#needed) return;
    const bytes = this.#chunks.length === 1 ? chunk : Buffer.concat(this.#chunks);
    let pos = 0;
    this.#needed = 1;
    while (pos < bytes.length) {
      const headerBytes = headerBytesOf(bytes[pos]!);
      this.#needed = headerBytes;
      if (bytes.length - pos < headerBytes) break;
      const header = readFrameHeader(bytes, pos, this.#maxBytes);
      if (header.isCommand && header.bodyBytes > MAX_COMMAND_BYTES) {
        throw new ZmtpError(`A command may have at most ${MAX_COMMAND_BYTES} bytes.`);
      }
      const end = pos + headerBytes + header.bodyBytes;
      this.#needed = end - pos;
      if (end > bytes.length) break;
      handle(header, bytes, pos + headerBytes, end);
      pos = end;
      this.#needed = 1;
    }
    this.#size = bytes.length - pos;
    this.#chunks = this.#size === 0 ? [] : [bytes.subarray(pos)];
  }
}

/** A heartbeat with the time of a clock has no more. */
const MAX_TEXT_BYTES = 128;
/** What a heartbeat begins with: `PING` or `PONG`. No `TopicData` can, they are not of protobuf. */
const PING_BYTES = 0x5049_4e47;
const PONG_BYTES = 0x504f_4e47;
const WORD_BYTES = 4;
/** Most frames of a message that are read: it should have one or two. Messages with more are reported; the connection ends above this limit. */
const MAX_FRAMES = 8;

const NO_MESSAGE =
  'The message has more than one frame. Send topic data as one frame, with or without an empty frame in front.';

/** Finds the messages in what a DEALER sends, and hands them over. [TD-51] */
export class MessageReader {
  readonly #handle: ConnectionHandle;
  readonly #frames: FrameReader;
  readonly #answer: (frame: Buffer) => void;
  /** Frames of the message that have come. */
  #count = 0;
  #isMessage = true;

  /** @param answer sends a frame of the protocol itself */
  constructor(handle: ConnectionHandle, maxBytes: number, answer: (frame: Buffer) => void) {
    this.#handle = handle;
    this.#frames = new FrameReader(maxBytes);
    this.#answer = answer;
  }

  /** @throws ZmtpError when the connection is of no more use */
  read(chunk: Buffer): void {
    this.#frames.read(chunk, this.#handleFrame);
  }

  readonly #handleFrame = (
    { isCommand, hasMore }: FrameHeader,
    bytes: Buffer,
    start: number,
    end: number,
  ): void => {
    if (isCommand) {
      const answer = answerCommand(bytes.subarray(start, end));
      if (answer !== undefined) this.#answer(answer);
      return;
    }
    // One frame, or an empty one and another.
    if (hasMore && (this.#count > 0 || start < end)) this.#isMessage = false;
    this.#count++;
    if (hasMore && this.#count >= MAX_FRAMES) {
      throw new ZmtpError(`A message has more than ${MAX_FRAMES} frames.`);
    }
    if (hasMore) return;
    const isMessage = this.#isMessage;
    this.#count = 0;
    this.#isMessage = true;
    if (isMessage) this.#handleContent(bytes, start, end);
    else this.#handle.handleProtocolError(NO_MESSAGE);
  };

  #handleContent(bytes: Buffer, start: number, end: number): void {
    const size = end - start;
    const word = size >= WORD_BYTES && size <= MAX_TEXT_BYTES ? bytes.readUInt32BE(start) : 0;
    if (word === PING_BYTES || word === PONG_BYTES) {
      handleText(this.#handle, bytes.toString('latin1', start, end));
      return;
    }
    // In memory of its own: the master keeps it.
    this.#handle.handleTopicData(new Uint8Array(bytes.subarray(start, end)));
  }
}
