import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { temporaryFolder } from '@ubii/program/testing';
import { startNats, type NatsServer } from '@ubii/harness';
import { SystemClock } from '@ubii/timing/system';
import { afterEach, describe, expect, it } from 'vitest';

import { RecordingLog } from '../../testing/recording-log.ts';
import { parseCluster } from '../config/cluster-address.ts';
import { issueAuthority, issueLeaf } from '../tls/issue-certificates.ts';
import { explainStart } from './explain-nats-error.ts';
import { openCluster, type ClusterOptions, type OpenCluster } from './open-cluster.ts';

const ends: (() => Promise<void>)[] = [];
afterEach(async () => {
  for (const end of ends.splice(0).reverse()) await end();
});

async function start(args?: readonly string[], jetstream = true): Promise<NatsServer> {
  const server = await startNats({ jetstream, ...(args && { args }) });
  ends.push(() => server.stop());
  return server;
}

async function enter(url: string, options: Partial<ClusterOptions> = {}): Promise<OpenCluster> {
  const opened = await openCluster({
    address: parseCluster(url),
    name: 'lab',
    credentialsFile: undefined,
    caFile: undefined,
    masterName: 'master',
    frameBytes: 1000,
    clock: new SystemClock(),
    log: new RecordingLog(),
    ...options,
  });
  ends.push(() => opened.close());
  return opened;
}

const fileWith = (name: string, text: string): string => {
  const file = join(
    temporaryFolder((remove) => ends.push(() => Promise.resolve(remove()))),
    name,
  );
  writeFileSync(file, text);
  return file;
};

describe('[CU-61] a cluster', () => {
  it('has one key and the same documents for all its masters', async () => {
    const { url } = await start();
    const [a, b] = await Promise.all([enter(url), enter(url)]);
    expect(b.key).toEqual(a.key);
    const stores = ({ storage }: OpenCluster) => ({
      sessions: storage.sessions,
      modules: storage.modules,
      running: storage.running,
      history: storage.history,
      grants: storage.grants,
      personalData: storage.personalData,
    });
    for (const [kind, store] of Object.entries(stores(a))) {
      const told = new Promise((resolve) => {
        stores(b)[kind as keyof ReturnType<typeof stores>].onChange(resolve);
      });
      await store.write('one', { kind });
      expect(await told).toEqual(['one']);
    }
    for (const [kind, store] of Object.entries(stores(b))) {
      expect([...store.documents()]).toEqual([['one', { json: { kind } }]]);
    }
  });

  it('has nothing in common with one of another name', async () => {
    const { url } = await start();
    const [a, b] = await Promise.all([enter(url), enter(url, { name: 'lab-2' })]);
    await a.storage.sessions.write('one', {});
    await a.cluster.owners.claim('key', 'A', undefined);
    expect(b.key).not.toEqual(a.key);
    const again = await enter(url, { name: 'lab-2' });
    expect(again.storage.sessions.documents().size).toBe(0);
    expect(again.cluster.owners.owners().size).toBe(0);
  });

  it('brings what was written last to NATS before it is left', async () => {
    const { url } = await start();
    const a = await enter(url);
    const writing = a.storage.sessions.write('late', { n: 1 });
    await a.close();
    await writing;
    const b = await enter(url);
    expect([...b.storage.sessions.documents().keys()]).toEqual(['late']);
  });

  it('cannot be joined without JetStream, and the error says how to get it', async () => {
    const { url } = await start([], false);
    await expect(enter(url, { startMs: 300 })).rejects.toThrow(/no JetStream.*-js and -sd/);
  });

  it('[CU-62] is joined over TLS, with a login in a file, by masters that know its authority', async () => {
    const authority = await issueAuthority('test', ['localhost'], Date.now());
    const leaf = await issueLeaf(authority, ['localhost'], Date.now());
    const { port } = await start([
      ...['--tls', '--tlscert', fileWith('cert.pem', leaf.certificate)],
      ...['--tlskey', fileWith('key.pem', leaf.key), '--user', 'ann', '--pass', 'secret'],
    ]);
    const caFile = fileWith('ca.pem', authority.certificate);
    const credentialsFile = fileWith('login', 'ann:secret\n');
    const url = `tls://localhost:${port}`;
    const log = new RecordingLog();
    const { storage } = await enter(url, { caFile, credentialsFile, log });
    await storage.sessions.write('one', {});
    expect(storage.sessions.documents().size).toBe(1);
    expect(JSON.stringify(log.lines)).not.toContain('secret');
    const isDistrusted = /does not trust.*Name the authority.*--cluster-ca/;
    await expect(enter(url, { credentialsFile })).rejects.toThrow(isDistrusted);
    const plain = `nats://localhost:${port}`;
    await expect(enter(plain, { caFile, startMs: 300 })).rejects.toThrow(/refuses this master/);
  });

  it('[CU-62] is not waited for where the certificate of NATS is for other addresses', () => {
    const cause = Object.assign(new Error('Host: 10.0.0.7. is not in the names'), {
      code: 'ERR_TLS_CERT_ALTNAME_INVALID',
    });
    const { error, isFinal } = explainStart(cause, ['tls://10.0.0.7:4222']);
    expect(isFinal).toBe(true);
    expect(error.message).toContain('tls://10.0.0.7:4222 has no such address (Host: 10.0.0.7.');
  });
});
