import { Readable } from 'node:stream';

import { answerCommand } from './answer-command.ts';
import type { ByteSource } from './byte-source.ts';
import { takeFrameHeader } from './read-frame.ts';
import { DELIMITER, MORE, ZmtpError, encodeFrame } from './zmtp-frames.ts';

/** Frames that may stand in front of a request, for who passes requests on. */
const MAX_ENVELOPE_FRAMES = 8;
/** Most bytes of each, and of a command. */
const MAX_SMALL_FRAME_BYTES = 255;
/** So much of a body is taken at once, bytes. */
const PIECE_BYTES = 64 * 1024;

/** A request of which all has come but its body. */
export interface ServiceMessage {
  /** Encoded frames that stood in front of it, and stand in front of the reply. */
  readonly envelope: readonly Buffer[];
  /** Bytes of the body. */
  readonly size: number;
  /** It has more than one frame, which no request has. */
  readonly hasMore: boolean;
  openBody(): RequestBody;
}

/**
 * Takes a message up to its body: the frames of its envelope, which ends with an empty one. [SV-61]
 *
 * @param answer sends a frame of the protocol itself
 * @throws ZmtpError when it is none, SourceEnded
 */
export async function takeRequest(
  source: ByteSource,
  answer: (frame: Buffer) => void,
): Promise<ServiceMessage> {
  const envelope: Buffer[] = [];
  for (;;) {
    const { isCommand, hasMore, bodyBytes } = await takeFrameHeader(source, Infinity);
    const isEnvelope = hasMore && envelope.at(-1) !== DELIMITER;
    if (!isCommand && !isEnvelope) {
      return {
        envelope,
        hasMore,
        size: bodyBytes,
        openBody: () => new RequestBody(source, bodyBytes),
      };
    }
    if (bodyBytes > MAX_SMALL_FRAME_BYTES) throw new ZmtpError('An envelope is too long.');
    const body = await source.take(bodyBytes);
    if (isCommand) {
      const answered = answerCommand(body);
      if (answered !== undefined) answer(answered);
    } else {
      envelope.push(bodyBytes === 0 ? DELIMITER : encodeFrame(body, MORE));
      if (envelope.length > MAX_ENVELOPE_FRAMES) throw new ZmtpError('An envelope is too long.');
    }
  }
}

/** The reply to a request, encoded. */
export function encodeReply({ envelope }: ServiceMessage, reply: Uint8Array): readonly Buffer[] {
  return [...envelope, encodeFrame(reply)];
}

/** Body of a request, read from the socket as it is asked for. */
export class RequestBody {
  readonly stream: Readable;
  #left: number;

  constructor(source: ByteSource, size: number) {
    this.#left = size;
    this.stream = Readable.from(this.#pieces(source), { objectMode: false });
  }

  /** Nothing of it is left on the socket. */
  get isRead(): boolean {
    return this.#left === 0;
  }

  async *#pieces(source: ByteSource): AsyncGenerator<Buffer> {
    while (this.#left > 0) {
      const piece = await source.takeSome(Math.min(this.#left, PIECE_BYTES));
      this.#left -= piece.length;
      yield piece;
    }
  }
}
