import { randomBytes } from 'node:crypto';

import { sendAndWaitForEnd } from '../deliver-tcp.ts';
import type { Entrance, FuzzTarget } from '../entrance.ts';
import type { Random } from '../../random.ts';
import { joined, mutateBytes } from '../mutate-bytes.ts';
import { mutateWire } from '../mutate-wire.ts';
import { fromBase64, readSeeds } from '../seeds.ts';

/** Opcodes of RFC 6455, section 5.2. */
const TEXT = 1;
const BINARY = 2;
const CLOSE = 8;
const PING = 9;
const CONTINUATION = 0;
/** The mask does not matter to the master; a fixed one keeps cases the same. */
const MASK = Uint8Array.of(0x37, 0xfa, 0x21, 0x3d);
const TEXTS = ['PING', 'PONG', 'PING 1', '{"a":1}', 'preflight 1 2', '\u0000', 'x'.repeat(200)];

interface FrameShape {
  readonly opcode: number;
  readonly isFinal?: boolean;
  readonly reserved?: number;
  readonly isMasked?: boolean;
  /** Bytes of the length: 1, 3 or 9. Default: the shortest that fits. */
  readonly lengthForm?: 1 | 3 | 9;
  /** The length that the header states. Default: that of the payload. */
  readonly statedLength?: number;
}

export function clientFrame(payload: Uint8Array, shape: FrameShape): Uint8Array {
  const { opcode, isFinal = true, reserved = 0, isMasked = true } = shape;
  const length = shape.statedLength ?? payload.length;
  const form = shape.lengthForm ?? (length < 126 ? 1 : length < 0x1_0000 ? 3 : 9);
  const header = Buffer.alloc(1 + form);
  header[0] = (isFinal ? 0x80 : 0) | (reserved << 4) | opcode;
  if (form === 1) header[1] = Math.min(length, 125);
  else if (form === 3) {
    header[1] = 126;
    header.writeUInt16BE(length % 0x1_0000, 2);
  } else {
    header[1] = 127;
    header.writeBigUInt64BE(BigInt(length), 2);
  }
  if (!isMasked) return joined(header, payload);
  header[1]! |= 0x80;
  return joined(
    header,
    MASK,
    payload.map((byte, index) => byte ^ MASK[index % 4]!),
  );
}

/** Topic data in well-formed frames: the records are what is strange. */
export const topicData: Entrance = {
  name: 'topic-data',
  about: 'topic data: records, record lists and node messages in binary frames',
  kind: 'running',
  seeds: () => fromBase64(readSeeds().frames),
  mutate(random, seed, other) {
    return random.oneIn(4) ? mutateBytes(random, seed, other) : mutateWire(random, seed, other);
  },
  deliver: (input, target) => deliverFrames(clientFrame(input, { opcode: BINARY }), target),
};

function frameSeeds(): Uint8Array[] {
  const { frames } = readSeeds();
  const payloads = fromBase64(frames).map((payload) => clientFrame(payload, { opcode: BINARY }));
  const texts = TEXTS.map((text) => clientFrame(Buffer.from(text), { opcode: TEXT }));
  const control = [
    clientFrame(Buffer.from('x'), { opcode: PING }),
    clientFrame(Uint8Array.of(0x03, 0xe8), { opcode: CLOSE }),
    clientFrame(new Uint8Array(), { opcode: CLOSE }),
  ];
  const halves = fromBase64(frames.slice(0, 3)).map((payload) =>
    joined(
      clientFrame(payload.subarray(0, 3), { opcode: BINARY, isFinal: false }),
      clientFrame(Buffer.from('PING'), { opcode: PING }),
      clientFrame(payload.subarray(3), { opcode: CONTINUATION }),
    ),
  );
  return [...payloads, ...texts, ...control, ...halves];
}

function mutateFrames(random: Random, seed: Uint8Array, other: Uint8Array): Uint8Array {
  if (random.oneIn(3)) return mutateBytes(random, seed, other);
  const count = random.oneIn(40) ? 500 : 1 + random.below(4);
  const frames = Array.from({ length: count }, () => {
    const payload = random.pick([seed, other, new Uint8Array(), random.bytes(random.below(200))]);
    const statedLength = random.oneIn(6)
      ? random.pick([0, 1, 125, 126, 65_535, 2 ** 31, 2 ** 53 - 1, 40 * 1024 * 1024])
      : undefined;
    const lengthForm = random.oneIn(6) ? random.pick([1, 3, 9] as const) : undefined;
    return clientFrame(payload, {
      opcode: random.oneIn(2)
        ? random.below(16)
        : random.pick([TEXT, BINARY, CLOSE, PING, CONTINUATION]),
      isFinal: !random.oneIn(4),
      reserved: random.oneIn(8) ? random.below(8) : 0,
      isMasked: !random.oneIn(10),
      ...(statedLength !== undefined && { statedLength }),
      ...(lengthForm !== undefined && { lengthForm }),
    });
  });
  return joined(...frames);
}

/** Frames as they are: opcodes, fragments, masks, lengths that lie, control frames. */
export const frames: Entrance = {
  name: 'frames',
  about: 'WebSocket frames: opcodes, fragments, masks, lengths, control and text frames',
  kind: 'running',
  seeds: frameSeeds,
  mutate: mutateFrames,
  deliver: deliverFrames,
};

/** The socket that a page may open before it has joined. */
export const preflight: Entrance = {
  name: 'preflight',
  about: 'frames on the socket that pages open before they join',
  kind: 'running',
  seeds: frameSeeds,
  mutate: mutateFrames,
  async deliver(input, { master }) {
    await sendAndWaitForEnd(master.port, joined(handshake('/preflight'), input));
  },
};

/** Handshake and frames leave together: the master reads them however they arrive. */
async function deliverFrames(input: Uint8Array, target: FuzzTarget): Promise<void> {
  const { master, clientId, resumeToken } = target;
  const path = `/topicdata?clientID=${clientId}&token=${resumeToken}`;
  // A client that ends its connection before the master has identified it gets no socket.
  const answer = await sendAndWaitForEnd(master.port, joined(handshake(path), input), true);
  const head = answer.toString('latin1', 0, 60);
  if (!head.startsWith('HTTP/1.1 101')) {
    throw new Error(`The master did not open the fuzzer's socket: ${head}`);
  }
}

function handshake(path: string): Uint8Array {
  const lines = [
    `GET ${path} HTTP/1.1`,
    'Host: localhost',
    'Connection: Upgrade',
    'Upgrade: websocket',
    'Sec-WebSocket-Version: 13',
    `Sec-WebSocket-Key: ${randomBytes(16).toString('base64')}`,
  ];
  return Buffer.from(`${lines.join('\r\n')}\r\n\r\n`, 'latin1');
}
