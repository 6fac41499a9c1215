import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type MasterProcess, reasonAgainstNats, startNats, StartRefused } from '@ubii/harness';
import { AccessRole } from '@ubii/proto';

import { pause } from '../../pause.ts';
import { comparison, finding, roleName, type Attack, type Finding } from '../attack.ts';
import type { AttackEnvironment } from '../environment/attack-environment.ts';

/** Time in which masters of a cluster find each other. */
const SETTLE_MS = 5_000;

export const clusterSecrets: Attack = {
  name: 'cluster-secrets',
  about:
    "secrets of one master's machine at another master of the cluster, and NATS without a login",
  async run(environment) {
    const reason = reasonAgainstNats();
    if (reason !== undefined) return [comparison('left out', reason)];
    const folder = mkdtempSync(join(tmpdir(), 'ubii-cluster-'));
    environment.closeLater(() => rmSync(folder, { recursive: true, force: true }));
    const nats = await startNats({ jetstream: true, host: '127.0.0.1', parentFolder: folder });
    environment.closeLater(() => nats.stop());
    const flags = ['--cluster', `nats://127.0.0.1:${nats.port}`];
    const masters: MasterProcess[] = [];
    for (const name of ['a', 'b']) {
      const start = { trustsLoopback: false, flags: [...flags, '--name', name] } as const;
      masters.push(await environment.startMaster(start));
    }
    await pause(SETTLE_MS);
    const [first, second] = masters as [MasterProcess, MasterProcess];
    const { adminToken, adminCode } = first.endpoints;
    const findings: Finding[] = [];
    for (const [what, secret] of [
      ['token', adminToken!],
      ['code', adminCode!],
    ] as const) {
      const here = await roleWith(environment, first, secret);
      findings.push(comparison(`the admin's ${what} at its own machine`, roleName(here)));
      const there = await roleWith(environment, second, secret);
      const holds = there !== AccessRole.ACCESS_ROLE_ADMIN;
      findings.push(
        finding(`the admin's ${what} at another machine`, roleName(there), 'no admin', holds),
      );
    }
    const warns = first.log.some((line) => /NATS/.test(line) && /"level":"warn/.test(line));
    findings.push(
      finding('a warning about NATS without a login', warns ? 'yes' : 'no', 'yes', warns),
    );
    findings.push(await startAtOpenNats(environment, folder));
    return findings;
  },
};

/** A NATS server that programs of other machines can use without a login. */
async function startAtOpenNats(
  environment: AttackEnvironment,
  parentFolder: string,
): Promise<Finding> {
  const nats = await startNats({ jetstream: true, host: '0.0.0.0', parentFolder });
  environment.closeLater(() => nats.stop());
  const flags = ['--cluster', `nats://127.0.0.1:${nats.port}`];
  const started = await environment.startMaster({ flags }).then(
    () => 'used',
    (error: unknown) => {
      if (!(error instanceof StartRefused)) throw error;
      return 'refused at the start';
    },
  );
  const isRefused = started !== 'used';
  return finding('NATS without a login for other machines', started, 'refused', isRefused);
}

/** The role of a client of the machine of a master that joins with a secret. */
async function roleWith(
  environment: AttackEnvironment,
  master: MasterProcess,
  secret: string,
): Promise<AccessRole> {
  const caller = environment.insider(master);
  try {
    const { bearer } = await caller.join(secret);
    return await caller.role(bearer);
  } catch {
    return AccessRole.ACCESS_ROLE_NONE;
  }
}
