import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { createClient, createMemoryIdentity } from '@ubii/client-web/node';
import { reasonAgainstNats, startNats, type MasterProcess } from '@ubii/harness';
import { AccessRole } from '@ubii/proto';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { startMaster, startNode } from './programs.ts';

// Starts a NATS server and three programs, which takes long on a busy machine.
vi.setConfig({ testTimeout: 120_000 });

const reason = reasonAgainstNats();
if (reason !== undefined) console.warn(`The test of a node in a cluster is left out: ${reason}`);

/** Waits until a master tells its clients of another one. @returns the token of an invitation, which is good at both */
async function inviteWhenKnown({ port, dataDir }: MasterProcess): Promise<string> {
  const joinToken = readFileSync(join(dataDir, 'admin-token'), 'utf8').trim();
  const url = `http://127.0.0.1:${port}`;
  const client = createClient({ url, name: 'guest', joinToken, identity: createMemoryIdentity() });
  onTestFinished(() => client.close());
  await client.connect();
  await expect.poll(() => client.otherMasters.length).toBeGreaterThan(0);
  const role = AccessRole.ACCESS_ROLE_PARTICIPANT;
  const { token } = await client.call('accessGrantCreate', { role });
  await client.close();
  return token;
}

describe.skipIf(reason !== undefined)('a node in a cluster', () => {
  it('[CU-83] [CU-94] moves over HTTPS, trusting the authority that both masters have', async () => {
    const nats = await startNats({ jetstream: true });
    onTestFinished(() => nats.stop());
    const authority = join(temporaryFolder(), 'authority.pem');
    const start = () =>
      startMaster({
        network: ['--lan', 'on'],
        trustsLoopback: false,
        flags: ['--cluster', nats.url, '--tls-authority', authority],
      });
    const [a, b] = [await start(), await start()];
    const certificate = join(temporaryFolder(), 'ca.pem');
    writeFileSync(certificate, await (await fetch(`http://127.0.0.1:${a.port}/ca.pem`)).text());

    const tokenFile = join(temporaryFolder(), 'token');
    writeFileSync(tokenFile, await inviteWhenKnown(a));
    const node = startNode(
      [
        ...[
          '--master',
          `https://127.0.0.1:${a.port}`,
          '--name',
          'mover',
          '--print-endpoints',
          'json',
        ],
        ...['--token-file', tokenFile, '--log-level', 'debug'],
      ],
      { env: { NODE_EXTRA_CA_CERTS: certificate } },
    );
    const { id } = await node.ready<{ id: string }>();
    await a.kill();
    await node.says(new RegExp(`Moved to https://[^ ]+:${b.port}\\n`));
    await node.says(new RegExp(`Connected to https://[^ ]+:${b.port} as ${id}`));
    expect(node.stderr).not.toContain('http://');
  });
});
