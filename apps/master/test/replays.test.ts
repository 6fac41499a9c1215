import { decodeRecord, ReplayAction, ReplayState, REPLAYS_TOPIC } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';
import { start as record, stop as stopRecording } from './recording-world.ts';
import {
  at,
  change,
  clientList,
  folderWith,
  heard,
  ledger,
  list,
  listener,
  masterWith,
  play,
  RECORDING,
  RECORDS,
  stop,
} from './replay-world.ts';

/** Topics and times of the records. */
const VALUES = RECORDS.map(({ topic, logTimeNs }) => [
  topic,
  Number(logTimeNs - RECORDS[0]!.logTimeNs) / 1e6,
]);

const { REPLAY_STATE_PLAYING, REPLAY_STATE_ENDED } = ReplayState;
const { REPLAY_ACTION_PLAY } = ReplayAction;

describe('a replay', () => {
  it('[RP-1] [RP-2] plays a recording into live topics as a client, until its end', async () => {
    const master = await masterWith();
    const ada = await listener(master);
    const replay = await play(master);
    expect(replay).toMatchObject({
      name: 'Replay of Tuesday',
      recordingName: 'Tuesday',
      recordingId: RECORDING,
      state: REPLAY_STATE_PLAYING,
      durationMs: 1_000,
      rate: 1,
      copies: 1,
      topicCount: 1,
    });
    expect(await clientList(master)).toContainEqual({
      name: 'Replay of Tuesday',
      tags: ['replay'],
    });
    await master.pass(1_100);
    expect(heard(ada)).toEqual(VALUES);
    const [ended] = await list(master);
    expect(ended).toMatchObject({
      state: REPLAY_STATE_ENDED,
      positionMs: 1_000,
      recordCount: VALUES.length,
      topicCount: 2,
      clientIds: [replay.clientIds[0]],
      problem: '',
      refusedCount: 0,
    });
  });

  it('[RP-6] gives back everything when it stops', async () => {
    const master = await masterWith();
    const before = await ledger(master);
    const { id } = await play(master);
    await master.pass(300);
    expect(await stop(master, id)).toBe(undefined);
    await master.pass(10_000);
    expect(await list(master)).toEqual([]);
    expect(await ledger(master)).toEqual(before);
    expect(await stop(master, id)).toBe('not_found');
  });

  it('[RP-10] publishes records bit for bit, or with the time of the replay', async () => {
    const master = await masterWith();
    const ada = await master.extension('ada');
    await ada.subscribe({ subscribeTopics: ['/a'] });
    const first = await play(master, { keepsTimestamps: true, isPaused: true });
    const [sent] = ada.takeSent();
    expect(sent).toEqual({ kind: 'record', record: RECORDS[0]!.record });
    await stop(master, first.id);
    ada.takeSent();
    await play(master, { isPaused: true });
    const [now] = ada.takeRecords();
    expect(now).toEqual({
      ...decodeRecord(RECORDS[0]!.record),
      timestampMs: master.clock.nowMs(),
    });
  });

  it('[RP-14] takes longer when more is due than it may publish, and loses nothing', async () => {
    const records = Array.from({ length: 3_000 }, (_, index) => at('/fast', 1, index));
    const master = await masterWith([at('/fast', 0, -1), ...records], {
      limits: { replayRecordsPerSecond: 1_000 },
    });
    await play(master);
    await master.pass(1_000);
    const [halfway] = await list(master);
    expect(halfway!.recordCount).toBeLessThan(2_500);
    await master.pass(3_000);
    expect((await list(master))[0]!.recordCount).toBe(3_001);
  });

  it('[RP-7] is published when it changes, and while it plays', async () => {
    const master = await masterWith();
    const ada = await master.extension('ada');
    await ada.subscribe({ subscribeTopics: [REPLAYS_TOPIC] });
    const { id } = await play(master);
    await master.pass(1_000);
    await change(master, { id, action: REPLAY_ACTION_PLAY, rate: 2 });
    await stop(master, id);
    await master.pass(300);
    const lists = ada
      .takeRecords()
      .flatMap(({ format, value }) => (format === 'replayList' ? [value.elements] : []));
    expect(lists.length).toBeGreaterThan(4);
    expect(lists.length).toBeLessThan(9);
    const positions = lists.flatMap(([replay]) => (replay ? [replay.positionMs] : []));
    expect(positions.filter((ms) => ms > 0 && ms < 1_000).length).toBeGreaterThan(2);
    expect(lists.at(-1)).toEqual([]);
  });
});

describe('two replays', () => {
  it('[RP-1] of two masters play the same file without mixing', async () => {
    const recordings = await folderWith();
    const masters = [new TestMaster({ recordings }), new TestMaster({ recordings })] as const;
    const listeners = [await listener(masters[0]), await listener(masters[1])] as const;
    await play(masters[0]);
    await play(masters[1], { rate: 0.5, renames: [{ fromPrefix: '', toPrefix: '/two' }] });
    for (let ms = 0; ms < 1_100; ms += 10) {
      await masters[0].pass(10);
      await masters[1].pass(10);
    }
    expect(heard(listeners[0])).toEqual(VALUES);
    expect(heard(listeners[1])).toEqual(
      VALUES.slice(0, 7).map(([topic, value]) => [`/two${topic}`, value]),
    );
    await stop(masters[0], (await list(masters[0]))[0]!.id);
    await masters[1].pass(1_000);
    expect(heard(listeners[1])).toEqual(
      VALUES.slice(7).map(([topic, value]) => [`/two${topic}`, value]),
    );
  });

  it('[RP-1] of one master: what one plays is recorded and played by the other', async () => {
    const master = await masterWith();
    const recordingId = await record(master);
    const first = await play(master);
    await master.pass(1_100);
    await stopRecording(master, recordingId);
    const ada = await listener(master);
    await play(master, { recordingId, renames: [{ fromPrefix: '', toPrefix: '/again' }] });
    await change(master, { id: first.id, action: REPLAY_ACTION_PLAY });
    await master.pass(1_300);
    const values = heard(ada);
    const again = values.filter(([topic]) => topic.startsWith('/again'));
    expect(again.map(([topic, value]) => [topic.slice('/again'.length), value])).toEqual(VALUES);
    expect(values.filter(([topic]) => !topic.startsWith('/again'))).toEqual(VALUES);
  });
});
