import { AccessRole, ReplayConflict, REPLAYS_TOPIC } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { DEFAULT_LIMITS } from '../src/core/limits/index.ts';
import type { TestClient, TestMaster } from '../src/testing/index.ts';
import { joinAs } from './access-world.ts';
import {
  at,
  heard,
  list,
  listener,
  makerOfRecording,
  masterWith,
  play,
  stop,
} from './replay-world.ts';

const { REPLAY_CONFLICT_MOVE_LIVE: MOVE_LIVE } = ReplayConflict;

describe('live topics of a replay', () => {
  it('[RP-20] [RP-23] are muted, and flow again with their last value', async () => {
    const master = await masterWith();
    const bob = await master.extension('bob');
    bob.publish('/a', 'double', -1);
    const ada = await listener(master);
    heard(ada);
    const { id } = await play(master, { isPaused: true });
    bob.publish('/a', 'double', -2);
    bob.publish('/free', 'double', -3);
    expect(heard(ada)).toEqual([
      ['/a', 0],
      ['/free', -3],
    ]);
    expect(bob.takeErrors()).toMatchObject([
      { code: 'failed_precondition', message: expect.stringContaining('/a') as string },
    ]);
    expect((await list(master))[0]).toMatchObject({ mutedCount: 1, mutedTopics: ['/a'] });
    await stop(master, id);
    expect(heard(ada)).toEqual([['/a', -2]]);
    bob.publish('/a', 'double', -4);
    expect(heard(ada)).toEqual([['/a', -4]]);
    expect(bob.takeErrors()).toEqual([]);
  });

  it('[RP-23] get the value from before the replay when nothing came meanwhile', async () => {
    const master = await masterWith();
    const bob = await master.extension('bob');
    bob.publish('/a', 'double', -1);
    const { id } = await play(master, { isPaused: true });
    await stop(master, id);
    const ada = await master.extension('ada');
    await ada.subscribe({ subscribeTopics: ['/a'] });
    expect(ada.takeValues()).toEqual([['/a', -1]]);
  });

  it('[RP-23] get no value of a client that has left', async () => {
    const master = await masterWith();
    const bob = await master.extension('bob');
    const { id } = await play(master, { isPaused: true });
    bob.publish('/a', 'double', -1);
    bob.drop('left');
    const before = heard(await listener(master));
    await stop(master, id);
    expect(before).toEqual([]);
    expect(heard(await listener(master))).toEqual([]);
  });

  it('[RP-21] are moved below a prefix, which ends with the replay', async () => {
    const master = await masterWith();
    const bob = await master.extension('bob');
    const ada = await listener(master);
    const conflict = ReplayConflict.REPLAY_CONFLICT_MOVE_LIVE;
    const { id, livePrefix } = await play(master, { conflict, isPaused: true });
    bob.sendRecords(at('/a', 0, -1).record, at('/b', 0, -2).record, at('/a', 0, -3).record);
    master.clock.endTurnSync();
    expect(heard(ada)).toEqual([
      ['/a', 0],
      ['/live/a', -1],
      ['/b', -2],
      ['/live/a', -3],
    ]);
    expect([livePrefix, bob.takeErrors()]).toEqual(['/live', []]);
    expect((await list(master))[0]).toMatchObject({ mutedCount: 2, mutedTopics: ['/a'] });
    await stop(master, id);
    expect(heard(ada)).toEqual([['/a', -3]]);
    const late = await master.extension('late');
    await late.subscribe({ subscribeTopics: ['/live/a'] });
    expect(late.takeValues()).toEqual([]);
  });

  it.each([true, false])(
    '[RP-7] are counted in news once a second (paused: %s)',
    async (isPaused) => {
      const master = await masterWith();
      const bob = await master.extension('bob');
      await play(master, { isPaused });
      await master.pass(3_000);
      const ada = await master.extension('ada');
      await ada.subscribe({ subscribeTopics: [REPLAYS_TOPIC] });
      ada.takeRecords();
      for (let record = 0; record < 20; record++) {
        bob.publish('/a', 'double', record);
        await master.pass(100);
      }
      await master.pass(5_000);
      const counts = ada
        .takeRecords()
        .flatMap(({ format, value }) => (format === 'replayList' ? [value.elements[0]!] : []))
        .map(({ mutedCount }) => mutedCount);
      expect(counts).toEqual([10, 20]);
    },
  );

  it('[RP-22] are kept', async () => {
    const master = await masterWith();
    const bob = await master.extension('bob');
    const ada = await listener(master);
    const conflict = ReplayConflict.REPLAY_CONFLICT_KEEP_LIVE;
    await play(master, { conflict, isPaused: true });
    bob.publish('/a', 'double', -1);
    expect(heard(ada)).toEqual([
      ['/a', 0],
      ['/a', -1],
    ]);
    expect((await list(master))[0]!.mutedCount).toBe(0);
  });
});

describe('a replay of a participant', () => {
  const player = (master: TestMaster): Promise<TestClient> =>
    joinAs(master, AccessRole.ACCESS_ROLE_PLAYER);

  it('[RP-20] mutes nothing where it may not publish', async () => {
    const master = await masterWith();
    const bob = await player(master);
    const topic = `/${bob.id}/tilt`;
    const eve = await makerOfRecording(master, [at(topic, 0), at('/a', 0), at(topic, 100)]);
    const ada = await listener(master);
    await play(eve, { isPaused: true });
    bob.publish(topic, 'double', -1);
    expect(heard(ada)).toEqual([
      ['/a', 0],
      [topic, -1],
    ]);
    expect(bob.takeErrors()).toEqual([]);
  });

  it('[RP-4] [RP-20] keeps no other replay from the topics where it may not publish', async () => {
    const master = await masterWith();
    const bob = await player(master);
    const topic = `/${bob.id}/tilt`;
    const eve = await makerOfRecording(master, [at(topic, 0), at(topic, 100)]);
    await play(eve, { isPaused: true });
    const { id } = await play(master, { isPaused: true });
    bob.publish(topic, 'double', -1);
    expect(bob.takeErrors()).toMatchObject([{ code: 'failed_precondition' }]);
    await stop(master, id);
    bob.publish(topic, 'double', -2);
    expect(bob.takeErrors()).toEqual([]);
  });

  it('[RP-20] mutes nothing when there is no room for its records', async () => {
    const master = await masterWith(undefined, { limits: { topicsPerParticipant: 1 } });
    const eve = await makerOfRecording(master, [at('/a', 0), at('/b', 0), at('/a', 100)]);
    const { refusedCount } = await play(eve, { isPaused: true });
    const bob = await joinAs(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const codes = ['/a', '/b'].map((topic) => {
      bob.publish(topic, 'double', -1);
      return bob.takeErrors().map(({ code }) => code);
    });
    expect([refusedCount, codes]).toEqual([1, [['failed_precondition'], []]]);
  });

  it('[RP-44] does not mute an admin, whose value stays when it stops', async () => {
    const master = await masterWith();
    const eve = await makerOfRecording(master);
    const [admin, bob, ada] = [
      await master.extension('admin'),
      await joinAs(master, AccessRole.ACCESS_ROLE_PARTICIPANT),
      await listener(master),
    ];
    admin.publish('/a', 'double', -1);
    heard(ada);
    const { id } = await play(eve, { isPaused: true });
    admin.publish('/a', 'double', -2);
    bob.publish('/a', 'double', -3);
    expect(heard(ada)).toEqual([
      ['/a', 0],
      ['/a', -2],
    ]);
    expect([admin.takeErrors(), bob.takeErrors().length]).toEqual([[], 1]);
    await stop(eve, id);
    expect(heard(ada)).toEqual([['/a', -3]]);
    const second = await play(eve, { isPaused: true });
    admin.publish('/a', 'double', -4);
    await stop(eve, second.id);
    expect(heard(ada).at(-1)).toEqual(['/a', -4]);
  });

  it.each<[string, (other: TestClient) => string]>([
    ['of the master', () => '/ubii'],
    ['of the master, in `/info`', () => '/info'],
    ['of another client', ({ id }) => `/${id}`],
    ['of another client, without a slash', ({ id }) => id],
    ['with a line break', () => '/live\n'],
    ['that is too long', () => `/${'x'.repeat(DEFAULT_LIMITS.topicBytes - 1)}`],
  ])('[RP-45] moves live records to no topic %s', async (_, prefixOf) => {
    const master = await masterWith();
    const bob = await player(master);
    const eve = await makerOfRecording(master);
    const livePrefix = prefixOf(bob);
    for (const starter of [eve, master]) {
      const started = play(starter, { conflict: MOVE_LIVE, livePrefix, isPaused: true });
      await expect(started).rejects.toThrow(/invalid_argument.*live_prefix/s);
    }
    expect(await list(master)).toEqual([]);
  });

  it('[RP-45] moves live records to no topic that it plays itself', async () => {
    const master = await masterWith([at('/a', 0), at('/live/a', 0)]);
    const started = play(master, { conflict: MOVE_LIVE, isPaused: true });
    await expect(started).rejects.toThrow(/invalid_argument.*live_prefix/s);
  });

  it('[RP-45] moves live records over no value of others, which stays when it stops', async () => {
    const master = await masterWith();
    const bob = await master.extension('bob');
    const other = await master.extension('other');
    other.publish('/live/a', 'double', 7);
    const ada = await listener(master);
    const { id } = await play(master, { conflict: MOVE_LIVE, isPaused: true });
    bob.publish('/a', 'double', -1);
    expect(bob.takeErrors()).toMatchObject([{ code: 'failed_precondition' }]);
    await stop(master, id);
    expect(heard(ada).filter(([topic]) => topic === '/live/a')).toEqual([]);
    const late = await master.extension('late');
    await late.subscribe({ subscribeTopics: ['/live/a'] });
    expect(late.takeValues()).toEqual([['/live/a', 7]]);
  });

  it('[RP-45] stops moving live records to a topic that becomes that of a client', async () => {
    const master = await masterWith();
    const bob = await master.extension('bob');
    const phone = await master.extension('phone');
    const { id, token: resumeToken } = phone;
    await phone.call({ topic: '/services/client/deregistration', client: { id } });
    await play(master, { conflict: MOVE_LIVE, livePrefix: `/${id}`, isPaused: true });
    await master.register({ id, name: 'phone', extension: { resumeToken } });
    bob.publish('/a', 'double', -1);
    expect(bob.takeErrors()).toMatchObject([{ code: 'failed_precondition' }]);
  });

  it('[RP-21] [RP-45] moves live records of a player, which may not publish there itself', async () => {
    const master = await masterWith();
    const bob = await player(master);
    const topic = `/${bob.id}/tilt`;
    const ada = await listener(master);
    const files = await masterWith([at(topic, 0), at(topic, 100)]);
    for (const [id, file] of files.recordings.files) master.recordings.files.set(id, file);
    await play(master, { conflict: MOVE_LIVE, isPaused: true });
    bob.publish(topic, 'double', -1);
    expect(heard(ada)).toEqual([
      [topic, 0],
      [`/live${topic}`, -1],
    ]);
  });
});
