import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it, vi } from 'vitest';

import { send, startEdgeMaster } from './edge-master.ts';

// A whole master each: minutes on a busy machine are no fault of it.
vi.setConfig({ testTimeout: 60_000 });

const MODULE = 'export const one = 1;'.repeat(100);
const STRANGER = { 'x-forwarded-for': '192.0.2.7' };

function builtLibrary(): string {
  const folder = join(temporaryFolder(), 'sdk');
  mkdirSync(folder);
  writeFileSync(join(folder, '..', 'secret.txt'), 'classified');
  writeFileSync(join(folder, 'other.json'), '{}');
  writeFileSync(join(folder, 'ubii-client-1.2.3.tgz'), 'archive');
  writeFileSync(join(folder, 'ubii-client.js'), MODULE);
  writeFileSync(join(folder, 'ubii-client.js.br'), brotliCompressSync(MODULE));
  writeFileSync(join(folder, 'ubii-client.js.map'), '{}');
  writeFileSync(join(folder, 'ubii-client.d.ts'), 'export {};');
  return folder;
}

describe('the client library [AC-5]', () => {
  it.each([
    ['ubii-client-1.2.3.tgz', 'application/gzip'],
    ['ubii-client.js', 'text/javascript; charset=utf-8'],
    ['ubii-client.js.map', 'application/json; charset=utf-8'],
    ['ubii-client.d.ts', 'text/plain; charset=utf-8'],
  ])('has %s for strangers, as %s, and says when it did not change', async (name, type) => {
    const { port } = await startEdgeMaster({ sdkFolder: builtLibrary() });
    const { status, headers } = await send(port, `/sdk/${name}`, { headers: STRANGER });
    expect([status, headers['content-type']]).toEqual([200, type]);
    expect(headers['cache-control']).toBe('no-cache');
    const again = { ...STRANGER, 'if-none-match': String(headers['etag']) };
    expect((await send(port, `/sdk/${name}`, { headers: again })).status).toBe(304);
  });

  it('is compressed for those who take it', async () => {
    const { port } = await startEdgeMaster({ sdkFolder: builtLibrary() });
    const headers = { 'accept-encoding': 'br' };
    const reply = await send(port, '/sdk/ubii-client.js', { headers });
    expect(reply.headers['content-encoding']).toBe('br');
    expect(reply.headers['content-type']).toMatch(/^(text|application)\/javascript;/);
    expect(reply.body.length).toBeLessThan(MODULE.length);
  });

  it('is read by pages of files and of other ports, and by no other page than may call [AC-46]', async () => {
    const { port } = await startEdgeMaster({ sdkFolder: builtLibrary() });
    const readBy = async (origin: string) => {
      const { status, headers } = await send(port, '/sdk/ubii-client.js', { headers: { origin } });
      return [status, headers['access-control-allow-origin']];
    };
    expect(await readBy('null')).toEqual([200, 'null']);
    expect(await readBy('http://127.0.0.1:3000')).toEqual([200, 'http://127.0.0.1:3000']);
    expect(await readBy('https://evil.example')).toEqual([403, undefined]);
    const page = await send(port, '/health', { headers: { origin: 'null' } });
    expect(page.status).toBe(403);
  });

  it.each([
    '/sdk/other.json',
    '/sdk/ubii-client.js.br',
    '/sdk/../secret.txt',
    '/sdk/%2e%2e/secret.txt',
    '/sdk/..%2fsecret.txt',
    '/sdk/ubii-client-9.9.9.tgz',
    '/sdk/nothing',
  ])('has no %s', async (path) => {
    const { port } = await startEdgeMaster({ sdkFolder: builtLibrary() });
    const { status, body } = await send(port, path, { headers: { accept: 'text/html' } });
    expect([400, 403, 404]).toContain(status);
    expect(body.toString()).not.toContain('classified');
  });

  it('has a page with its files, and how to install it from the address that was called', async () => {
    const { port } = await startEdgeMaster({ sdkFolder: builtLibrary() });
    for (const path of ['/sdk', '/sdk/']) {
      const { status, headers, body } = await send(port, path, { headers: STRANGER });
      expect([status, headers['content-type']]).toEqual([200, 'text/html; charset=utf-8']);
      expect(headers['content-security-policy']).toContain("default-src 'none'");
      const text = body.toString();
      expect(text).toContain(`npm i http://127.0.0.1:${port}/sdk/ubii-client-1.2.3.tgz`);
      expect(text).toContain(`from 'http://127.0.0.1:${port}/sdk/ubii-client.js'`);
      expect(text).toContain('<a href="/sdk/ubii-client.d.ts">');
      expect(text).not.toContain('other.json');
    }
  });

  it('says when it is not built', async () => {
    const { port } = await startEdgeMaster();
    for (const path of ['/sdk/', '/sdk/ubii-client.js']) {
      const { status, body } = await send(port, path);
      expect([status, body.toString()]).toEqual([404, expect.stringContaining('run npm start')]);
    }
  });
});
