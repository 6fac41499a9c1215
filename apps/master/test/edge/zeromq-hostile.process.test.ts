import { randomBytes } from 'node:crypto';
import { decode, encode } from '@ubii/proto';
import { describe, expect, it, vi } from 'vitest';

import { OPENING, REST_OF_GREETING } from '../../src/adapters/zeromq/greeting.ts';
import {
  DELIMITER,
  MORE,
  encodeCommand,
  encodeFrame,
} from '../../src/adapters/zeromq/zmtp-frames.ts';
import { send, startEdgeMaster, type EdgeMaster } from './edge-master.ts';
import { RawPeer, ZeroMqCaller, ZeroMqClient, zeromqPorts } from './zeromq-peers.ts';

vi.setConfig({ testTimeout: 120_000 });

const IDENTITIES = 200;
const LONG_HEADER = (size: bigint, flags = 2): Buffer => {
  const header = Buffer.alloc(9, flags);
  header.writeBigUInt64BE(size, 1);
  return header;
};

function readyAs(identity: Uint8Array): Buffer {
  const property = (name: string, value: Uint8Array): Buffer =>
    Buffer.concat([
      Buffer.from([name.length]),
      Buffer.from(name),
      Buffer.from([0, 0, 0, value.length]),
      value,
    ]);
  return encodeCommand(
    'READY',
    Buffer.concat([property('Socket-Type', Buffer.from('DEALER')), property('Identity', identity)]),
  );
}

async function connections(master: EdgeMaster): Promise<number> {
  const { body } = await send(master.port, '/metrics', { headers: { connection: 'close' } });
  return Number(/^ubii_connections (\d+)$/m.exec(body.toString())?.[1]);
}

describe('peers of ZeroMQ that mean harm', () => {
  it('end nothing but their own connections, whatever bytes they send', async () => {
    const master = await startEdgeMaster({ flags: ['--zeromq-ports', '0,0'] });
    const { services, topicData } = zeromqPorts(master);
    const greeted = [OPENING, REST_OF_GREETING, readyAs(Buffer.from('x'))];
    const inputs: Uint8Array[] = [
      Buffer.from('POST /services/json HTTP/1.1\r\nhost: localhost\r\n\r\n{}'),
      randomBytes(1_000),
      Buffer.concat([OPENING, randomBytes(1_000)]),
      Buffer.concat([OPENING, REST_OF_GREETING, randomBytes(1_000)]),
      Buffer.concat([...greeted, randomBytes(1_000)]),
      Buffer.concat([...greeted, Buffer.from([0xff])]),
      Buffer.concat([...greeted, encodeCommand('PING', Buffer.alloc(0)), Buffer.from([4, 0])]),
      // An envelope without an end, and one with a frame that is too long.
      Buffer.concat([...greeted, ...Array<Buffer>(20).fill(encodeFrame(Buffer.from('a'), MORE))]),
      Buffer.concat([...greeted, LONG_HEADER(2n ** 40n, 3), randomBytes(100)]),
      Buffer.concat([OPENING, REST_OF_GREETING, LONG_HEADER(2n ** 63n, 6)]),
    ];
    const peers = inputs.flatMap((input) =>
      [services, topicData].map((port) => {
        const peer = new RawPeer(port);
        peer.write(input);
        return peer;
      }),
    );
    // Those of which the master waits for more end by themselves.
    await Promise.all(
      peers.map(async (peer) => {
        peer.socket.end();
        await peer.ended;
      }),
    );
    const caller = new ZeroMqCaller(master);
    expect((await caller.call({ topic: '/services/topic_list' })).stringList).toBeDefined();
    expect(master.logged.filter((line) => line.includes('"level":"error"'))).toEqual([]);
  });

  it('cannot send a message over the limit, and are told of by its header [TD-18]', async () => {
    const master = await startEdgeMaster({
      flags: ['--zeromq-ports', '0,0', '--limits', 'frameBytes=10000'],
    });
    const caller = new ZeroMqCaller(master);
    const id = await caller.register();
    const peer = new RawPeer(zeromqPorts(master).topicData);
    peer.write(OPENING, REST_OF_GREETING, readyAs(Buffer.from(id)), LONG_HEADER(10_001n));
    await peer.ended;
    const { error } = await caller.call({ topic: '/services/topic_list' });
    expect(error).toBeUndefined();
  });

  it.each([
    ['a message whose frames do not end', Buffer.concat(Array<Buffer>(8).fill(DELIMITER))],
    ['a command over 255 bytes', LONG_HEADER(256n, 6)],
  ])('lose their connection for %s, at once [TD-51] [TD-53]', async (_name, bytes) => {
    const master = await startEdgeMaster({ flags: ['--zeromq-ports', '0,0'] });
    const caller = new ZeroMqCaller(master);
    const peer = new RawPeer(zeromqPorts(master).topicData);
    peer.write(OPENING, REST_OF_GREETING, readyAs(Buffer.from(await caller.register())), bytes);
    // Nothing more comes from this side: only the master can end it.
    await peer.ended;
    expect((await caller.call({ topic: '/services/topic_list' })).stringList).toBeDefined();
  });

  it('give back what they took: hundreds of identities leave nothing behind [AC-68]', async () => {
    const master = await startEdgeMaster({ flags: ['--zeromq-ports', '0,0'] });
    const { topicData } = zeromqPorts(master);
    for (let i = 0; i < IDENTITIES; i += 100) {
      const peers = Array.from({ length: 100 }, (_, j) => {
        const peer = new RawPeer(topicData);
        peer.write(OPENING, REST_OF_GREETING, readyAs(Buffer.from(`identity ${i + j}`)));
        return peer;
      });
      await Promise.all(
        peers.map(async (peer) => {
          await peer.take(OPENING.length + REST_OF_GREETING.length);
          // Refused: the identity is unknown.
          const { flags, body } = await peer.takeFrame();
          expect([flags, body.toString('latin1', 1, 6)]).toEqual([4, 'ERROR']);
          peer.socket.destroy();
        }),
      );
    }
    await expect.poll(() => connections(master), { timeout: 60_000 }).toBe(1);
  });

  it('cannot have the identity of a client that joined with a token [EX-4]', async () => {
    const master = await startEdgeMaster({ flags: ['--zeromq-ports', '0,0'] });
    const reply = await new ZeroMqCaller(master).send(
      encode('ubii.services.ServiceRequest', {
        topic: '/services/client/registration',
        client: { name: 'ours', extension: {} },
      }),
    );
    const { client } = decode('ubii.services.ServiceReply', reply);
    const thief = new ZeroMqClient(master, client!.id);
    await thief.ended;
    expect(thief.connections).toBe(1);
  });

  it('do not make others wait when they take no replies', async () => {
    const master = await startEdgeMaster({ flags: ['--zeromq-ports', '0,0'] });
    const peer = await RawPeer.greeted(zeromqPorts(master).services, 'DEALER');
    peer.socket.pause();
    const request = encodeFrame(
      encode('ubii.services.ServiceRequest', { topic: '/services/server_configuration' }),
    );
    for (let i = 0; i < 10_000; i++) peer.write(DELIMITER, request);
    const caller = new ZeroMqCaller(master);
    expect((await caller.call({ topic: '/services/topic_list' })).stringList).toBeDefined();
  });
});
