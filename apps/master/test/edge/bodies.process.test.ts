import { once } from 'node:events';
import { connect, type Socket } from 'node:net';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { temporaryFolder } from '@ubii/program/testing';
import { decode, encode } from '@ubii/proto';
import { build } from 'esbuild';
import { afterAll, beforeAll, describe, expect, it, onTestFinished, vi } from 'vitest';

import { send, startEdgeMaster } from './edge-master.ts';
import type { EdgeMaster } from './edge-master.ts';

vi.setConfig({ testTimeout: 60_000 });

const MIB = 1024 * 1024;
/** Headers of a proxy: the master sees a caller that has not joined. */
const STRANGER = { 'x-forwarded-for': '203.0.113.7' };

const workerFolder = temporaryFolder(afterAll);
let decodeWorkerFile: URL;

beforeAll(async () => {
  const file = join(workerFolder, 'decode-worker.mjs');
  await build({
    entryPoints: [
      fileURLToPath(
        new URL('../../src/adapters/services/bodies/decode-worker.ts', import.meta.url),
      ),
    ],
    outfile: file,
    bundle: true,
    platform: 'node',
    format: 'esm',
    logLevel: 'warning',
  });
  decodeWorkerFile = pathToFileURL(file);
}, 60_000);

/** A connection on which a request is begun and not ended. */
async function begin(
  master: EdgeMaster,
  contentLength: number,
  headers: Readonly<Record<string, string>> = {},
  start = '',
): Promise<Socket & { readonly answer: () => string }> {
  const socket = connect(master.port, '127.0.0.1');
  let text = '';
  socket.on('data', (chunk: Buffer) => (text += chunk.toString()));
  socket.on('error', () => undefined);
  onTestFinished(() => void socket.destroy());
  await once(socket, 'connect');
  const lines = Object.entries({
    host: `localhost:${master.port}`,
    'content-type': 'application/json',
    'content-length': String(contentLength),
    ...headers,
  }).map(([name, value]) => `${name}: ${value}`);
  socket.write(`POST /services/json HTTP/1.1\r\n${lines.join('\r\n')}\r\n\r\n${start}`);
  return Object.assign(socket, { answer: () => text });
}

async function metric(master: EdgeMaster, start: string): Promise<number> {
  const text = (await send(master.port, '/metrics')).body.toString();
  const line = text.split('\n').find((each) => each.startsWith(start));
  return Number(line?.split(' ').at(-1));
}

async function post(master: EdgeMaster, body: string | Uint8Array, headers = {}) {
  const response = await send(master.port, '/services/json', {
    method: 'POST',
    headers: { 'content-type': 'application/json', ...headers },
    body,
  });
  return {
    ...response,
    reply: JSON.parse(response.body.toString()) as { error?: { code: string; message: string } },
  };
}

describe('a caller that has not joined', () => {
  it('[SV-40] is refused by the declared length, before it sent a byte of the body', async () => {
    const master = await startEdgeMaster();
    const socket = await begin(master, 31 * MIB, STRANGER);
    await expect.poll(() => socket.answer()).toContain('"code":"unauthenticated"');
    expect(socket.answer()).toContain('strangerBodyBytes');
    expect(socket.answer()).toMatch(/^HTTP\/1\.1 200 /);
    await once(socket, 'close');
  });

  it('[SV-40] is refused once a body without a declared length is too long', async () => {
    const master = await startEdgeMaster();
    const response = await post(master, '', {
      ...STRANGER,
      'transfer-encoding': 'chunked',
    });
    expect(response.status).toBe(200);
    const socket = connect(master.port, '127.0.0.1');
    onTestFinished(() => void socket.destroy());
    socket.on('error', () => undefined);
    let text = '';
    socket.on('data', (chunk: Buffer) => (text += chunk.toString()));
    socket.write(
      `POST /services HTTP/1.1\r\nhost: localhost:${master.port}\r\nx-real-ip: 203.0.113.7\r\ntransfer-encoding: chunked\r\n\r\n`,
    );
    for (let i = 0; i < 20; i++) socket.write(`1000\r\n${'x'.repeat(4096)}\r\n`);
    await expect.poll(() => text).toContain('strangerBodyBytes');
    await once(socket, 'close');
  });

  it('[SV-41] has its request for other services refused without a look at the payload', async () => {
    const master = await startEdgeMaster();
    const { reply } = await post(master, '{"topic":"/services/topic_list","u":[[[', STRANGER);
    expect(reply.error?.code).toBe('unauthenticated');
  });

  it('[SV-46] sends sixty bodies of 30 MiB, which take nothing', async () => {
    const master = await startEdgeMaster();
    const sockets = await Promise.all(
      Array.from({ length: 60 }, () => begin(master, 30 * MIB, STRANGER, '{"topic":"')),
    );
    for (const socket of sockets) {
      await expect.poll(() => socket.answer()).toContain('strangerBodyBytes');
    }
    expect(await metric(master, 'ubii_request_bytes_in_flight')).toBe(0);
  });
});

describe('a caller that has joined', () => {
  const pad = (bytes: number) => 'x'.repeat(bytes);

  it('[SV-42] is refused what is too large for the service, as soon as that is known', async () => {
    const master = await startEdgeMaster();
    const large = `{"topic":"/services/topic_list","u":"${pad(300 * 1024)}"}`;
    const { status, reply } = await post(master, large);
    expect(status).toBe(200);
    expect(reply.error).toMatchObject({ code: 'resource_exhausted' });
    expect(reply.error?.message).toContain('serviceBodyBytes');
    const begun = await begin(master, 9 * MIB, {}, '{"topic":"/services/topic_list",');
    await expect.poll(() => begun.answer()).toContain('serviceBodyBytes');
    await once(begun, 'close');
    // Before the topic is known, the largest service counts.
    const declared = await begin(master, 13 * MIB);
    await expect.poll(() => declared.answer()).toContain('sessionBytes');
    expect(await metric(master, 'ubii_limit_hits_total{limit="serviceBodyBytes"}')).toBe(2);
    expect(await metric(master, 'ubii_request_bytes_in_flight')).toBe(0);
  });

  it('[SV-42] is refused more values and levels than the service takes, and told where', async () => {
    const master = await startEdgeMaster();
    const values = await post(master, `{"topic":"/services/topic_list","u":[${'1,'.repeat(9_000)}`);
    expect(values.reply.error?.message).toMatch(/at most 8192 values .*at byte \d+/);
    const deep = await post(master, `{"u":${'['.repeat(100)}`);
    expect(deep.reply.error).toMatchObject({ code: 'resource_exhausted' });
    expect(deep.reply.error?.message).toMatch(/requestDepth\), which is exceeded at byte 68\./);
    const request = {
      topic: '/services/topic_list',
      session: { processingModules: Array(9_000).fill({}) },
    };
    const response = await send(master.port, '/services/binary', {
      method: 'POST',
      body: encode('ubii.services.ServiceRequest', request),
    });
    expect(response.body.toString()).toContain('serviceValues');
  });

  it('[SV-44] has large requests decoded by a thread, in either format, with the same result', async () => {
    const master = await startEdgeMaster({ decodeWorkerFile });
    const editorJson = `"${'ä'.repeat(200_000)}"`;
    const session = {
      name: 's',
      extension: { editorJson },
      processingModules: Array.from({ length: 200 }, (_, i) => ({
        name: `m${i}`,
        onProcessingStringified: '() => ({})',
      })),
    };
    const request = { topic: '/services/session/database/save', session };
    const saved = await post(master, JSON.stringify(request));
    expect(saved.reply.error).toBeUndefined();
    const binary = await send(master.port, '/services/binary', {
      method: 'POST',
      body: encode('ubii.services.ServiceRequest', {
        ...request,
        session: { ...session, name: 'binary' },
      }),
    });
    expect(binary.status).toBe(200);
    const { body } = await send(master.port, '/services/json', {
      method: 'POST',
      body: '{"topic":"/services/session/database/get_list"}',
    });
    const { sessionList } = JSON.parse(body.toString()) as {
      sessionList: { elements: { description: string; processingModules: { name: string }[] }[] };
    };
    expect(sessionList.elements).toHaveLength(2);
    for (const each of sessionList.elements) {
      expect(each.processingModules.map((module) => module.name)).toEqual(
        session.processingModules.map((module) => module.name),
      );
    }
    const broken = await post(master, JSON.stringify(request).slice(0, -1));
    expect(broken.reply.error).toMatchObject({ code: 'invalid_argument' });
    const wrong = JSON.stringify({ ...request, session: { ...session, tags: 5 } });
    expect((await post(master, wrong)).reply.error?.message).toContain(
      'session.tags must be a list',
    );
  });

  it('[EC-20] sends 10 MB with a session, in either format', async () => {
    const master = await startEdgeMaster({ decodeWorkerFile });
    const size = 10_000_000;
    const request = { topic: '/services/session/database/save', session: { name: 'large' } };
    const json = { ...request, session: { ...request.session, helper: pad(size) } };
    expect((await post(master, JSON.stringify(json))).reply.error).toBeUndefined();
    // The same as a field of a later schema: number 2000, with its length.
    const field = Uint8Array.of(0x82, 0x7d, 0x80, 0xad, 0xe2, 0x04);
    const known = encode('ubii.services.ServiceRequest', request);
    const { status, body } = await send(master.port, '/services/binary', {
      method: 'POST',
      body: Buffer.concat([known, field, Buffer.alloc(size)]),
    });
    expect(status).toBe(200);
    expect(decode('ubii.services.ServiceReply', body).error).toBeUndefined();
  });

  it('[SV-44] is told when the thread cannot be had', async () => {
    const master = await startEdgeMaster({ decodeWorkerFile: new URL('file:///not/there.mjs') });
    const large = JSON.stringify({
      topic: '/services/session/database/save',
      session: { name: 'x'.repeat(100_000) },
    });
    for (let i = 0; i < 2; i++) {
      expect((await post(master, large)).reply.error).toMatchObject({ code: 'unavailable' });
    }
    expect((await post(master, '{"topic":"/services/topic_list"}')).reply.error).toBeUndefined();
  });

  it('[SV-46] has a limit on what is in flight, told with Retry-After, and gets it back', async () => {
    const master = await startEdgeMaster({ flags: ['--limits', 'bodyBytes=2000000'] });
    const start = '{"topic":"/services/session/database/save","session":{"name":"';
    const first = await begin(master, 1_400_000, {}, start);
    await expect.poll(() => metric(master, 'ubii_request_bytes_in_flight')).toBe(1_400_000);
    const refused = await begin(master, 1_400_000, {}, start);
    await expect.poll(() => refused.answer()).toContain('bodyBytes');
    expect(refused.answer().toLowerCase()).toContain('retry-after: 1');
    first.destroy();
    await expect.poll(() => metric(master, 'ubii_request_bytes_in_flight')).toBe(0);
    const next = await begin(master, 1_400_000, {}, start);
    await expect.poll(() => metric(master, 'ubii_request_bytes_in_flight')).toBe(1_400_000);
    expect(next.answer()).toBe('');
  });

  it('[SV-47] is cut off when a body comes too slowly', async () => {
    const master = await startEdgeMaster({ flags: ['--limits', 'bodyGraceMs=100'] });
    const slow = await begin(master, 1000, {}, '{"topic":');
    await expect.poll(() => slow.answer(), { timeout: 20_000 }).toContain('deadline_exceeded');
    expect(slow.answer()).toContain('bodyBytesPerSecond');
    await once(slow, 'close');
    expect(await metric(master, 'ubii_request_bytes_in_flight')).toBe(0);
  });

  it('[SV-45] hears the answer while it still sends', async () => {
    const master = await startEdgeMaster();
    const { reply } = await post(master, `{"topic":"/services/topic_list","u":"${pad(MIB)}`);
    expect(reply.error).toMatchObject({ code: 'resource_exhausted' });
  });
});

describe('a body with something unusual in it [SV-48]', () => {
  const codeOf = async (body: string | Uint8Array, headers = {}) => {
    const master = await startEdgeMaster();
    return (await post(master, body, headers)).reply.error?.code;
  };
  const configuration = (more: string) => `{"topic":"/services/server_configuration"${more}}`;

  it.each([
    [
      'the same key twice: the last one counts',
      configuration(',"topic":"/services/nonsense"'),
      'unimplemented',
    ],
    ['the key __proto__', configuration(',"__proto__":{"topic":"/services/nonsense"}'), undefined],
    [
      'only the key __proto__',
      '{"__proto__":{"topic":"/services/topic_list"}}',
      'invalid_argument',
    ],
    ['an escaped key', '{"\\u0074opic":"/services/server_configuration"}', undefined],
    ['a number of any size', configuration(`,"u":1e999,"v":${'9'.repeat(5_000)}`), undefined],
    [
      'a number too large for its member',
      '{"topic":"/services/client/registration","client":{"latency":"x"}}',
      'invalid_argument',
    ],
    ['half a surrogate', configuration(',"u":"\\ud800"'), undefined],
    ['a byte order mark', `\ufeff${configuration('')}`, 'invalid_argument'],
    ['a topic that is no text', '{"topic":["/services/server_configuration"]}', 'invalid_argument'],
  ])('%s', async (_what, body, code) => {
    expect(await codeOf(body)).toBe(code);
  });

  it('bytes that are no UTF-8 are read as U+FFFD', async () => {
    const bytes = Buffer.concat([
      Buffer.from(configuration(',"u":"').slice(0, -1)),
      Buffer.of(0xff),
      Buffer.from('"}'),
    ]);
    expect(await codeOf(bytes)).toBeUndefined();
  });

  it('a compressed body is refused', async () => {
    for (const encoding of ['gzip', 'br', 'deflate, identity']) {
      expect(await codeOf('{}', { 'content-encoding': encoding })).toBe('invalid_argument');
    }
    expect(await codeOf(configuration(''), { 'content-encoding': 'identity' })).toBeUndefined();
  });
});
