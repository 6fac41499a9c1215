import { FrameReader, OPCODE, clientFrame, serverFrame } from './frames.ts';
import { LoadConnection, type StreamReceiver } from './load-connection.ts';
import { Tape, type RecordRing } from './record-ring.ts';
import type { Wire } from './wire.ts';

/** A binary event of Socket.IO is a text packet that announces it, and a frame with the bytes. */
const DELIVERED = announcement('record');
const PING = '2';
const PONG = text('3');
const CONNECT = text('40');
const SUBSCRIBED = '430[]';

interface Tapes {
  readonly published: Tape;
  readonly delivered: Tape;
}

const tapes = new WeakMap<RecordRing, Tapes>();

/** Binary events of Socket.IO over a WebSocket. */
export const SOCKET_IO: Wire = {
  published: (ring) => tapesOf(ring).published,
  delivered: (ring) => tapesOf(ring).delivered,
  openReader: (sink) =>
    new FrameReader((opcode, bytes, start, end) => {
      if (opcode === OPCODE.binary) return sink.handleTopicData(bytes, start, end);
      const words = bytes.toString('latin1', start, end);
      if (words === PING) sink.handlePing();
      else if (words !== DELIVERED) sink.handleOther(`the packet ${words}`);
    }),
};

/** Connects, and joins the room of a topic if one is given. */
export async function openSocketIo(
  url: string,
  topic: string | undefined,
  receiver: StreamReceiver,
): Promise<LoadConnection> {
  let isReady = false;
  let handleReady: () => void = () => {};
  const ready = new Promise<void>((resolve) => (handleReady = resolve));
  const greeting = new FrameReader((_opcode, bytes, start, end) => {
    const words = bytes.toString('latin1', start, end);
    if (words.startsWith('40')) {
      const request = JSON.stringify(['subscribe', topic ?? '']);
      connection.send(text(`420${request}`));
    } else if (words === SUBSCRIBED) {
      isReady = true;
      handleReady();
    }
  });
  const connection = await LoadConnection.open(`${url}/socket.io/?EIO=4&transport=websocket`, {
    push: (chunk) => (isReady ? receiver.push(chunk) : greeting.push(chunk)),
    onPing: () => {},
    handleEnd: (reason) => receiver.handleEnd(reason),
  });
  receiver.onPing = () => connection.send(PONG);
  connection.send(CONNECT);
  await ready;
  return connection;
}

function announcement(...words: readonly string[]): string {
  return `451-${JSON.stringify([...words, { _placeholder: true, num: 0 }])}`;
}

function text(words: string): Buffer {
  return clientFrame(OPCODE.text, Buffer.from(words));
}

function tapesOf(ring: RecordRing): Tapes {
  let made = tapes.get(ring);
  if (made === undefined) {
    const messages = [...ring.messages.steps()];
    const announced = text(announcement('record', ring.topic));
    const delivered = serverFrame(Buffer.from(DELIVERED), OPCODE.text);
    made = {
      published: new Tape(
        messages.map((message) => Buffer.concat([announced, clientFrame(OPCODE.binary, message)])),
      ),
      delivered: new Tape(
        messages.map((message) => Buffer.concat([delivered, serverFrame(message)])),
      ),
    };
    tapes.set(ring, made);
  }
  return made;
}
