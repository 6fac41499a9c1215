import { Tape, type RecordRing } from './record-ring.ts';
import { RestReader } from './frames.ts';
import type { Greeting } from './stream-connection.ts';
import type { StreamSink, Wire } from './wire.ts';

/** The number a client gives to its only subscription. */
const SUBSCRIPTION = 1;
const HELLO = 'CONNECT {"verbose":false,"pedantic":false,"lang":"benchmark","version":"1"}\r\n';
const PONG = 'PONG\r\n';

const LINE_END = '\r\n';

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

/** @param subject to subscribe to; undefined for none */
export function greetNats(port: number, subject: string | undefined): Greeting {
  const subscribe = subject === undefined ? '' : `SUB ${subject} ${SUBSCRIPTION}\r\n`;
  return {
    broker: 'NATS',
    port,
    pong: Buffer.from(PONG),
    hello: Buffer.from(`${HELLO}${subscribe}PING\r\n`),
    // INFO, and PONG once the server has the subscription.
    answerEnd: (bytes) => {
      const at = bytes.indexOf(PONG);
      return at < 0 ? undefined : at + PONG.length;
    },
  };
}

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
export class NatsReader extends RestReader {
  readonly #sink: StreamSink;

  constructor(sink: StreamSink) {
    super();
    this.#sink = sink;
  }

  protected override readMessages(bytes: Buffer): number {
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
    return at;
  }

  #handleLine(words: readonly string[]): void {
    if (words[0] === 'PING') this.#sink.handlePing();
    // What the server says of itself, now and then.
    else if (words[0] !== 'INFO') this.#sink.handleOther(`the line "${words.join(' ')}"`);
  }
}
