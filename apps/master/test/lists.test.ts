import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';

async function createHouse() {
  const master = new TestMaster();
  const ada = await master.extension('ada', {
    tags: ['player'],
    processingModules: [{ name: 'mirror', tags: ['fast'] }],
    devices: [
      {
        name: 'phone',
        tags: ['smart device'],
        components: [
          { name: 'touch', topic: '/touch', messageFormat: 'vector2', tags: ['touch'] },
          { name: 'second', topic: '/second', messageFormat: 'vector2', tags: ['touch'] },
          { name: 'tilt', topic: '/tilt', messageFormat: 'vector3', tags: ['orientation'] },
          { name: 'vibrate', topic: '/vibrate', messageFormat: 'double', ioType: 1 },
        ],
      },
    ],
  });
  const ben = await master.legacy('ben', {
    tags: ['player', 'host'],
    devices: [{ name: 'pen', components: [{ name: 'tip', topic: '/tip' }] }],
  });
  const names = (elements: { name: string }[] | undefined) => elements?.map(({ name }) => name);
  return {
    master,
    ada,
    ben,
    clients: async (elements?: object[]) =>
      names(
        (
          await master.call({
            topic: '/services/client/get_list',
            ...(elements && { clientList: { elements } }),
          })
        ).clientList?.elements,
      ),
    devices: async (elements?: object[]) =>
      names(
        (
          await master.call({
            topic: '/services/device/get_list',
            ...(elements && { deviceList: { elements } }),
          })
        ).deviceList?.elements,
      ),
    components: async (request: object) =>
      names(
        (await master.call({ topic: '/services/component/get_list', ...request })).componentList
          ?.elements,
      ),
  };
}

describe('lists', () => {
  it('of clients are chosen by profiles [CL-20]', async () => {
    const { clients, ada } = await createHouse();
    expect(await clients([{ tags: ['player'] }])).toEqual(['ada', 'ben']);
    expect(await clients([{ tags: ['player', 'host'] }])).toEqual(['ben']);
    expect(await clients([{ id: ada.id }, { name: 'ben' }, { name: 'ada' }])).toEqual([
      'ada',
      'ben',
    ]);
    expect(await clients([{ processingModules: [{ name: 'mirror' }] }])).toEqual(['ada']);
    expect(await clients([{ processingModules: [{ name: 'mirror', tags: ['slow'] }] }])).toEqual(
      [],
    );
  });

  it('of devices are chosen by their components, of which one will do [CL-20]', async () => {
    const { devices, ben } = await createHouse();
    const profile = { components: [{ tags: ['touch'] }, { tags: ['orientation'] }] };
    expect(await devices([profile])).toEqual(['phone']);
    expect(await devices([{ clientId: ben.id }])).toEqual(['pen']);
    expect(await devices([{ name: 'phone', clientId: ben.id }])).toEqual([]);
  });

  it('of components know subscribers, and not publishers, as a criterion [CL-20]', async () => {
    const { components } = await createHouse();
    expect(await components({ componentList: { elements: [{ ioType: 1 }] } })).toEqual(['vibrate']);
    expect(
      await components({ componentList: { elements: [{ ioType: 0, messageFormat: 'vector2' }] } }),
    ).toEqual(['touch', 'second']);
  });

  it('hold everything for an empty list of profiles, and for none [CL-21]', async () => {
    const { clients, devices, components } = await createHouse();
    expect(await clients()).toEqual(['ada', 'ben']);
    expect(await clients([])).toEqual(['ada', 'ben']);
    expect(await clients([{ id: '', name: '', tags: [] }])).toEqual(['ada', 'ben']);
    expect(await devices([])).toEqual(['phone', 'pen']);
    expect(await components({})).toHaveLength(5);
  });

  it('of components take a single component for a profile [CL-21]', async () => {
    const { components } = await createHouse();
    expect(await components({ component: { tags: ['touch'] } })).toEqual(['touch', 'second']);
  });

  it('of devices and components leave out clients that are away [CL-22]', async () => {
    const { master, ada, ben, clients, devices, components } = await createHouse();
    ada.drop();
    expect(await devices()).toEqual(['phone', 'pen']);
    master.clock.advanceSync(9_500);
    ben.sendText('PONG');
    master.clock.advanceSync(500);
    expect(await clients()).toEqual(['ada', 'ben']);
    expect(await devices()).toEqual(['pen']);
    expect(await components({})).toEqual(['tip']);
    ada.open();
    expect(await devices()).toEqual(['phone', 'pen']);
    expect(await components({})).toHaveLength(5);
  });

  it('show nothing of what lies between a client and the master [CL-23]', async () => {
    const { master, ada } = await createHouse();
    const lists = [
      await master.call({ topic: '/services/client/get_list' }),
      await master.call({ topic: '/services/latency_clients_list' }),
      await master.call({ topic: '/services/device/get_list' }),
    ];
    expect(JSON.stringify(lists)).not.toContain('token');
    const topic = `/ubii/client/${ada.id}`;
    await ada.subscribe({ subscribeTopics: [topic] });
    expect(JSON.stringify(ada.takeRecords())).not.toContain('token');
  });
});
