import { FrameReader, OPCODE } from './frames.ts';
import type { RecordRing, Tape } from './record-ring.ts';

/** Takes what is in a stream. The bytes are borrowed. */
export interface StreamSink {
  handleTopicData(bytes: Buffer, start: number, end: number): void;
  handlePing(): void;
  /** Something that is not expected, in words. */
  handleOther(what: string): void;
}

/** Cuts the stream of a broker into messages. */
export interface StreamReader {
  /** True when every byte pushed so far belonged to a whole message. */
  readonly isAtBoundary: boolean;
  push(chunk: Buffer): void;
}

/** The way records travel between a client and its broker. */
export interface Wire {
  /** What a client sends to publish the records of a ring. */
  published(ring: RecordRing): Tape;
  /** What it receives when a broker passes them on one by one. */
  delivered(ring: RecordRing): Tape;
  openReader(sink: StreamSink): StreamReader;
}

const TEXT_PING = 'PING';

/** Frames of a WebSocket. */
export const WEB_SOCKET: Wire = {
  published: (ring) => ring.published,
  delivered: (ring) => ring.frames,
  openReader: (sink) =>
    new FrameReader((opcode, bytes, start, end) => {
      if (opcode === OPCODE.binary) sink.handleTopicData(bytes, start, end);
      else if (opcode === OPCODE.text && bytes.toString('latin1', start, end) === TEXT_PING) {
        sink.handlePing();
      } else sink.handleOther(`a frame with opcode ${opcode} and ${end - start} bytes`);
    }),
};
