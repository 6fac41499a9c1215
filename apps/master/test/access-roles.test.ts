import { AccessRole, ComponentIOType, DeviceType, FAREWELL_TOPIC, SERVICES } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { codeOf, createGrant, join, joinAs } from './access-world.ts';

const { ACCESS_ROLE_ADMIN, ACCESS_ROLE_PARTICIPANT, ACCESS_ROLE_PLAYER, ACCESS_ROLE_VIEWER } =
  AccessRole;
/** The code with which a record is refused; empty when it is published. */
function published(client: TestClient, topic: string): string {
  client.takeErrors();
  client.publish(topic, 'double', 1);
  return client.takeErrors()[0]?.code ?? '';
}

describe('services by role [AC-21]', () => {
  it('let participants neither see nor make invitations, nor read the log', async () => {
    const client = await joinAs(new TestMaster(), ACCESS_ROLE_PARTICIPANT);
    const grants = [
      '/services/ubii/access_grant_list',
      '/services/ubii/log_tail',
      '/services/ubii/setting_list',
    ];
    for (const topic of grants) expect(await codeOf(client, { topic })).toBe('permission_denied');
    const create = {
      topic: '/services/ubii/access_grant_create',
      accessGrantCreateRequest: { role: ACCESS_ROLE_ADMIN },
    };
    expect(await codeOf(client, create)).toBe('permission_denied');
  });
});

describe('publishing [AC-24]', () => {
  it('admins that joined publish everywhere but where only the master does', async () => {
    const master = new TestMaster();
    const ada = await joinAs(master, ACCESS_ROLE_ADMIN);
    const other = await joinAs(master, ACCESS_ROLE_PLAYER);
    expect(published(ada, '/anything')).toBe('');
    expect(published(ada, `/${other.id}/x`)).toBe('');
    expect(published(ada, '/info/x')).toBe('permission_denied');
  });

  it('participants leave the namespaces of others alone, but for what these listen to', async () => {
    const master = new TestMaster();
    const ben = await joinAs(master, ACCESS_ROLE_PARTICIPANT);
    const phone = await joinAs(master, ACCESS_ROLE_PLAYER);
    expect(published(ben, '/shared/x')).toBe('');
    expect(published(ben, 'x')).toBe('');
    expect(published(ben, `/${ben.id}/x`)).toBe('');
    expect(published(ben, `${ben.id}/orientation`)).toBe('');
    expect(published(ben, `${phone.id}/orientation`)).toBe('permission_denied');
    expect(published(ben, `/${phone.id}/pad/touch`)).toBe('permission_denied');
    expect(published(ben, `/${phone.id}/identify`)).toBe('');
    expect(published(ben, `/${phone.id}/pad/vibrate`)).toBe('permission_denied');
    const device = (components: object[]) => ({ clientId: phone.id, name: 'pad', components });
    const vibrate = { topic: `/${phone.id}/pad/vibrate`, ioType: ComponentIOType.SUBSCRIBER };
    await phone.call({ topic: '/services/device/registration', device: device([vibrate]) });
    expect(published(ben, `/${phone.id}/pad/vibrate`)).toBe('');
    // A component of another client gives no right.
    const spy = { topic: `/${phone.id}/pad/touch`, ioType: ComponentIOType.SUBSCRIBER };
    await ben.call({
      topic: '/services/device/registration',
      device: { clientId: ben.id, name: 'spy', components: [spy] },
    });
    expect(published(ben, `/${phone.id}/pad/touch`)).toBe('permission_denied');
    // Nor can it claim to be the one who publishes there.
    const mask = { topic: `/${phone.id}/pad/touch`, ioType: ComponentIOType.PUBLISHER };
    expect(
      await codeOf(ben, {
        topic: '/services/device/registration',
        device: { clientId: ben.id, name: 'mask', components: [mask] },
      }),
    ).toBe('permission_denied');
  });

  it('players publish on their own topics and those of their invitation', async () => {
    const master = new TestMaster();
    const ada = await master.extension('ada');
    await ada.subscribe({ subscribeTopicRegexp: ['.*'] });
    const player = await joinAs(master, ACCESS_ROLE_PLAYER, { writeTopics: ['/game/*/move'] });
    expect(published(player, `/${player.id}/pad/touch`)).toBe('');
    expect(published(player, `${player.id}/orientation`)).toBe('');
    expect(published(player, '/game/1/move')).toBe('');
    const refused = [
      '/game/1/state',
      '/game/1/2/move',
      'x/game/1/move',
      '/shared',
      `/${ada.id}/x`,
      `/${ada.id}/identify`,
      `/${player.id}`,
      player.id,
      `${ada.id}/orientation`,
      `//${player.id}/x`,
      'removeClient',
      `/${player.id}x/x`,
      `/${player.id.toUpperCase()}y/x`,
      '/info/device/new',
      `/ubii/client/${player.id}`,
    ];
    for (const topic of refused) {
      master.clock.advanceSync(200); // Errors are told at a rate.
      expect([topic, published(player, topic)]).toEqual([topic, 'permission_denied']);
    }
    expect(ada.takeRecords().map(({ topic }) => topic)).toEqual([
      `/${player.id}/pad/touch`,
      `${player.id}/orientation`,
      '/game/1/move',
    ]);
    const report = await master.call({
      topic: '/services/ubii/client_report',
      clientReportRequest: { clientIds: [player.id] },
    });
    expect(report.clientReport?.clients[0]?.refused).toBe(refused.length);
  });

  it('players can publish only that they have left themselves, as controllers do', async () => {
    const master = new TestMaster();
    const game = await master.extension('game');
    await game.subscribe({ subscribeTopics: [FAREWELL_TOPIC] });
    const [player, viewer] = [
      await joinAs(master, ACCESS_ROLE_PLAYER),
      await joinAs(master, ACCESS_ROLE_VIEWER),
    ];
    const says = (client: TestClient, format: 'string' | 'double', value: string | number) => {
      master.clock.advanceSync(200); // Errors are told at a rate.
      client.takeErrors();
      client.publish(FAREWELL_TOPIC, format, value);
      return client.takeErrors()[0]?.code ?? '';
    };
    expect(says(player, 'string', player.id)).toBe('');
    expect(says(player, 'string', game.id)).toBe('permission_denied');
    expect(says(player, 'string', '')).toBe('permission_denied');
    expect(says(player, 'double', 1)).toBe('permission_denied');
    expect(says(viewer, 'string', viewer.id)).toBe('permission_denied');
    expect(published(player, `/${FAREWELL_TOPIC}`)).toBe('permission_denied');
    expect(game.takeValues()).toEqual([[FAREWELL_TOPIC, player.id]]);
  });

  it('viewers publish what their preflight found, and nothing else [AC-30]', async () => {
    const viewer = await joinAs(new TestMaster(), ACCESS_ROLE_VIEWER);
    expect(published(viewer, `/${viewer.id}/preflight`)).toBe('');
    for (const topic of ['/x', `/${viewer.id}/x`, `${viewer.id}/preflight`, '/other/preflight']) {
      expect([topic, published(viewer, topic)]).toEqual([topic, 'permission_denied']);
    }
  });
});

describe('subscribing [AC-25]', () => {
  async function setup() {
    const master = new TestMaster();
    const ada = await master.extension('ada');
    const { token } = await createGrant(master, ACCESS_ROLE_PLAYER, { readTopics: ['/game/**'] });
    const player = await join(master, token);
    player.takeSent();
    return { master, ada, player };
  }

  it('players subscribe to no topics of others', async () => {
    const { ada, player } = await setup();
    ada.publish('/secret', 'double', 1);
    for (const topic of ['/secret', `/${ada.id}/x`, `/ubii/client/${ada.id}`, '/info/device/new']) {
      await expect(player.subscribe({ subscribeTopics: [topic] })).rejects.toThrow(
        'permission_denied',
      );
    }
    const own = [`/${player.id}/x`, `/ubii/client/${player.id}`, '/game/a/b'];
    await player.subscribe({ subscribeTopics: own });
    ada.publish('/game/a/b', 'double', 2);
    ada.publish('/secret', 'double', 3);
    expect(player.takeValues().filter(([topic]) => topic !== own[1])).toEqual([['/game/a/b', 2]]);
  });

  it('expressions, profiles and watchers of players bring what they may read: now, retained and later', async () => {
    const { master, ada, player } = await setup();
    ada.publish('/secret', 'double', 1);
    ada.publish('/game/a', 'double', 2);
    const device = {
      clientId: ada.id,
      name: 'd',
      components: [
        { topic: '/secret', tags: ['all'] },
        { topic: '/game/a', tags: ['all'] },
      ],
    };
    await ada.call({ topic: '/services/device/registration', device });
    await player.subscribe({ subscribeTopicRegexp: ['.*', '^/secret', '^/ubii/.*', '^/info/'] });
    await player.subscribe({ subscribeComponents: [{ tags: ['all'] }, {}] });
    await player.call({
      topic: '/services/device/registration',
      device: { clientId: player.id, name: 'w', deviceType: DeviceType.WATCHER },
    });
    for (let i = 0; i < 2; i++) {
      ada.publish('/secret', 'double', 3);
      ada.publish(`/secret/${i}`, 'double', 4);
      ada.publish('/game/a', 'double', 5);
      ada.publish(`/game/${i}`, 'double', 6);
      player.drop();
      ada.publish('/secret', 'double', 7);
      ada.publish('/secret/new', 'double', 7);
      expect(player.open()).toBe(true);
      // A component that comes later brings the retained record of its topic.
      const late = {
        clientId: ada.id,
        name: `l${i}`,
        components: [{ topic: '/secret', tags: ['all'] }],
      };
      await ada.call({ topic: '/services/device/registration', device: late });
    }
    master.clock.advanceSync(100);
    const topics = new Set(player.takeRecords().map(({ topic }) => topic));
    expect([...topics].filter((topic) => !topic.startsWith('/game/')).sort()).toEqual([
      `/ubii/client/${player.id}`,
    ]);
    expect(topics.has('/game/a')).toBe(true);
  });

  it('others do not lose anything by it', async () => {
    const { ada, player } = await setup();
    await ada.subscribe({ subscribeTopicRegexp: ['.*'] });
    await player.subscribe({ subscribeTopicRegexp: ['.*'] });
    ada.publish('/secret', 'double', 1);
    expect(ada.takeValues()).toEqual([['/secret', 1]]);
    expect(player.takeValues()).toEqual([]);
  });

  it('a client whose role changes keeps no more than it may read', async () => {
    const master = new TestMaster();
    const ada = await master.extension('ada');
    const phone = await joinAs(master, ACCESS_ROLE_VIEWER);
    await phone.subscribe({ subscribeTopics: ['/a'], subscribeTopicRegexp: ['^/b'] });
    const player = await createGrant(master, ACCESS_ROLE_PLAYER);
    await master.register(
      { name: 'phone', id: phone.id, extension: { resumeToken: phone.token! } },
      { ...phone.caller, bearer: player.token },
    );
    phone.takeSent();
    ada.publish('/a', 'double', 1);
    ada.publish('/b', 'double', 1);
    expect(phone.takeValues()).toEqual([]);
    expect(published(phone, '/a')).toBe('permission_denied');
  });

  it('another invitation of the same role brings its own topics, and takes the others [AC-18]', async () => {
    const master = new TestMaster();
    const ada = await master.extension('ada');
    const player = await joinAs(master, ACCESS_ROLE_PLAYER, {
      readTopics: ['/red/**'],
      writeTopics: ['/red/move'],
    });
    await player.subscribe({ subscribeTopics: ['/red/a'], subscribeTopicRegexp: ['^/blue'] });
    const blue = await createGrant(master, ACCESS_ROLE_PLAYER, {
      readTopics: ['/blue/**'],
      writeTopics: ['/blue/move'],
    });
    const again = { name: 'phone', id: player.id, extension: { resumeToken: player.token! } };
    const { token } = blue;
    await master.register(again, { ...player.caller, bearer: token });
    player.takeSent();
    ada.publish('/red/a', 'double', 1);
    ada.publish('/blue/a', 'double', 2);
    expect(player.takeValues()).toEqual([['/blue/a', 2]]);
    expect(published(player, '/blue/move')).toBe('');
    expect(published(player, '/red/move')).toBe('permission_denied');
    const list = await master.call({ topic: '/services/ubii/access_grant_list' });
    const now = list.accessGrantList?.elements.find(({ id }) => id === blue.grant!.id);
    expect(now).toMatchObject({ joins: 1, clientIds: [player.id] });
  });

  it('players see no lists: of topics, clients, devices, components, counters', async () => {
    const { player } = await setup();
    const topics = [
      SERVICES.topicList.topic,
      SERVICES.clientGetList.topic,
      SERVICES.deviceGetList.topic,
      SERVICES.componentGetList.topic,
      SERVICES.latencyClientsList.topic,
    ];
    for (const topic of topics) expect(await codeOf(player, { topic })).toBe('permission_denied');
    const { topicStatistics, clientReport } = SERVICES;
    expect(await codeOf(player, { topic: topicStatistics.topic, topicStatisticsRequest: {} })).toBe(
      'permission_denied',
    );
    expect(await codeOf(player, { topic: clientReport.topic, clientReportRequest: {} })).toBe(
      'permission_denied',
    );
  });
});

describe('devices, nodes and modules [AC-26]', () => {
  it('components of players are theirs', async () => {
    const master = new TestMaster();
    const player = await joinAs(master, ACCESS_ROLE_PLAYER);
    const register = (component: object) =>
      codeOf(player, {
        topic: '/services/device/registration',
        device: { clientId: player.id, name: 'd', components: [component] },
      });
    const { SUBSCRIBER } = ComponentIOType;
    expect(await register({ topic: `/${player.id}/d/touch` })).toBe('');
    // As the smart device has it.
    expect(await register({ topic: `${player.id}/orientation` })).toBe('');
    expect(await register({ topic: 'x/orientation' })).toBe('permission_denied');
    expect(await register({ topic: `/${player.id}/d/vibrate`, ioType: SUBSCRIBER })).toBe('');
    expect(await register({ topic: '/secret' })).toBe('permission_denied');
    expect(await register({ topic: '/secret', ioType: SUBSCRIBER })).toBe('permission_denied');
  });

  it('are not admitted by the registration of a client either', async () => {
    const master = new TestMaster();
    const admit = async (role: AccessRole, client: object) => {
      const { token } = await createGrant(master, role);
      const reply = await master.call(
        { topic: '/services/client/registration', client: { name: 'x', extension: {}, ...client } },
        { standing: 'other', isHere: false, place: '', bearer: token },
      );
      return reply.error?.code ?? '';
    };
    const device = { name: 'd', components: [{ topic: '/secret' }] };
    expect(await admit(ACCESS_ROLE_PLAYER, { devices: [device] })).toBe('permission_denied');
    expect(await admit(ACCESS_ROLE_VIEWER, { devices: [{ name: 'd' }] })).toBe('permission_denied');
    for (const role of [ACCESS_ROLE_PLAYER, ACCESS_ROLE_VIEWER]) {
      expect(await admit(role, { extension: { node: {} } })).toBe('permission_denied');
      expect(await admit(role, { isDedicatedProcessingNode: true })).toBe('permission_denied');
      expect(await admit(role, { processingModules: [{ name: 'm' }] })).toBe('permission_denied');
    }
    expect(await admit(ACCESS_ROLE_PARTICIPANT, { extension: { node: {} } })).toBe('');
    const { clientList } = await master.call({ topic: '/services/client/get_list' });
    expect(clientList?.elements).toHaveLength(1);
  });
});
