import type { Socket } from 'node:net';

import { pause } from '../../pause.ts';
import { finding, type Attack } from '../attack.ts';
import { canOpen } from '../parts/can-open.ts';

const LIMIT = 700;
const REFUSALS = 700;
/** Time for the master to give up on peers that do not hang up. */
const AFTERWARDS_MS = 20_000;

/** Each refused upgrade sends one more byte, and does not hang up. */
export const descriptors: Attack = {
  name: 'descriptors',
  about: `${REFUSALS} refused upgrades that send one more byte, at ${LIMIT} descriptors`,
  async run(environment) {
    const master = await environment.startMaster({ maxDescriptors: LIMIT });
    const before = master.figures().descriptors ?? 0;
    const sockets: Socket[] = [];
    environment.closeLater(() => sockets.forEach((socket) => socket.destroy()));
    for (let index = 0; index < REFUSALS; index++) {
      const stranger = environment.outsider(master, index);
      const socket = await stranger.dial().catch(() => undefined);
      if (socket === undefined) continue;
      sockets.push(socket);
      const upgrade = stranger.head('GET /?clientID=nobody HTTP/1.1', {
        ...{ Connection: 'Upgrade', Upgrade: 'websocket', 'Sec-WebSocket-Version': '13' },
        'Sec-WebSocket-Key': 'AAAAAAAAAAAAAAAAAAAAAA==',
      });
      socket.write(upgrade);
      const answered = new Promise<void>((resolve) => {
        socket.once('data', () => resolve());
        socket.once('close', () => resolve());
      });
      await Promise.race([answered, pause(500)]);
      if (!socket.destroyed) socket.write('x');
    }
    const during = await canOpen(environment.insider(master));
    await pause(AFTERWARDS_MS);
    const kept = (master.figures().descriptors ?? 0) - before;
    const afterwards = await canOpen(environment.insider(master));
    return [
      finding('this machine gets in during it', during ? 'yes' : 'no', 'yes', during),
      finding('descriptors kept 20 s later', String(kept), 'at most 20', kept <= 20),
      finding('this machine gets in 20 s later', afterwards ? 'yes' : 'no', 'yes', afterwards),
    ];
  },
};
