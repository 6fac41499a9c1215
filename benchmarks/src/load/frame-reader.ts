import { RestReader } from './rest-reader.ts';

/** Opcodes of RFC 6455 §5.2 that a broker sends. */
export const OPCODE = { text: 1, binary: 2, close: 8, ping: 9, pong: 10 } as const;

/** Receives a frame from the reader. The payload is `bytes[start, end)`, borrowed: it is valid only during the call. */
export type FrameSink = (opcode: number, bytes: Buffer, start: number, end: number) => void;

/** Thrown for what a server must not send: masked or fragmented frames, reserved bits. */
export class FrameError extends Error {}

/**
 * Cuts a byte stream from a WebSocket server into frames. The least that does it: a server does not
 * mask, and no broker measured here fragments.
 */
export class FrameReader extends RestReader {
  readonly #sink: FrameSink;

  constructor(sink: FrameSink) {
    super();
    this.#sink = sink;
  }

  /** @throws {FrameError} when the stream cannot come from a server of RFC 6455. */
  protected override readMessages(bytes: Buffer): number {
    let at = 0;
    while (bytes.length - at >= 2) {
      const head = bytes[at]!;
      let length = bytes[at + 1]!;
      if ((head & 0xf0) !== 0x80 || length > 127) {
        throw new FrameError(
          `Expected an unfragmented, unmasked frame, received the header ${head.toString(16)} ${length.toString(16)}.`,
        );
      }
      let start = at + 2;
      if (length === 126) {
        if (bytes.length - at < 4) break;
        length = bytes.readUInt16BE(start);
        start += 2;
      } else if (length === 127) {
        if (bytes.length - at < 10) break;
        length = Number(bytes.readBigUInt64BE(start));
        start += 8;
      }
      if (bytes.length < start + length) break;
      at = start + length;
      this.#sink(head & 0x0f, bytes, start, at);
    }
    return at;
  }
}
