import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { encodeRecord } from '@ubii/proto';
import { recordFrameHeader } from '@ubii/proto/wire';
import { afterAll, beforeAll, describe, expect, it, vi } from 'vitest';

import { MASTER, MASTER_V6, OLD_DEVICE, PHONE, PHONE_V6, TestNetwork } from './test-network.ts';

// Processes and networks, on a machine that may be busy.
vi.setConfig({ testTimeout: 60_000 });

const packageFolder = fileURLToPath(new URL('../..', import.meta.url));
const program = join(packageFolder, '.cache-lan', 'main.js');
const ask = fileURLToPath(new URL('ask.mjs', import.meta.url));
const zeromqClient = fileURLToPath(new URL('zeromq-client.mjs', import.meta.url));

const reason = TestNetwork.reasonAgainst();
if (reason !== undefined) console.warn(`The tests of the LAN are left out: ${reason}.`);

interface Answer {
  readonly status: number;
  readonly text: string;
}

interface Endpoints {
  readonly url: string;
  readonly joinToken: string;
  readonly joinCode: string;
  readonly adminToken: string;
  readonly adminCode: string;
}

describe.skipIf(reason !== undefined)('a master in a network of its own', () => {
  const network = new TestNetwork();
  let master: ReturnType<TestNetwork['startOnMaster']>;
  let endpoints: Endpoints;
  let port = '';

  beforeAll(async () => {
    execFileSync(process.execPath, ['build.mjs', '.cache-lan'], { cwd: packageFolder });
    network.open();
    const flags = [
      '--lan',
      'on',
      '--port',
      '0',
      '--legacy-ports',
      'off',
      '--zeromq-ports',
      '0,0',
      '--print-endpoints',
      'json',
    ];
    master = network.startOnMaster(
      [program, ...flags, '--data-dir', network.newFolder(), '--allow-legacy', `${OLD_DEVICE}/32`],
      { PATH: process.env['PATH'], HOME: network.newFolder() },
    );
    endpoints = await new Promise<Endpoints>((resolve, reject) => {
      let text = '';
      let problem = '';
      master.stderr?.on('data', (chunk) => (problem += String(chunk)));
      master.stdout?.on('data', (chunk) => {
        text += String(chunk);
        if (text.includes('\n')) resolve(JSON.parse(text) as Endpoints);
      });
      master.once('close', () => reject(new Error(problem)));
    });
    port = new URL(endpoints.url).port;
  }, 120_000);

  afterAll(() => {
    // `ip netns exec` becomes the program: this is the master itself.
    master?.kill('SIGKILL');
    network.close();
  });

  interface Call {
    readonly where?: 'master' | 'phone';
    readonly host?: string;
    readonly scheme?: string;
    readonly from?: string;
    readonly headers?: object;
    readonly path?: string;
  }

  const send = (more: object, call: Call): Promise<Answer> => {
    const { where = 'phone', host = MASTER, scheme = 'http', from, path = '/services/json' } = call;
    const url = `${scheme}://${host.includes(':') ? `[${host}]` : host}:${port}${path}`;
    return network.run(where, ask, {
      url,
      from,
      headers: call.headers,
      ...more,
    }) as Promise<Answer>;
  };

  async function call(topic: string, payload: object = {}, where: Call = {}) {
    const headers = { 'content-type': 'application/json', ...where.headers };
    const body = JSON.stringify({ topic, ...payload });
    const { status, text } = await send({ method: 'POST', body }, { ...where, headers });
    if (status !== 200) return { status, text };
    return JSON.parse(text) as Record<string, unknown>;
  }

  const list = (where: Call) => call('/services/client/get_list', {}, where);
  const register = (bearer: string, where: Call = {}) =>
    call(
      '/services/client/registration',
      { client: { name: 'phone', extension: {} } },
      { ...where, headers: { authorization: `Bearer ${bearer}` } },
    );

  it('takes a phone for a stranger, over IPv4 and IPv6, HTTP and HTTPS [AC-1] [AC-5]', async () => {
    for (const host of [MASTER, MASTER_V6]) {
      for (const scheme of ['http', 'https']) {
        expect(await list({ host, scheme })).toMatchObject({ error: { code: 'unauthenticated' } });
      }
    }
    expect(await list({ host: MASTER_V6, from: PHONE_V6 })).toHaveProperty('error');
    const { status, text } = await send({}, { path: '/health' });
    expect([status, text]).toEqual([200, '{"status":"ok"}']);
    expect((await send({}, { path: '/metrics' })).status).toBe(401);
    const configuration = await call('/services/server_configuration');
    expect(configuration).toMatchObject({ server: { ipEthernet: '', ipWlan: '' } });
    expect((await send({ upgrade: true }, { path: '/topicdata?clientID=x' })).status).toBe(403);
  });

  it('does not believe a phone that says it is here [AC-1]', async () => {
    const lies = [
      { host: 'localhost' },
      { host: '127.0.0.1', origin: 'http://127.0.0.1' },
      { forwarded: 'for=127.0.0.1' },
      { 'x-forwarded-for': '127.0.0.1' },
      { 'x-real-ip': '::1' },
      { origin: `http://${MASTER}:${port}` },
    ];
    for (const headers of lies) {
      expect(await list({ headers })).toMatchObject({ error: { code: 'unauthenticated' } });
    }
  });

  it('takes callers of its own machine for participants, by any of its addresses [AC-1] [AC-2]', async () => {
    for (const host of ['127.0.0.1', '::1', MASTER, MASTER_V6]) {
      expect(await list({ where: 'master', host })).toHaveProperty('clientList');
      const grants = await call('/services/ubii/access_grant_list', {}, { where: 'master', host });
      expect(grants).toMatchObject({ error: { code: 'permission_denied' } });
    }
    // A page of another device, open in the browser of the operator.
    const headers = { origin: `http://${PHONE}` };
    expect(await list({ where: 'master', headers })).toMatchObject({
      error: { code: 'unauthenticated' },
    });
    const upgrade = { where: 'master', path: '/topicdata?clientID=x', headers } as const;
    expect((await send({ upgrade: true }, upgrade)).status).toBe(403);
  });

  it('makes an admin of a local caller with the token or code [AC-42] [AC-43]', async () => {
    const grants = (where: Call) => call('/services/ubii/access_grant_list', {}, where);
    for (const secret of [endpoints.adminToken, endpoints.adminCode]) {
      expect(await register(secret)).toMatchObject({
        error: { join: { problem: 'JOIN_PROBLEM_WRONG' } },
      });
      const { client } = (await register(secret, { where: 'master', host: MASTER })) as unknown as {
        client: { extension: { credential: string; role: string } };
      };
      expect(client.extension.role).toBe('ACCESS_ROLE_ADMIN');
      const headers = { authorization: `Bearer ${client.extension.credential}` };
      expect(await grants({ where: 'master', headers })).toHaveProperty('accessGrantList');
      // Another user has read it, or a local proxy forwards it.
      expect(await grants({ headers })).toMatchObject({ error: { code: 'unauthenticated' } });
      const passedOn = { ...headers, 'x-forwarded-for': PHONE };
      expect(await grants({ where: 'master', headers: passedOn })).toMatchObject({
        error: { code: 'unauthenticated' },
      });
    }
  });

  it('lets existing devices in where the operator says so, and no others [AC-4]', async () => {
    expect(await list({ from: OLD_DEVICE })).toHaveProperty('clientList');
    expect(await list({ from: PHONE })).toHaveProperty('error');
    const through = { 'x-forwarded-for': OLD_DEVICE };
    expect(await list({ from: OLD_DEVICE, headers: through })).toHaveProperty('error');
    expect(await call('/services/ubii/access_grant_list', {}, { from: OLD_DEVICE })).toMatchObject({
      error: { code: 'permission_denied' },
    });
  });

  it('lets existing devices in over ZeroMQ as well, and no others [AC-4] [AC-68]', async () => {
    const { server } = (await call(
      '/services/server_configuration',
      {},
      { from: OLD_DEVICE },
    )) as unknown as { server: { portServiceZmq: string; portTopicDataZmq: string } };
    const record = encodeRecord({ topic: '/device', format: 'double', value: 1 });
    const frame = Buffer.concat([recordFrameHeader(record.length), record]).toString('base64');
    const join = (from: string, identity?: string): Promise<unknown> =>
      network.run('phone', zeromqClient, {
        host: MASTER,
        from,
        identity,
        topic: '/device',
        frame,
        services: server.portServiceZmq,
        topicData: server.portTopicDataZmq,
      });
    const admitted = (await join(OLD_DEVICE)) as { id: string };
    expect(admitted).toMatchObject({ frame });
    const refused = { error: 'unauthenticated', isRefused: true };
    expect(await join(PHONE)).toEqual(refused);
    // Nor with the identity of one that is admitted.
    expect(await join(PHONE, admitted.id)).toEqual(refused);
  });

  it('lets a phone in with the token and the code of the terminal [AC-11] [AC-19]', async () => {
    for (const secret of [endpoints.joinToken, endpoints.joinCode]) {
      const { client } = (await register(secret, { scheme: 'https' })) as unknown as {
        client: {
          id: string;
          extension: { credential: string; resumeToken: string; role: string };
        };
      };
      expect(client.extension.role).toBe('ACCESS_ROLE_PARTICIPANT');
      const headers = { authorization: `Bearer ${client.extension.credential}` };
      expect(await list({ headers })).toHaveProperty('clientList');
      const path = `/topicdata?token=${client.extension.resumeToken}&clientID=${client.id}`;
      expect((await send({ upgrade: true }, { path })).status).toBe(101);
    }
    expect(await register('nonsense')).toMatchObject({
      error: { join: { problem: 'JOIN_PROBLEM_WRONG' } },
    });
  });
});

describe.skipIf(reason !== undefined)('a master with --lan off in a network of its own', () => {
  const network = new TestNetwork();
  let master: ReturnType<TestNetwork['startOnMaster']>;
  let endpoints: Endpoints;

  beforeAll(async () => {
    execFileSync(process.execPath, ['build.mjs', '.cache-lan'], { cwd: packageFolder });
    network.open();
    const flags = ['--lan', 'off', '--port', '0', '--legacy-ports', 'off', '--mdns', 'off'];
    master = network.startOnMaster(
      [program, ...flags, '--print-endpoints', 'json', '--data-dir', network.newFolder()],
      { PATH: process.env['PATH'], HOME: network.newFolder() },
    );
    endpoints = await new Promise<Endpoints>((resolve, reject) => {
      let text = '';
      let problem = '';
      master.stderr?.on('data', (chunk) => (problem += String(chunk)));
      master.stdout?.on('data', (chunk) => {
        text += String(chunk);
        if (text.includes('\n')) resolve(JSON.parse(text) as Endpoints);
      });
      master.once('close', () => reject(new Error(problem)));
    });
  }, 120_000);

  afterAll(() => {
    master?.kill('SIGKILL');
    network.close();
  });

  const send = async (
    where: 'master' | 'phone',
    topic: string,
    payload: object,
    { host = MASTER, scheme = 'http', bearer = '' } = {},
  ): Promise<{ status: number; reply: Record<string, unknown> }> => {
    const { status, text } = (await network.run(where, ask, {
      url: `${scheme}://${host}:${new URL(endpoints.url).port}/services/json`,
      method: 'POST',
      headers: {
        'content-type': 'application/json',
        ...(bearer !== '' && { authorization: `Bearer ${bearer}` }),
      },
      body: JSON.stringify({ topic, ...payload }),
    })) as Answer;
    return {
      status,
      reply: status === 200 ? (JSON.parse(text) as Record<string, unknown>) : { text },
    };
  };
  const configuration = (where: 'master' | 'phone', scheme = 'http') =>
    send(where, '/services/server_configuration', {}, { scheme });

  it('is reached by phones after an admin of its machine turned the network on [AC-47]', async () => {
    expect((await configuration('phone')).status).toBe(0);
    const here = { host: '127.0.0.1' };
    // A caller without the token of the terminal is not an admin.
    const refused = await send('master', '/services/ubii/lan_open', {}, here);
    expect(refused.reply).toMatchObject({ error: { code: 'permission_denied' } });
    expect((await configuration('phone')).status).toBe(0);

    const registered = await send(
      'master',
      '/services/client/registration',
      { client: { name: 'desk', extension: {} } },
      { ...here, bearer: endpoints.adminToken },
    );
    const { client } = registered.reply as unknown as {
      client: { extension: { credential: string } };
    };
    const bearer = client.extension.credential;
    const opened = await send('master', '/services/ubii/lan_open', {}, { ...here, bearer });
    expect(opened.reply).toHaveProperty('success');

    // The same port, HTTP and HTTPS; all callers are strangers, as with --lan on.
    for (const scheme of ['http', 'https']) {
      expect((await configuration('phone', scheme)).reply).toHaveProperty('server');
    }
    expect((await send('phone', '/services/client/get_list', {})).reply).toMatchObject({
      error: { code: 'unauthenticated' },
    });
    // An admin's credential of the master's machine is worth nothing elsewhere. [AC-43]
    expect((await send('phone', '/services/client/get_list', {}, { bearer })).reply).toMatchObject({
      error: { code: 'unauthenticated' },
    });
    // Existing clients stay, and get the current addresses.
    const status = await send(
      'master',
      '/services/ubii/master_status',
      { masterStatusRequest: { sinceMs: 0 } },
      { ...here, bearer },
    );
    expect(JSON.stringify(status.reply)).toContain(`https://${MASTER}:`);

    const made = await send(
      'master',
      '/services/ubii/access_grant_create',
      { accessGrantCreateRequest: { role: 'ACCESS_ROLE_PARTICIPANT' } },
      { ...here, bearer },
    );
    const { accessGrantCreated } = made.reply as unknown as {
      accessGrantCreated: { token: string };
    };
    const joined = await send(
      'phone',
      '/services/client/registration',
      { client: { name: 'phone', extension: {} } },
      { scheme: 'https', bearer: accessGrantCreated.token },
    );
    expect(joined.reply).toMatchObject({
      client: { extension: { role: 'ACCESS_ROLE_PARTICIPANT' } },
    });
  });
});
