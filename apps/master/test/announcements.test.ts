import { AccessRole, ClientState } from '@ubii/proto';
import type { Client, Device, ErrorMessage, Init } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { joinAs } from './access-world.ts';

/** Components that take some 3.5 MB together. */
const LARGE = Array.from({ length: 900 }, (_, i) => ({
  name: `component ${i}`,
  topic: `/large/${i}`,
  description: 'd'.repeat(3_900),
}));

const sentBytes = (watcher: TestClient): number =>
  watcher.takeSent().reduce((sum, sent) => {
    if (sent.kind === 'record') return sum + sent.record.byteLength;
    if (sent.kind !== 'list') return sum;
    return sum + sent.records.reduce((bytes, { byteLength }) => bytes + byteLength, 0);
  }, 0);

async function createRoom(options: ConstructorParameters<typeof TestMaster>[0] = {}) {
  const master = new TestMaster(options);
  const watcher = await master.extension('watcher');
  await watcher.subscribe({ subscribeTopicRegexp: ['^/ubii/client/', '^/info/'] });
  const ada = await master.extension('ada');
  watcher.takeSent();
  const device = (device: Init<Device>) =>
    ada.call({
      topic: '/services/device/registration',
      device: { clientId: ada.id, ...device },
    });
  const register = (client: Init<Client>) =>
    master.call({
      topic: '/services/client/registration',
      client: { id: ada.id, extension: { resumeToken: ada.token! }, ...client },
    });
  return { master, watcher, ada, device, register };
}

describe('announcements', () => {
  it('of a client with a device of 3.5 MB are no larger for it [EX-74]', async () => {
    const { watcher, device, register } = await createRoom();
    expect((await device({ name: 'large', components: LARGE })).error).toBeUndefined();
    const registered = sentBytes(watcher);
    expect(registered).toBeGreaterThan(3_500_000); // the device itself, once
    expect(registered).toBeLessThan(4_200_000);
    for (let i = 0; i < 60; i++) await register({ name: `ada ${i}` });
    expect(sentBytes(watcher)).toBeLessThan(60 * 150 * 2);
  });

  it('of a client come no faster than its pace, and the last state always comes [EX-75]', async () => {
    const { master, watcher, ada, device, register } = await createRoom();
    for (let i = 0; i < 20; i++) {
      await device({
        name: `d${i}`,
        components: [{ topic: `/${i}`, description: 'x'.repeat(150) }],
      });
    }
    sentBytes(watcher);
    for (let i = 0; i < 200; i++) await register({ name: `ada ${i}` });
    master.clock.advanceSync(1_000);
    expect(sentBytes(watcher)).toBeLessThan(64 * 1024);
    for (let i = 0; i < 60; i++) {
      for (let j = 0; j < 20; j++) await register({ name: `eve ${i} ${j}` });
      master.clock.advanceSync(1_000);
    }
    const bytes = sentBytes(watcher);
    expect(bytes).toBeLessThan(61 * 16 * 1024);
    await register({ name: 'the last' });
    master.clock.advanceSync(3_000);
    const news = watcher.takeRecords().filter(({ topic }) => topic === `/ubii/client/${ada.id}`);
    expect(news.at(-1)).toMatchObject({ value: { name: 'the last', state: ClientState.ACTIVE } });
    expect(news.filter(({ value }) => (value as Client).name === 'the last')).toHaveLength(1);
  });

  it('come at once for a client that is small and changes now and then [EX-75]', async () => {
    const { watcher, register } = await createRoom();
    for (const name of ['a', 'b', 'c', 'd']) {
      await register({ name });
      expect(watcher.takeRecords()).toMatchObject([{ value: { name } }]);
    }
  });

  it('do not come when a client or device registers again as it is [EX-76]', async () => {
    const { watcher, device, register } = await createRoom();
    const pen = { name: 'pen', components: [{ topic: '/pen', name: 'tip' }] };
    const { device: registered } = await device(pen);
    await register({ name: 'ada' });
    watcher.takeSent();
    const again = await device({ ...pen, id: registered!.id });
    expect(again.device).toEqual(registered);
    expect((await device(registered!)).device).toEqual(registered);
    await register({ name: 'ada' });
    expect(watcher.takeRecords()).toEqual([]);
    await device({ ...pen, id: registered!.id, name: 'pencil' });
    expect(watcher.takeRecords().map(({ topic }) => topic)).toContain('/info/device/new');
  });

  it('of a large client say when what they leave out has changed [EX-74]', async () => {
    const { watcher, ada, device, register } = await createRoom();
    await device({ name: 'large', components: LARGE });
    const revisions = () =>
      watcher
        .takeRecords()
        .filter(({ topic }) => topic === `/ubii/client/${ada.id}`)
        .map(({ value }) => (value as Client).extension);
    const [first] = revisions();
    expect(first).toMatchObject({ abridged: true, resumeToken: '', credential: '' });
    await register({ name: 'eve' });
    await register({ name: 'eve', description: 'new' });
    await device({ name: 'small' });
    const [second, third, fourth] = revisions().map((extension) => extension!.registrationRevision);
    expect(third).toBeGreaterThan(second!);
    expect(fourth).toBeGreaterThan(third!);
  });

  it('are short while their client is away, and whole when it is back [EX-74] [CL-17]', async () => {
    const { master, watcher, ada, device } = await createRoom();
    await device({ name: 'phone', description: 'p'.repeat(600) });
    const newest = () =>
      watcher
        .takeRecords()
        .filter(({ topic }) => topic === `/ubii/client/${ada.id}`)
        .map(({ value }) => value as Client)
        .at(-1);
    expect(newest()?.devices).toHaveLength(1);
    ada.drop();
    master.clock.advanceSync(15_000);
    expect(newest()).toMatchObject({
      state: ClientState.UNAVAILABLE,
      devices: [],
      extension: { abridged: true },
    });
    ada.open();
    expect(newest()).toMatchObject({ state: ClientState.ACTIVE, devices: [{ name: 'phone' }] });
  });

  it('of changes of a session come no faster than its pace, and the last state always comes [EX-75]', async () => {
    const { master, watcher } = await createRoom();
    const editorJson = 'e'.repeat(2_000_000);
    const session = {
      name: 'large',
      processingModules: [{ name: 'm', onProcessingStringified: '() => ({})' }],
      extension: { editorJson },
    };
    const { session: added } = await master.call({
      topic: '/services/session/runtime/add',
      session,
    });
    sentBytes(watcher);
    for (let i = 0; i < 100; i++) {
      const { error } = await master.call({
        topic: '/services/session/runtime/update',
        session: {
          ...added!,
          description: `${i}`,
          extension: { ...added!.extension!, revision: 0 },
        },
      });
      expect(error).toBeUndefined();
    }
    master.clock.advanceSync(10_000);
    const changes = watcher
      .takeRecords()
      .filter(({ topic }) => topic === '/info/session/change')
      .map(({ value }) => (value as { description: string }).description);
    expect(changes.length).toBeLessThan(8);
    expect(changes.at(-1)).toBe('99');
  });

  it('of sessions that start are as many as those who start them may have, each for themselves [EX-77]', async () => {
    const { master, watcher } = await createRoom();
    const guest = await joinAs(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const other = await joinAs(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const session = {
      name: 'large',
      processingModules: [{ name: 'm', onProcessingStringified: '() => ({})' }],
      extension: { editorJson: 'e'.repeat(4_000_000) },
    };
    const added = await guest.call({ topic: '/services/session/runtime/add', session });
    const { id } = added.session!;
    const start = (client: TestClient) =>
      client.call({ topic: '/services/session/runtime/start', session: { id } });
    const stop = async () => {
      await guest.call({ topic: '/services/session/runtime/stop', session: { id } });
      await master.pass(100);
    };
    sentBytes(watcher);
    let error: ErrorMessage | undefined;
    let starts = 0;
    for (; starts < 100 && error === undefined; starts++) {
      ({ error } = await start(guest));
      await stop();
    }
    expect(error).toMatchObject({ code: 'resource_exhausted' });
    expect(error!.message).toMatch(/limit sessionStartBytesPerSecond\)\. Try again in \d+ s\.$/);
    expect(starts).toBeLessThan(15);
    expect(sentBytes(watcher)).toBeLessThan(3 * (32 + 4 + 4) * 1024 * 1024);
    expect((await start(other)).error).toBeUndefined();
    await stop();
    master.clock.advanceSync(10_000);
    expect((await start(guest)).error).toBeUndefined();
  });

  it('end with the client and with the master: no timer is left [EX-75]', async () => {
    const { master, watcher, ada, register } = await createRoom();
    for (let i = 0; i < 2_000; i++) await register({ name: `ada ${i}` });
    await master.call({ topic: '/services/client/deregistration', client: { id: ada.id } });
    const news = watcher.takeRecords().filter(({ topic }) => topic === `/ubii/client/${ada.id}`);
    expect(news.at(-1)).toMatchObject({
      value: { name: 'ada 1999', state: ClientState.UNAVAILABLE },
    });
    master.clock.advanceSync(60_000);
    expect(watcher.takeRecords().map(({ topic }) => topic)).not.toContain(`/ubii/client/${ada.id}`);
  });
});
