import { AccessRole, ProcessingModuleLanguage } from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';

const UUID = /^[0-9a-f-]{36}$/;

describe('registration', () => {
  it('gives a new id and repeats everything else [CL-1] [EC-18]', async () => {
    const master = new TestMaster();
    const client = {
      id: 'mine',
      name: 'ada',
      tags: ['one', 'two'],
      description: 'a test',
      processingModules: [{ name: 'mirror', language: ProcessingModuleLanguage.JS }],
      isDedicatedProcessingNode: true,
      hostIp: '10.0.0.1',
      metadataJson: '{}',
      state: 2 as const,
      latency: 99,
    };
    const reply = await master.call({ topic: '/services/client/registration', client });
    expect(reply.client).toMatchObject({
      ...client,
      id: expect.stringMatching(UUID),
      state: 0,
      latency: 0,
    });
    const again = await master.call({ topic: '/services/client/registration', client });
    expect(again.client?.id).not.toBe(reply.client?.id);
  });

  it('takes what existing clients send: nulls, unknown keys, defaults [CL-2] [EC-5]', async () => {
    const master = new TestMaster();
    const { client, error } = await master.callJson({
      topic: '/services/client/registration',
      type: 'client',
      client: {
        name: 'ada',
        id: '',
        state: 2,
        devices: [],
        tags: null,
        processingModules: [null, { name: 'mirror', language: 0, helper: {} }, null],
        isDedicatedProcessingNode: true,
        metadataJson: '',
      },
    });
    expect(error).toBeUndefined();
    expect(client).toMatchObject({
      name: 'ada',
      tags: [],
      processingModules: [{ name: 'mirror' }],
    });
    expect(client?.processingModules).toHaveLength(1);
  });

  it('takes back a known client with id and token, with all it had [CL-3] [EX-3]', async () => {
    const master = new TestMaster();
    const ada = await master.extension('ada');
    const ben = await master.legacy('ben');
    await ada.subscribe({ subscribeTopics: ['/b'] });
    await ada.call({
      topic: '/services/device/registration',
      device: { clientId: ada.id, name: 'pen' },
    });
    ada.publish('/a', 'double', 1);
    const { client } = await master.call({
      topic: '/services/client/registration',
      client: { id: ada.id, name: 'ada the second', extension: { resumeToken: ada.token } },
    });
    expect(client).toMatchObject({
      id: ada.id,
      name: 'ada the second',
      devices: [{ name: 'pen' }],
      extension: { resumed: true, resumeToken: ada.token, masterVersion: '1.2.3' },
    });
    ada.takeSent();
    ben.publish('/b', 'double', 2);
    expect(ada.takeValues()).toEqual([['/b', 2]]);
    await ben.subscribe({ subscribeTopics: ['/a'] });
    expect(ben.takeValues()).toEqual([['/a', 1]]);
    const { clientList } = await master.call({ topic: '/services/client/get_list' });
    expect(clientList?.elements).toHaveLength(2);
  });

  it('takes back a client that this run of the master never saw [CL-3]', async () => {
    const clock = new FakeClock();
    const ada = await new TestMaster({ clock }).extension('ada');
    const restarted = new TestMaster({ clock });
    expect(
      restarted.master.openConnection(
        { clientId: ada.id, token: ada.token },
        ada.connection,
        ada.caller,
      ),
    ).toBeUndefined();
    expect(ada.closed).toEqual({ reason: 'unknown client' });
    const back = await restarted.register({
      id: ada.id,
      name: 'ada',
      extension: { resumeToken: ada.token },
    });
    expect(back.registered).toMatchObject({ id: ada.id, extension: { resumed: true } });
    expect(back.open(ada.token)).toBe(true);
  });

  it.each(['', 'wrong', 'token-of-another'])(
    'gives a new id to a client with the token %j [CL-4]',
    async (resumeToken) => {
      const master = new TestMaster();
      const ada = await master.extension('ada');
      const other = await master.register({
        id: ada.id,
        name: 'mallory',
        extension: { resumeToken },
      });
      expect(other.id).not.toBe(ada.id);
      expect(other.registered.extension).toMatchObject({ resumed: false });
      expect(ada.closed).toBeUndefined();
    },
  );

  it('gives a new id to a legacy client, whatever it sends [CL-4] [EC-18]', async () => {
    const master = new TestMaster();
    const ada = await master.legacy('ada');
    const again = await master.register({ ...ada.registered });
    expect(again.id).not.toBe(ada.id);
  });

  it('registers the devices that come with it [CL-5]', async () => {
    const master = new TestMaster();
    const ada = await master.legacy('ada', {
      devices: [{ name: 'pen', components: [{ topic: '/pen' }] }, { name: 'pad' }],
    });
    expect(ada.registered.devices).toMatchObject([
      {
        name: 'pen',
        clientId: ada.id,
        id: expect.stringMatching(UUID),
        components: [{ topic: '/pen' }],
      },
      { name: 'pad', clientId: ada.id },
    ]);
    const { deviceList } = await master.call({ topic: '/services/device/get_list' });
    expect(deviceList?.elements.map(({ name }) => name)).toEqual(['pen', 'pad']);
  });

  it('leaves nothing behind when one of the devices is refused [CL-5]', async () => {
    const master = new TestMaster({ limits: { componentsPerDevice: 1 } });
    await expect(
      master.register({ devices: [{ name: 'pen' }, { name: 'rig', components: [{}, {}] }] }),
    ).rejects.toThrow('componentsPerDevice');
    const { clientList } = await master.call({ topic: '/services/client/get_list' });
    const { deviceList } = await master.call({ topic: '/services/device/get_list' });
    expect([clientList?.elements, deviceList?.elements]).toEqual([[], []]);
  });

  it('answers with our extension only to those who sent it [EX-1]', async () => {
    const master = new TestMaster();
    const ada = await master.legacy('ada');
    const ben = await master.extension('ben');
    expect(ada.registered.extension).toBeUndefined();
    expect(ben.registered.extension).toMatchObject({
      recordLists: true,
      library: '',
      resumeToken: `token-of-${ben.id}`,
      resumed: false,
      masterVersion: '1.2.3',
      tellsTime: true,
      role: AccessRole.ACCESS_ROLE_ADMIN, // [AC-2]
      credential: '',
      credentialExpiresMs: 0,
    });
  });

  it.each([undefined, '', 'wrong'])(
    'closes the socket of an extension client with the token %j [EX-4]',
    async (token) => {
      const master = new TestMaster();
      const ada = await master.extension('ada');
      const { connection } = ada;
      const stranger = await master.register({ name: 'mallory' });
      stranger.registered.id = ada.id;
      expect(stranger.open(token)).toBe(false);
      expect(stranger.closed).toEqual({ reason: 'not this client' });
      expect(connection.isClosed).toBe(false);
    },
  );
});
