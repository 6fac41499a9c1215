import { spawnSync } from 'node:child_process';
import { hostname } from 'node:os';
import { fileURLToPath } from 'node:url';
import { type MasterProcess, StartRefused } from '@ubii/harness';
import { AccessRole } from '@ubii/proto';

import { finding, roleName, type Attack, type Finding } from '../attack.ts';
import type { AttackEnvironment } from '../environment/attack-environment.ts';

const NOBODY = 65_534;
const asker = fileURLToPath(new URL('../parts/ask-role.mjs', import.meta.url));

/** As the master is started by people: nothing said of whom to trust. */
const PLAIN = { trustsLoopback: false } as const;

/** Headers that proxies, gateways and development environments add. */
const PROXY_HEADERS: Readonly<Record<string, string>> = {
  'X-Client-IP': '198.51.100.7',
  'CF-Connecting-IP': '198.51.100.7',
  'X-Remote-Source': '198.51.100.7',
  'X-Client-Port': '50123',
  'X-NginX-Proxy': 'true',
  'X-ProxyUser-IP': '198.51.100.7',
  'Front-End-Https': 'on',
  'X-MS-Proxy': 'AzureAD-Application-Proxy',
  'X-SSL-Client-Cert': 'a',
  'Proxy-Connection': 'keep-alive',
  'X-Coder-Session': 'a',
  'X-GitHub-Token': 'a',
};

export const originNull: Attack = {
  name: 'origin-null',
  about: 'a page without an origin, at a master with --allowed-origins null',
  async run(environment) {
    try {
      const master = await environment.startMaster({
        ...PLAIN,
        flags: ['--allowed-origins', 'null'],
      });
      return [await noAdmin(environment, master, 'Origin: null', { Origin: 'null' })];
    } catch (error) {
      if (!(error instanceof StartRefused)) throw error;
      return [finding('--allowed-origins null', 'refused at the start', 'no admin', true)];
    }
  },
};

export const proxies: Attack = {
  name: 'proxies',
  about: 'proxies on this machine that pass strangers on',
  async run(environment) {
    const master = await environment.startMaster(PLAIN);
    const findings = [
      await noAdmin(environment, master, 'HTTP/1.1, no header', {}),
      await noAdmin(environment, master, 'an unknown header', {
        'X-Gateway-Caller': '198.51.100.7',
      }),
    ];
    for (const [name, value] of Object.entries(PROXY_HEADERS)) {
      const role = await roleOf(environment, master, { [name]: value });
      const isStranger = role === AccessRole.ACCESS_ROLE_NONE;
      findings.push(finding(name, roleName(role), 'stranger', isStranger));
    }
    return findings;
  },
};

export const localName: Attack = {
  name: 'local-name',
  about: 'a page whose name <name>.local was made to mean this machine',
  async run(environment) {
    const master = await environment.startMaster(PLAIN);
    const findings: Finding[] = [];
    for (const name of [`${hostname().split('.')[0]}.local`, hostname()]) {
      const host = `${name}:${master.port}`;
      const headers = { host, origin: `http://${host}` };
      findings.push(await noAdmin(environment, master, `Host: ${name}`, headers));
    }
    return findings;
  },
};

export const localUsers: Attack = {
  name: 'local-users',
  about: 'other users of this machine, and pages of other ports of localhost',
  async run(environment) {
    const master = await environment.startMaster(PLAIN);
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
    findings.push(await noAdmin(environment, master, 'a page of localhost:5999', page));
    return findings;
  },
};

async function noAdmin(
  environment: AttackEnvironment,
  master: MasterProcess,
  what: string,
  headers: Readonly<Record<string, string>>,
): Promise<Finding> {
  const role = await roleOf(environment, master, headers);
  return finding(what, roleName(role), 'no admin', role !== AccessRole.ACCESS_ROLE_ADMIN);
}

/** @returns the reason when there is no answer */
function roleOf(
  environment: AttackEnvironment,
  master: MasterProcess,
  headers: Readonly<Record<string, string>>,
): Promise<AccessRole | string> {
  const caller = environment.insider(master, headers);
  return caller.role().catch((error: unknown) => String((error as Error).message));
}
