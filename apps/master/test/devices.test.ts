import { ComponentIOType, DecodeError, DeviceType, fromJson } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestClient } from '../src/testing/index.ts';

const UUID = /^[0-9a-f-]{36}$/;

async function createPair() {
  const master = new TestMaster();
  const ada = await master.legacy('ada');
  const ben = await master.legacy('ben');
  const register = async (client: TestClient, device: object) =>
    client.call({
      topic: '/services/device/registration',
      device: { clientId: client.id, ...device },
    });
  const deregister = async (client: TestClient, device: object) =>
    client.call({
      topic: '/services/device/deregistration',
      device: { clientId: client.id, ...device },
    });
  return { master, ada, ben, register, deregister };
}

describe('devices', () => {
  it('get ids, and every member is repeated in its order [DV-1]', async () => {
    const { ada, register } = await createPair();
    const device = {
      name: 'phone',
      deviceType: DeviceType.PARTICIPANT,
      tags: ['smart device'],
      description: 'a test',
      components: [
        { name: 'b', topic: '/b', messageFormat: 'vector2', description: 'second', tags: ['t'] },
        { name: 'a', topic: '/a', ioType: ComponentIOType.SUBSCRIBER, notifyConditionIds: ['n'] },
      ],
    };
    const reply = await register(ada, device);
    const id = reply.device!.id;
    expect(id).toMatch(UUID);
    expect(reply.device).toMatchObject({
      ...device,
      clientId: ada.id,
      components: device.components.map((component) => ({
        ...component,
        id: expect.stringMatching(UUID),
        deviceId: id,
      })),
    });
    const [first, second] = reply.device!.components;
    expect(first!.id).not.toBe(second!.id);
  });

  it('keep ids that are free, and get others for those that are not [DV-1]', async () => {
    const { ada, ben, register } = await createPair();
    const { device } = await register(ada, {
      id: 'pen',
      components: [{ id: 'tip' }, { id: 'tip' }, { id: 'cap' }],
    });
    expect(device?.id).toBe('pen');
    expect(device?.components.map(({ id }) => id)).toEqual([
      'tip',
      expect.stringMatching(UUID),
      'cap',
    ]);
    const other = await register(ben, { components: [{ id: 'tip' }] });
    expect(other.device?.components[0]?.id).toMatch(UUID);
  });

  it('belong to a registered client [DV-1]', async () => {
    const { master } = await createPair();
    for (const [clientId, code] of [
      ['unknown', 'not_found'],
      ['', 'invalid_argument'],
    ]) {
      const { error } = await master.call({
        topic: '/services/device/registration',
        device: { clientId: clientId! },
      });
      expect(error).toMatchObject({ code });
      expect(error?.message).toContain('client_id');
    }
  });

  it('that are registered again replace what was there [DV-2]', async () => {
    const { master, ada, register } = await createPair();
    await register(ada, { id: 'pen', name: 'old', components: [{ id: 'tip', topic: '/old' }] });
    ada.publish('/old', 'double', 1);
    const { device } = await register(ada, {
      id: 'pen',
      name: 'new',
      components: [{ id: 'tip', topic: '/new' }],
    });
    expect(device).toMatchObject({ id: 'pen', name: 'new', components: [{ id: 'tip' }] });
    const { deviceList } = await master.call({ topic: '/services/device/get_list' });
    expect(deviceList?.elements).toEqual([device]);
  });

  it('cannot take the id of a device of another client [DV-2]', async () => {
    const { master, ada, ben, register } = await createPair();
    await register(ada, { id: 'pen', name: 'mine' });
    const { error } = await register(ben, { id: 'pen', name: 'stolen' });
    expect(error).toMatchObject({ code: 'already_exists' });
    const { device } = await master.call({ topic: '/services/device/get', device: { id: 'pen' } });
    expect(device?.name).toBe('mine');
  });

  it('that watch get every topic, there and to come [DV-3]', async () => {
    const { master, ada, ben, register, deregister } = await createPair();
    ada.publish('/a', 'double', 1);
    const { device } = await register(ben, { deviceType: DeviceType.WATCHER });
    master.clock.advanceSync(25);
    expect(ben.takeValues()).toContainEqual(['/a', 1]);
    ada.publish('/b', 'double', 2);
    ada.publish('/a', 'double', 3);
    expect(ben.takeValues()).toEqual([
      ['/b', 2],
      ['/a', 3],
    ]);
    await deregister(ben, device!);
    ada.publish('/a', 'double', 4);
    expect(ben.takeValues().filter(([topic]) => topic === '/a')).toEqual([]);
  });

  it('are deregistered by their client alone [DV-4]', async () => {
    const { master, ada, ben, register, deregister } = await createPair();
    const { device } = await register(ada, { name: 'pen' });
    for (const [clientId, code] of [
      [ben.id, 'permission_denied'],
      ['unknown', 'not_found'],
      ['', 'invalid_argument'],
    ]) {
      const { error } = await deregister(ben, { id: device!.id, clientId });
      expect(error).toMatchObject({ code });
    }
    const { deviceList } = await master.call({ topic: '/services/device/get_list' });
    expect(deviceList?.elements).toHaveLength(1);
    expect((await deregister(ada, device!)).success).toBeDefined();
  });

  it('that are unknown are deregistered with success [DV-4]', async () => {
    const { ada, deregister } = await createPair();
    for (const id of ['unknown', '']) {
      expect((await deregister(ada, { id })).success).toBeDefined();
    }
  });

  it('given as an array are refused, not fatal [DV-5] [SV-7]', async () => {
    const { master, ada } = await createPair();
    const json = {
      topic: '/services/device/deregistration',
      device: ['some-id', { id: 'some-id', clientId: ada.id }],
    };
    let thrown: unknown;
    try {
      fromJson('ubii.services.ServiceRequest', json);
    } catch (error) {
      thrown = error;
    }
    expect(thrown).toBeInstanceOf(DecodeError);
    const { reply } = master.master.refuseServiceRequest(thrown);
    expect(reply.error).toMatchObject({ code: 'invalid_argument', stack: '' });
  });

  it('may have any names, formats, topics and tags [DV-6] [EC-22]', async () => {
    const { ada, register } = await createPair();
    const component = {
      name: '../?*',
      topic: 'no slash, but spaces',
      messageFormat: 'ubii.dataStructure.Image',
      tags: ['', 'ä', 'a b'],
    };
    const { device } = await register(ada, { name: '', components: [component, { topic: '' }] });
    expect(device?.components[0]).toMatchObject(component);
  });

  it('are announced when they come and go [CL-30]', async () => {
    const { ada, ben, register, deregister } = await createPair();
    await ben.subscribe({ subscribeTopics: ['/info/device/new', '/info/device/delete'] });
    const { device } = await register(ada, { name: 'pen', components: [{ topic: '/pen' }] });
    expect(ben.takeRecords()).toMatchObject([
      { topic: '/info/device/new', format: 'device', value: device },
    ]);
    await deregister(ada, { id: device!.id });
    expect(ben.takeRecords()).toMatchObject([
      { topic: '/info/device/delete', format: 'device', value: device },
    ]);
    await register(ada, { name: 'pad' });
    ben.takeSent();
    await ada.call({ topic: '/services/client/deregistration', client: { id: ada.id } });
    expect(ben.takeRecords()).toMatchObject([
      { topic: '/info/device/delete', value: { name: 'pad' } },
    ]);
  });
});
