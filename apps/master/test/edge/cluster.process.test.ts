import { readdirSync } from 'node:fs';
import { AccessRole, type ServiceReply } from '@ubii/proto';
import { temporaryFolder } from '@ubii/program/testing';
import { startNats } from '@ubii/harness';
import { describe, expect, it, onTestFinished, vi } from 'vitest';

import { send, startEdgeMaster, type EdgeMaster } from './edge-master.ts';

/** A caller that is not of this machine, as far as a test can be one. [AC-1] */
const STRANGER = { 'x-forwarded-for': '203.0.113.7' };

async function startCluster() {
  const nats = await startNats({ jetstream: true });
  onTestFinished(() => nats.stop());
  const join = (dataDir = temporaryFolder()): Promise<EdgeMaster> =>
    startEdgeMaster({ dataDir, flags: ['--cluster', nats.url] });
  return { nats, join };
}

async function call(
  { port }: EdgeMaster,
  topic: string,
  payload: object = {},
  headers: Record<string, string> = {},
): Promise<ServiceReply> {
  const { body } = await send(port, '/services/json', {
    method: 'POST',
    headers: { 'content-type': 'application/json', ...headers },
    body: JSON.stringify({ topic: `/services/${topic}`, ...payload }),
  });
  return JSON.parse(body.toString()) as ServiceReply;
}

async function storedSessions(master: EdgeMaster): Promise<unknown[]> {
  const { sessionList } = await call(master, 'session/database/get_list');
  return (sessionList?.elements ?? []).map(({ name }) => name);
}

describe('masters of a cluster over NATS', () => {
  it('[CU-54] have the same stored sessions, and no files of them', async () => {
    const { join } = await startCluster();
    const dataDir = temporaryFolder();
    const [a, b] = [await join(dataDir), await join()];
    const session = { name: 'Shared', processingModules: [] };
    const saved = await call(a, 'session/database/save', { session });
    expect(saved.error).toBeUndefined();
    await vi.waitFor(async () => expect(await storedSessions(b)).toContain('Shared'), 10_000);
    expect(readdirSync(dataDir)).not.toContain('sessions');
    expect(readdirSync(dataDir)).not.toContain('resume-token.key');
    await Promise.all([a.close(), b.close()]);
    expect(await storedSessions(await join())).toContain('Shared');
  });

  it('[CU-56] admit a client with what another of them issued', async () => {
    const { join } = await startCluster();
    const [a, b] = [await join(), await join()];
    const created = await call(a, 'ubii/access_grant_create', {
      accessGrantCreateRequest: { role: AccessRole.ACCESS_ROLE_PARTICIPANT },
    });
    const authorization = `Bearer ${created.accessGrantCreated!.token}`;
    const tryToken = (): Promise<ServiceReply> =>
      call(
        b,
        'ubii/join_check',
        { joinCheckRequest: { token: '' } },
        { ...STRANGER, authorization },
      );
    await vi.waitFor(async () => {
      const { joinCheck } = await tryToken();
      expect(joinCheck?.role).toBe('ACCESS_ROLE_PARTICIPANT');
    }, 10_000);
  });

  it('[CU-60] goes on while NATS is away, and says what cannot be stored', async () => {
    const { nats, join } = await startCluster();
    const a = await join();
    await nats.kill();
    await vi.waitFor(
      () => expect(a.logged.join()).toContain('lost the connection to NATS'),
      10_000,
    );
    const session = { name: 'Lost', processingModules: [] };
    const { error } = await call(a, 'session/database/save', { session });
    expect(error?.message).toContain('NATS cannot be reached');
    await nats.restart();
    await vi.waitFor(() => expect(a.logged.join()).toContain('NATS is back'), 10_000);
    expect((await call(a, 'session/database/save', { session })).error).toBeUndefined();
    expect(await storedSessions(a)).toContain('Lost');
  });
});
