import { createServer } from 'node:http';
import type { RequestListener, Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { buffer } from 'node:stream/consumers';
import { decode, encode, fromJson, toJson } from '@ubii/proto';
import { afterEach, describe, expect, it } from 'vitest';
import { describeServiceTransport } from '../testing/service-transport-suite.ts';
import type { AnswerRequest } from '../testing/service-transport-suite.ts';
import { createHttpServices } from './http.ts';

async function listen(handle: RequestListener): Promise<{ server: Server; origin: string }> {
  const server = createServer(handle);
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { server, origin: `http://127.0.0.1:${(server.address() as AddressInfo).port}` };
}

async function stop(server: Server): Promise<void> {
  server.closeAllConnections();
  await new Promise((resolve) => server.close(resolve));
}

/** A master's HTTP side, as small as it can be: `path` says how to read and write. */
function answering(answer: AnswerRequest): RequestListener {
  return (request, response) => {
    const isJson = request.headers['content-type'] === 'application/json';
    void (async () => {
      const body = await buffer(request);
      const reply = await answer(
        isJson
          ? fromJson('ubii.services.ServiceRequest', JSON.parse(body.toString()))
          : decode('ubii.services.ServiceRequest', body),
      );
      response.end(
        isJson
          ? JSON.stringify(toJson('ubii.services.ServiceReply', reply))
          : encode('ubii.services.ServiceReply', reply),
      );
    })().catch(() => response.writeHead(500).end());
  };
}

describe.each(['binary', 'json'])('over %s', (encoding) => {
  describeServiceTransport(`HTTP ${encoding}`, async (answer) => {
    const { server, origin } = await listen(answering(answer));
    return {
      transport: createHttpServices({ url: `${origin}/services/${encoding}` }),
      close: () => stop(server),
    };
  });
});

describe('createHttpServices()', () => {
  let server: Server | undefined;
  afterEach(async () => {
    if (server !== undefined) await stop(server);
    server = undefined;
  });

  async function contentTypeAt(path: string): Promise<string | undefined> {
    let contentType: string | undefined;
    const world = await listen((request, response) => {
      contentType = request.headers['content-type'];
      response.end();
    });
    server = world.server;
    await createHttpServices({ url: world.origin + path })
      .send({ topic: '/t' })
      .reply.catch(() => undefined);
    return contentType;
  }

  it.each([
    ['/services/json', 'application/json'],
    ['/services', 'application/json'],
    ['/services/?x=1', 'application/json'],
    ['/services/binary', 'application/octet-stream'],
    ['/ubii', 'application/octet-stream'],
  ])('at %s speaks %s', async (path, contentType) => {
    expect(await contentTypeAt(path)).toBe(contentType);
  });

  it.each([
    ['json', 'this is no JSON'],
    ['json', '[]'],
    ['binary', '\u{1F600}'],
  ])('rejects a %s reply that is none', async (encoding, body) => {
    const world = await listen((_, response) => response.end(body));
    server = world.server;
    const { reply } = createHttpServices({ url: `${world.origin}/services/${encoding}` }).send({
      topic: '/t',
    });
    await expect(reply).rejects.toMatchObject({ name: 'ConnectionError', reason: 'protocol' });
  });

  it.each([403, 404, 500])('rejects status %i', async (status) => {
    const world = await listen((_, response) => response.writeHead(status).end());
    server = world.server;
    const { reply } = createHttpServices({ url: world.origin }).send({ topic: '/t' });
    await expect(reply).rejects.toMatchObject({
      reason: 'refused',
      message: expect.stringContaining(String(status)) as string,
    });
  });
});
