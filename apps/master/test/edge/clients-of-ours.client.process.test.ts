import { createClient, createMemoryIdentity } from '@ubii/client-web/node';
import type { ClientOptions, ConnectionState, UbiiClient } from '@ubii/client-web/node';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { WebSocket } from 'ws';
import { startEdgeMaster } from './edge-master.ts';

// Real sockets and timers, on a machine that may be busy.
vi.setConfig({ testTimeout: 30_000 });

const quick = { initialDelayMs: 20, maxDelayMs: 100 };

function create(options: ClientOptions): UbiiClient {
  const client = createClient({ reconnect: quick, ...options });
  onTestFinished(() => client.close());
  return client;
}

/** The next state of this status, or the present one. */
function until<S extends ConnectionState['status']>(
  client: UbiiClient,
  status: S,
): Promise<Extract<ConnectionState, { status: S }>> {
  return new Promise((resolve) => {
    const look = (state: ConnectionState): void => {
      if (state.status === status) resolve(state as Extract<ConnectionState, { status: S }>);
    };
    client.onState(look);
    look(client.state);
  });
}

describe.each(['binary', 'json'])('clients of ours with %s services', (encoding) => {
  it('register, subscribe in every way, publish, and leave', async () => {
    const { url } = await startEdgeMaster();
    const endpoints = { servicesUrl: `${url}/services/${encoding}`, topicDataUrl: `${url}/` };
    const ada = create({ ...endpoints, name: 'ada' });
    const ben = create({ ...endpoints, name: 'ben' });
    await Promise.all([ada.connect(), ben.connect()]);

    const subscriptions = [
      ben.subscribe({ component: { tags: ['pointer'] } }, { format: 'vector2' }),
      ben.subscribe({ glob: `/${ada.id}/**` }, { format: 'vector2' }),
      ben.subscribe(`/${ada.id}/mouse/position`, { format: 'vector2', maxRateHz: 100 }),
    ];
    await Promise.all(subscriptions.map(({ ready }) => ready));
    const device = await ada.registerDevice({
      name: 'mouse',
      components: [{ name: 'position', format: 'vector2', tags: ['pointer'] }],
    });
    device.component('position').publish({ x: 0.5, y: 1 });
    for (const subscription of subscriptions) {
      for await (const { value, clientId } of subscription) {
        expect(value).toEqual({ x: 0.5, y: 1 });
        expect(clientId).toBe(ada.id);
        break;
      }
    }
    expect((await ben.call('clientGetList')).elements).toMatchObject([
      { name: 'ada' },
      { name: 'ben' },
    ]);
    await ada.close();
    expect((await ben.call('clientGetList')).elements).toMatchObject([{ name: 'ben' }]);
  });

  it('are refused patterns that RE2 does not know [TD-21]', async () => {
    const { url } = await startEdgeMaster();
    const ada = create({
      servicesUrl: `${url}/services/${encoding}`,
      topicDataUrl: `${url}/`,
      name: 'ada',
    });
    await ada.connect();
    expect(() => ada.subscribe({ regex: '(a)\\1' })).toThrow('back-references are not supported');
    const asked = ada.call('topicSubscription', {
      clientId: ada.id,
      subscribeTopicRegexp: ['(a)\\1'],
    });
    await expect(asked).rejects.toMatchObject({ name: 'ServiceError', code: 'invalid_argument' });
  });
});

describe('a client of ours', () => {
  it('is the same client after a restart of the master [EX-3]', async () => {
    const dataDir = temporaryFolder();
    const first = await startEdgeMaster({ dataDir });
    const ada = create({ url: first.url, name: 'ada' });
    await ada.connect();
    const values: unknown[] = [];
    const subscription = ada.subscribe({ glob: '/a/*' });
    subscription.onRecord(({ value }) => values.push(value));
    await subscription.ready;
    const { id } = ada;

    await first.close();
    await until(ada, 'reconnecting');
    ada.publish('/a/b', 'int32', 1);
    ada.publish('/a/b', 'int32', 2);
    await startEdgeMaster({ dataDir, flags: ['--port', String(first.port)] });
    expect(await until(ada, 'connected')).toMatchObject({ clientId: id, resumed: true });
    await vi.waitFor(() => expect(values).toEqual([2]), { timeout: 20_000 });
  });

  it('is a new client for a master with another key, and says so', async () => {
    const first = await startEdgeMaster();
    const ada = create({ url: first.url, name: 'ada' });
    await ada.connect();
    const changed = new Promise((resolve) => ada.onIdentityChange(resolve));
    const { id } = ada;
    await first.close();
    await until(ada, 'reconnecting');
    await startEdgeMaster({ flags: ['--port', String(first.port)] });
    expect(await until(ada, 'connected')).toMatchObject({ resumed: false });
    expect(await changed).toEqual({ previousId: id, clientId: ada.id });
  });

  it('stops when another socket takes its identity [TD-7]', async () => {
    const { url } = await startEdgeMaster();
    const identity = createMemoryIdentity();
    const ada = create({ url, name: 'ada', identity });
    await ada.connect();
    const { clientId, resumeToken } = (await identity.load())!;
    const thief = new WebSocket(
      `${url.replace('http', 'ws')}/?token=${resumeToken}&clientID=${clientId}`,
    );
    onTestFinished(() => thief.terminate());
    expect(await until(ada, 'closed')).toMatchObject({ error: { reason: 'superseded' } });
  });

  it('sends and receives pictures of many megabytes', async () => {
    const { url } = await startEdgeMaster();
    const ada = create({ url, name: 'ada' });
    await ada.connect();
    const pictures = ada.subscribe('/camera', { format: 'image2D' });
    await pictures.ready;
    const data = new Uint8Array(1_920 * 1_080 * 4).map((_, i) => i);
    ada.publish('/camera', 'image2D', { width: 1_920, height: 1_080, data, dataFormat: 2 });
    for await (const { value } of pictures) {
      expect(value.width).toBe(1_920);
      expect(Buffer.compare(value.data, data)).toBe(0);
      break;
    }
  });

  it('rejects connect() when there is no master and the policy gives up', async () => {
    const { url, close } = await startEdgeMaster();
    await close();
    const ada = create({ url, name: 'ada', reconnect: { giveUpAfterAttempts: 1 } });
    await expect(ada.connect()).rejects.toMatchObject({
      name: 'ConnectionError',
      reason: 'refused',
    });
  });
});
