import { Tape, type RecordRing } from './record-ring.ts';
import { RestReader } from './frames.ts';
import type { Greeting } from './stream-connection.ts';
import type { StreamSink, Wire } from './wire.ts';

/** Types of packets of MQTT 3.1.1, section 2.2.1, with their fixed flags. */
const PACKET = { connect: 0x10, publish: 0x30, subscribe: 0x82, pingResponse: 0xd0 } as const;
const CLEAN_SESSION = 0x02;
const LEVEL_OF_3_1_1 = 4;
const CONNACK_BYTES = 4;
const SUBACK_BYTES = 5;
const NOTHING = Buffer.alloc(0);

const tapes = new WeakMap<RecordRing, Tape>();
let clients = 0;

/** Packets of MQTT with quality of service 0: what is published is what is delivered. */
export const MQTT: Wire = {
  published: tapeOf,
  delivered: tapeOf,
  openReader: (sink) => new MqttReader(sink),
};

/** @param topic to subscribe to; undefined for none */
export function greetMqtt(broker: string, port: number, topic: string | undefined): Greeting {
  clients += 1;
  const keepAlive = Buffer.from([0, 0]);
  const connect = packet(PACKET.connect, [
    ...[text('MQTT'), Buffer.from([LEVEL_OF_3_1_1, CLEAN_SESSION]), keepAlive],
    text(`benchmark-${process.pid}-${clients}`),
  ]);
  const number = Buffer.from([0, 1]);
  const subscribe =
    topic === undefined
      ? NOTHING
      : packet(PACKET.subscribe, [number, text(topic), Buffer.from([0])]);
  const answerBytes = CONNACK_BYTES + (topic === undefined ? 0 : SUBACK_BYTES);
  return {
    broker,
    port,
    hello: Buffer.concat([connect, subscribe]),
    answerEnd: (bytes) => (bytes.length < answerBytes ? undefined : answerBytes),
  };
}

function tapeOf(ring: RecordRing): Tape {
  let made = tapes.get(ring);
  if (made === undefined) {
    const topic = text(ring.topic);
    made = new Tape(
      [...ring.messages.steps()].map((content) => packet(PACKET.publish, [topic, content])),
    );
    tapes.set(ring, made);
  }
  return made;
}

function packet(type: number, parts: readonly Buffer[]): Buffer {
  const content = Buffer.concat(parts);
  const head = [type];
  let length = content.length;
  for (; length > 0x7f; length >>>= 7) head.push((length & 0x7f) | 0x80);
  return Buffer.concat([Buffer.from([...head, length]), content]);
}

function text(value: string): Buffer {
  const bytes = Buffer.from(value);
  const length = Buffer.alloc(2);
  length.writeUInt16BE(bytes.length);
  return Buffer.concat([length, bytes]);
}

/** Cuts a byte stream from an MQTT broker into packets. The least that does it. */
class MqttReader extends RestReader {
  readonly #sink: StreamSink;

  constructor(sink: StreamSink) {
    super();
    this.#sink = sink;
  }

  protected override readMessages(bytes: Buffer): number {
    let at = 0;
    for (;;) {
      const body = bodyAt(bytes, at);
      if (body === undefined || body.end > bytes.length) break;
      const type = bytes[at]!;
      if (type === PACKET.publish) {
        const start = body.start + 2 + bytes.readUInt16BE(body.start);
        this.#sink.handleTopicData(bytes, start, body.end);
      } else if (type !== PACKET.pingResponse) {
        this.#sink.handleOther(`a packet of type ${type.toString(16)}`);
      }
      at = body.end;
    }
    return at;
  }
}

/** Bounds of what follows the head of a packet; undefined when the head is not complete. */
function bodyAt(bytes: Buffer, at: number): { start: number; end: number } | undefined {
  let length = 0;
  for (let index = 0; index < 4; index += 1) {
    const byte = bytes[at + 1 + index];
    if (byte === undefined) return undefined;
    length |= (byte & 0x7f) << (7 * index);
    if (byte < 0x80) return { start: at + 2 + index, end: at + 2 + index + length };
  }
  return undefined;
}
