import { describe, expect, it } from 'vitest';
import { ComponentIOType } from '@ubii/proto';
import type { TestMaster } from '../src/testing/index.ts';
import {
  at,
  deviceEvent,
  heard,
  list,
  listener,
  makerOfRecording,
  masterWith,
  play,
  stop,
} from './replay-world.ts';

const RECORDED = [at('/ada/tilt', 0, 1), at('/room/light', 0, 2), at('/ada/tilt', 100, 3)];

describe('a ghost', () => {
  it('[RP-30] [RP-31] plays its span in a loop, as clients with topics of their own', async () => {
    const master = await masterWith(RECORDED);
    const ada = await listener(master);
    const { clientIds, isLooping, name } = await play(master, { isGhost: true, copies: 2 });
    const [first, second] = clientIds as [string, string];
    expect([name, isLooping, clientIds.length]).toEqual(['1: Ghost of Tuesday', true, 2]);
    await master.pass(260);
    const values = heard(ada);
    for (const [id, number] of [
      [first, 1],
      [second, 2],
    ]) {
      const own = values.filter(([topic]) => topic === `/${id}/tilt`);
      expect(own.slice(0, 4).map(([, value]) => value)).toEqual([1, 3, 1, 3]);
      expect(values).toContainEqual([`/ghost-${number}/room/light`, 2]);
    }
    expect(values.some(([topic]) => topic.startsWith('/ada/'))).toBe(false);
  });

  it('[RP-31] states its own client id in records that state one', async () => {
    const master = await masterWith(RECORDED);
    const ada = await listener(master);
    const { clientIds } = await play(master, { isGhost: true, isPaused: true });
    const own = ada.takeRecords().filter(({ topic }) => topic.endsWith('/tilt'));
    expect(own.map(({ clientId }) => clientId)).toEqual(clientIds);
  });

  it('[RP-31] keeps topics of several recorded clients apart, and numbers of all ghosts', async () => {
    const master = await masterWith([
      at('/ada/tilt', 0, 1, 'ada'),
      at('/bob/tilt', 0, 2, 'bob'),
      at('/ada/tilt', 100, 3, 'ada'),
    ]);
    const ada = await listener(master);
    const { id } = await play(master, { isGhost: true, isPaused: true });
    const other = await play(master, { isGhost: true, isPaused: true });
    expect(heard(ada).filter(([topic]) => topic.startsWith('/ghost'))).toEqual([
      ['/ghost-1/bob/tilt', 2],
      ['/ghost-2/bob/tilt', 2],
    ]);
    await stop(master, id);
    await play(master, { isGhost: true, isPaused: true });
    expect(heard(ada).filter(([topic]) => topic.startsWith('/ghost'))).toEqual([
      ['/ghost-1/bob/tilt', 2],
    ]);
    expect((await list(master)).map((replay) => replay.id)).toContain(other.id);
  });

  it('[RP-32] spreads the starts of its copies', async () => {
    const master = await masterWith([...RECORDED, at('/room/light', 1_000, 4)]);
    const ada = await listener(master);
    await play(master, { isGhost: true, copies: 4, jitterMs: 400 });
    const moved = (): number => heard(ada).filter(([, value]) => value === 3).length;
    await master.pass(50);
    expect(moved()).toBe(0);
    for (let copy = 0; copy < 4; copy++) {
      await master.pass(100);
      expect(moved()).toBe(1);
    }
  });

  it('[RP-30] plays beside live topics and beside another replay of the recording', async () => {
    const master = await masterWith(RECORDED);
    const ada = await master.extension('ada');
    await play(master, { isPaused: true });
    await play(master, { isGhost: true, isPaused: true });
    ada.publish('/other', 'double', 1);
    expect(ada.takeErrors()).toEqual([]);
    expect((await list(master)).length).toBe(2);
  });
});

/** A phone with what it publishes and what it takes, and a lamp whose topic is not recorded. */
const PHONE = deviceEvent(
  'phone',
  'ada',
  [
    { topic: '/ada/tilt', name: 'tilt', format: 'double', tags: ['sensor', 'tilt'] },
    { topic: '/room/light', name: 'light', tags: ['sensor'] },
    { topic: '/ada/silent', name: 'silent' },
    { topic: '/ada/vibrate', name: 'vibrate', direction: 'subscriber' },
  ],
  { name: 'smart-device', tags: ['phone'] },
);
const LEFT = deviceEvent('phone', 'ada', [], { state: 'deregistered' });
const LAMP = deviceEvent('lamp', 'ada', [{ topic: '/ada/brightness' }]);

async function devicesOf(master: TestMaster, clientId: string) {
  const { deviceList } = await master.call({ topic: '/services/device/get_list' });
  return deviceList!.elements.filter((device) => device.clientId === clientId);
}

describe('devices of a ghost', () => {
  it('[RP-33] are the recorded ones, with components on topics of their own', async () => {
    const master = await masterWith(RECORDED, {}, [PHONE, LAMP]);
    const { id, clientIds } = await play(master, { isGhost: true, copies: 2 });
    for (const [index, clientId] of clientIds.entries()) {
      const devices = await devicesOf(master, clientId);
      expect(devices.map(({ name, tags }) => [name, tags])).toEqual([['smart-device', ['phone']]]);
      const [tilt, light, vibrate, ...others] = devices[0]!.components;
      expect(tilt).toMatchObject({
        name: 'tilt',
        topic: `/${clientId}/tilt`,
        messageFormat: 'double',
        tags: ['sensor', 'tilt'],
        ioType: ComponentIOType.PUBLISHER,
      });
      expect(light!.topic).toBe(`/ghost-${index + 1}/room/light`);
      expect(vibrate).toMatchObject({
        topic: `/${clientId}/vibrate`,
        ioType: ComponentIOType.SUBSCRIBER,
      });
      expect(others).toEqual([]);
    }
    await stop(master, id);
    const { deviceList } = await master.call({ topic: '/services/device/get_list' });
    expect(deviceList!.elements).toEqual([]);
  });

  it('[RP-33] have no component on topics of the master and of others', async () => {
    const master = await masterWith();
    const bob = await master.extension('bob');
    const subscriber = (topic: string) => ({ topic, direction: 'subscriber' as const });
    const inputs = [
      '/ada/vibrate',
      '/room/lamp',
      '/ubii/x',
      '/info/x',
      `/${bob.id}/vibrate`,
      `${bob.id}/vibrate`,
    ];
    const phone = deviceEvent('phone', 'ada', [
      { topic: '/ada/tilt' },
      { topic: '/ubii/ada/x' },
      ...inputs.map(subscriber),
    ]);
    const records = [...RECORDED, at('/ubii/ada/x', 0)];
    const maker = await makerOfRecording(master, records, [phone]);
    for (const starter of [maker, master]) {
      const { clientIds, id } = await play(starter, { isGhost: true });
      const [device] = await devicesOf(master, clientIds[0]!);
      const topics = device!.components.map(({ topic }) => topic.replace(clientIds[0]!, 'ghost'));
      expect(topics).toEqual([
        '/ghost/tilt',
        '/ghost-1/ubii/ada/x',
        '/ghost/vibrate',
        '/room/lamp',
      ]);
      await stop(starter, id);
    }
  });

  it('[RP-33] are seen by what selects components', async () => {
    const master = await masterWith(RECORDED, {}, [PHONE]);
    const ada = await master.extension('ada');
    await ada.subscribe({ subscribeComponents: [{ tags: ['tilt'] }] });
    const { clientIds } = await play(master, { isGhost: true, copies: 2, isPaused: true });
    expect(ada.takeValues()).toEqual(clientIds.map((id) => [`/${id}/tilt`, 1]));
  });

  it.each([
    ['whose topics are not played', [LAMP]],
    ['that had left', [PHONE, LEFT]],
  ])('[RP-33] have none %s', async (_, events) => {
    const master = await masterWith(RECORDED, {}, events);
    const { clientIds } = await play(master, { isGhost: true });
    expect(await devicesOf(master, clientIds[0]!)).toEqual([]);
  });

  it.each<[string, object, string]>([
    ['devices', { devices: 1 }, 'devices'],
    ['components', { componentsPerDevice: 1 }, 'componentsPerDevice'],
    ['long texts', { topicBytes: 20 }, 'topicBytes'],
  ])(
    '[RP-33] are refused when there is no room for %s, and nothing is left',
    async (_, limits, name) => {
      const master = await masterWith(RECORDED, { limits }, [PHONE]);
      const started = play(master, { isGhost: true, copies: 2 });
      await expect(started).rejects.toThrow(name);
      expect(await list(master)).toEqual([]);
      const { clientList } = await master.call({ topic: '/services/client/get_list' });
      expect(clientList!.elements).toEqual([]);
    },
  );
});
