import type { Socket } from 'node:net';
import { mib } from '@ubii/harness';

import { pause } from '../../pause.ts';
import { finding, type Attack } from '../attack.ts';

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
