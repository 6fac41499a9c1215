import { statSync, readdirSync, readFileSync } from 'node:fs';
import { connect } from 'node:net';
import { hostname } from 'node:os';
import { join } from 'node:path';
import { AccessRole } from '@ubii/proto';
import { describe, expect, it, vi } from 'vitest';
import { WebSocket } from 'ws';

import { newFolder, send, startEdgeMaster } from './edge-master.ts';

// A whole master each: minutes on a busy machine are no fault of it.
vi.setConfig({ testTimeout: 60_000 });

type Headers = Readonly<Record<string, string>>;

/** Whoever comes through a tunnel or proxy on this machine: a stranger, and the one a test can be. [AC-1] */
const STRANGER: Headers = { 'x-forwarded-for': '203.0.113.7' };

interface Reply {
  readonly error?: {
    readonly code: string;
    readonly message: string;
    readonly join?: { problem: string };
  };
  readonly client?: { readonly id: string; readonly extension: Record<string, string> };
  readonly accessGrantCreated?: {
    readonly token: string;
    readonly code: string;
    readonly grant: { readonly id: string };
  };
  readonly joinCheck?: { readonly role?: string };
  readonly [member: string]: unknown;
}

async function call(
  port: number,
  topic: string,
  headers: Headers = {},
  payload: object = {},
  path = '/services/json',
) {
  const response = await send(port, path, {
    method: 'POST',
    headers: { 'content-type': 'application/json', ...headers },
    body: JSON.stringify({ topic, ...payload }),
  });
  const { status, body } = response;
  return { status, reply: (status === 200 ? JSON.parse(String(body)) : {}) as Reply };
}

const LIST = '/services/client/get_list';

/** The code of the error with which a call that needs a role ends; `admin` or another word for success. */
async function roleOf(port: number, headers: Headers, path?: string): Promise<string> {
  const check = await call(
    port,
    '/services/ubii/join_check',
    headers,
    { joinCheckRequest: { token: '' } },
    path,
  );
  if (check.status !== 200) return String(check.status);
  const list = await call(port, LIST, headers, {}, path);
  if (list.reply.error !== undefined) return list.reply.error.code;
  return String(check.reply.joinCheck?.role).replace('ACCESS_ROLE_', '').toLowerCase();
}

async function createGrant(
  port: number,
  role: AccessRole = AccessRole.ACCESS_ROLE_PLAYER,
  more: object = {},
) {
  const { reply } = await call(
    port,
    '/services/ubii/access_grant_create',
    {},
    {
      accessGrantCreateRequest: { role, ...more },
    },
  );
  return reply.accessGrantCreated!;
}

function register(port: number, bearer: string, client: object = {}) {
  return call(
    port,
    '/services/client/registration',
    { ...STRANGER, authorization: `Bearer ${bearer}` },
    { client: { name: 'phone', extension: {}, ...client } },
  );
}

/** How an upgrade ends: `open`, a close code, or the status it was refused with. */
function upgrade(
  port: number,
  query: string,
  headers: Headers = {},
  path = '/topicdata',
): Promise<string> {
  return new Promise((resolve) => {
    const socket = new WebSocket(`ws://127.0.0.1:${port}${path}${query}`, { headers });
    const end = (how: string): void => {
      resolve(how);
      socket.terminate();
    };
    socket.on('unexpected-response', (_request, response) => end(String(response.statusCode)));
    socket.on('message', () => end('open'));
    socket.on('close', (code) => end(String(code)));
    socket.on('error', () => undefined);
  });
}

describe('who is of this machine [AC-1] [AC-2]', () => {
  it('goes by headers of proxies, the host and the origin', async () => {
    const { port } = await startEdgeMaster({
      flags: ['--allowed-origins', 'https://lab.example,*'],
    });
    const host = `localhost:${port}`;
    const cases: [Headers, string][] = [
      [{}, 'admin'],
      [{ host, origin: `http://${host}` }, 'admin'],
      [{ host, origin: 'http://localhost:3000' }, 'admin'],
      [{ host, origin: 'http://127.0.0.1:3000' }, 'admin'],
      [{ host: `${hostname().split('.')[0]!.toLowerCase()}.local` }, 'admin'],
      [{ host, origin: 'https://lab.example' }, 'admin'],
      [{ host, 'sec-fetch-site': 'same-origin' }, 'admin'],
      [{ host, 'sec-fetch-site': 'none' }, 'admin'],
      [{ host, 'sec-fetch-site': 'cross-site' }, 'unauthenticated'],
      [{ host, 'sec-fetch-site': 'same-site' }, 'unauthenticated'],
      // Pages of others, which `*` lets call.
      [{ host, origin: 'http://192.168.1.50' }, 'unauthenticated'],
      [{ host, origin: 'https://evil.example' }, 'unauthenticated'],
      [{ host, origin: 'null' }, 'unauthenticated'],
      [{ host, origin: 'http://localhost.evil.example' }, 'unauthenticated'],
      // Names that somebody in the network can make mean this machine: DNS rebinding.
      [{ host: 'box.local', origin: 'http://box.local' }, 'unauthenticated'],
      [{ host: 'printer', origin: 'http://printer' }, 'unauthenticated'],
      [{ host: 'evil.example', origin: 'http://evil.example' }, 'unauthenticated'],
      [{ host: '203.0.113.9' }, 'unauthenticated'],
      // Proxies and tunnels.
      ...[
        'Forwarded',
        'X-Forwarded-For',
        'x-forwarded-host',
        'X-Forwarded-Proto',
        'X-Real-IP',
        'Via',
        'CF-Connecting-IP',
      ].map((name): [Headers, string] => [{ [name]: '127.0.0.1' }, 'unauthenticated']),
    ];
    for (const [headers, role] of cases)
      expect([headers, await roleOf(port, headers)]).toEqual([headers, role]);
  });

  it('refuses pages of names and origins that are nobody’s, as before [SV-8]', async () => {
    const { port } = await startEdgeMaster();
    expect(await roleOf(port, { host: 'evil.example', origin: 'http://evil.example' })).toBe('403');
    expect(await roleOf(port, { host: `localhost:${port}`, origin: 'http://192.168.1.50' })).toBe(
      '403',
    );
    expect(await upgrade(port, '?clientID=x', { origin: 'http://192.168.1.50' })).toBe('403');
  });

  it('takes no proxy that says nothing for this machine: they speak HTTP/1.0', async () => {
    const { port } = await startEdgeMaster();
    const answer = await new Promise<string>((resolve) => {
      let text = '';
      const body = JSON.stringify({ topic: LIST });
      const socket = connect(port, '127.0.0.1', () => {
        socket.write(
          `POST /services/json HTTP/1.0\r\nHost: localhost:${port}\r\nContent-Length: ${body.length}\r\n\r\n${body}`,
        );
      });
      socket.on('data', (chunk) => (text += String(chunk)));
      socket.on('close', () => resolve(text));
    });
    expect(answer).toContain('unauthenticated');
  });

  it('is the same on every port and path, and whatever headers are called [AC-6]', async () => {
    const { ports } = await startEdgeMaster({ flags: ['--legacy-ports', '0,0'] });
    for (const port of new Set([ports.main, ports.services, ports.topicData])) {
      for (const path of [
        '/services',
        '/services/',
        '/services/json',
        '/services/json/',
        '/services/json?x=1',
      ]) {
        expect(await roleOf(port, STRANGER, path)).toBe('unauthenticated');
      }
      expect(await roleOf(port, { 'X-FORWARDED-FOR': '' })).toBe('unauthenticated');
      for (const path of ['/services/binary', '/services/binary/']) {
        const { body, status } = await send(port, path, {
          method: 'POST',
          headers: { ...STRANGER, 'content-type': 'application/octet-stream' },
          body: Buffer.from([10, LIST.length, ...Buffer.from(LIST)]),
        });
        expect([status, body.includes('unauthenticated')]).toEqual([200, true]);
      }
      for (const path of ['/topicdata', '/', '/anything/', '/services/json']) {
        expect(await upgrade(port, '?clientID=x', STRANGER, path)).toBe('403');
      }
    }
  });

  it('tells strangers that it is there, and no more [AC-5]', async () => {
    const { port } = await startEdgeMaster();
    expect(JSON.parse(String((await send(port, '/health', { headers: STRANGER })).body))).toEqual({
      status: 'ok',
    });
    expect(JSON.parse(String((await send(port, '/health')).body))).toHaveProperty('version');
    for (const path of ['/metrics', '/metrics/']) {
      for (const method of ['GET', 'HEAD']) {
        expect((await send(port, path, { method, headers: STRANGER })).status).toBe(401);
      }
      expect((await send(port, path)).status).toBe(200);
    }
    const { token } = await createGrant(port);
    const { reply } = await register(port, token);
    const authorization = `Bearer ${reply.client!.extension['credential']}`;
    expect((await send(port, '/metrics', { headers: { ...STRANGER, authorization } })).status).toBe(
      403,
    );
  });
});

describe('joining over HTTP', () => {
  it('lets in with a token, and goes on with the credential, in any spelling of the header [AC-13]', async () => {
    const { port } = await startEdgeMaster();
    const { token } = await createGrant(port, AccessRole.ACCESS_ROLE_VIEWER);
    const { reply } = await register(port, token);
    const { credential, resumeToken, role } = reply.client!.extension;
    expect(role).toBe('ACCESS_ROLE_VIEWER');
    for (const authorization of [
      `Bearer ${credential}`,
      `bearer ${credential}`,
      `BEARER  ${credential} `,
    ]) {
      expect(await roleOf(port, { ...STRANGER, authorization })).toBe('viewer');
    }
    for (const authorization of [
      `Basic ${credential}`,
      `Bearer x${credential}`,
      'Bearer',
      `Bearer ${'a'.repeat(5_000)}`,
      `Bearer ${token}`,
    ]) {
      expect(await roleOf(port, { ...STRANGER, authorization })).toBe('unauthenticated');
    }
    const { id } = reply.client!;
    const query = `?token=${resumeToken}&clientID=${id}`;
    expect(await upgrade(port, query, STRANGER)).toBe('open');
    expect(await upgrade(port, `?clientID=${id}`, STRANGER)).toBe('403');
    expect(await upgrade(port, `?token=x${resumeToken}&clientID=${id}`, STRANGER)).toBe('403');
    // A page of another origin has no use of what it does not know either.
    expect(await upgrade(port, query, { ...STRANGER, origin: 'https://evil.example' })).toBe('403');
  });

  it('refuses headers that are longer than any [AC-13]', async () => {
    const { port } = await startEdgeMaster();
    const authorization = `Bearer ${'a'.repeat(20_000)}`;
    const { status } = await call(port, LIST, { ...STRANGER, authorization });
    expect(status).toBe(431);
  });

  it('answers the preflight of pages that send a credential [SV-8]', async () => {
    const { port } = await startEdgeMaster();
    const { headers } = await send(port, '/services/json', {
      method: 'OPTIONS',
      headers: { origin: 'http://localhost:3000', 'access-control-request-method': 'POST' },
    });
    expect(headers['access-control-allow-headers']).toContain('Authorization');
  });

  it('limits guesses [AC-17]', async () => {
    const { port } = await startEdgeMaster();
    const { code, token } = await createGrant(port);
    for (let i = 0; i < 10; i++) await register(port, `0000000${i}`);
    expect((await register(port, code)).reply.error?.join?.problem).toBe('JOIN_PROBLEM_GUESSING');
    expect((await register(port, token)).reply.client).toBeDefined();
  });

  it('keeps grants for its owner only, without secrets, over a restart [AC-11] [AC-19]', async () => {
    const dataDir = newFolder();
    const before = await startEdgeMaster({ dataDir });
    const { token, code, grant } = await createGrant(before.port, AccessRole.ACCESS_ROLE_PLAYER, {
      maxJoins: 1,
    });
    const { reply } = await register(before.port, token);
    await before.close();
    const folder = join(dataDir, 'grants');
    expect(statSync(folder).mode & 0o077).toBe(0);
    for (const name of readdirSync(folder)) {
      expect(statSync(join(folder, name)).mode & 0o077).toBe(0);
      const kept = readFileSync(join(folder, name), 'utf8');
      for (const secret of [token, code, code.replace('-', '')]) expect(kept).not.toContain(secret);
    }
    expect(before.logged.join('\n')).not.toContain(token);
    const { port } = await startEdgeMaster({ dataDir });
    const { id, extension } = reply.client!;
    expect((await register(port, token)).reply.error?.join?.problem).toBe('JOIN_PROBLEM_USED');
    const { credential = '', resumeToken = '' } = extension;
    expect(await upgrade(port, `?token=${resumeToken}&clientID=${id}`, STRANGER)).toBe('4004');
    const back = await register(port, credential, { id, extension: { resumeToken } });
    expect(back.reply.client).toMatchObject({ id, extension: { role: 'ACCESS_ROLE_PLAYER' } });
    const socket = upgrade(port, `?token=${resumeToken}&clientID=${id}`, STRANGER);
    expect(await socket).toBe('open');
    await call(
      port,
      '/services/ubii/access_grant_revoke',
      {},
      {
        accessGrantRevokeRequest: { grantId: grant.id },
      },
    );
    expect(await upgrade(port, `?token=${resumeToken}&clientID=${id}`, STRANGER)).toBe('4011');
    expect((await register(port, credential)).reply.error?.join?.problem).toBe(
      'JOIN_PROBLEM_REVOKED',
    );
  });
});
