import type { Socket } from 'node:net';

import type { Outsider } from '@ubii/harness';
import { AccessRole } from '@ubii/proto';

import { pause } from '../../pause.ts';
import { finding, type Attack } from '../attack.ts';

const TIMEOUT_MS = 5_000;

/** Whether the master answers a new connection within 5 s. */
async function canOpen(caller: Outsider): Promise<boolean> {
  const late = new Promise<boolean>((resolve) => {
    setTimeout(() => resolve(false), TIMEOUT_MS).unref();
  });
  const answered = caller.ask('GET', '/health').then(({ status }) => status === 200);
  return Promise.race([answered, late]);
}

const DESCRIPTORS_FOR_CONNECTIONS = 1_500;
const CONNECTIONS = 2_000;

export const connections: Attack = {
  name: 'connections',
  about: `${CONNECTIONS} connections that say nothing, at ${DESCRIPTORS_FOR_CONNECTIONS} descriptors`,
  async run(environment) {
    const master = await environment.startMaster({ maxDescriptors: DESCRIPTORS_FOR_CONNECTIONS });
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
      finding(
        'descriptors of the master',
        String(open),
        `below ${DESCRIPTORS_FOR_CONNECTIONS}`,
        open < DESCRIPTORS_FOR_CONNECTIONS,
      ),
    ];
  },
};

const DESCRIPTORS_FOR_UPGRADES = 700;
const REFUSALS = 700;
/** Time for the master to give up on peers that do not hang up. */
const AFTERWARDS_MS = 20_000;

/** Each refused upgrade sends one more byte, and does not hang up. */
export const descriptors: Attack = {
  name: 'descriptors',
  about: `${REFUSALS} refused upgrades that send one more byte, at ${DESCRIPTORS_FOR_UPGRADES} descriptors`,
  async run(environment) {
    const master = await environment.startMaster({ maxDescriptors: DESCRIPTORS_FOR_UPGRADES });
    const before = master.figures().descriptors ?? 0;
    const sockets: Socket[] = [];
    environment.closeLater(() => sockets.forEach((socket) => socket.destroy()));
    for (let index = 0; index < REFUSALS; index++) {
      const stranger = environment.outsider(master, index);
      const socket = await stranger.dial().catch(() => undefined);
      if (socket === undefined) continue;
      sockets.push(socket);
      const upgrade = stranger.head('GET /?clientID=nobody HTTP/1.1', {
        Connection: 'Upgrade',
        Upgrade: 'websocket',
        'Sec-WebSocket-Version': '13',
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
