import { ClientState } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';

describe('news of clients', () => {
  it('come when a client registers, changes state, name or devices, and goes [CL-31] [EX-10]', async () => {
    const master = new TestMaster();
    const ben = await master.extension('ben');
    await ben.subscribe({ subscribeTopicRegexp: ['^/ubii/client/'] });
    ben.takeSent();
    const ada = await master.extension('ada');
    const news = () => ben.takeRecords().filter(({ topic }) => topic === `/ubii/client/${ada.id}`);
    expect(news()).toMatchObject([
      { format: 'client', value: { id: ada.id, name: 'ada', state: ClientState.ACTIVE } },
    ]);
    const { device } = await ada.call({
      topic: '/services/device/registration',
      device: { clientId: ada.id, name: 'pen' },
    });
    expect(news()).toMatchObject([{ value: { devices: [{ name: 'pen' }] } }]);
    await ada.call({ topic: '/services/device/deregistration', device: device! });
    expect(news()).toMatchObject([{ value: { devices: [] } }]);
    await master.register({ id: ada.id, name: 'adele', extension: { resumeToken: ada.token } });
    expect(news()).toMatchObject([{ value: { name: 'adele' } }]);
    ada.drop();
    expect(news()).toMatchObject([{ value: { state: ClientState.INACTIVE } }]);
    ada.open();
    expect(news()).toMatchObject([{ value: { state: ClientState.ACTIVE } }]);
    await ada.call({ topic: '/services/client/deregistration', client: { id: ada.id } });
    expect(news()).toMatchObject([{ value: { name: 'adele', state: ClientState.UNAVAILABLE } }]);
    // And nothing of it is retained.
    const cleo = await master.extension('cleo');
    await cleo.subscribe({ subscribeTopicRegexp: ['^/ubii/client/'] });
    expect(cleo.takeRecords().map(({ topic }) => topic)).toEqual([
      `/ubii/client/${ben.id}`,
      `/ubii/client/${cleo.id}`,
    ]);
  });

  it('do not come when nothing changes', async () => {
    const master = new TestMaster();
    const ben = await master.extension('ben');
    const ada = await master.legacy('ada');
    await ben.subscribe({ subscribeTopicRegexp: ['^/ubii/client/'] });
    ben.takeSent();
    ada.publish('/a', 'double', 1);
    ada.sendText('PONG');
    await ada.subscribe({ subscribeTopics: ['/a'] });
    await ada.call({
      topic: '/services/device/deregistration',
      device: { clientId: ada.id, id: 'x' },
    });
    expect(ben.takeRecords()).toEqual([]);
  });
});
