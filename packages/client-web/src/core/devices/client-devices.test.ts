import { ComponentIOType, DeviceType, ServiceError } from '@ubii/proto';
import { settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { createTestClient } from '../../testing/create-test-client.ts';
import { FakeMaster } from '../../testing/fake-master.ts';

async function setup(options: { isOriginal?: boolean } = {}) {
  const master = new FakeMaster(options);
  const all = createTestClient(master);
  await all.client.connect();
  return { master, ...all };
}

const pointer = {
  name: 'mouse',
  tags: ['pointer'],
  components: [
    { name: 'position', format: 'vector2', tags: ['xy'], description: '0 to 1' },
    { name: 'colour', format: 'color', ioType: 'subscriber', topic: '/lights/1' },
  ],
} as const;

describe('client.registerDevice()', () => {
  it('registers the components with the topics of the convention', async () => {
    const { master, client } = await setup();
    const device = await client.registerDevice(pointer);
    expect(master.holds(client.id).devices).toMatchObject([
      {
        clientId: client.id,
        name: 'mouse',
        deviceType: DeviceType.PARTICIPANT,
        tags: ['pointer'],
        components: [
          {
            name: 'position',
            topic: `/${client.id}/mouse/position`,
            messageFormat: 'ubii.dataStructure.Vector2',
            ioType: ComponentIOType.PUBLISHER,
            tags: ['xy'],
            description: '0 to 1',
          },
          {
            name: 'colour',
            topic: '/lights/1',
            messageFormat: 'ubii.dataStructure.Color',
            ioType: ComponentIOType.SUBSCRIBER,
          },
        ],
      },
    ]);
    expect(device.component('position').topic).toBe(`/${client.id}/mouse/position`);
    expect(device.component('position').id).toBe(`${device.id}-0`);
  });

  it('makes a topic of the id the client has', async () => {
    const { master, client } = await setup();
    const device = await client.registerDevice({
      name: 'phone',
      components: [{ name: 'tilt', format: 'vector3', topic: (id: string) => `${id}/orientation` }],
    });
    expect(device.component('tilt').topic).toBe(`${client.id}/orientation`);
    expect(master.holds(client.id).devices[0]?.components[0]?.topic).toBe(
      `${client.id}/orientation`,
    );
  });

  it('publishes and subscribes by the name of the component', async () => {
    const { master, client, clock } = await setup();
    const device = await client.registerDevice(pointer);
    device.component('position').publish({ x: 0.5, y: 0.5 });
    const reds: number[] = [];
    device
      .component('colour')
      .subscribe()
      .onRecord(({ value }) => reds.push(value.r));
    await clock.advance(20);
    expect(master.published).toMatchObject([
      { topic: `/${client.id}/mouse/position`, format: 'vector2', value: { x: 0.5, y: 0.5 } },
    ]);
    master.publish({ topic: '/lights/1', format: 'color', value: { r: 1, g: 0, b: 0, a: 1 } });
    await settle();
    expect(reds).toEqual([1]);
  });

  it('refuses names that cannot be right', async () => {
    const { client } = await setup();
    await expect(client.registerDevice({ name: '', components: [] })).rejects.toThrow(TypeError);
    await expect(
      client.registerDevice({
        name: 'd',
        components: [
          { name: 'a', format: 'double' },
          { name: 'a', format: 'bool' },
        ],
      }),
    ).rejects.toThrow(TypeError);
    const device = await client.registerDevice(pointer);
    // @ts-expect-error no such component
    expect(() => device.component('wheel')).toThrow(RangeError);
  });

  it('rejects when the master refuses the device', async () => {
    const { master, client } = await setup();
    master.onRequest = ({ device }) =>
      device && new ServiceError('resource_exhausted', 'Too many devices');
    await expect(client.registerDevice(pointer)).rejects.toMatchObject({
      code: 'resource_exhausted',
    });
  });

  it('waits for the connection', async () => {
    const master = new FakeMaster();
    const { client } = createTestClient(master);
    const registered = client.registerDevice(pointer);
    await client.connect();
    await registered;
    expect(master.holds(client.id).devices).toHaveLength(1);
  });

  it('tries again when a request does not get through though the link is up', async () => {
    const { master, client, clock } = await setup();
    master.isDown = true;
    const registered = client.registerDevice(pointer);
    await settle();
    master.isDown = false;
    await clock.advance(1_000);
    await registered;
  });

  it('rejects when the client is closed before', async () => {
    const { client } = createTestClient(new FakeMaster());
    const registered = client.registerDevice(pointer);
    await settle();
    const outcome = registered.catch((error: unknown) => error);
    await client.close();
    expect(await outcome).toMatchObject({ reason: 'closed' });
  });
});

describe('a registered device', () => {
  it('is registered again, under the same ids, at a master that was restarted [DV-2]', async () => {
    const { master, client, clock } = await setup();
    const device = await client.registerDevice(pointer);
    const ids = [device.id, device.component('position').id];
    master.restart();
    await clock.advance(5_000);
    expect(client.state.status).toBe('connected');
    expect(master.holds(client.id).devices).toMatchObject([
      { id: ids[0], components: [{ id: ids[1] }, {}] },
    ]);
    expect([device.id, device.component('position').id]).toEqual(ids);
  });

  it('is not registered again when only the socket was lost', async () => {
    const { master, client, clock } = await setup();
    await client.registerDevice(pointer);
    master.drop();
    await clock.advance(5_000);
    expect(master.requests.filter(({ device }) => device !== undefined)).toHaveLength(1);
  });

  it('gets the topics of the new id when the identity changed', async () => {
    const { master, client, clock } = await setup();
    const device = await client.registerDevice(pointer);
    master.restart({ hasNewKey: true });
    await clock.advance(5_000);
    expect(client.id).not.toBe('client-1');
    expect(device.component('position').topic).toBe(`/${client.id}/mouse/position`);
  });

  it('gets another id when its own was taken meanwhile [DV-2]', async () => {
    const { master, client, clock } = await setup();
    const device = await client.registerDevice(pointer);
    const before = device.id;
    master.onRequest = ({ device: asked }) =>
      asked?.id === before ? new ServiceError('already_exists', 'Taken') : undefined;
    master.restart();
    await clock.advance(5_000);
    expect(device.id).not.toBe(before);
    expect(master.holds(client.id).devices).toMatchObject([{ id: device.id }]);
  });

  it('tells when the master does not take it back', async () => {
    const { master, client, clock, problems } = await setup();
    await client.registerDevice(pointer);
    master.onRequest = ({ device }) =>
      device && new ServiceError('resource_exhausted', 'Too many devices');
    master.restart();
    await clock.advance(5_000);
    expect(client.state.status).toBe('connected');
    expect(problems).toMatchObject([{ code: 'resource_exhausted' }]);
  });

  it('is deregistered by close(), once', async () => {
    const { master, client } = await setup();
    const device = await client.registerDevice(pointer);
    await device.close();
    await device.close();
    expect(master.holds(client.id).devices).toEqual([]);
  });

  it('is deregistered after the reconnect when it was closed while away', async () => {
    const { master, client, clock } = await setup();
    const device = await client.registerDevice(pointer);
    master.stop();
    await settle();
    await device.close();
    master.isDown = false;
    await clock.advance(5_000);
    expect(client.state.status).toBe('connected');
    expect(master.holds(client.id).devices).toEqual([]);
  });
});
