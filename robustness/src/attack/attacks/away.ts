import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { AccessRole } from '@ubii/proto';

import { pause } from '../../pause.ts';
import { Gauge, probeFlags } from '../../soak/measure.ts';
import { publish, registerDevice } from '../../soak/workload/phones.ts';
import { comparison, finding, type Attack } from '../attack.ts';

const CLIENTS = 1_500;
/** They warm up whatever is made once. */
const FIRST_CLIENTS = 1_000;
/** One of each component. */
const RECORDS = 3;
const MAX_BYTES = 17 * 1024;
const LIMITS = 'connectionsPerAddress=9000,connectionsPerNetwork=9000,connectionsOfStrangers=9000';

export const awayClients: Attack = {
  name: 'away-clients',
  about: `${CLIENTS} phones join, publish, and disappear silently`,
  async run(environment) {
    const folder = mkdtempSync(join(tmpdir(), 'ubii-away-'));
    environment.closeLater(() => rmSync(folder, { recursive: true, force: true }));
    const probe = join(folder, 'probe.json');
    const flags = ['--flight-recorder', 'off', '--limits', LIMITS];
    const master = await environment.startMaster({ flags, nodeFlags: probeFlags(probe) });
    const gauge = new Gauge(master, probe);
    const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PLAYER);
    let problem: unknown;
    const joinAndVanish = async (count: number): Promise<void> => {
      for (let index = 0; index < count; index++) {
        const player = environment.outsider(master, index);
        try {
          const member = await player.join(token, { name: `player ${index}` });
          await registerDevice(player, member);
          const socket = await player.openSocket(member);
          await publish(socket, member.client, RECORDS);
          socket.terminate();
        } catch (refused) {
          problem = refused;
        }
      }
      await pause(5_000);
    };
    await joinAndVanish(FIRST_CLIENTS);
    const before = await gauge.read();
    await joinAndVanish(CLIENTS);
    const after = await gauge.read();
    const clients = after.clients - before.clients;
    if (clients === 0) throw new Error(`No client joined: ${String(problem)}`);
    const each =
      (after.heapBytes + after.externalBytes - before.heapBytes - before.externalBytes) / clients;
    const resident = (after.residentBytes - before.residentBytes) / clients;
    return [
      comparison('clients that are away', String(after.clients)),
      finding(
        'heap and buffers of each',
        kib(each),
        `at most ${kib(MAX_BYTES)}`,
        each <= MAX_BYTES,
      ),
      // Pages that the garbage of joining filled stay with the process: fewer for each, the more clients there are.
      comparison('resident memory of each', kib(resident)),
    ];
  },
};

function kib(bytes: number): string {
  return `${(bytes / 1024).toFixed(1)} KiB`;
}
