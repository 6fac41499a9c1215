import { createSocket, Socket } from 'node:dgram';
import { systemClock } from '@ubii/timing/system';
import { FakeClock } from '@ubii/timing/testing';
import OSC from 'osc-js';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { oscCodec } from '../src/adapters/osc/osc-codec.ts';
import type { OscContent } from '../src/adapters/osc/osc-codec.ts';
import { createOscSystem } from '../src/adapters/osc/osc-system.ts';
import { foreignSystemSuite } from '../src/testing/foreign-system-suite.ts';
import { Inbox } from '../src/testing/inbox.ts';
import { mappingOf } from '../src/testing/mapping-of.ts';
import { isConnected, SystemEvents } from '../src/testing/system-events.ts';
import { joinAs, mappingFile, startBridge, startMaster } from './programs.ts';

vi.setConfig({ testTimeout: 60_000 });

interface Heard {
  readonly address: string;
  readonly args: readonly unknown[];
  readonly types: string;
}

/** Another implementation of OSC at the other end: `osc-js` over a socket of the test. */
async function openPeer() {
  const socket = createSocket('udp4');
  await new Promise<void>((resolve) => socket.bind(0, '127.0.0.1', resolve));
  const heard = new Inbox<Heard>();
  const times: number[] = [];
  socket.on('message', (bytes) => {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const packet = new OSC.Packet();
    packet.unpack(view);
    const value = packet.value as unknown as OscJsMessage & {
      bundleElements?: OscJsMessage[];
      timetag?: { readonly value: { timestamp(): number } };
    };
    if (value.timetag !== undefined) times.push(value.timetag.value.timestamp());
    for (const { address, args, types } of value.bundleElements ?? [value]) {
      heard.add({ address, args, types: types.replace(',', '') });
    }
  });
  return { socket, heard, times, port: socket.address().port };
}

interface OscJsMessage {
  readonly address: string;
  readonly args: readonly unknown[];
  readonly types: string;
}

function sendTo(socket: Socket, port: number, bytes: Uint8Array): void {
  socket.send(bytes, port, '127.0.0.1');
}

const message = (address: string, ...args: (number | string | boolean)[]) =>
  new OSC.Message(address, ...args);

foreignSystemSuite<OscContent>('OscSystem', async () => {
  const peer = await openPeer();
  const system = createOscSystem({
    host: '127.0.0.1',
    port: peer.port,
    listen: undefined,
    clock: systemClock,
  });
  const received = new Inbox<{ address: string; number: number }>();
  const add = peer.heard.add.bind(peer.heard);
  peer.heard.add = (item) => {
    add(item);
    received.add({ address: item.address, number: Number(item.args[0]) });
  };
  return {
    system,
    received,
    address: (level) => `/suite/${level}`,
    mapping: (direction, foreign) =>
      mappingOf(direction, foreign, foreign.includes('+') ? '/x/{1}' : '/x'),
    payload: (number) => ({ args: [{ type: 'f', value: number }], timestampMs: undefined }),
    number: ({ args }) => Number(args[0]?.value),
    publish: (address, number) => {
      if (system.port > 0) sendTo(peer.socket, system.port, message(address, number).pack());
    },
    close: () => new Promise<void>((resolve) => peer.socket.close(() => resolve())),
  };
});

describe('OSC', () => {
  async function open() {
    const peer = await openPeer();
    const system = createOscSystem({
      host: '127.0.0.1',
      port: peer.port,
      listen: undefined,
      clock: systemClock,
    });
    const events = new SystemEvents<OscContent>();
    system.open(events);
    await events.states.next(isConnected);
    onTestFinished(async () => {
      await system.close();
      peer.socket.close();
    });
    return { peer, system, messages: events.messages, refused: events.refused };
  }

  it.each([
    ['double', [0.5], 'f', 0.5],
    ['int32', [7], 'i', 7],
    ['bool', [true], 'T', true],
    ['string', ['hall'], 's', 'hall'],
    ['vector3', [0.5, 1.5, 2.5], 'fff', { x: 0.5, y: 1.5, z: 2.5 }],
    ['int32List', [1, 2, 3], 'iii', { elements: [1, 2, 3] }],
    ['object2D', ['{"id":"a"}'], 's', { id: 'a' }],
  ] as const)(
    '%s are arguments of another implementation [BR-60]',
    async (format, args, types, value) => {
      const { peer, system, messages } = await open();
      const mapping = mappingOf('both', '/a', '/a', { format });
      sendTo(peer.socket, system.port, message('/a', ...args).pack());
      const { payload } = await messages.next();
      expect(oscCodec.read(payload, mapping)).toMatchObject({ format, value });
      const written = oscCodec.write(
        {
          topic: '/a',
          format,
          bytes: new Uint8Array(),
          value: oscCodec.read(payload, mapping).value,
        },
        mapping,
      );
      system.send({ address: '/a', mapping, payload: written });
      const heard = await peer.heard.next();
      expect(heard.types).toBe(types);
      if (format !== 'object2D') expect(heard.args).toEqual(args);
    },
  );

  it('bundles have a time in both directions [BR-62]', async () => {
    const { peer, system, messages } = await open();
    const mapping = mappingOf('both', '/a', '/a', { timeTag: true });
    const atMs = Date.UTC(2026, 0, 2);
    const bundle = new OSC.Bundle([message('/a', 0.5), message('/b', 1.5)], atMs);
    sendTo(peer.socket, system.port, bundle.pack());
    const [first, second] = [await messages.next(), await messages.next()];
    expect([first.address, second.address]).toEqual(['/a', '/b']);
    expect(first.payload.timestampMs).toBe(atMs);
    const record = { topic: '/a', format: 'double', value: 2, timestampMs: atMs } as const;
    const payload = oscCodec.write({ ...record, bytes: new Uint8Array() }, mapping);
    system.send({ address: '/a', mapping, payload });
    await peer.heard.next();
    expect(Math.round(peer.times[0]!)).toBe(atMs);
  });

  it('refuses what is no message, patterns as addresses, and other computers [BR-61]', async () => {
    const { peer, system, messages, refused } = await open();
    sendTo(peer.socket, system.port, Buffer.from('no message at all'));
    expect(await refused.next()).toContain('No OSC message');
    sendTo(peer.socket, system.port, message('/a/*', 1).pack());
    expect(await refused.next()).toContain('characters that OSC does not allow');
    const other = createSocket('udp4');
    onTestFinished(() => void other.close());
    await new Promise<void>((resolve) => other.bind(0, '127.0.0.2', resolve));
    other.send(message('/a', 1).pack(), system.port, '127.0.0.1');
    expect(await refused.next()).toContain('127.0.0.2 is not the computer of this bridge');
    expect(messages.all).toEqual([]);
    const mapping = mappingOf('out', '/{1}', '/x/*');
    const send = (address: string, bytes = 4) =>
      system.send({
        address,
        mapping,
        payload: { args: [{ type: 's', value: 'x'.repeat(bytes) }], timestampMs: undefined },
      });
    expect(send('/a b').kind).toBe('refused');
    expect(send('/a', 70_000).kind).toBe('refused');
  });

  it('leaves no socket of a port that it cannot open, and tries again [BR-40]', async () => {
    const taken = await openPeer();
    const clock = new FakeClock();
    const events = new SystemEvents<OscContent>();
    const { states } = events;
    const closed = vi.spyOn(Socket.prototype, 'close');
    onTestFinished(() => closed.mockRestore());
    const system = createOscSystem({
      host: '127.0.0.1',
      port: 9,
      listen: taken.port,
      clock,
      random: () => 0,
    });
    system.open(events);
    for (let attempt = 0; attempt < 3; attempt++) {
      const state = await states.next(({ status }) => status === 'waiting');
      expect(state).toHaveProperty('reason', expect.stringMatching(/EADDRINUSE/));
      clock.advanceSync(60_000);
    }
    await states.next(({ status }) => status === 'waiting');
    expect(closed).toHaveBeenCalledTimes(4);
    await new Promise<void>((resolve) => taken.socket.close(() => resolve()));
    clock.advanceSync(60_000);
    await states.next(isConnected);
    await system.close();
  });

  it('follows a computer that gets another address [BR-61]', async () => {
    const peer = await openPeer();
    const clock = new FakeClock();
    const events = new SystemEvents<OscContent>();
    const { states, messages } = events;
    const addresses = ['127.0.0.2', '127.0.0.2', '127.0.0.1'];
    const system = createOscSystem({
      host: 'controller.local',
      port: peer.port,
      listen: undefined,
      clock,
      lookUp: async () => ({ address: addresses.shift() ?? '127.0.0.1', family: 4 }),
    });
    onTestFinished(async () => {
      await system.close();
      peer.socket.close();
    });
    system.open(events);
    await states.next(isConnected);
    // Once it is as before, once it is another one.
    clock.advanceSync(60_000);
    clock.advanceSync(60_000);
    const away = await states.next(({ status }) => status === 'waiting');
    expect(away).toHaveProperty('reason', 'controller.local is now at 127.0.0.1');
    await states.next(isConnected);
    sendTo(peer.socket, system.port, message('/a', 1).pack());
    expect((await messages.next()).address).toBe('/a');
    expect(addresses).toEqual([]);
  });

  it('refuses a user and a password, because OSC has none [BR-43]', async () => {
    const file = mappingFile({ mappings: [] });
    const bridge = startBridge(['osc://127.0.0.1:9'], 'http://127.0.0.1:9', file, {
      UBII_BRIDGE_USER: 'ada',
    });
    expect(await bridge.ended()).toBe(1);
    expect(bridge.stderr).toContain('OSC has no users and no passwords.');
  });

  it('passes values of a running program into topics and back [BR-2]', async () => {
    const { url } = await startMaster();
    const client = await joinAs(url);
    const peer = await openPeer();
    onTestFinished(() => void peer.socket.close());
    const probe = await openPeer();
    const { port: listen } = probe;
    await new Promise<void>((resolve) => probe.socket.close(() => resolve()));
    const file = mappingFile({
      mappings: [
        { direction: 'in', foreign: '/fader/+', topic: '/osc/fader/{1}', format: 'double' },
        { direction: 'out', foreign: '/lamp/{1}', topic: '/lamps/*', format: 'bool' },
      ],
    });
    const target = [`osc://127.0.0.1:${peer.port}`, '--listen', String(listen)];
    const bridge = startBridge(target, url, file);
    await bridge.says('Connected to osc:');
    const records = client.subscribe({ glob: '/osc/**' }, { format: 'double' });
    await records.ready;
    sendTo(peer.socket, listen, message('/fader/1', 0.5).pack());
    for await (const { topic, value } of records) {
      expect([topic, value]).toEqual(['/osc/fader/1', 0.5]);
      break;
    }
    client.publish('/lamps/red', 'bool', true);
    expect(await peer.heard.next()).toMatchObject({ address: '/lamp/red', args: [true] });
  });
});
