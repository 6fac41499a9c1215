const NOTHING = Buffer.alloc(0);

/** Cuts a stream into messages, and keeps the beginning of one until the rest of it comes. */
export abstract class RestReader {
  #rest: Buffer = NOTHING;

  /** True when every byte pushed so far belonged to a whole message. */
  get isAtBoundary(): boolean {
    return this.#rest.length === 0;
  }

  /** Takes the next bytes of the stream. They are borrowed; an incomplete message at the end is copied. */
  push(chunk: Buffer): void {
    const bytes = this.#rest.length === 0 ? chunk : Buffer.concat([this.#rest, chunk]);
    const end = this.readMessages(bytes);
    this.#rest = end === bytes.length ? NOTHING : Buffer.from(bytes.subarray(end));
  }

  /** Reads the messages that are whole. @returns where the last one ends */
  protected abstract readMessages(bytes: Buffer): number;
}

/** Opcodes of RFC 6455 §5.2 that a broker sends. */
export const OPCODE = { text: 1, binary: 2, close: 8, ping: 9, pong: 10 } as const;

/** Receives a frame from the reader. The payload is `bytes[start, end)`, borrowed: it is valid only during the call. */
type FrameSink = (opcode: number, bytes: Buffer, start: number, end: number) => void;

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

/** Not random as RFC 6455 asks for: no proxy is in between, and every run sends the same bytes. */
const MASK = Buffer.from([0x5a, 0xc3, 0x17, 0x8e]);

const MASKED = 0x80;
const FINAL = 0x80;

/** One masked frame as a client sends it; brokers have to unmask it, as they have to for any client. */
export function clientFrame(opcode: number, payload: Uint8Array): Buffer {
  const head = headOf(opcode, payload.length, MASKED);
  const frame = Buffer.allocUnsafe(head.length + MASK.length + payload.length);
  frame.set(head);
  frame.set(MASK, head.length);
  const start = head.length + MASK.length;
  for (let i = 0; i < payload.length; i += 1) frame[start + i] = payload[i]! ^ MASK[i & 3]!;
  return frame;
}

/** One unmasked frame as a server sends it. @param opcode default: binary */
export function serverFrame(payload: Uint8Array, opcode: number = OPCODE.binary): Buffer {
  return Buffer.concat([headOf(opcode, payload.length, 0), payload]);
}

/** Opcode and length of a frame, RFC 6455 section 5.2. @param masked the bit for masked frames, or 0 */
function headOf(opcode: number, length: number, masked: number): Buffer {
  if (length < 126) return Buffer.from([FINAL | opcode, masked | length]);
  const isShort = length <= 0xffff;
  const head = Buffer.alloc(isShort ? 4 : 10);
  head[0] = FINAL | opcode;
  head[1] = masked | (isShort ? 126 : 127);
  if (isShort) head.writeUInt16BE(length, 2);
  else head.writeUInt32BE(length, 6);
  return head;
}
