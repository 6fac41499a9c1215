import { once } from 'node:events';
import { connect } from 'node:net';
import { decode, encode } from '@ubii/proto';
import { describe, expect, it, vi } from 'vitest';

import { DEFAULT_LIMITS } from '../../src/index.ts';
import { send, startEdgeMaster } from './edge-master.ts';
import type { EdgeMaster } from './edge-master.ts';

// A whole master each: minutes on a busy machine are no fault of it.
vi.setConfig({ testTimeout: 60_000 });

const JSON_TYPE = { 'content-type': 'application/json' };
const BINARY_TYPE = { 'content-type': 'application/octet-stream' };
const CONFIGURATION = { topic: '/services/server_configuration' };
const configurationBytes = encode('ubii.services.ServiceRequest', CONFIGURATION);

async function postJson(master: EdgeMaster, path: string, body: string, headers = {}) {
  const response = await send(master.port, path, { method: 'POST', headers, body });
  return { ...response, reply: JSON.parse(response.body.toString()) as Record<string, never> };
}

describe('services over HTTP', () => {
  it.each(['/services/json', '/services/json/', '/services'])(
    '[EC-6] [SV-1] take JSON at %s',
    async (path) => {
      const master = await startEdgeMaster();
      const { status, headers, reply } = await postJson(
        master,
        path,
        JSON.stringify(CONFIGURATION),
        JSON_TYPE,
      );
      expect(status).toBe(200);
      expect(headers['content-type']).toBe('application/json; charset=utf-8');
      expect(reply).toMatchObject({
        server: { ipEthernet: '', ipWlan: '', portServiceRest: String(master.port) },
      });
    },
  );

  it.each(['/services/binary', '/services'])('[EC-6] [SV-1] take protobuf at %s', async (path) => {
    const master = await startEdgeMaster();
    const { status, headers, body } = await send(master.port, path, {
      method: 'POST',
      headers: BINARY_TYPE,
      body: configurationBytes,
    });
    expect(status).toBe(200);
    expect(headers['content-type']).toBe('application/octet-stream');
    expect(decode('ubii.services.ServiceReply', body).server?.portTopicDataWs).toBe(
      String(master.port),
    );
  });

  it('[SV-49] do nothing for a sender that is gone already', async () => {
    const master = await startEdgeMaster();
    const postOf = (name: string): string => {
      const body = JSON.stringify({ topic: '/services/client/registration', client: { name } });
      return `POST /services/json HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/json\r\nContent-Length: ${body.length}\r\n\r\n${body}`;
    };
    const gone = connect(master.port, '127.0.0.1');
    await once(gone, 'connect');
    // Both are in the system before the master, in the same thread, reads either.
    gone.write(postOf('gone'));
    gone.destroy();
    const waiting = connect(master.port, '127.0.0.1');
    waiting.end(postOf('half closed'));
    await once(waiting, 'close');
    await postJson(
      master,
      '/services',
      JSON.stringify({ topic: '/services/client/registration', client: { name: 'here' } }),
      JSON_TYPE,
    );
    const list = JSON.stringify({ topic: '/services/client/get_list', clientList: {} });
    const { reply } = await postJson(master, '/services', list, JSON_TYPE);
    expect(reply).toMatchObject({ clientList: { elements: [{ name: 'here' }] } });
  });

  it('[EX-70] cut or refuse texts that are too long, in either format', async () => {
    const master = await startEdgeMaster();
    const long = 'x'.repeat(200_000);
    const registration = { topic: '/services/client/registration', client: { name: long } };
    const { reply } = await postJson(master, '/services/json', JSON.stringify(registration));
    expect(reply).toMatchObject({ client: { name: 'x'.repeat(100) } });
    const { status, body } = await send(master.port, '/services/binary', {
      method: 'POST',
      headers: BINARY_TYPE,
      body: encode('ubii.services.ServiceRequest', {
        topic: '/services/session/runtime/add',
        session: { name: long },
      }),
    });
    expect(status).toBe(200);
    expect(decode('ubii.services.ServiceReply', body).error).toMatchObject({
      code: 'resource_exhausted',
      message: expect.stringContaining('session.name has 200000 characters'),
    });
  });

  it('[SV-1] go by the path, whatever the content is called', async () => {
    const master = await startEdgeMaster();
    const json = JSON.stringify(CONFIGURATION);
    for (const headers of [{}, { 'content-type': 'text/plain' }, BINARY_TYPE]) {
      expect((await postJson(master, '/services/json', json, headers)).reply).toHaveProperty(
        'server',
      );
    }
    expect((await postJson(master, '/services', json)).reply).toHaveProperty('server');
  });

  it.each([
    ['/services/json', JSON_TYPE, '{"topic":'],
    ['/services/json', JSON_TYPE, ''],
    ['/services/json', JSON_TYPE, '[1]'],
    ['/services/json', JSON_TYPE, '{"topic":{}}'],
    ['/services/json', { 'content-type': ';;' }, '{}'],
    ['/services', {}, 'topic'],
  ])('[SV-7] answer what cannot be read: POST %s %j %j', async (path, headers, body) => {
    const { status, reply } = await postJson(await startEdgeMaster(), path, body, headers);
    expect(status).toBe(200);
    expect(reply).toMatchObject({ error: { code: 'invalid_argument', stack: '' } });
  });

  it('[EC-6] [SV-7] answer bytes that cannot be read', async () => {
    const master = await startEdgeMaster();
    for (const body of [Uint8Array.of(0xff, 0xff), Uint8Array.of(0x0a, 0x7f), new Uint8Array()]) {
      const response = await send(master.port, '/services/binary', {
        method: 'POST',
        headers: BINARY_TYPE,
        body,
      });
      expect(response.status).toBe(200);
      expect(decode('ubii.services.ServiceReply', response.body).error?.code).toBe(
        'invalid_argument',
      );
    }
  });

  it('[SV-6] answer a request without topic and one for an unknown service', async () => {
    const master = await startEdgeMaster();
    expect((await postJson(master, '/services', '{}')).reply).toMatchObject({
      error: { code: 'invalid_argument' },
    });
    const { reply } = await postJson(master, '/services', '{"topic":"/services/nonsense"}');
    expect(reply).toMatchObject({ error: { code: 'unimplemented' } });
    expect(JSON.stringify(reply)).toContain('/services/nonsense');
  });

  it('[SV-2] answer a body that is too large, and count it', async () => {
    const master = await startEdgeMaster();
    const { status, reply } = await postJson(
      master,
      '/services/json',
      'x'.repeat(DEFAULT_LIMITS.frameBytes + 1),
      JSON_TYPE,
    );
    expect(status).toBe(200);
    expect(reply).toMatchObject({ error: { code: 'resource_exhausted' } });
    const metrics = (await send(master.port, '/metrics')).body.toString();
    expect(metrics).toContain('ubii_refused_total{code="resource_exhausted"} 1');
  });

  it('go on after a sender that broke off in the middle, without a fault in the log', async () => {
    const master = await startEdgeMaster();
    for (const start of [
      'POST /services/json HTTP/1.1\r\nhost: x\r\ncontent-length: 9\r\n\r\n{"to',
      'no HTTP at all\r\n\r\n',
    ]) {
      const socket = connect(master.port, '127.0.0.1');
      await new Promise((resolve) => socket.write(start, resolve));
      // When the master answers another caller, it has read the data.
      await postJson(master, '/services', '{}');
      socket.destroy();
      await new Promise((resolve) => socket.once('close', resolve));
    }
    await expect
      .poll(async () => (await send(master.port, '/metrics')).body.toString())
      .toContain('ubii_refused_total{code="invalid_argument"} 3');
    expect(master.logged.filter((line) => line.includes('"level":"error"'))).toEqual([]);
  });

  it('[EC-4] [SV-4] write defaults, enum names and empty lists', async () => {
    const { reply } = await postJson(
      await startEdgeMaster(),
      '/services/json',
      '{"topic":"/services/client/registration","client":{"name":"x","processing_modules":[null],"unknown":1}}',
    );
    expect(reply).toMatchObject({ client: { state: 'ACTIVE', latency: 0, devices: [], tags: [] } });
  });
});

describe('[SV-8] pages of other origins', () => {
  const fromPage = (origin: string) => ({ ...JSON_TYPE, origin });
  const registration = '{"topic":"/services/client/registration","client":{"name":"x"}}';

  it('are answered when they are allowed', async () => {
    const master = await startEdgeMaster();
    const { headers, reply } = await postJson(
      master,
      '/services',
      registration,
      fromPage('http://localhost:3000'),
    );
    expect(reply).toHaveProperty('client');
    expect(headers['access-control-allow-origin']).toBe('http://localhost:3000');
    expect(headers.vary).toContain('Origin');
  });

  it('are refused otherwise, and nothing is executed', async () => {
    const master = await startEdgeMaster();
    for (const headers of [
      fromPage('https://evil.example'),
      fromPage('null'),
      { ...fromPage('http://evil.example'), host: 'evil.example' },
      { ...JSON_TYPE, host: `evil.example:${master.port}` },
    ]) {
      const response = await postJson(master, '/services/json', registration, headers);
      expect(response.status).toBe(403);
      expect(response.headers).not.toHaveProperty('access-control-allow-origin');
      expect(response.reply).toMatchObject({ error: { code: 'permission_denied' } });
    }
    const clients = await postJson(master, '/services', '{"topic":"/services/client/get_list"}');
    expect(clients.reply).toMatchObject({ clientList: { elements: [] } });
  });

  it('get an answer to their preflight', async () => {
    const { port } = await startEdgeMaster({ flags: ['--allowed-origins', 'https://a.example'] });
    const preflight = (origin: string) =>
      send(port, '/services/json', {
        method: 'OPTIONS',
        headers: {
          origin,
          'access-control-request-method': 'POST',
          'access-control-request-headers': 'content-type',
          'access-control-request-private-network': 'true',
        },
      });
    const { status, headers } = await preflight('https://a.example');
    expect(status).toBe(204);
    expect(headers).toMatchObject({
      'access-control-allow-origin': 'https://a.example',
      'access-control-allow-private-network': 'true',
    });
    expect(headers['access-control-allow-methods']).toContain('POST');
    expect(headers['access-control-allow-headers']).toContain('Content-Type');
    expect((await preflight('https://b.example')).status).toBe(403);
  });

  it('may be of private addresses once the master listens on the LAN', async () => {
    const onLan = await startEdgeMaster({ flags: ['--host', '0.0.0.0'] });
    const headers = fromPage('http://192.168.1.2:8080');
    expect((await postJson(onLan, '/services', registration, headers)).status).toBe(200);
    const alone = await startEdgeMaster();
    expect((await postJson(alone, '/services', registration, headers)).status).toBe(403);
  });
});

describe('other paths', () => {
  it('/health says that the master runs', async () => {
    const { body } = await send((await startEdgeMaster()).port, '/health');
    expect(JSON.parse(body.toString())).toMatchObject({ status: 'ok', version: '1.2.3' });
  });

  it('/metrics has labels of closed lists only', async () => {
    const { port } = await startEdgeMaster();
    for (const path of ['/nothing-here-1', '/nothing-here-2']) await send(port, path);
    const { body, headers } = await send(port, '/metrics');
    expect(headers['content-type']).toContain('text/plain');
    expect(body.toString()).toContain('# TYPE ubii_records_received_total counter');
    expect(body.toString()).toMatch(/ubii_http_responses_total\{route="[^"]*",status="4xx"\} 2/);
    expect(body.toString()).not.toContain('nothing-here');
  });

  it.each([
    ['GET', '/services/json', 404, 'called by POST'],
    ['PUT', '/services/json', 404, 'called by POST'],
    ['GET', '/topicdata', 404, 'is a WebSocket'],
    ['GET', '/missing.js', 404, 'No page or service exists at /missing.js'],
    ['POST', '/', 404, 'No page or service exists at /'],
  ])('%s %s: %i', async (method, path, status, text) => {
    const response = await send((await startEdgeMaster()).port, path, { method });
    expect(response.status).toBe(status);
    expect(response.body.toString()).toContain(text);
  });

  it('the legacy ports answer like the main port', async () => {
    const { ports, port } = await startEdgeMaster({ flags: ['--legacy-ports', '0,0'] });
    expect(new Set([port, ports.services, ports.topicData]).size).toBe(3);
    for (const each of [ports.services, ports.topicData]) {
      const { body } = await send(each, '/services', {
        method: 'POST',
        body: JSON.stringify(CONFIGURATION),
      });
      // [SV-10]
      expect(JSON.parse(body.toString())).toMatchObject({
        server: {
          portServiceRest: String(ports.services),
          portTopicDataWs: String(ports.topicData),
        },
      });
    }
  });
});
