import { ReplayConflict, REPLAYS_TOPIC } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { at, heard, list, listener, masterWith, play, stop } from './replay-world.ts';

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
