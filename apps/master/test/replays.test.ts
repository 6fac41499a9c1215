import {
  AccessRole,
  decodeRecord,
  isMasterTopic,
  ReplayAction,
  ReplayConflict,
  ReplayState,
  REPLAYS_TOPIC,
  type Init,
  type ReplayStartRequest,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';
import { joinAs } from './access-world.ts';
import { start as record, stop as stopRecording } from './recording-world.ts';
import {
  at,
  change,
  folderWith,
  heard,
  list,
  listener,
  masterWith,
  play,
  RECORDING,
  RECORDS,
  stop,
} from './replay-world.ts';

const { REPLAY_STATE_PLAYING, REPLAY_STATE_PAUSED, REPLAY_STATE_ENDED } = ReplayState;
const { REPLAY_ACTION_PLAY, REPLAY_ACTION_PAUSE } = ReplayAction;
const VALUES = RECORDS.map(({ topic, logTimeNs }) => [
  topic,
  Number(logTimeNs - RECORDS[0]!.logTimeNs) / 1e6,
]);

/** What a replay may hold: topics and clients. */
async function ledger(master: TestMaster) {
  const { stringList } = await master.call({ topic: '/services/topic_list' });
  return {
    topics: stringList!.elements.filter((topic) => !isMasterTopic(topic)),
    clients: await clientList(master),
  };
}

async function clientList(master: TestMaster) {
  const { clientList: reply } = await master.call({ topic: '/services/client/get_list' });
  return reply!.elements.map(({ name, tags }) => ({ name, tags }));
}

describe('a replay', () => {
  it('[RP-1] [RP-2] plays a recording into live topics as a client, until its end', async () => {
    const master = await masterWith();
    const ada = await listener(master);
    const replay = await play(master);
    expect(replay).toMatchObject({
      ...{ name: 'Replay of Tuesday', recordingName: 'Tuesday', recordingId: RECORDING },
      ...{ state: REPLAY_STATE_PLAYING, durationMs: 1_000, rate: 1, copies: 1, topicCount: 1 },
    });
    expect(await clientList(master)).toContainEqual({
      ...{ name: 'Replay of Tuesday', tags: ['replay'] },
    });
    await master.pass(1_100);
    expect(heard(ada)).toEqual(VALUES);
    const [ended] = await list(master);
    expect(ended).toMatchObject({
      ...{ state: REPLAY_STATE_ENDED, positionMs: 1_000, recordCount: VALUES.length },
      ...{ topicCount: 2, clientIds: [replay.clientIds[0]], problem: '', refusedCount: 0 },
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

  it('[RP-5] [RP-11] pauses, jumps with the last values, steps, and changes its rate', async () => {
    const master = await masterWith();
    const ada = await listener(master);
    const { id } = await play(master, { isPaused: true });
    expect(heard(ada)).toEqual([['/a', 0]]);
    await master.pass(500);
    expect(heard(ada)).toEqual([]);
    const jumped = await change(master, { id, seek: { positionMs: 450 } });
    expect(jumped).toMatchObject({ state: REPLAY_STATE_PAUSED, positionMs: 450 });
    expect(heard(ada).sort()).toEqual([
      ['/a', 400],
      ['/b', 50],
    ]);
    expect(await change(master, { id, step: 2 })).toMatchObject({ positionMs: 600 });
    expect(heard(ada)).toEqual([
      ['/a', 500],
      ['/a', 600],
    ]);
    await change(master, { id, step: -1 });
    expect(heard(ada)).toContainEqual(['/a', 500]);
    const playing = await change(master, { id, rate: 10, action: REPLAY_ACTION_PLAY });
    expect(playing).toMatchObject({ state: REPLAY_STATE_PLAYING, rate: 10 });
    await master.pass(80);
    expect(heard(ada).map(([, value]) => value)).toEqual([600, 700, 800, 900, 1_000]);
    await change(master, { id, action: REPLAY_ACTION_PLAY });
    expect(await change(master, { id, action: REPLAY_ACTION_PAUSE })).toMatchObject({
      state: REPLAY_STATE_PAUSED,
    });
    expect(heard(ada)[0]).toEqual(['/a', 0]);
  });

  it('[RP-5] plays a span once or in a loop', async () => {
    const master = await masterWith();
    const ada = await listener(master);
    const { id } = await play(master, { span: { fromMs: 300, untilMs: 500 }, isLooping: true });
    await master.pass(480);
    expect(
      heard(ada)
        .filter(([topic]) => topic === '/a')
        .map(([, value]) => value),
    ).toEqual([300, 400, 500, 300, 400, 500, 300]);
    const once = await change(master, { id, loop: { span: { fromMs: 800 } } });
    expect(once).toMatchObject({ isLooping: false, span: { fromMs: 800, untilMs: 1_000 } });
    await master.pass(300);
    expect((await list(master))[0]!.state).toBe(REPLAY_STATE_ENDED);
    expect(heard(ada).at(-1)).toEqual(['/a', 1_000]);
  });

  it('[RP-11] jumps in a recording of 1000 topics', async () => {
    const topics = Array.from({ length: 1_000 }, (_, index) =>
      at(`/t/${index}`, index / 10, index),
    );
    const master = await masterWith([...topics, at('/end', 1_000)]);
    const ada = await listener(master);
    const { id } = await play(master, { isPaused: true });
    await change(master, { id, seek: { positionMs: 500 } });
    expect(new Map(heard(ada))).toEqual(
      new Map(topics.map(({ topic }, index) => [topic, index] as const)),
    );
  });

  it('[RP-12] [RP-13] plays what is selected, under the new names', async () => {
    const master = await masterWith([at('/x/a', 0, 1), at('/x/y/b', 0, 2), at('/z', 0, 3)]);
    const ada = await listener(master);
    const renames = [
      { fromPrefix: '/x', toPrefix: '/one' },
      { fromPrefix: '/x/y', toPrefix: '/two' },
    ];
    await play(master, { topics: ['/x/**'], renames, isPaused: true });
    expect(heard(ada)).toEqual([
      ['/one/a', 1],
      ['/two/b', 2],
    ]);
    await play(master, { excludedTopics: ['/x/**'], isPaused: true });
    expect(heard(ada)).toEqual([['/z', 3]]);
  });

  it.each<[string, Init<ReplayStartRequest>, string]>([
    ['topics that do not exist', { topics: ['/none'] }, 'invalid_argument'],
    [
      'a topic of the master',
      { renames: [{ fromPrefix: '/a', toPrefix: '/ubii/a' }] },
      'invalid_argument',
    ],
    [
      'one name for two topics',
      { renames: [{ fromPrefix: '/a', toPrefix: '/b' }] },
      'invalid_argument',
    ],
    ['a rate of 11', { rate: 11 }, 'invalid_argument'],
    ['a negative span', { span: { fromMs: 2, untilMs: 1 } }, 'invalid_argument'],
    ['a span beyond the end', { span: { fromMs: 2_000 } }, 'invalid_argument'],
    ['copies without a ghost', { copies: 2 }, 'invalid_argument'],
    ['a negative jitter', { isGhost: true, jitterMs: -1 }, 'invalid_argument'],
    ['too many copies', { isGhost: true, copies: 33 }, 'resource_exhausted'],
    ['an unknown recording', { recordingId: 'none' }, 'not_found'],
  ])('[RP-3] [RP-12] [RP-13] is refused with %s, and leaves nothing', async (_, request, code) => {
    const master = await masterWith();
    const before = await ledger(master);
    await expect(play(master, request)).rejects.toThrow(code);
    expect(await list(master)).toEqual([]);
    expect(await ledger(master)).toEqual(before);
  });

  it('[RP-3] [RP-4] is one of four, and alone on its topics', async () => {
    const master = await masterWith();
    await play(master);
    await expect(play(master)).rejects.toThrow(
      'failed_precondition: The replay "Replay of Tuesday"',
    );
    for (const toPrefix of ['/2', '/3', '/4']) {
      await play(master, { renames: [{ fromPrefix: '', toPrefix }] });
    }
    const fifth = play(master, { renames: [{ fromPrefix: '', toPrefix: '/5' }] });
    await expect(fifth).rejects.toThrow('resource_exhausted');
  });

  it('[RP-1] does not play a running recording', async () => {
    const master = new TestMaster();
    const recordingId = await record(master);
    await expect(play(master, { recordingId })).rejects.toThrow('failed_precondition');
    await stopRecording(master, recordingId);
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
    bob.drop(4000);
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

describe('the end of a replay', () => {
  it('[RP-6] is for those who started it, and for admins', async () => {
    const master = await masterWith();
    const ada = await joinAs(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const bob = await joinAs(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const viewer = await joinAs(master, AccessRole.ACCESS_ROLE_VIEWER);
    await expect(play(viewer)).rejects.toThrow('permission_denied');
    const { id } = await play(ada);
    expect(await stop(bob, id)).toBe('permission_denied');
    await expect(change(bob, { id, rate: 2 })).rejects.toThrow('permission_denied');
    expect(await stop(ada, id)).toBe(undefined);
    const second = await play(ada);
    expect(await stop(master, second.id)).toBe(undefined);
  });

  it('[RP-6] comes with the deletion of its recording', async () => {
    const master = await masterWith();
    const before = await ledger(master);
    await play(master);
    await master.pass(200);
    const request = {
      topic: '/services/ubii/recording_delete',
      recordingRequest: { id: RECORDING },
    };
    expect((await master.call(request)).error).toBe(undefined);
    expect(await list(master)).toEqual([]);
    await master.pass(2_000);
    expect(await ledger(master)).toEqual(before);
  });

  it('[RP-6] comes when an admin disconnects its client', async () => {
    const master = await masterWith();
    const bob = await master.extension('bob');
    const { clientIds } = await play(master, { isPaused: true });
    await master.call({
      topic: '/services/ubii/client_disconnect',
      clientDisconnectRequest: { targetId: clientIds[0]! },
    });
    expect(await list(master)).toEqual([]);
    bob.publish('/a', 'double', -1);
    expect(bob.takeErrors()).toEqual([]);
  });

  it('[RP-6] comes with the end of the master', async () => {
    const master = await masterWith();
    await play(master);
    await master.master.close();
    expect(master.clock.timerCount).toBe(0);
  });

  it('[RP-2] waits when the file cannot be read, and goes on when it can', async () => {
    const master = await masterWith([at('/a', 0), at('/a', 5_000)]);
    const { id } = await play(master, { isPaused: true });
    const file = master.recordings.files.get(RECORDING)!;
    const read = file.read.bind(file);
    file.read = () => Promise.reject(new Error('EIO: i/o error, read.'));
    const failed = await change(master, { id, seek: { positionMs: 5_000 } });
    expect(failed.state).toBe(ReplayState.REPLAY_STATE_FAILED);
    expect(failed.problem).toContain('EIO');
    file.read = read;
    const { state, problem } = await change(master, { id, seek: { positionMs: 5_000 } });
    expect([state, problem]).toEqual([REPLAY_STATE_PAUSED, '']);
  });
});
