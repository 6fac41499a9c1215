import { Tape, type RecordRing } from './record-ring.ts';
import type { StreamReader, StreamSink, Wire } from './wire.ts';

/** The number a client gives to its only subscription. */
export const SUBSCRIPTION = 1;

const LINE_END = '\r\n';
const NOTHING = Buffer.alloc(0);

interface Tapes {
  readonly published: Tape;
  readonly delivered: Tape;
}

const tapes = new WeakMap<RecordRing, Tapes>();

/** Messages of NATS: the topic is the subject, and the content is the same as in a frame of a WebSocket. */
export const NATS: Wire = {
  published: (ring) => tapesOf(ring).published,
  delivered: (ring) => tapesOf(ring).delivered,
  openReader: (sink) => new NatsReader(sink),
};

function tapesOf(ring: RecordRing): Tapes {
  let made = tapes.get(ring);
  if (made === undefined) {
    const { topic, messages } = ring;
    const lead = (line: string): Tape => new Tape([...messages.steps()].map(framed(line)));
    made = {
      published: lead(`PUB ${topic}`),
      delivered: lead(`MSG ${topic} ${SUBSCRIPTION}`),
    };
    tapes.set(ring, made);
  }
  return made;
}

function framed(line: string): (content: Buffer) => Buffer {
  return (content) =>
    Buffer.concat([
      Buffer.from(`${line} ${content.length}${LINE_END}`),
      content,
      Buffer.from(LINE_END),
    ]);
}

/** Cuts a byte stream from a NATS server into messages. The least that does it: without headers. */
export class NatsReader implements StreamReader {
  readonly #sink: StreamSink;
  #rest: Buffer = NOTHING;

  constructor(sink: StreamSink) {
    this.#sink = sink;
  }

  get isAtBoundary(): boolean {
    return this.#rest.length === 0;
  }

  /** Takes the next bytes of the stream. They are borrowed; an incomplete message at the end is copied. */
  push(chunk: Buffer): void {
    const bytes = this.#rest.length === 0 ? chunk : Buffer.concat([this.#rest, chunk]);
    let at = 0;
    for (;;) {
      const end = bytes.indexOf(LINE_END, at);
      if (end < 0) break;
      const words = bytes.toString('latin1', at, end).split(' ');
      const start = end + LINE_END.length;
      if (words[0] !== 'MSG') {
        this.#handleLine(words);
        at = start;
        continue;
      }
      const contentEnd = start + Number(words.at(-1));
      if (bytes.length < contentEnd + LINE_END.length) break;
      this.#sink.handleTopicData(bytes, start, contentEnd);
      at = contentEnd + LINE_END.length;
    }
    this.#rest = at === bytes.length ? NOTHING : Buffer.from(bytes.subarray(at));
  }

  #handleLine(words: readonly string[]): void {
    if (words[0] === 'PING') this.#sink.handlePing();
    // What the server says of itself, now and then.
    else if (words[0] !== 'INFO') this.#sink.handleOther(`the line "${words.join(' ')}"`);
  }
}
