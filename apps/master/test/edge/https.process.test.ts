import { X509Certificate } from 'node:crypto';
import { get } from 'node:https';
import type { IncomingMessage } from 'node:http';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { WebSocket } from 'ws';

import { send, startEdgeMaster } from './edge-master.ts';

// Real sockets and timers, on a machine that may be busy.
vi.setConfig({ testTimeout: 30_000 });

function ask(port: number, path: string, ca: Buffer): Promise<{ status: number; text: string }> {
  return new Promise((resolve, reject) => {
    get({ host: '127.0.0.1', port, path, ca, agent: false }, (response: IncomingMessage) => {
      let text = '';
      response.on('data', (chunk) => (text += String(chunk)));
      response.on('end', () => resolve({ status: response.statusCode ?? 0, text }));
    }).on('error', reject);
  });
}

describe('a master that others can reach', () => {
  it('serves HTTPS and HTTP on one port, for clients that trust its authority', async () => {
    const { port } = await startEdgeMaster({ flags: ['--lan'] });
    const { body: ca, headers } = await send(port, '/ca.pem');
    expect(headers['content-type']).toContain('x-pem-file');
    expect(await ask(port, '/health', ca)).toMatchObject({ status: 200 });
    await expect(ask(port, '/health', Buffer.from(''))).rejects.toThrow();
    expect((await send(port, '/health')).status).toBe(200);
  });

  it('takes topic data over the same certificate', async () => {
    const { port } = await startEdgeMaster({ flags: ['--lan'] });
    const { body: ca } = await send(port, '/ca.pem');
    const registered = await send(port, '/services/json', {
      method: 'POST',
      headers: { 'content-type': 'application/json' },
      body: JSON.stringify({ topic: '/services/client/registration', client: { name: 'phone' } }),
    });
    const { client } = JSON.parse(String(registered.body)) as { client: { id: string } };
    const socket = new WebSocket(`wss://127.0.0.1:${port}/topicdata?clientID=${client.id}`, { ca });
    onTestFinished(() => socket.terminate());
    await new Promise((resolve, reject) => {
      socket.on('error', reject);
      // [TD-2] The master sends a PING.
      socket.on('message', resolve);
    });
  });

  it('gives its authority in the forms that phones install', async () => {
    const { port } = await startEdgeMaster({ flags: ['--lan'] });
    const { body: pem } = await send(port, '/ca.pem');
    const authority = new X509Certificate(pem);
    expect(authority.ca).toBe(true);
    const { body: der } = await send(port, '/ca.crt');
    expect(der.equals(authority.raw)).toBe(true);
    const { body: profile, headers } = await send(port, '/ca.mobileconfig');
    expect(headers['content-type']).toContain('x-apple-aspen-config');
    expect(String(profile)).toContain(authority.raw.toString('base64'));
    expect(String(profile)).toMatch(/<key>PayloadUUID<\/key><string>[0-9A-F-]{36}<\/string>/);
  });

  it('keeps to HTTP when it is told to', async () => {
    const { port } = await startEdgeMaster({ flags: ['--lan', '--https', 'off'] });
    expect((await send(port, '/ca.pem')).status).toBe(404);
    expect((await send(port, '/health')).status).toBe(200);
  });
});

describe('a master that is alone on its machine', () => {
  it('makes no certificates: browsers trust loopback', async () => {
    const { port } = await startEdgeMaster();
    expect((await send(port, '/ca.pem')).status).toBe(404);
  });
});
