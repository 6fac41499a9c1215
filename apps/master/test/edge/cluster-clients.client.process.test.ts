import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { createClient, type MasterChange } from '@ubii/client-web/node';
import { temporaryFolder } from '@ubii/program/testing';
import { startNats } from '@ubii/harness';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { send, startEdgeMaster } from './edge-master.ts';

// Real sockets and timers, on a machine that may be busy.
vi.setConfig({ testTimeout: 60_000 });

async function startTwo() {
  const nats = await startNats({ jetstream: true });
  onTestFinished(() => nats.stop());
  const frontendFolder = temporaryFolder();
  mkdirSync(join(frontendFolder, 'assets'));
  writeFileSync(join(frontendFolder, 'index.html'), '<!doctype html><title>page</title>');
  const options = { frontendFolder, flags: ['--cluster', nats.url] };
  return [await startEdgeMaster(options), await startEdgeMaster(options)] as const;
}

const policyOf = async (port: number): Promise<string> => {
  const { headers } = await send(port, '/', { headers: { accept: 'text/html' } });
  return `${headers['content-security-policy']} ${headers['cache-control']}`;
};

describe('clients of ours at masters of a cluster over NATS', () => {
  it('[CU-83] go on at the other one when theirs ends', async () => {
    const [a, b] = await startTwo();
    const phone = createClient({ url: a.url, name: 'phone' });
    const screen = createClient({ url: b.url, name: 'screen' });
    onTestFinished(async () => void (await Promise.all([phone.close(), screen.close()])));
    await Promise.all([phone.connect(), screen.connect()]);
    const { id } = phone;
    const seen: unknown[] = [];
    await screen.subscribe('/lamp').onRecord(({ value }) => seen.push(value)).ready;
    await vi.waitFor(() => expect(phone.otherMasters).toHaveLength(1), 20_000);
    const moved = new Promise<MasterChange>((resolve) => phone.onMaster(resolve));
    await a.close();
    phone.publish('/lamp', 'int32', 1);
    const { url } = await moved;
    expect(new URL(url).port).toBe(String(b.port));
    await vi.waitFor(() => expect(phone.state.status).toBe('connected'), 20_000);
    expect(phone.id).toBe(id);
    phone.publish('/lamp', 'int32', 2);
    await vi.waitFor(() => expect(seen).toEqual([1, 2]), 20_000);
  });

  it('[CU-90] [CU-91] come from pages that may ask the other master, and no further one', async () => {
    const [a, b] = await startTwo();
    const others = new RegExp(`connect-src 'self' ws: wss: (http://[a-z0-9.]+:${b.port});`);
    await vi.waitFor(async () => expect(await policyOf(a.port)).toMatch(others), 20_000);
    const policy = await policyOf(a.port);
    expect(policy).toMatch(/no-store$/);
    expect(policy.match(/https?:\/\//g)).toHaveLength(1);
  });
});
