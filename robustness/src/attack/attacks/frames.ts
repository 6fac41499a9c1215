import { fork, type ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';
import type { Socket } from 'node:net';

import { mib, type Member, type Outsider } from '@ubii/harness';
import { AccessRole, encode, encodeRecord } from '@ubii/proto';

import { pause } from '../../pause.ts';
import { comparison, finding, type Attack, type Finding } from '../attack.ts';

const program = fileURLToPath(new URL('../environment/delay-process.ts', import.meta.url));

/** Milliseconds. */
interface Delays {
  readonly p50: number;
  readonly p99: number;
}

/** Measures how long the master takes to answer, in a process that an attack does not slow down. */
class DelayMeter {
  readonly #child: ChildProcess;

  private constructor(child: ChildProcess) {
    this.#child = child;
  }

  static async open(url: string): Promise<DelayMeter> {
    const child = fork(program, [url], { execArgv: ['--import', import.meta.resolve('tsx')] });
    await once(child, 'message');
    return new DelayMeter(child);
  }

  /** @returns delays of `GET /health`, and of records from one client of this machine to another */
  async during(durationMs: number): Promise<{ health: Delays; record: Delays }> {
    const answer = once(this.#child, 'message');
    this.#child.send(durationMs);
    const [{ health, record }] = (await answer) as [{ health: number[]; record: number[] }];
    return { health: delaysIn(health), record: delaysIn(record) };
  }

  close(): void {
    this.#child.kill('SIGKILL');
  }
}

function delaysIn(sorted: readonly number[]): Delays {
  const at = (part: number): number => sorted[Math.floor(part * (sorted.length - 1))]!;
  return { p50: at(0.5), p99: at(0.99) };
}

/** Not zero: the master has to unmask what comes. */
const MASK = Buffer.of(0x5a, 0xa5, 0x3c, 0xc3);
const KEY = Buffer.alloc(16).toString('base64');
/** Between the end of a connection and the next, milliseconds. */
const REST_MS = 20;

/** Small frames are written together: the attack is to be busy with sending alone. */
const WRITE_BYTES = 256 * 1024;

/** WebSocket frames as a client sends them, one or several small ones, to be sent again and again. */
function clientFrames(payload: Uint8Array): Buffer {
  const head = Buffer.alloc(14);
  head[0] = 0x82;
  head[1] = 0x80 | 127;
  head.writeBigUInt64BE(BigInt(payload.length), 2);
  MASK.copy(head, 10);
  const masked = Buffer.from(payload);
  for (let i = 0; i < masked.length; i++) masked[i]! ^= MASK[i & 3]!;
  const frame = Buffer.concat([head, masked]);
  return Buffer.alloc(frame.length * Math.ceil(WRITE_BYTES / frame.length), frame);
}

/** A client that sends the same frames, as fast as the master reads, and comes back when it is closed. */
class FrameFlood {
  readonly #outsider: Outsider;
  readonly #member: Member;
  #socket: Socket | undefined = undefined;
  #isOver = false;
  #connections = 0;
  #sentBytes = 0;

  constructor(outsider: Outsider, member: Member) {
    this.#outsider = outsider;
    this.#member = member;
  }

  get connections(): number {
    return this.#connections;
  }

  /** Bytes that the system took. */
  get sentBytes(): number {
    return this.#sentBytes + (this.#socket?.bytesWritten ?? 0);
  }

  /** Sends until it is closed. @throws Error when the first connection is refused */
  async send(frames: Buffer): Promise<void> {
    while (!this.#isOver) {
      const socket = await this.#open();
      while (!socket.destroyed) if (!socket.write(frames)) await drained(socket);
      this.#socket = undefined;
      this.#sentBytes += socket.bytesWritten;
      await pause(REST_MS);
    }
  }

  close(): void {
    this.#isOver = true;
    this.#socket?.destroy();
  }

  async #open(): Promise<Socket> {
    const { id, extension } = this.#member.client;
    const socket = await this.#outsider.dial();
    const upgrade = {
      Connection: 'Upgrade',
      Upgrade: 'websocket',
      'Sec-WebSocket-Version': '13',
      'Sec-WebSocket-Key': KEY,
    };
    const path = `/?clientID=${id}&token=${extension?.resumeToken ?? ''}`;
    socket.write(this.#outsider.head(`GET ${path} HTTP/1.1`, upgrade));
    const [answer] = (await once(socket, 'data')) as [Buffer];
    const start = answer.toString('latin1', 0, 12);
    if (start !== 'HTTP/1.1 101') throw new Error(`The socket was refused: ${start}`);
    this.#connections++;
    this.#socket = socket;
    // What the master says is of no interest; unread, it would fill its buffers.
    return socket.resume();
  }
}

/** Waits until the socket takes more, or is closed. */
function drained(socket: Socket): Promise<void> {
  return new Promise((resolve) => {
    const handle = (): void => {
      socket.off('drain', handle).off('close', handle);
      resolve();
    };
    socket.once('drain', handle).once('close', handle);
  });
}

const RECORDS = 390_000;
const ATTACK_MS = 10_000;
const WARM_UP_MS = 1_000;
const CALM_MS = 2_000;
/** A busy machine is slower by itself: twice as much as before is as good. */
const MAX_HEALTH_P50_MS = 10;
const MAX_HEALTH_P99_MS = 50;
const MAX_RECORD_P99_MS = 50;

/** Frames that cost the master the most, in bytes of one `TopicData`. @param id of the player */
const SHAPES: { readonly [shape: string]: (id: string) => Uint8Array } = {
  [`${RECORDS} records`]: (id) => manyRecords(`/${id}/a`, RECORDS),
  [`${RECORDS} records on a topic of others`]: () => manyRecords('/others', RECORDS),
  '150000 records': (id) => manyRecords(`/${id}/a`, 150_000),
  '4096 records': (id) => manyRecords(`/${id}/a`, 4_096),
  'one record': (id) => manyRecords(`/${id}/a`, 1),
  'a record of small objects': (id) => {
    const elements = Array.from({ length: RECORDS }, () => ({}));
    return single(encodeRecord({ topic: `/${id}/a`, format: 'object2DList', value: { elements } }));
  },
  'a record of unknown fields': (id) => {
    const record = encodeRecord({ topic: `/${id}/a`, format: 'double', value: 1 });
    // Field 99, which no record has, as a varint.
    return single(Buffer.concat([record, Buffer.alloc(3 * 2_000_000, Buffer.of(0x98, 0x06, 1))]));
  },
};

export const frames: Attack = {
  name: 'frames',
  about: `frames of ${RECORDS} records of one player, for ${ATTACK_MS / 1000} s`,
  async run(environment) {
    const findings: Finding[] = [];
    for (const [shape, make] of Object.entries(SHAPES)) {
      const master = await environment.startMaster();
      const meter = await DelayMeter.open(master.endpoints.url);
      environment.closeLater(() => meter.close());
      await meter.during(WARM_UP_MS);
      const calm = await meter.during(CALM_MS);
      const player = environment.outsider(master);
      const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PLAYER);
      const member = await player.join(token);
      const flood = new FrameFlood(player, member);
      environment.closeLater(() => flood.close());
      const frame = clientFrames(make(member.client.id));
      const cpuBefore = master.figures().cpuMs ?? 0;
      const sent = flood.send(frame);
      const under = await Promise.race([
        meter.during(ATTACK_MS),
        sent.then(() => Promise.reject(new Error('The player stopped sending.'))),
      ]);
      const cpuMs = (master.figures().cpuMs ?? 0) - cpuBefore;
      const perSecond = flood.sentBytes / (ATTACK_MS / 1000);
      findings.push(
        comparison(`${shape}: taken from the player`, `${mib(perSecond)} a second`),
        comparison(`${shape}: connections of the player`, String(flood.connections)),
        comparison(`${shape}: CPU of the master`, `${Math.round((cpuMs / ATTACK_MS) * 100)} %`),
        comparison(`${shape}: health p50 before`, fine(calm.health.p50)),
        atMost(`${shape}: health p50`, under.health.p50, MAX_HEALTH_P50_MS, calm.health.p50),
        atMost(`${shape}: health p99`, under.health.p99, MAX_HEALTH_P99_MS, calm.health.p99),
        comparison(`${shape}: records of others p50`, fine(under.record.p50)),
        atMost(
          `${shape}: records of others p99`,
          under.record.p99,
          MAX_RECORD_P99_MS,
          calm.record.p99,
        ),
      );
      await environment.clear();
    }
    return findings;
  },
};

function manyRecords(topic: string, count: number): Uint8Array {
  const record = encode('ubii.topicData.TopicDataRecord', { topic, double: 1 });
  const element = Buffer.concat([Buffer.of(0x0a, record.length), record]);
  return lengthDelimited(0x1a, Buffer.alloc(element.length * count, element));
}

function single(record: Uint8Array): Uint8Array {
  return lengthDelimited(0x12, record);
}

function lengthDelimited(tag: number, bytes: Uint8Array): Uint8Array {
  const head = [tag];
  let rest = bytes.length;
  for (; rest >= 0x80; rest >>>= 7) head.push((rest & 0x7f) | 0x80);
  return Buffer.concat([Buffer.of(...head, rest), bytes]);
}

function fine(ms: number): string {
  return `${ms.toFixed(1)} ms`;
}

function atMost(what: string, ms: number, maxMs: number, beforeMs: number): Finding {
  const holds = ms <= Math.max(maxMs, 2 * beforeMs);
  return finding(what, fine(ms), `at most ${maxMs} ms, or as before it`, holds);
}
