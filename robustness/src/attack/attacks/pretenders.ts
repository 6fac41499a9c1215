import { spawnSync } from 'node:child_process';
import { hostname } from 'node:os';
import { fileURLToPath } from 'node:url';
import { AccessRole } from '@ubii/proto';

import { StartRefused, type MasterProcess } from '../../master/master-process.ts';
import { finding, type Attack, type Finding } from '../attack.ts';
import type { World } from '../world/world.ts';

const NOBODY = 65_534;
const asker = fileURLToPath(new URL('../parts/ask-role.mjs', import.meta.url));

/** As the master is started by people: nothing said of whom to trust. */
const PLAIN = { loopback: 'unsaid' } as const;

export const originNull: Attack = {
  name: 'origin-null',
  about: 'a page without an origin, at a master with --allowed-origins null',
  async run(world) {
    try {
      const master = await world.startMaster({ ...PLAIN, flags: ['--allowed-origins', 'null'] });
      return [await noAdmin(world, master, 'Origin: null', { Origin: 'null' })];
    } catch (error) {
      if (!(error instanceof StartRefused)) throw error;
      return [finding('--allowed-origins null', 'refused at the start', 'no admin', true)];
    }
  },
};

export const proxies: Attack = {
  name: 'proxies',
  about: 'proxies on this machine that pass strangers on',
  async run(world) {
    const master = await world.startMaster(PLAIN);
    const findings = [await noAdmin(world, master, 'HTTP/1.1, no header', {})];
    const headers = ['X-Client-IP', 'CF-Connecting-IP', 'X-Gateway-Caller', 'X-Remote-Source'];
    for (const name of headers) {
      findings.push(await noAdmin(world, master, name, { [name]: '198.51.100.7' }));
    }
    return findings;
  },
};

export const localName: Attack = {
  name: 'local-name',
  about: 'a page whose name <name>.local was made to mean this machine',
  async run(world) {
    const master = await world.startMaster(PLAIN);
    const findings: Finding[] = [];
    for (const name of [`${hostname().split('.')[0]}.local`, hostname()]) {
      const host = `${name}:${master.port}`;
      const headers = { host, origin: `http://${host}` };
      findings.push(await noAdmin(world, master, `Host: ${name}`, headers));
    }
    return findings;
  },
};

export const localUsers: Attack = {
  name: 'local-users',
  about: 'other users of this machine, and pages of other ports of localhost',
  async run(world) {
    const master = await world.startMaster(PLAIN);
    const findings: Finding[] = [];
    if (process.getuid?.() === 0) {
      const { stdout } = spawnSync(process.execPath, [asker, String(master.port)], {
        uid: NOBODY,
        gid: NOBODY,
        encoding: 'utf8',
      });
      const role = Number(stdout);
      findings.push(
        finding(
          'a program of another user',
          roleName(role),
          'no admin',
          role !== AccessRole.ACCESS_ROLE_ADMIN,
        ),
      );
    }
    const page = { Origin: 'http://localhost:5999', 'Sec-Fetch-Site': 'same-site' };
    findings.push(await noAdmin(world, master, 'a page of localhost:5999', page));
    return findings;
  },
};

async function noAdmin(
  world: World,
  master: MasterProcess,
  what: string,
  headers: Readonly<Record<string, string>>,
): Promise<Finding> {
  const caller = world.insider(master, headers);
  const role = await caller.role().catch((error: unknown) => String((error as Error).message));
  return finding(what, roleName(role), 'no admin', role !== AccessRole.ACCESS_ROLE_ADMIN);
}

function roleName(role: number | string): string {
  if (typeof role === 'string') return `refused (${role.replace(/^.*answered with /, '')})`;
  const name = Object.entries(AccessRole).find(([, value]) => value === role)?.[0] ?? '?';
  return name === 'ACCESS_ROLE_NONE' ? 'stranger' : name.replace('ACCESS_ROLE_', '').toLowerCase();
}
