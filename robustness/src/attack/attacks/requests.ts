import type { Socket } from 'node:net';

import { mib, type Outsider } from '@ubii/harness';
import { AccessRole } from '@ubii/proto';

import { pause } from '../../pause.ts';
import { comparison, finding, millis, seconds, type Attack, type Finding } from '../attack.ts';

const MIB = 1024 * 1024;
/** Below what any build takes as one body. */
const SIZE = 31 * MIB;

/** A request to save a session, as JSON, of some 31 MiB. */
const LARGE_BODIES: Readonly<Record<string, () => Buffer>> = {
  nested: () => {
    const half = (SIZE - 100) / 2;
    return wrap(Buffer.concat([Buffer.alloc(half, '['), Buffer.alloc(half, ']')]));
  },
  keys: () => {
    const parts: string[] = [];
    for (let index = 0, size = 0; size < SIZE - 200; index++) {
      const part = `"k${index.toString(36)}":1`;
      parts.push(part);
      size += part.length + 1;
    }
    return wrap(Buffer.from(`{${parts.join(',')}}`));
  },
  objects: () => {
    const one = '{"name":"a"},';
    const list = Buffer.alloc(Math.floor((SIZE - 200) / one.length) * one.length, one);
    return wrap(Buffer.concat([Buffer.from('{"processingModules":['), list, Buffer.from('{}]}')]));
  },
};

function wrap(session: Buffer): Buffer {
  const topic = '/services/session/database/save';
  return Buffer.concat([Buffer.from(`{"topic":"${topic}","session":`), session, Buffer.from('}')]);
}

/** The aim of the issue: a body of an unknown sender delays records for longer. A busy machine adds its own delays. */
const MAX_DELAY_MS = 25;
const MAX_PEAK_BYTES = 400 * 1024 * 1024;

export const largeBodies: Attack = {
  name: 'large-bodies',
  about: 'JSON bodies of 31 MiB in three shapes, of a stranger and of a participant',
  async run(environment) {
    const findings: Finding[] = [];
    const bodies = Object.entries(LARGE_BODIES).map(([shape, make]) => [shape, make()] as const);
    for (const who of ['stranger', 'participant'] as const) {
      const master = await environment.startMaster();
      const meter = await environment.gapMeter(master);
      const calmMs = await meter.during(async () => {});
      findings.push(comparison(`${who}: stall before it`, millis(calmMs)));
      const caller = environment.outsider(master);
      const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
      const member = who === 'participant' ? await caller.join(token) : undefined;
      for (const [shape, body] of bodies) {
        const headers = {
          'content-type': 'application/json',
          ...(member && { authorization: `Bearer ${member.bearer}` }),
        };
        const longestMs = await meter.during(() =>
          caller.ask('POST', '/services/json', headers, body),
        );
        findings.push(
          finding(
            `${who}, ${shape}: stall of records`,
            millis(longestMs),
            `at most ${MAX_DELAY_MS} ms, or as before it`,
            longestMs <= Math.max(MAX_DELAY_MS, 2 * calmMs),
          ),
        );
      }
      const { peakBytes = 0 } = master.figures();
      findings.push(
        finding(
          `${who}: most resident`,
          mib(peakBytes),
          `at most ${mib(MAX_PEAK_BYTES)}`,
          peakBytes <= MAX_PEAK_BYTES,
        ),
      );
      await environment.clear();
    }
    return findings;
  },
};

const TIMEOUT_MS = 90_000;
const MAX_HELD_MS = 30_000;

export const slowHeads: Attack = {
  name: 'slow-heads',
  about: 'connections of strangers that say nothing, or a header a byte at a time',
  async run(environment) {
    const master = await environment.startMaster();
    const ways: [string, (caller: Outsider) => Promise<number | undefined>][] = [
      ['one byte every 2 s', (caller) => held(caller, 'GET / HTTP/1.1\r\nX-Slow: ', 'a')],
      ['half a request line, then nothing', (caller) => held(caller, 'GET / HT')],
      ['nothing at all', (caller) => held(caller, '')],
      ['half a TLS handshake', (caller) => held(caller, Buffer.from('160301010001', 'hex'))],
      [
        'a body a byte every 2 s',
        (caller) => held(caller, caller.head('POST /services/json HTTP/1.1', BODY), ' '),
      ],
    ];
    return Promise.all(
      ways.map(async ([what, way], index): Promise<Finding> => {
        const heldMs = await way(environment.outsider(master, index));
        return finding(
          what,
          heldMs === undefined ? `held for more than ${seconds(TIMEOUT_MS)}` : seconds(heldMs),
          `at most ${seconds(MAX_HELD_MS)}`,
          heldMs !== undefined && heldMs <= MAX_HELD_MS,
        );
      }),
    );
  },
};

const BODY = { 'Content-Type': 'application/json', 'Content-Length': '4000' };

/** Time until the master closes a connection, ms. @param drop data that is sent every 2 s */
async function held(
  caller: Outsider,
  first: string | Buffer,
  drop?: string,
): Promise<number | undefined> {
  const socket = await caller.dial();
  const begunMs = performance.now();
  const closed = new Promise<number>((resolve) => {
    socket.once('close', () => resolve(performance.now() - begunMs));
    // A reset or an end is how it is let go; what comes is of no interest.
    socket.once('end', () => socket.destroy());
    socket.resume();
  });
  if (first.length > 0) socket.write(first);
  const timer = drop === undefined ? undefined : setInterval(() => void socket.write(drop), 2_000);
  const heldMs = await Promise.race([closed, pause(TIMEOUT_MS).then(() => undefined)]);
  clearInterval(timer);
  socket.destroy();
  return heldMs;
}

const BODIES = 60;
const PART = Buffer.alloc(1024 * 1024, 0x20);
const PARTS = 30;
const MAX_GROWTH_BYTES = 200 * 1024 * 1024;

export const unfinishedBodies: Attack = {
  name: 'unfinished-bodies',
  about: `${BODIES} bodies of ${PARTS} MiB that do not end, of strangers`,
  async run(environment) {
    const master = await environment.startMaster();
    const before = master.figures().residentBytes ?? 0;
    const sockets: Socket[] = [];
    environment.closeLater(() => sockets.forEach((socket) => socket.destroy()));
    for (let index = 0; index < BODIES; index++) {
      const stranger = environment.outsider(master, index);
      const socket = await stranger.dial().catch(() => undefined);
      if (socket === undefined) continue;
      sockets.push(socket);
      socket.write(
        stranger.head('POST /services/json HTTP/1.1', {
          'Content-Type': 'application/json',
          'Content-Length': String((PARTS + 1) * PART.length),
        }),
      );
      for (let part = 0; part < PARTS && !socket.destroyed; part++) {
        socket.write(PART);
        await whenDrained(socket);
      }
    }
    await pause(1_000);
    const { residentBytes = 0, peakBytes = 0 } = master.figures();
    const grown = peakBytes - before;
    return [
      finding(
        'most memory more than before',
        mib(grown),
        `at most ${mib(MAX_GROWTH_BYTES)}`,
        grown <= MAX_GROWTH_BYTES,
      ),
      finding(
        'memory more than before while they are held',
        mib(residentBytes - before),
        `at most ${mib(MAX_GROWTH_BYTES)}`,
        residentBytes - before <= MAX_GROWTH_BYTES,
      ),
    ];
  },
};

/** Waits for a second at most: a master that reads no further is no reason to wait. */
async function whenDrained(socket: Socket): Promise<void> {
  const endMs = performance.now() + 1_000;
  while (socket.writableNeedDrain && !socket.destroyed && performance.now() < endMs) await pause(5);
}
