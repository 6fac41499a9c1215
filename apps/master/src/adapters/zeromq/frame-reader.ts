import {
  headerBytesOf,
  MAX_COMMAND_BYTES,
  readFrameHeader,
  ZmtpError,
  type FrameHeader,
} from './zmtp-frames.ts';

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
