import { startMosquitto, type Mosquitto } from '@ubii/harness';
import { Socket } from 'node:net';
import { connectAsync } from 'mqtt';
import type { MqttClient } from 'mqtt';
import { afterAll, beforeAll, describe, expect, it, onTestFinished, vi } from 'vitest';
import { createMqttSystem } from '../src/adapters/mqtt/mqtt-system.ts';
import type { ForeignMessage, ForeignState } from '../src/core/ports/foreign-system.ts';
import { foreignSystemSuite } from '../src/testing/foreign-system-suite.ts';
import { Inbox } from '../src/testing/inbox.ts';
import { mappingOf } from '../src/testing/mapping-of.ts';

vi.setConfig({ testTimeout: 60_000 });

let broker: Mosquitto;
let serial = 0;

beforeAll(async () => {
  broker = await startMosquitto();
});
afterAll(() => broker?.close());

function openSystem(more: Partial<Parameters<typeof createMqttSystem>[0]> = {}) {
  serial++;
  return createMqttSystem({
    url: broker.url,
    clientId: `bridge-${serial}`,
    user: undefined,
    password: undefined,
    ca: undefined,
    availability: `status/${serial}`,
    masterId: () => 'master',
    // Without chance, attempts come as early as they can.
    random: () => 0,
    ...more,
  });
}

async function openPeer(): Promise<MqttClient> {
  const peer = await connectAsync(broker.url, { protocolVersion: 5, reconnectPeriod: 50 });
  peer.on('error', () => undefined);
  onTestFinished(() => peer.endAsync(true));
  return peer;
}

foreignSystemSuite<Uint8Array>('MqttSystem', async () => {
  const root = `suite/${serial}`;
  const system = openSystem();
  const peer = await connectAsync(broker.url, { protocolVersion: 5, reconnectPeriod: 50 });
  peer.on('error', () => undefined);
  const received = new Inbox<{ readonly address: string; readonly number: number }>();
  peer.on('message', (address, payload) =>
    received.add({ address, number: Number(payload.toString()) }),
  );
  await peer.subscribeAsync([`${root}/result`, `${root}/early`]);
  return {
    system,
    received,
    address: (level) => `${root}/${level}`,
    mapping: (direction, foreign) =>
      mappingOf(direction, foreign, foreign.includes('+') ? '/x/{1}' : '/x', { qos: 1 }),
    payload: (number) => new TextEncoder().encode(String(number)),
    number: (payload) => Number(new TextDecoder().decode(payload)),
    // At QoS 1 with `retain`, so that it comes whenever the adapter has subscribed.
    async publish(address, number) {
      if (!peer.connected) await new Promise((resolve) => peer.once('connect', resolve));
      await peer.publishAsync(address, String(number), { qos: 1, retain: true });
    },
    outage: { end: () => broker.stop(), begin: () => broker.start() },
    close: () => peer.endAsync(true),
  };
});

describe('the broker and the bridge', () => {
  const isConnected = ({ status }: ForeignState): boolean => status === 'connected';
  const open = (system: ReturnType<typeof openSystem>) => {
    const states = new Inbox<ForeignState>();
    const messages = new Inbox<ForeignMessage<Uint8Array>>();
    /** How many messages had come by then. */
    const settled = new Inbox<number>();
    const dropped: string[] = [];
    system.open({
      handleMessage: (message) => messages.add(message),
      handleRefused: (reason) => dropped.push(reason),
      handleDropped: (_mapping, reason) => dropped.push(reason),
      handleState: (state) => states.add(state),
      handleSettled: () => settled.add(messages.all.length),
    });
    onTestFinished(() => system.close());
    return { states, messages, settled, dropped };
  };
  const text = (payload: Uint8Array): string => new TextDecoder().decode(payload);

  it('takes retained messages where the mapping says so, and leaves a retained one [BR-12]', async () => {
    const peer = await openPeer();
    await peer.publishAsync('kept/in', '1', { qos: 1, retain: true });
    await peer.publishAsync('unkept/in', '1', { qos: 1, retain: true });
    const system = openSystem();
    const { states, messages } = open(system);
    const kept = mappingOf('both', 'kept/+', '/kept/{1}', { retained: true, qos: 1 });
    system.setMappings([kept, mappingOf('in', 'unkept/+', '/unkept/{1}')]);
    await states.next(isConnected);
    expect((await messages.next()).address).toBe('kept/in');
    expect(messages.all).toEqual([]);
    system.send({ address: 'kept/out', mapping: kept, payload: Buffer.from('2') });
    const later = await openPeer();
    const got = new Promise<string>((resolve) =>
      later.on('message', (address, payload, { retain }) =>
        resolve(`${address} ${payload.toString()} ${retain}`),
      ),
    );
    await later.subscribeAsync('kept/out', { qos: 0, rap: true });
    expect(await got).toBe('kept/out 2 true');
  });

  it('says when all that the broker kept has come, however much it is [BR-14]', async () => {
    const peer = await openPeer();
    const names = Array.from({ length: 200 }, (_, index) => `many/${index}`);
    await Promise.all(names.map((name) => peer.publishAsync(name, '1', { qos: 1, retain: true })));
    const system = openSystem();
    const { messages, settled } = open(system);
    system.setMappings([mappingOf('both', 'many/+', '/many/{1}', { retained: true, qos: 1 })]);
    expect(await settled.next()).toBe(names.length);
    expect(messages.all.every(({ isKept }) => isKept)).toBe(true);
    await peer.publishAsync('many/0', '2', { qos: 1, retain: true });
    expect(await messages.next(({ payload }) => text(payload) === '2')).toMatchObject({
      isKept: false,
    });
    system.setMappings([]);
    expect(await settled.next()).toBe(0);
  });

  it('marks what it sends, so that bridges of the same master leave it alone [BR-21]', async () => {
    const [first, second, other] = [
      openSystem(),
      openSystem(),
      openSystem({ masterId: () => 'another' }),
    ];
    const mapping = mappingOf('both', 'loop/+', '/loop/{1}');
    const seen = [first, second, other].map((system) => {
      const events = open(system);
      system.setMappings([mapping]);
      return events;
    });
    for (const { states } of seen) await states.next(isConnected);
    first.send({ address: 'loop/x', mapping, payload: Buffer.from('1') });
    expect((await seen[1]!.messages.next()).isOurs).toBe(true);
    expect((await seen[2]!.messages.next()).isOurs).toBe(false);
    const peer = await openPeer();
    await peer.publishAsync('loop/y', '2');
    const message = await seen[0]!.messages.next();
    // The broker did not send back the first one.
    expect([message.address, message.isOurs]).toEqual(['loop/y', false]);
  });

  it('sends small messages at once', async () => {
    const noDelay = vi.spyOn(Socket.prototype, 'setNoDelay');
    onTestFinished(() => noDelay.mockRestore());
    await open(openSystem()).states.next(isConnected);
    expect(noDelay).toHaveBeenCalledWith(true);
  });

  it('says when the broker has forgotten what it kept [BR-15]', async () => {
    const own = await startMosquitto();
    onTestFinished(() => own.close());
    const { states } = open(openSystem({ url: own.url }));
    expect(await states.next(isConnected)).toHaveProperty('hasForgotten', false);
    await own.stop();
    await states.next(({ status }) => status === 'waiting');
    await own.start();
    expect(await states.next(isConnected)).toHaveProperty('hasForgotten', true);
  });

  it('says whether it is there, also when it is lost [BR-41]', async () => {
    const peer = await openPeer();
    const words = new Inbox<string>();
    peer.on('message', (_address, payload) => words.add(payload.toString()));
    const system = openSystem({ availability: 'there/bridge' });
    const { states } = open(system);
    await states.next(isConnected);
    await peer.subscribeAsync('there/bridge', { qos: 1 });
    expect(await words.next()).toBe('offline');
    system.setAvailable(true);
    expect(await words.next()).toBe('online');
    await system.close();
    expect(await words.next()).toBe('offline');
  });

  it('keeps the newest of each address while the broker is away, where that has a use [BR-32]', async () => {
    const peer = await openPeer();
    const got = new Inbox<string>();
    peer.on('message', (address, payload) => got.add(`${address} ${payload.toString()}`));
    const system = openSystem();
    const { states, dropped } = open(system);
    await states.next(isConnected);
    await broker.stop();
    await states.next(({ status }) => status === 'waiting');
    const sure = mappingOf('out', 'away/{1}', '/away/*', { qos: 1 });
    const unsure = mappingOf('out', 'away/{1}', '/away/*');
    const send = (mapping: typeof sure, address: string, value: string) =>
      system.send({ address, mapping, payload: Buffer.from(value) }).kind;
    expect(send(sure, 'away/a', '1')).toBe('waiting');
    expect(send(sure, 'away/a', '2')).toBe('waiting');
    expect(send(unsure, 'away/b', '3')).toBe('dropped');
    await broker.start();
    if (!peer.connected) await new Promise((resolve) => peer.once('connect', resolve));
    await peer.subscribeAsync('away/+', { qos: 1 });
    await states.next(isConnected);
    // Of what waited, the newest comes, unless the peer was later than the bridge.
    send(sure, 'away/c', '4');
    await got.next((line) => line === 'away/c 4');
    expect(dropped).toEqual(['A newer value took its place.']);
  });

  it('gets over a reconnect what was sent to it meanwhile, at QoS 1 [BR-42]', async () => {
    const system = openSystem();
    const { states, messages } = open(system);
    system.setMappings([mappingOf('in', 'session/+', '/session/{1}', { qos: 1 })]);
    await states.next(isConnected);
    // Another connection with the same client id takes its place, without a new session.
    const thief = await connectAsync(broker.url, {
      protocolVersion: 5,
      clientId: `bridge-${serial}`,
      clean: false,
      reconnectPeriod: 0,
      properties: { sessionExpiryInterval: 3_600 },
    });
    await states.next(({ status }) => status === 'waiting');
    thief.stream.destroy();
    const peer = await openPeer();
    await peer.publishAsync('session/x', '5', { qos: 1 });
    expect(text((await messages.next()).payload)).toBe('5');
    expect(await states.next(isConnected)).toHaveProperty('hasForgotten', false);
    await thief.endAsync(true);
  });

  it('logs in with user and password, and says when they are refused [BR-43]', async () => {
    const { execFileSync } = await import('node:child_process');
    const guarded = await startMosquitto((folder) => {
      execFileSync('mosquitto_passwd', ['-b', '-c', `${folder}/passwords`, 'ada', 'secret']);
      return ['allow_anonymous false', `password_file ${folder}/passwords`];
    });
    onTestFinished(() => guarded.close());
    const right = open(openSystem({ url: guarded.url, user: 'ada', password: 'secret' }));
    await right.states.next(isConnected);
    const wrong = open(openSystem({ url: guarded.url, user: 'ada', password: 'wrong-secret' }));
    const state = await wrong.states.next(({ status }) => status === 'waiting');
    expect(state).toHaveProperty('reason', expect.stringMatching(/user/));
    expect(JSON.stringify(state)).not.toContain('wrong-secret');
  });

  it('trusts the authority that it is given over TLS, and no other [BR-43]', async () => {
    const { execFileSync } = await import('node:child_process');
    const { readFileSync } = await import('node:fs');
    const safe = await startMosquitto((folder) => {
      const inFolder = { cwd: folder, stdio: 'ignore' } as const;
      const [ca, key] = [
        ['req', '-x509', '-newkey', 'ec', '-pkeyopt', 'ec_paramgen_curve:prime256v1', '-nodes'],
        ['-subj', '/CN=127.0.0.1', '-addext', 'subjectAltName=IP:127.0.0.1', '-days', '2'],
      ];
      execFileSync(
        'openssl',
        [...ca!, ...key!, '-keyout', 'key.pem', '-out', 'cert.pem'],
        inFolder,
      );
      return ['allow_anonymous true', `certfile ${folder}/cert.pem`, `keyfile ${folder}/key.pem`];
    });
    onTestFinished(() => safe.close());
    const url = safe.url.replace('mqtt:', 'mqtts:');
    const ca = readFileSync(`${safe.folder}/cert.pem`);
    await open(openSystem({ url, ca })).states.next(isConnected);
    const distrusting = open(openSystem({ url }));
    expect(await distrusting.states.next(({ status }) => status === 'waiting')).toHaveProperty(
      'reason',
      expect.stringMatching(/certificate|self.signed/i),
    );
  });
});
