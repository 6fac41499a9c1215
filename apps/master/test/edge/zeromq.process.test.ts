import { decode, encode, encodeRecord } from '@ubii/proto';
import { encodeRecordListFrame, recordFrameHeader } from '@ubii/proto/wire';
import { describe, expect, it, vi } from 'vitest';

import { DELIMITER, encodeFrame } from '../../src/adapters/zeromq/zmtp-frames.ts';
import { send, startEdgeMaster } from './edge-master.ts';
import type { EdgeMaster } from './edge-master.ts';
import { RawPeer, ZeroMqCaller, ZeroMqClient, zeromqPorts } from './zeromq-peers.ts';

// A whole master each: minutes on a busy machine are no fault of it.
vi.setConfig({ testTimeout: 60_000 });

const CONFIGURATION = { topic: '/services/server_configuration' };

function start(...flags: string[]): Promise<EdgeMaster> {
  return startEdgeMaster({ flags: ['--zeromq-ports', '0,0', ...flags] });
}

function frameOf(topic: string, value: string): Uint8Array {
  const bytes = encodeRecord({ topic, format: 'string', value });
  return Buffer.concat([recordFrameHeader(bytes.length), bytes]);
}

async function stateOf(caller: ZeroMqCaller, id: string): Promise<number | undefined> {
  const { clientList } = await caller.call({
    topic: '/services/client/get_list',
    clientList: { elements: [{ id }] },
  });
  return clientList?.elements[0]?.state;
}

describe('the ports of ZeroMQ', () => {
  it('are announced as decimal numbers, also where there are none [EC-13] [SV-62]', async () => {
    const without = await startEdgeMaster();
    const { body } = await send(without.port, '/services/json', {
      method: 'POST',
      body: JSON.stringify(CONFIGURATION),
    });
    expect(JSON.parse(body.toString())).toMatchObject({
      server: { portServiceZmq: '0', portTopicDataZmq: '0' },
    });
    const master = await start();
    const { services, topicData } = zeromqPorts(master);
    expect((await new ZeroMqCaller(master).call(CONFIGURATION)).server).toMatchObject({
      portServiceZmq: String(services),
      portTopicDataZmq: String(topicData),
      portServiceRest: String(master.port),
    });
  });

  it('end the start with a sentence when another program uses them', async () => {
    const { port } = await startEdgeMaster();
    await expect(start('--zeromq-ports', `${port},0`)).rejects.toThrow(
      `Port ${port} (--zeromq-ports) is used by another program`,
    );
  });
});

describe('services over ZeroMQ', () => {
  it('answer protobuf with protobuf and JSON with JSON [SV-60]', async () => {
    const caller = new ZeroMqCaller(await start());
    expect((await caller.call({ topic: '/services/topic_list' })).stringList).toBeDefined();
    const reply = await caller.send(JSON.stringify({ topic: '/services/topic_list' }));
    expect(JSON.parse(reply.toString())).toHaveProperty('stringList.elements');
  });

  it('answer every request, whatever it is [EC-24] [SV-2]', async () => {
    const caller = new ZeroMqCaller(await start());
    const codeOf = async (request: Uint8Array | string): Promise<string | undefined> =>
      decode('ubii.services.ServiceReply', await caller.send(request)).error?.code;
    expect(await codeOf('')).toBe('invalid_argument');
    expect(await codeOf(Buffer.alloc(100, 0xff))).toBe('invalid_argument');
    expect(await codeOf(encode('ubii.services.ServiceRequest', { topic: '/nobody' }))).toBe(
      'unimplemented',
    );
    const json = await caller.send('{"topic": ');
    expect(JSON.parse(json.toString())).toHaveProperty('error.code', 'invalid_argument');
  });

  it('answer others while one sends its request slowly [SV-61]', async () => {
    const master = await start();
    const slow = await RawPeer.greeted(zeromqPorts(master).services, 'REQ');
    const request = encode('ubii.services.ServiceRequest', CONFIGURATION);
    slow.write(DELIMITER, encodeFrame(request).subarray(0, 10));
    const caller = new ZeroMqCaller(master);
    expect((await caller.call(CONFIGURATION)).server).toBeDefined();
    slow.write(encodeFrame(request).subarray(10));
    expect((await slow.takeFrame()).body).toHaveLength(0);
    const { body } = await slow.takeFrame();
    expect(decode('ubii.services.ServiceReply', body).server).toBeDefined();
  });

  it('give every frame of the envelope back, in front of the reply [SV-61]', async () => {
    const peer = await RawPeer.greeted(zeromqPorts(await start()).services, 'DEALER');
    const request = encodeFrame(encode('ubii.services.ServiceRequest', CONFIGURATION));
    // Two at once: they are answered one after another.
    for (const id of ['a', 'b']) peer.write(encodeFrame(Buffer.from(id), 1), DELIMITER, request);
    for (const id of ['a', 'b']) {
      expect(await peer.takeFrame()).toEqual({ flags: 1, body: Buffer.from(id) });
      expect(await peer.takeFrame()).toEqual({ flags: 1, body: Buffer.alloc(0) });
      const { body } = await peer.takeFrame();
      expect(decode('ubii.services.ServiceReply', body).server).toBeDefined();
    }
  });

  it('refuse bodies that are too large by their size, and end the connection [SV-40] [SV-45]', async () => {
    const peer = await RawPeer.greeted(zeromqPorts(await start()).services, 'REQ');
    const head = Buffer.from([1, 0, 2, 0, 0, 0, 0, 0x7f, 0xff, 0xff, 0xff]);
    peer.write(head, 'the first bytes of two gigabytes');
    await peer.takeFrame();
    const { error } = decode('ubii.services.ServiceReply', (await peer.takeFrame()).body);
    expect(error?.code).toBe('resource_exhausted');
    await peer.ended;
  });

  it('refuse strangers, and tell them why [AC-5] [AC-12]', async () => {
    const caller = new ZeroMqCaller(await start('--trust-loopback', 'off', '--loopback', 'none'));
    const { error } = await caller.call({
      topic: '/services/client/registration',
      client: { name: 'stranger' },
    });
    expect(error?.code).toBe('unauthenticated');
    expect((await caller.call(CONFIGURATION)).server).toMatchObject({ ipWlan: '' });
  });
});

describe('topic data over ZeroMQ', () => {
  it('is published and delivered as existing clients do it [EC-1] [EC-15] [TD-50]', async () => {
    const master = await start();
    const caller = new ZeroMqCaller(master);
    const id = await caller.register();
    const client = new ZeroMqClient(master, id);
    await caller.subscribe(id, '/a', '/b');
    const records = ['/a', '/b'].map((topic) =>
      encodeRecord({ topic, format: 'string', value: `of ${topic}` }),
    );
    // With an empty frame in front and without one.
    await client.dealer.send(['', frameOf('/a', 'first')]);
    expect((await client.nextTopicData()).records).toMatchObject([{ topic: '/a', value: 'first' }]);
    await client.dealer.send(encodeRecordListFrame(records));
    for (const topic of ['/a', '/b']) {
      const { records: received } = await client.nextTopicData();
      expect(received).toMatchObject([{ topic, value: `of ${topic}` }]);
    }
  });

  it('says that a client is away when its DEALER is gone [CL-13]', async () => {
    const master = await start();
    const caller = new ZeroMqCaller(master);
    const id = await caller.register();
    const client = new ZeroMqClient(master, id);
    await client.dealer.send(frameOf('/here', 'yes'));
    await caller.subscribe(id, '/here');
    await client.next();
    expect(await stateOf(caller, id)).toBe(0);
    client.dealer.close();
    await expect.poll(() => stateOf(caller, id), { timeout: 30_000 }).not.toBe(0);
  });

  it('ends for a client that deregisters, and its library does not come back [TD-52]', async () => {
    const master = await start();
    const caller = new ZeroMqCaller(master);
    const id = await caller.register();
    const client = new ZeroMqClient(master, id);
    await caller.subscribe(id, '/here');
    await client.dealer.send(frameOf('/here', 'yes'));
    await client.next();
    await caller.call({ topic: '/services/client/deregistration', client: { id } });
    await client.ended;
    await expect.poll(() => client.connections, { timeout: 30_000 }).toBe(2);
    // The second time, it was refused as unknown.
    const stranger = new ZeroMqClient(master, 'nobody');
    await stranger.ended;
    expect(stranger.connections).toBe(1);
    expect(client.connections).toBe(2);
  });

  it('goes to the connection that came last, and the one before does not come back [TD-7]', async () => {
    const master = await start();
    const caller = new ZeroMqCaller(master);
    const id = await caller.register();
    const first = new ZeroMqClient(master, id);
    await caller.subscribe(id, '/a');
    await first.dealer.send(frameOf('/a', 'from the first'));
    await first.next();
    const second = new ZeroMqClient(master, id);
    await second.dealer.send(frameOf('/a', 'from the second'));
    await expect
      .poll(async () => (await second.nextTopicData()).records[0])
      .toMatchObject({ value: 'from the second' });
    expect(first.connections).toBe(1);
  });

  it('is refused to strangers before it begins [AC-27]', async () => {
    const master = await start('--trust-loopback', 'off', '--loopback', 'none');
    const client = new ZeroMqClient(master, 'any');
    await client.ended;
    expect(client.connections).toBe(1);
  });
});
