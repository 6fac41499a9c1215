import { AccessRole, type Init, type TopicSubscription } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import type { Limits } from '../src/index.ts';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { createGrant, join, joinAs, NETWORK_CALLER, stranger } from './access-world.ts';

const { ACCESS_ROLE_PARTICIPANT, ACCESS_ROLE_PLAYER, ACCESS_ROLE_ADMIN } = AccessRole;

/** Small limits, so that they are met soon: a player may use up to 1/4 of each by one invitation. */
const LIMITS: Partial<Limits> = {
  topics: 160,
  topicsPerClient: 80,
  topicsPerParticipant: 40,
  topicsPerPlayer: 20,
  retainedBytes: 160_000,
  retainedBytesPerClient: 80_000,
  retainedBytesPerParticipant: 40_000,
  retainedBytesPerPlayer: 20_000,
  patterns: 160,
  patternsPerClient: 80,
  patternsPerParticipant: 40,
  patternsPerPlayer: 20,
  profiles: 160,
  profilesPerClient: 80,
  profilesPerPlayer: 20,
  registrationBytes: 160_000,
  registrationBytesPerClient: 80_000,
  registrationBytesPerPlayer: 20_000,
  devices: 160,
  devicesPerClient: 80,
  devicesPerPlayer: 20,
  clients: 160,
};

/** Takes one more unit of a resource for a client; resolves to whether it was granted. */
type Take = (client: TestClient, n: number) => Promise<boolean> | boolean;

function taking(subscription: (n: string) => Init<TopicSubscription>): Take {
  return async (client, n) => {
    const { error } = await client.call({
      topic: '/services/topic_subscription',
      topicSubscription: { clientId: client.id, ...subscription(`${client.id}-${n}`) },
    });
    return error === undefined;
  };
}

const TAKES: { readonly [what: string]: Take } = {
  'regular expressions': taking((n) => ({ subscribeTopicRegexp: [n] })),
  'component profiles': taking((n) => ({ subscribeComponents: [{ name: n }] })),
  'topics by publishing': (client, n) => {
    client.publish(`/${client.id}/${n}`, 'double', n);
    return client.takeErrors().length === 0;
  },
  'topics by subscribing': taking((n) => ({ subscribeTopics: [`/${n.slice(0, 36)}/${n}`] })),
  'retained bytes': (client, n) => {
    client.publish(`/${client.id}/${n}`, 'string', 'x'.repeat(900));
    return client.takeErrors().length === 0;
  },
  'registration bytes and devices': async (client, n) => {
    const { error } = await client.call({
      topic: '/services/device/registration',
      device: { clientId: client.id, name: `${n}`, description: 'x'.repeat(900) },
    });
    return error === undefined;
  },
};

/** Takes until the master refuses; how much it got. */
async function takeAll(take: Take, client: TestClient): Promise<number> {
  for (let n = 0; ; n++) if (!(await take(client, n))) return n;
}

describe.each(Object.entries(TAKES))('shares of %s [AC-80]', (_, take) => {
  it('one player cannot use up what all have, nor can others by its invitation', async () => {
    const master = new TestMaster({ limits: LIMITS });
    const { token } = await createGrant(master, ACCESS_ROLE_PLAYER, { label: 'Class 4b' });
    const taken: number[] = [];
    for (let i = 0; i < 4; i++) taken.push(await takeAll(take, await join(master, token)));
    expect(taken[0]).toBeLessThanOrEqual(20);
    expect(taken[0]).toBeGreaterThan(10);
    expect(taken.reduce((a, b) => a + b)).toBeLessThanOrEqual(40);
    const other = await joinAs(master, ACCESS_ROLE_PLAYER);
    expect(await takeAll(take, other)).toBeGreaterThan(10);
  });

  it('three participants of one invitation leave as much to others', async () => {
    const master = new TestMaster({ limits: LIMITS });
    const { token } = await createGrant(master, ACCESS_ROLE_PARTICIPANT);
    let taken = 0;
    for (let i = 0; i < 3; i++) taken += await takeAll(take, await join(master, token));
    expect(taken).toBeLessThanOrEqual(80);
    expect(taken).toBeGreaterThan(60);
    const other = await joinAs(master, ACCESS_ROLE_PARTICIPANT);
    expect(await takeAll(take, other)).toBeGreaterThan(20);
  });

  it('admins get what they need, however many others have come', async () => {
    const master = new TestMaster({ limits: LIMITS });
    for (const role of [ACCESS_ROLE_PLAYER, ACCESS_ROLE_PARTICIPANT]) {
      for (let i = 0; i < 3; i++) {
        const { token } = await createGrant(master, role);
        for (let k = 0; k < 2; k++) await takeAll(take, await join(master, token));
      }
    }
    const old = await master.register({ name: 'old' }, NETWORK_CALLER);
    old.open();
    expect(await takeAll(take, old)).toBeLessThan(10);
    const admin = await joinAs(master, ACCESS_ROLE_ADMIN);
    expect(await takeAll(take, admin)).toBeGreaterThan(5);
  });

  it('what a client used is there for others when it leaves', async () => {
    const master = new TestMaster({ limits: LIMITS });
    const { token } = await createGrant(master, ACCESS_ROLE_PLAYER);
    const taken: number[] = [];
    for (let i = 0; i < 4; i++) {
      const client = await join(master, token);
      taken.push(await takeAll(take, client));
      await client.call({
        topic: '/services/client/deregistration',
        client: { id: client.id },
      });
    }
    expect(new Set(taken.slice(1)).size).toBe(1);
    expect(taken[0]).toBeGreaterThan(10);
  });

  it('what clients that are away used is there for others of the invitation [AC-84]', async () => {
    const master = new TestMaster({ limits: LIMITS });
    const { token } = await createGrant(master, ACCESS_ROLE_PLAYER);
    const away: TestClient[] = [];
    for (let i = 0; i < 3; i++) {
      const client = await join(master, token);
      await takeAll(take, client);
      client.drop();
      away.push(client);
    }
    master.clock.advanceSync(11_000);
    expect(await takeAll(take, await join(master, token))).toBeGreaterThan(10);
    expect(await takeAll(take, await join(master, token))).toBeGreaterThan(10);
  });
});

describe('clients of one invitation [AC-80]', () => {
  it('are at most a quarter of all, when it is one to play', async () => {
    const master = new TestMaster({ limits: LIMITS });
    const { token } = await createGrant(master, ACCESS_ROLE_PLAYER, { label: 'Class 4b' });
    for (let i = 0; i < 40; i++) await join(master, token);
    await expect(join(master, token)).rejects.toThrow(
      'more than 40 clients of all clients that joined with the invitation "Class 4b", its share of 160 (limit clients, used: 40)',
    );
    await joinAs(master, ACCESS_ROLE_PLAYER);
    await joinAs(master, ACCESS_ROLE_ADMIN);
  });

  it('that are away are removed for others of theirs, and for no more privileged ones [AC-84]', async () => {
    const master = new TestMaster({ limits: { ...LIMITS, clients: 16 } });
    const host = await master.extension('host');
    const { token } = await createGrant(master, ACCESS_ROLE_PLAYER);
    for (let i = 0; i < 4; i++) (await join(master, token)).drop();
    host.drop();
    master.clock.advanceSync(11_000);
    for (let i = 0; i < 4; i++) (await join(master, token)).drop();
    expect(host.open()).toBe(true);
  });

  it('count for another invitation when they join with that [AC-18]', async () => {
    const master = new TestMaster({ limits: LIMITS });
    const { token } = await createGrant(master, ACCESS_ROLE_PLAYER);
    const phone = await join(master, token);
    expect(await takeAll(TAKES['regular expressions']!, phone)).toBe(20);
    const second = await createGrant(master, ACCESS_ROLE_PARTICIPANT);
    const { extension, id } = phone.registered;
    await master.register(
      { id, name: 'phone', extension: { resumeToken: extension!.resumeToken } },
      stranger(second.token),
    );
    expect(await takeAll(TAKES['regular expressions']!, phone)).toBe(40);
    expect(await takeAll(TAKES['regular expressions']!, await join(master, token))).toBe(20);
  });
});

describe('a class of thirty phones', () => {
  it('joins by one invitation to play, with two devices of ten components each', async () => {
    const master = new TestMaster();
    const { token } = await createGrant(master, ACCESS_ROLE_PLAYER, { label: 'Class 4b' });
    for (let i = 0; i < 30; i++) {
      const phone = await join(master, token, `phone ${i}`);
      for (const device of ['smart device', 'pad']) {
        const components = Array.from({ length: 10 }, (__, k) => ({
          name: `${k}`,
          topic: `/${phone.id}/${device}/${k}`,
          messageFormat: 'ubii.dataStructure.Vector3',
        }));
        const { error } = await phone.call({
          topic: '/services/device/registration',
          device: { clientId: phone.id, name: device, components },
        });
        expect(error).toBeUndefined();
        for (const { topic } of components) phone.publish(topic, 'vector3', { x: 1, y: 2, z: 3 });
      }
      await phone.subscribe({ subscribeTopicRegexp: [`^/${phone.id}/.*`] });
      expect(phone.takeErrors()).toEqual([]);
    }
  });
});
