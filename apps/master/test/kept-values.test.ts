import { AccessRole, encodeRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import type { Limits } from '../src/index.ts';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { createGrant, join, revoke } from './access-world.ts';

const MINUTE_MS = 60_000;

async function createWorld(limits: Partial<Limits> = {}) {
  const master = new TestMaster({ limits });
  const ada = await master.extension('ada');
  const ben = await master.legacy('ben');
  const topics = async (): Promise<string[]> => {
    const { stringList } = await master.call({ topic: '/services/topic_list' });
    return stringList!.elements.filter((topic) => !/^\/(services|info)\//.test(topic));
  };
  /** The value that a new subscriber receives. */
  const valueOf = async (topic: string): Promise<unknown> => {
    const reader = await master.legacy('reader');
    await reader.subscribe({ subscribeTopics: [topic] });
    return reader.takeValues().at(-1)?.[1];
  };
  const comeBack = (client: TestClient) =>
    master.register({
      id: client.id,
      name: 'ada',
      extension: { resumeToken: client.token! },
    });
  return { master, ada, ben, topics, valueOf, comeBack };
}

function keep(client: TestClient, topic: string, value: number, keepSeconds = 600): void {
  client.sendRecords(encodeRecord({ topic, format: 'double', value, keepSeconds }));
}

const used = async (master: TestMaster, name: string): Promise<number> => {
  const { limitList } = await master.call({ topic: '/services/ubii/limit_list' });
  return limitList!.elements.find((limit) => limit.name === name)!.use!.value;
};

describe('kept values', () => {
  it('outlive a client that leaves or is lost, until their time is over [TD-43]', async () => {
    const { master, ada, topics, valueOf } = await createWorld();
    keep(ada, '/light', 0.5);
    ada.publish('/pulse', 'double', 1);
    const eva = await master.extension('eva');
    keep(eva, '/eva', 2);
    ada.drop('left');
    eva.drop();
    master.clock.advanceSync(11_000);
    expect(await topics()).toEqual(['/light', '/eva']);
    expect(await valueOf('/light')).toBe(0.5);
    master.clock.advanceSync(9 * MINUTE_MS);
    expect(await valueOf('/eva')).toBe(2);
    master.clock.advanceSync(MINUTE_MS + 1_000);
    expect(await topics()).toEqual([]);
  });

  it('stay for keepMs at most, and not at all after a newer record that asks for nothing [TD-43]', async () => {
    const { master, ada, ben, topics } = await createWorld({ keepMs: MINUTE_MS });
    keep(ada, '/long', 1, 1_000_000);
    keep(ada, '/never', 1, -5);
    keep(ada, '/taken back', 1);
    ada.publish('/taken back', 'double', 2);
    keep(ada, '/by another', 1);
    ben.publish('/by another', 'double', 2);
    ada.drop('left');
    expect(await topics()).toEqual(['/long']);
    master.clock.advanceSync(MINUTE_MS + 500);
    expect(await topics()).toEqual([]);
  });

  it('end with the device that publishes them [TD-43]', async () => {
    const { ada, topics } = await createWorld();
    const { device } = await ada.call({
      topic: '/services/device/registration',
      device: { clientId: ada.id, components: [{ topic: '/pen', ioType: 0 }] },
    });
    keep(ada, '/pen', 1);
    await ada.call({ topic: '/services/device/deregistration', device: device! });
    expect(await topics()).toEqual([]);
  });

  it('belong to their client again when it comes back [TD-45]', async () => {
    const { master, ada, topics, comeBack } = await createWorld();
    keep(ada, '/light', 0.5);
    ada.drop('left');
    master.clock.advanceSync(9 * MINUTE_MS);
    const again = await comeBack(ada);
    again.open();
    for (let i = 0; i < 20; i++) {
      master.clock.advanceSync(4_000);
      again.sendText('PONG');
    }
    expect(await topics()).toEqual(['/light']);
    again.publish('/light', 'double', 0.6);
    again.drop('left');
    expect(await topics()).toEqual([]);
  });

  it('belong to a client that publishes on their topic meanwhile [TD-19]', async () => {
    const { master, ada, ben, topics, comeBack, valueOf } = await createWorld();
    keep(ada, '/light', 0.5);
    ada.drop('left');
    ben.publish('/light', 'double', 0.7);
    master.clock.advanceSync(0);
    const again = await comeBack(ada);
    again.open();
    again.drop('left');
    expect(await valueOf('/light')).toBe(0.7);
    await ben.call({ topic: '/services/client/deregistration', client: { id: ben.id } });
    expect(await topics()).toEqual([]);
  });

  it('are forwarded to existing clients as ordinary records [TD-11]', async () => {
    const { ada, ben } = await createWorld();
    await ben.subscribe({ subscribeTopics: ['/light'] });
    keep(ada, '/light', 0.5);
    ada.publish('/light', 'double', 0.6);
    expect(ben.takeValues()).toEqual([
      ['/light', 0.5],
      ['/light', 0.6],
    ]);
  });

  it('count for the share of their invitation until they end [TD-44]', async () => {
    const { master } = await createWorld({ topics: 160, topicsPerPlayer: 20 });
    const { token } = await createGrant(master, AccessRole.ACCESS_ROLE_PLAYER);
    const before = await used(master, 'topics');
    const bytesBefore = await used(master, 'retainedBytes');
    let kept = 0;
    for (let i = 0; i < 5; i++) {
      const player = await join(master, token);
      for (let n = 0; n < 15; n++) keep(player, `/${player.id}/${n}`, n);
      kept += 15 - player.takeErrors().length;
      player.drop('left');
    }
    // Older kept values made room: none of these publications was refused
    expect(kept).toBe(75);
    expect((await used(master, 'topics')) - before).toBe(40);
    const other = await join(
      master,
      (await createGrant(master, AccessRole.ACCESS_ROLE_PLAYER)).token,
    );
    for (let n = 0; n < 20; n++) other.publish(`/${other.id}/${n}`, 'double', n);
    expect(other.takeErrors()).toEqual([]);
    other.drop('left');
    master.clock.advanceSync(11 * MINUTE_MS);
    expect(await used(master, 'topics')).toBe(before);
    expect(await used(master, 'retainedBytes')).toBe(bytesBefore);
  });

  it('give their bytes back when their share needs them [TD-44]', async () => {
    const { master, ada, topics } = await createWorld({ retainedBytes: 4_000 });
    const big = 'x'.repeat(1_500);
    for (const topic of ['/a', '/b']) {
      ada.sendRecords(encodeRecord({ topic, format: 'string', value: big, keepSeconds: 600 }));
    }
    ada.drop('left');
    const eva = await master.extension('eva');
    eva.publish('/c', 'string', big);
    expect(eva.takeErrors()).toEqual([]);
    expect(await topics()).toEqual(['/b', '/c']);
    eva.publish('/b', 'string', big);
    expect(eva.takeErrors()).toEqual([]);
    eva.publish('/d', 'string', big);
    expect(eva.takeErrors()).toHaveLength(1);
  });

  it('end when their client was disconnected or its invitation is revoked [TD-46]', async () => {
    const { master, ada, ben, topics } = await createWorld();
    keep(ada, '/light', 0.5);
    await master.call({
      topic: '/services/ubii/client_disconnect',
      clientDisconnectRequest: { clientId: ben.id, targetId: ada.id, reason: 'over' },
    });
    expect(await topics()).toEqual([]);
    const { token, grant } = await createGrant(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const eva = await join(master, token);
    keep(eva, '/light', 0.5);
    eva.drop('left');
    expect(await topics()).toEqual(['/light']);
    await revoke(master, grant!.id);
    expect(await topics()).toEqual([]);
  });
});
