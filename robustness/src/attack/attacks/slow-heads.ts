import type { Outsider } from '@ubii/harness';

import { pause } from '../../pause.ts';
import { finding, seconds, type Attack, type Finding } from '../attack.ts';

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
