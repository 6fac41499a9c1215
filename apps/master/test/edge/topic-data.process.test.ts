import { decodeTopicData, encodeRecord } from '@ubii/proto';
import { encodeRecordListFrame, recordFrameHeader } from '@ubii/proto/wire';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it, vi } from 'vitest';
import { WebSocket } from 'ws';

import { DEFAULT_LIMITS } from '../../src/index.ts';
import { send, startEdgeMaster } from './edge-master.ts';
import type { EdgeMaster } from './edge-master.ts';

// A whole master each: minutes on a busy machine are no fault of it.
vi.setConfig({ testTimeout: 60_000 });

/** A registered client's socket, with everything it receives in order. */
class Socket {
  readonly webSocket: WebSocket;
  readonly #received: (string | Buffer)[] = [];
  #wake: () => void = () => {};

  constructor(url: string, options: { readonly origin?: string } = {}) {
    this.webSocket = new WebSocket(url, options);
    this.webSocket.on('message', (data: Buffer, isBinary) => {
      this.#received.push(isBinary ? data : data.toString());
      this.#wake();
    });
    this.webSocket.on('error', () => {});
  }

  opened(): Promise<this> {
    return new Promise((resolve, reject) => {
      this.webSocket.once('open', () => resolve(this));
      this.webSocket.once('unexpected-response', (_request, { statusCode }) =>
        reject(new Error(`refused with ${statusCode}`)),
      );
      this.webSocket.once('error', reject);
    });
  }

  closed(): Promise<{ code: number; reason: string }> {
    return new Promise((resolve) => {
      this.webSocket.once('close', (code, reason) => resolve({ code, reason: reason.toString() }));
    });
  }

  /** The next message that `read` makes something of; the others are passed over. */
  async next<T>(read: (message: string | Buffer) => T | undefined): Promise<T> {
    for (;;) {
      for (let message = this.#received.shift(); message !== undefined;) {
        const result = read(message);
        if (result !== undefined) return result;
        message = this.#received.shift();
      }
      await new Promise<void>((resolve) => (this.#wake = resolve));
    }
  }

  nextTopicData() {
    return this.next((message) =>
      typeof message === 'string' ? undefined : decodeTopicData(message),
    );
  }

  nextText(): Promise<string> {
    return this.next((message) => (typeof message === 'string' ? message : undefined));
  }
}

interface Registered {
  readonly id: string;
  readonly extension?: { readonly resumeToken: string };
}

async function call(master: EdgeMaster, body: object) {
  const response = await send(master.port, '/services/json', {
    method: 'POST',
    body: JSON.stringify(body),
  });
  return JSON.parse(response.body.toString()) as {
    client: Registered;
    error?: { message: string };
  };
}

async function register(master: EdgeMaster, extension?: object): Promise<Registered> {
  const client = { name: 'tester', ...(extension && { extension }) };
  return (await call(master, { topic: '/services/client/registration', client })).client;
}

function subscribe(master: EdgeMaster, clientId: string, topics: readonly string[]) {
  return call(master, {
    topic: '/services/topic_subscription',
    topicSubscription: { clientId, subscribeTopics: topics },
  });
}

function socketUrl(master: EdgeMaster, { id, extension }: Registered, path = '/'): string {
  const query = extension ? `token=${extension.resumeToken}&clientID=${id}` : `clientID=${id}`;
  return `ws://127.0.0.1:${master.port}${path}?${query}`;
}

function record(topic: string, value: string): Uint8Array {
  return encodeRecord({ topic, format: 'string', value });
}

function frameOf(bytes: Uint8Array): Uint8Array {
  return Buffer.concat([recordFrameHeader(bytes.length), bytes]);
}

describe('topic data over WebSocket', () => {
  it.each(['/', '/topicdata', '/any/path/at/all'])('[EC-7] [TD-1] opens on %s', async (path) => {
    const master = await startEdgeMaster();
    const socket = await new Socket(socketUrl(master, await register(master), path)).opened();
    expect(socket.webSocket.protocol).toBe('');
    expect(socket.webSocket.extensions).toBe('');
  });

  it('[TD-1] opens on the legacy ports', async () => {
    const master = await startEdgeMaster({ flags: ['--legacy-ports', '0,0'] });
    const client = await register(master);
    await new Socket(`ws://127.0.0.1:${master.ports.topicData}?clientID=${client.id}`).opened();
  });

  it('[TD-2] [EX-6] answers a text PING with a text PONG', async () => {
    const master = await startEdgeMaster();
    const socket = await new Socket(socketUrl(master, await register(master))).opened();
    socket.webSocket.send('PING');
    expect(await socket.nextText()).toBe('PONG');
  });

  it('[EC-2] [TD-2] [TD-5] [CL-15] sends a text PING and takes PONG as text and as binary', async () => {
    const master = await startEdgeMaster();
    for (const pong of ['PONG', Buffer.from('PONG')]) {
      const client = await register(master);
      const socket = await new Socket(socketUrl(master, client)).opened();
      expect(await socket.nextText()).toBe('PING');
      socket.webSocket.send(pong);
      // An answer to the next frame shows that the previous one was accepted
      socket.webSocket.send('PING');
      expect(await socket.nextText()).toBe('PONG');
    }
    const metrics = (await send(master.port, '/metrics')).body.toString();
    expect(metrics).toContain('ubii_protocol_errors_total 0');
  });

  it('[EC-1] [EC-17] [TD-3] [TD-11] [TD-14] echoes records unchanged, one frame each', async () => {
    const master = await startEdgeMaster();
    const client = await register(master);
    const socket = await new Socket(socketUrl(master, client)).opened();
    await subscribe(master, client.id, ['/a', '/b']);
    const records = [record('/a', '1'), record('/b', 'ü'.repeat(100)), record('/a', '3')];
    socket.webSocket.send(encodeRecordListFrame(records));
    for (const bytes of records) {
      const frame = await socket.next((message) =>
        Buffer.isBuffer(message) ? message : undefined,
      );
      expect(frame.equals(frameOf(bytes))).toBe(true);
    }
  });

  it('[TD-4] [TD-30] sends extension clients what meets in one turn as one list', async () => {
    const master = await startEdgeMaster();
    const client = await register(master, { recordLists: true });
    const socket = await new Socket(socketUrl(master, client)).opened();
    await subscribe(master, client.id, ['/a', '/b']);
    const records = [record('/a', '1'), record('/b', '2')];
    socket.webSocket.send(encodeRecordListFrame(records));
    const frame = await socket.next((message) => (Buffer.isBuffer(message) ? message : undefined));
    expect(frame.equals(Buffer.from(encodeRecordListFrame(records)))).toBe(true);
  });

  it.each([10, 20_000, 200_000, 5_000_000])('carries records of %i bytes', async (size) => {
    const master = await startEdgeMaster();
    const client = await register(master);
    const socket = await new Socket(socketUrl(master, client)).opened();
    await subscribe(master, client.id, ['/large']);
    const bytes = record('/large', 'x'.repeat(size));
    socket.webSocket.send(frameOf(bytes));
    const frame = await socket.next((message) => (Buffer.isBuffer(message) ? message : undefined));
    expect(frame.equals(frameOf(bytes))).toBe(true);
  });

  it('[TD-24] sends the retained record after the reply, once the socket is open', async () => {
    const master = await startEdgeMaster();
    const publisher = await register(master);
    const from = await new Socket(socketUrl(master, publisher)).opened();
    await subscribe(master, publisher.id, ['/kept']);
    from.webSocket.send(frameOf(record('/kept', 'value')));
    await from.nextTopicData();

    const late = await register(master);
    await subscribe(master, late.id, ['/kept']);
    const socket = await new Socket(socketUrl(master, late)).opened();
    expect((await socket.nextTopicData()).records).toMatchObject([
      { topic: '/kept', value: 'value' },
    ]);
  });
});

describe('sockets that are not welcome', () => {
  it.each(['', '?clientID=', '?clientID=unknown', '?clientID=%ff%fe', '?x=1&clientID'])(
    '[TD-6] are closed when their client is unknown: "%s"',
    async (query) => {
      const master = await startEdgeMaster();
      const socket = new Socket(`ws://127.0.0.1:${master.port}/${query}`);
      expect(await socket.closed()).toEqual({ code: 4004, reason: 'unknown client' });
    },
  );

  it('[EC-7] [TD-7] are closed when a second socket of the client opens', async () => {
    const master = await startEdgeMaster();
    const client = await register(master);
    const first = await new Socket(socketUrl(master, client)).opened();
    const firstClosed = first.closed();
    const second = await new Socket(socketUrl(master, client)).opened();
    expect(await firstClosed).toEqual({ code: 4001, reason: 'superseded' });
    second.webSocket.send('PING');
    expect(await second.nextText()).toBe('PONG');
  });

  it('[EX-4] are closed without the token of an extension client', async () => {
    const master = await startEdgeMaster();
    const { id } = await register(master, {});
    const socket = new Socket(`ws://127.0.0.1:${master.port}/?token=x&clientID=${id}`);
    expect(await socket.closed()).toEqual({ code: 4003, reason: 'not this client' });
  });

  it('[SV-8] are refused when a page of another origin opens them', async () => {
    const master = await startEdgeMaster();
    const url = socketUrl(master, await register(master));
    await expect(new Socket(url, { origin: 'https://evil.example' }).opened()).rejects.toThrow(
      '403',
    );
    await new Socket(url, { origin: 'http://localhost:3000' }).opened();
  });

  it('[TD-17] hear what was wrong with a frame, and [TD-18] are closed after too many', async () => {
    const master = await startEdgeMaster();
    const socket = await new Socket(socketUrl(master, await register(master))).opened();
    const closed = socket.closed();
    socket.webSocket.send(Buffer.from('no protobuf at all'));
    expect((await socket.nextTopicData()).error).toMatchObject({ code: 'invalid_argument' });
    socket.webSocket.send('neither PING nor PONG');
    expect((await socket.nextTopicData()).error).toBeDefined();
    for (let sent = 0; sent <= DEFAULT_LIMITS.protocolErrors; sent += 1) {
      socket.webSocket.send(Buffer.of(0xff));
    }
    expect((await closed).code).toBe(4008);
  });

  it('are closed when a message is larger than allowed, and it is counted', async () => {
    const master = await startEdgeMaster();
    const socket = await new Socket(socketUrl(master, await register(master))).opened();
    const closed = socket.closed();
    socket.webSocket.send(Buffer.alloc(DEFAULT_LIMITS.frameBytes + 1));
    expect((await closed).code).toBe(1009);
    const metrics = (await send(master.port, '/metrics')).body.toString();
    expect(metrics).toContain('ubii_protocol_errors_total 1');
  });

  it('do not disturb others', async () => {
    const master = await startEdgeMaster();
    const client = await register(master);
    const socket = await new Socket(socketUrl(master, client)).opened();
    await subscribe(master, client.id, ['/a']);
    const rude = await new Socket(socketUrl(master, await register(master))).opened();
    const rudeClosed = rude.closed();
    // Text that is no UTF-8, a frame with a reserved bit, and half a frame.
    (rude.webSocket as unknown as { _socket: NodeJS.WritableStream })._socket.write(
      Buffer.of(0x81, 0x82, 0, 0, 0, 0, 0xff, 0xff),
    );
    expect((await rudeClosed).code).toBe(1007);
    socket.webSocket.send(frameOf(record('/a', 'still here')));
    expect((await socket.nextTopicData()).records).toMatchObject([{ value: 'still here' }]);
  });
});

describe('a subscriber that does not read', () => {
  it('[TD-31] [TD-32] gets the newest values once it reads, and its queue stays small', async () => {
    const master = await startEdgeMaster();
    const publisher = await register(master);
    const fast = await new Socket(socketUrl(master, publisher)).opened();
    const reader = await register(master);
    const slow = await new Socket(socketUrl(master, reader)).opened();
    await subscribe(master, reader.id, ['/state']);
    await subscribe(master, publisher.id, ['/done']);
    slow.webSocket.pause();

    const records = 400;
    const filler = 'x'.repeat(100_000);
    for (let index = 1; index <= records; index += 1) {
      fast.webSocket.send(frameOf(record('/state', `${index} ${filler}`)));
    }
    fast.webSocket.send(frameOf(record('/done', 'done')));
    await fast.nextTopicData();

    slow.webSocket.resume();
    const seen: number[] = [];
    while (seen.at(-1) !== records) {
      const { records: read } = await slow.nextTopicData();
      for (const { value } of read) seen.push(Number.parseInt(String(value), 10));
    }
    expect(seen).toEqual([...seen].sort((a, b) => a - b));
    expect(seen.length).toBeLessThan(records);
    const metrics = (await send(master.port, '/metrics')).body.toString();
    expect(metrics).toContain(`ubii_records_dropped_total ${records - seen.length}`);
  });
});

describe('a master that ends', () => {
  it('closes its sockets and frees its ports', async () => {
    const master = await startEdgeMaster();
    const socket = await new Socket(socketUrl(master, await register(master))).opened();
    const closed = socket.closed();
    await master.close();
    expect((await closed).code).toBe(1001);
    await expect(send(master.port, '/health')).rejects.toThrow();
  });

  it('does not wait for a client that never answers', async () => {
    const master = await startEdgeMaster();
    const socket = await new Socket(socketUrl(master, await register(master))).opened();
    socket.webSocket.pause();
    await master.close();
    socket.webSocket.terminate();
  });

  it('[CL-3] knows its clients again when it returns', async () => {
    const dataDir = temporaryFolder();
    const before = await startEdgeMaster({ dataDir });
    const { id, extension } = await register(before, {});
    await before.close();
    const after = await startEdgeMaster({ dataDir });
    const { client } = await call(after, {
      topic: '/services/client/registration',
      client: { id, name: 'tester', extension },
    });
    expect(client).toMatchObject({ id, extension: { resumed: true } });
  });
});
