import { createHash } from 'node:crypto';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it, vi } from 'vitest';

import { send, startEdgeMaster } from './edge-master.ts';

// A whole master each: minutes on a busy machine are no fault of it.
vi.setConfig({ testTimeout: 60_000 });

const HELLO = 'hello';
const HASH = createHash('sha256').update(HELLO).digest('hex');

/** Data of a master with the set `greeting`. */
function dataWithSet(): string {
  const dataDir = temporaryFolder();
  const folder = join(dataDir, 'models', 'greeting', 'texts');
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'a.txt'), HELLO);
  writeFileSync(join(dataDir, 'secret.txt'), 'secret');
  return dataDir;
}

describe('asset sets of a master [PM-92]', () => {
  it('are served with a manifest that names size and hash', async () => {
    const { port } = await startEdgeMaster({ dataDir: dataWithSet() });
    const { status, headers, body } = await send(port, '/asset-sets/greeting/manifest.json');
    expect(status).toBe(200);
    expect(headers['cache-control']).toBe('no-cache');
    expect(JSON.parse(body.toString())).toMatchObject({
      name: 'greeting',
      files: [{ path: 'texts/a.txt', bytes: 5, sha256: HASH }],
    });
  });

  it('are served file by file, permanently, and as nothing that a browser runs', async () => {
    const { port } = await startEdgeMaster({ dataDir: dataWithSet() });
    const { status, headers, body } = await send(port, `/asset-sets/greeting/${HASH}/texts/a.txt`);
    expect([status, body.toString()]).toEqual([200, HELLO]);
    expect(headers).toMatchObject({
      'cache-control': 'public, max-age=31536000, immutable',
      'content-type': 'application/octet-stream',
      'content-security-policy': "default-src 'none'",
      'x-content-type-options': 'nosniff',
    });
  });

  it.each([
    '/asset-sets/none/manifest.json',
    '/asset-sets/../secret.txt/manifest.json',
    '/asset-sets/%2e%2e/manifest.json',
    `/asset-sets/greeting/${'0'.repeat(64)}/texts/a.txt`,
    `/asset-sets/greeting/${HASH}/texts/b.txt`,
    `/asset-sets/greeting/${HASH}/../../secret.txt`,
    `/asset-sets/greeting/${HASH}/..%2f..%2f..%2fsecret.txt`,
    `/asset-sets/greeting/${HASH}/`,
  ])('have nothing at %s', async (path) => {
    const { port } = await startEdgeMaster({ dataDir: dataWithSet() });
    const { status, body } = await send(port, path);
    expect(status).toBe(404);
    expect(body.toString()).not.toContain('secret');
  });

  it('do not give a damaged file to caches, and give it once it is repaired', async () => {
    const dataDir = dataWithSet();
    const folder = join(dataDir, 'models', 'greeting');
    const manifest = { name: 'greeting', files: [{ path: 'texts/a.txt', bytes: 5, sha256: HASH }] };
    writeFileSync(join(folder, 'manifest.json'), JSON.stringify(manifest));
    writeFileSync(join(folder, 'texts', 'a.txt'), 'hallo');
    const { port } = await startEdgeMaster({ dataDir });
    const path = `/asset-sets/greeting/${HASH}/texts/a.txt`;
    const damaged = await send(port, path);
    expect(damaged.status).toBe(400);
    expect(damaged.headers['cache-control']).toBe('no-store');
    expect(damaged.body.toString()).toContain('Replace the file');
    writeFileSync(join(folder, 'texts', 'a.txt'), `${HELLO}`);
    expect((await send(port, path)).body.toString()).toBe(HELLO);
  });

  it('that are damaged say so', async () => {
    const dataDir = dataWithSet();
    writeFileSync(join(dataDir, 'models', 'greeting', 'manifest.json'), '{"name":"greeting"}');
    const { port } = await startEdgeMaster({ dataDir });
    const { status, body } = await send(port, '/asset-sets/greeting/manifest.json');
    expect(status).toBe(400);
    expect(body.toString()).toContain('lists no files');
  });
});
