import { existsSync, statSync, readdirSync, readFileSync } from 'node:fs';
import { execFile } from 'node:child_process';
import { connect } from 'node:net';
import { hostname } from 'node:os';
import { join } from 'node:path';
import { AccessRole } from '@ubii/proto';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it, vi } from 'vitest';
import { WebSocket } from 'ws';

import { send, startEdgeMaster } from './edge-master.ts';

// A whole master each: minutes on a busy machine are no fault of it.
vi.setConfig({ testTimeout: 60_000 });

type Headers = Readonly<Record<string, string>>;

/** A caller behind a tunnel or proxy on this machine: the only kind of stranger that a test can be. [AC-1] */
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
  return {
    status,
    headers: response.headers,
    reply: (status === 200 ? JSON.parse(String(body)) : {}) as Reply,
  };
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

/** Hostnames of this machine, including the mDNS name. */
function ownNames(): string[] {
  const name = hostname().toLowerCase();
  return [name, `${name.split('.')[0]}.local`];
}

/** Result of an upgrade: `open`, a close code, or the status of the refusal. */
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

/** Callers of this machine as a master takes them that was told nothing. */
const DEFAULT = ['--trust-loopback', 'off'];

const GUESSING = 'JOIN_PROBLEM_GUESSING';

describe('local callers [AC-1] [AC-2]', () => {
  it.each([
    ['admin', ['--trust-loopback']],
    ['participant', DEFAULT],
    ['unauthenticated', [...DEFAULT, '--loopback', 'none']],
  ])('goes by headers of proxies, the host and the origin: %s [AC-40]', async (local, flags) => {
    const { port } = await startEdgeMaster({
      flags: ['--allowed-origins', 'https://lab.example,*', ...flags],
    });
    const named = local === 'admin' ? 'participant' : local;
    const host = `localhost:${port}`;
    const cases: [Headers, string][] = [
      [{}, local],
      [{ host, origin: `http://${host}` }, local],
      [{ host, origin: 'http://localhost:3000' }, local],
      [{ host, origin: 'http://127.0.0.1:3000' }, local],
      [{ host, 'sec-fetch-site': 'same-origin' }, local],
      [{ host, 'sec-fetch-site': 'none' }, local],
      // A page that the operator named calls, and is no admin for its name.
      [{ host, origin: 'https://lab.example' }, named],
      // Names of this machine are names: a page that is re-bound to one has it as well. [AC-45]
      ...ownNames().flatMap((name): [Headers, string][] => [
        [{ host: name }, 'unauthenticated'],
        [{ host: name, origin: `http://${name}` }, 'unauthenticated'],
      ]),
      [{ host, 'sec-fetch-site': 'cross-site' }, 'unauthenticated'],
      [{ host, 'sec-fetch-site': 'same-site' }, 'unauthenticated'],
      // Pages of others, which `*` lets call.
      [{ host, origin: 'http://192.168.1.50' }, 'unauthenticated'],
      [{ host, origin: 'https://evil.example' }, 'unauthenticated'],
      [{ host, origin: 'null' }, 'unauthenticated'],
      [{ host, origin: 'http://localhost.evil.example' }, 'unauthenticated'],
      // Names that an attacker in the network can bind to this machine: DNS rebinding.
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
        // An unknown header.
        'X-New-Proxy-Forwarded-By',
      ].map((name): [Headers, string] => [{ [name]: '127.0.0.1' }, 'unauthenticated']),
    ];
    for (const [headers, role] of cases)
      expect([headers, await roleOf(port, headers)]).toEqual([headers, role]);
  });

  it('refuses pages of unknown names and origins [SV-8]', async () => {
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

/** Runs as another user: no test without the right to become one. */
describe.skipIf(process.platform !== 'linux' || process.getuid?.() !== 0)(
  'another user of this machine, as a proxy is that says nothing [AC-1]',
  () => {
    const OTHER_USER = 65_534;
    const LISTING = JSON.stringify({ topic: LIST });
    const REQUEST = `
      const [port, body, bearer] = process.argv.slice(1);
      const headers = { 'content-type': 'application/json' };
      if (bearer) headers.authorization = 'Bearer ' + bearer;
      fetch('http://127.0.0.1:' + port + '/services/json', { method: 'POST', headers, body })
        .then((reply) => reply.text()).then((text) => process.stdout.write(text));`;
    const UPGRADE = `
      const [port, path] = process.argv.slice(1);
      const key = Buffer.alloc(16).toString('base64');
      const headers = { connection: 'Upgrade', upgrade: 'websocket', 'sec-websocket-version': '13', 'sec-websocket-key': key };
      const end = ({ statusCode }) => { process.stdout.write(String(statusCode)); process.exit(); };
      require('http').get({ host: '127.0.0.1', port, path, headers }).on('upgrade', end).on('response', end);`;
    const runAs = (uid: number, program: string, words: string[]): Promise<string> =>
      new Promise((resolve, reject) => {
        const options = { uid, cwd: '/', env: { PATH: process.env['PATH'] } };
        execFile(process.execPath, ['-e', program, ...words], options, (error, stdout) => {
          if (error === null) resolve(stdout);
          else reject(error);
        });
      });
    const ask = async (uid: number, ...words: string[]) =>
      JSON.parse(await runAs(uid, REQUEST, words)) as Reply;
    const upgradeAs = (uid: number, port: number, query: string) =>
      runAs(uid, UPGRADE, [String(port), `/topicdata${query}`]);

    it.each([['--trust-loopback'], DEFAULT])('is a stranger: %s', async (...flags) => {
      const { port } = await startEdgeMaster({ flags });
      expect((await ask(OTHER_USER, String(port), LISTING)).error?.code).toBe('unauthenticated');
      expect(await ask(0, String(port), LISTING)).toHaveProperty('clientList');
    });

    it('opens a socket with the resume token of its client, and no other [AC-27]', async () => {
      const { port } = await startEdgeMaster({ flags: DEFAULT });
      const registration = { client: { name: 'page', extension: {} } };
      const { reply } = await call(port, '/services/client/registration', {}, registration);
      const { id, extension } = reply.client!;
      const query = `?clientID=${id}`;
      expect(await upgradeAs(OTHER_USER, port, query)).toBe('403');
      expect(await upgradeAs(OTHER_USER, port, `${query}&token=nonsense`)).toBe('403');
      const proven = `${query}&token=${extension['resumeToken']}`;
      expect(await upgradeAs(OTHER_USER, port, proven)).toBe('101');
    });

    it('cannot use what is good on this machine for its operator [AC-43]', async () => {
      const { port, terminal } = await startEdgeMaster({ flags: DEFAULT });
      const check = { topic: '/services/ubii/join_check', joinCheckRequest: { token: '' } };
      const words = [String(port), JSON.stringify(check), terminal.admin.token];
      const problem = async (uid: number) =>
        ((await ask(uid, ...words)).joinCheck as { problem?: string } | undefined)?.problem;
      expect(await problem(OTHER_USER)).toBe('JOIN_PROBLEM_WRONG');
      expect(await problem(0)).toBe('JOIN_PROBLEM_NONE');
    });
  },
);

describe('the operator [AC-42]', () => {
  const authorized = (bearer: string): Headers => ({ authorization: `Bearer ${bearer}` });
  const registerHere = async (port: number, bearer: string) => {
    const { reply } = await call(port, '/services/client/registration', authorized(bearer), {
      client: { name: 'desk', extension: {} },
    });
    return reply;
  };

  it('is admin by the token, the code and the file, and stays it over restarts [AC-44]', async () => {
    const dataDir = temporaryFolder();
    const file = join(dataDir, 'admin-token');
    const before = await startEdgeMaster({ dataDir, flags: DEFAULT });
    const { token, code } = before.terminal.admin;
    expect(before.terminal.join).toBeUndefined();
    expect(readFileSync(file, 'utf8')).toBe(`${token}\n`);
    expect(statSync(file).mode & 0o777).toBe(0o600);
    expect(before.logged.join('\n')).not.toContain(token);
    const credentials: string[] = [];
    for (const secret of [token, code.toLowerCase()]) {
      const { client } = await registerHere(before.port, secret);
      expect(client?.extension['role']).toBe('ACCESS_ROLE_ADMIN');
      credentials.push(client!.extension['credential']!);
    }
    await before.close();
    expect(existsSync(file)).toBe(false);

    const after = await startEdgeMaster({ dataDir, flags: DEFAULT });
    for (const credential of credentials) {
      expect(await roleOf(after.port, authorized(credential))).toBe('admin');
    }
    // The terminal shows others now, and the one before is scrolled away.
    expect(readFileSync(file, 'utf8')).toBe(`${after.terminal.admin.token}\n`);
    for (const secret of [token, code]) {
      const { error } = await registerHere(after.port, secret);
      expect(error?.join?.problem).toBe('JOIN_PROBLEM_WRONG');
    }
    expect((await registerHere(after.port, after.terminal.admin.code)).client).toBeDefined();
  });

  it('is not a caller that forwards requests, with or without token [AC-43]', async () => {
    const { port, terminal } = await startEdgeMaster({ flags: DEFAULT });
    const { client } = await registerHere(port, terminal.admin.token);
    const credential = client!.extension['credential']!;
    expect(await roleOf(port, authorized(credential))).toBe('admin');
    expect(await roleOf(port, { ...STRANGER, ...authorized(credential) })).toBe('unauthenticated');
    for (const secret of [terminal.admin.token, terminal.admin.code]) {
      expect((await register(port, secret)).reply.error?.join?.problem).toBe('JOIN_PROBLEM_WRONG');
    }
  });

  it('is replaced by the next start when it was taken back', async () => {
    const dataDir = temporaryFolder();
    const before = await startEdgeMaster({ dataDir });
    const { client } = await registerHere(before.port, before.terminal.admin.token);
    const { reply } = await call(before.port, '/services/ubii/access_grant_list');
    const [grant] = (reply['accessGrantList'] as { elements: { id: string }[] }).elements;
    await call(
      before.port,
      '/services/ubii/access_grant_revoke',
      {},
      {
        accessGrantRevokeRequest: { grantId: grant!.id },
      },
    );
    await before.close();
    const after = await startEdgeMaster({ dataDir });
    const credential = client!.extension['credential']!;
    expect(await roleOf(after.port, authorized(credential))).toBe('unauthenticated');
    expect((await registerHere(after.port, after.terminal.admin.token)).client).toBeDefined();
  });

  it('is asked for a socket of an admin, by its resume token [AC-27]', async () => {
    const { port, terminal } = await startEdgeMaster({ flags: DEFAULT });
    const { client } = await registerHere(port, terminal.admin.token);
    const query = `?clientID=${client!.id}`;
    expect(await upgrade(port, query)).toBe('403');
    expect(await upgrade(port, `${query}&token=${client!.extension['resumeToken']}`)).toBe('open');
    const { reply } = await call(
      port,
      '/services/client/registration',
      {},
      { client: { name: 'old' } },
    );
    expect(await upgrade(port, `?clientID=${reply.client!.id}`)).toBe('open');
  });
});

describe('pages without a name [AC-46]', () => {
  const file = { origin: 'null' };

  it('call with a token of their own, and with nothing else', async () => {
    for (const flags of [DEFAULT, ['--trust-loopback']]) {
      const { port } = await startEdgeMaster({ flags });
      expect(await roleOf(port, file)).toBe('403');
      expect(await roleOf(port, { ...file, authorization: 'Bearer ABCD-EFGH' })).toBe('403');
      const nonsense = { ...file, authorization: `Bearer ${'x'.repeat(64)}` };
      expect(await roleOf(port, nonsense)).toBe('403');
    }
    const { port } = await startEdgeMaster();
    const { token } = await createGrant(port, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const shown = { ...file, authorization: `Bearer ${token}` };
    const { reply } = await call(port, '/services/client/registration', shown, {
      client: { name: 'page', extension: {} },
    });
    const { credential, resumeToken } = reply.client!.extension;
    expect(await roleOf(port, { ...file, authorization: `Bearer ${credential}` })).toBe(
      'participant',
    );
    const query = `?clientID=${reply.client!.id}`;
    expect(await upgrade(port, query, file)).toBe('403');
    expect(await upgrade(port, `${query}&token=nonsense`, file)).toBe('403');
    expect(await upgrade(port, `${query}&token=${resumeToken}`, file)).toBe('open');
  });

  it('are told by the preflight of their browser that they may send one', async () => {
    const { port } = await startEdgeMaster();
    const ask = (headers: Headers) =>
      send(port, '/services/json', {
        method: 'OPTIONS',
        headers: { ...file, 'access-control-request-method': 'POST', ...headers },
      });
    const asked = { 'access-control-request-headers': 'authorization,content-type' };
    const { status, headers } = await ask(asked);
    expect([status, headers['access-control-allow-origin']]).toEqual([204, 'null']);
    expect((await ask({})).status).toBe(403);
  });
});

describe('joining over HTTP', () => {
  it('admits with a token, and continues with the credential, in any spelling of the header [AC-13]', async () => {
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

  it('slows guesses down, and lets right codes in beside them [AC-17]', async () => {
    const { port } = await startEdgeMaster({ flags: ['--limits', 'wrongCodesPerAddress=1'] });
    const { code, token } = await createGrant(port);
    let refused;
    for (let i = 0; i < 200 && refused?.reply.error?.join?.problem !== GUESSING; i++) {
      refused = await register(port, `0000000${i % 10}`);
    }
    expect(refused?.reply.error?.join?.problem).toBe(GUESSING);
    expect(refused?.headers['retry-after']).toBe('1');
    expect((await register(port, token)).reply.client).toBeDefined();
    await expect
      .poll(async () => (await register(port, code)).reply.client, { timeout: 30_000 })
      .toBeDefined();
  });

  it('keeps invitations for its owner only, without secrets, over a restart [AC-11] [AC-19]', async () => {
    const dataDir = temporaryFolder();
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
