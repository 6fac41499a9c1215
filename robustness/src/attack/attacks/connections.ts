import type { Socket } from 'node:net';
import { AccessRole } from '@ubii/proto';

import { pause } from '../../pause.ts';
import { finding, type Attack } from '../attack.ts';
import { canOpen } from '../parts/can-open.ts';

const LIMIT = 1_500;
const CONNECTIONS = 2_000;

export const connections: Attack = {
  name: 'connections',
  about: `${CONNECTIONS} connections that say nothing, at ${LIMIT} descriptors`,
  async run(environment) {
    const master = await environment.startMaster({ maxDescriptors: LIMIT });
    const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PLAYER);
    const phone = environment.outsider(master, 40);
    const member = await phone.join(token);
    const sockets: Socket[] = [];
    environment.closeLater(() => sockets.forEach((socket) => socket.destroy()));
    for (let index = 0; index < CONNECTIONS; index++) {
      const stranger = environment.outsider(master, index % 40);
      const socket = await Promise.race([stranger.dial(), pause(200)]).catch(() => undefined);
      if (socket !== undefined && typeof socket === 'object') sockets.push(socket);
    }
    await pause(500);
    const here = await canOpen(environment.insider(master));
    const joined = await Promise.race([
      phone.openSocket(member).then(
        () => true,
        () => false,
      ),
      pause(5_000).then(() => false),
    ]);
    const neighbour = await canOpen(environment.outsider(master, 41));
    const open = master.figures().descriptors ?? 0;
    return [
      finding('this machine gets in', here ? 'yes' : 'no', 'yes', here),
      finding('who has joined opens a socket', joined ? 'yes' : 'no', 'yes', joined),
      finding('an address that took no part gets in', neighbour ? 'yes' : 'no', 'yes', neighbour),
      finding('descriptors of the master', String(open), `below ${LIMIT}`, open < LIMIT),
    ];
  },
};
