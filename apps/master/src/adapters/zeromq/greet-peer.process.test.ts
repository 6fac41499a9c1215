import { once } from 'node:events';
import { connect, createServer, type AddressInfo, type Socket } from 'node:net';
import { describe, expect, it, onTestFinished } from 'vitest';

import { ByteSource, SourceEnded } from './byte-source.ts';
import { greetPeer, type ZmtpPeer } from './greet-peer.ts';
import {
  OPENING,
  REST_OF_GREETING,
  encodeError,
  encodeReady,
  socketTypeByte,
  type SocketType,
} from './greeting.ts';
import { encodeCommand, encodeFrame } from './zmtp-frames.ts';

/** Greets a peer that sends these bytes and ends. */
async function greet(...sent: readonly Uint8Array[]): Promise<{ peer: ZmtpPeer; read: Buffer }> {
  const server = createServer();
  onTestFinished(() => void server.close());
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const client = connect((server.address() as AddressInfo).port, '127.0.0.1');
  const chunks: Buffer[] = [];
  client.on('data', (chunk: Buffer) => chunks.push(chunk));
  client.on('error', () => undefined);
  const [socket] = (await once(server, 'connection')) as [Socket];
  client.end(Buffer.concat(sent));
  const own = { own: 'ROUTER', accepted: ['DEALER'] } as const;
  const peer = await greetPeer(socket, new ByteSource(socket), own).finally(() => socket.end());
  await once(client, 'close');
  return { peer, read: Buffer.concat(chunks) };
}

/** The command READY with these properties. */
function ready(properties: Readonly<Record<string, Uint8Array>>): Buffer {
  const data = Object.entries(properties).flatMap(([name, value]) => [
    Buffer.from([name.length]),
    Buffer.from(name),
    Buffer.from([0, 0, 0, value.length]),
    value,
  ]);
  return encodeCommand('READY', Buffer.concat(data));
}

const V3 = [OPENING, REST_OF_GREETING];
const V2_OPENING = Buffer.concat([OPENING.subarray(0, 10), Uint8Array.of(1)]);
const DEALER = Buffer.from('DEALER');

describe('greeting a peer of ZeroMQ', () => {
  it('learns the identity in ZMTP 3, whatever the case and order of properties', async () => {
    const identity = Buffer.from('ada');
    const { peer, read } = await greet(
      ...V3,
      ready({ 'x-own': Buffer.from('any'), identity, 'SOCKET-TYPE': DEALER }),
    );
    expect(peer.identity).toEqual(identity);
    expect(read).toEqual(Buffer.concat(V3));
    expect(peer.acceptance).toEqual(encodeReady('ROUTER'));
    expect(peer.refusal('no')).toEqual(encodeError('no'));
  });

  it('learns the identity in ZMTP 2, as older libraries speak it', async () => {
    const { peer, read } = await greet(
      V2_OPENING,
      socketTypeByte('DEALER'),
      encodeFrame(Buffer.from('ada')),
    );
    expect(peer.identity.toString()).toBe('ada');
    expect(read).toEqual(OPENING);
    expect([...peer.acceptance]).toEqual([6, 0, 0]);
    expect(peer.refusal('no')).toHaveLength(0);
  });

  const wrongType = (type: SocketType): Buffer => ready({ 'Socket-Type': Buffer.from(type) });
  const cutOff = encodeCommand(
    'READY',
    Buffer.from([11, ...Buffer.from('Socket-Type'), 0, 0, 0, 9]),
  );
  it.each<[string, Buffer[], string]>([
    ['HTTP', [Buffer.from('GET / HTTP/1.1\r\n')], 'not of ZeroMQ'],
    ['TLS', [Buffer.from('\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03', 'latin1')], 'not of'],
    ['ZMTP 1', [Buffer.from([...OPENING.subarray(0, 10), 0])], 'before 2.0'],
    ['CURVE', [OPENING, Buffer.from('\x01CURVE'.padEnd(53, '\0'))], 'mechanism'],
    ['no READY', [...V3, encodeCommand('HELLO', DEALER)], 'begin with READY'],
    ['a message for READY', [...V3, encodeFrame(DEALER)], 'begin with READY'],
    ['long properties', [...V3, Buffer.from([6, 0, 0, 0, 0, 0, 1, 0, 0])], 'at most 1024 bytes'],
    ['properties that are cut off', [...V3, cutOff], 'cut off'],
    ['a socket of another type', [...V3, wrongType('SUB')], 'takes DEALER sockets only'],
    ['an unknown type of ZMTP 2', [V2_OPENING, Buffer.from([99, 0, 0])], 'takes DEALER sockets'],
    ['two frames as identity', [V2_OPENING, Buffer.from([5, 1, 0])], 'begin with its identity'],
  ])('refuses %s', async (_name, sent, message) => {
    await expect(greet(...sent)).rejects.toThrow(message);
  });

  it('ends with a peer that ends', async () => {
    await expect(greet(OPENING, REST_OF_GREETING.subarray(0, 20))).rejects.toThrow(SourceEnded);
  });
});
