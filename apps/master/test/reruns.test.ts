import {
  RecordingKind,
  RecordingState,
  ReplayState,
  toJson,
  decode,
  encode,
  type Init,
  type ProcessingModule,
  type Session,
} from '@ubii/proto';
import type { RecordingEvent } from '@ubii/recording';
import { SAMPLE_START_NS } from '@ubii/recording/testing';
import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';
import { contentOf, SERVICES } from './recording-world.ts';
import { at, folderWith, list, play, stop } from './replay-world.ts';
import { doubler, TOPICS } from './sessions/session-world.ts';

const RECORDED = [at('/in', 0, 1), at('/out', 5, 2), at('/in', 100, 5), at('/out', 105, 10)];
const SESSION_ID = 'recorded-session';

const times = (factor: number): Init<ProcessingModule> => ({
  ...doubler,
  onProcessingStringified: doubler.onProcessingStringified.replace('2 *', `${factor} *`),
});

/** The doubler from /in by /middle to /out, in two modules. */
const CHAIN: Init<Session> = {
  id: SESSION_ID,
  name: 'chain',
  processingModules: [
    { ...times(2), id: 'one' },
    { ...times(1), id: 'two', name: 'copier' },
  ],
  ioMappings: [
    {
      processingModuleId: 'one',
      inputMappings: [{ inputName: 'in', topic: '/in' }],
      outputMappings: [{ outputName: 'out', topic: '/middle' }],
    },
    {
      processingModuleId: 'two',
      inputMappings: [{ inputName: 'in', topic: '/middle' }],
      outputMappings: [{ outputName: 'out', topic: '/out' }],
    },
  ],
};

function sessionEvent(session: Init<Session>): RecordingEvent {
  const message = decode('ubii.sessions.Session', encode('ubii.sessions.Session', session));
  const value = { id: SESSION_ID, name: message.name, state: 'running' };
  const json = JSON.stringify(toJson('ubii.sessions.Session', message));
  return { kind: 'session', timeNs: SAMPLE_START_NS, value: { ...value, session: json } };
}

async function masterWithSession(session: Init<Session>, library: Init<ProcessingModule>[] = []) {
  const master = new TestMaster({
    recordings: await folderWith(RECORDED, [sessionEvent(session)]),
  });
  for (const processingModule of library) {
    const { error } = await master.call({ topic: TOPICS.saveModule, processingModule });
    if (error !== undefined) throw new Error(error.message);
  }
  return master;
}

async function runningSessions(master: TestMaster): Promise<number> {
  return (await master.call({ topic: TOPICS.list })).sessionList!.elements.length;
}

describe('a recorded session', () => {
  it('[RP-40] [RP-41] runs again with the modules of today, beside its recorded outputs', async () => {
    const master = await masterWithSession(CHAIN, [times(10)]);
    const { id, session } = await play(master, { sessionId: SESSION_ID });
    expect(session).toMatchObject({
      ...{ sessionId: SESSION_ID, recordedModules: ['copier'] },
      ...{ inputPrefix: `/replays/${id}/in`, outputPrefix: `/replays/${id}/out` },
    });
    await master.pass(1_000);
    const [replay] = await list(master);
    expect(replay).toMatchObject({ state: ReplayState.REPLAY_STATE_ENDED });
    expect(replay!.session!.runningId).toBe('');
    expect(await runningSessions(master)).toBe(0);
    const comparisonId = session!.comparisonRecordingId;
    const { values } = await contentOf(master, comparisonId);
    expect(values).toEqual([
      [`/replays/${id}/in/in`, 1],
      [`/replays/${id}/out/middle`, 10],
      [`/replays/${id}/out/out`, 10],
      [`/replays/${id}/in/in`, 5],
      [`/replays/${id}/out/middle`, 50],
      [`/replays/${id}/out/out`, 50],
    ]);
    const { recording } = await master.call({
      topic: `${SERVICES}recording_get`,
      recordingRequest: { id: comparisonId },
    });
    expect(recording).toMatchObject({
      kind: RecordingKind.RECORDING_KIND_COMPARISON,
      state: RecordingState.RECORDING_STATE_COMPLETE,
      replayedRecordingId: replay!.recordingId,
      name: 'Replay of chain in Tuesday',
    });
  });

  it('[RP-41] ends with its replay', async () => {
    const master = await masterWithSession(CHAIN);
    const { id, session } = await play(master, { sessionId: SESSION_ID });
    expect(await runningSessions(master)).toBe(1);
    await stop(master, id);
    await master.pass(100);
    expect(await runningSessions(master)).toBe(0);
    const { recordingList } = await master.call({ topic: `${SERVICES}recording_list` });
    const comparison = recordingList!.elements.find(
      (recording) => recording.id === session!.comparisonRecordingId,
    );
    expect(comparison!.state).toBe(RecordingState.RECORDING_STATE_COMPLETE);
  });

  it('[RP-40] that does not run or is not there is refused, and leaves nothing', async () => {
    const broken = {
      ...times(1),
      name: 'broken',
      onCreatedStringified: '() => { throw new Error("no"); }',
    };
    const [first] = CHAIN.ioMappings!;
    const master = await masterWithSession({
      ...CHAIN,
      processingModules: [{ ...broken, id: 'one' }],
      ioMappings: [first!],
    });
    await expect(play(master, { sessionId: SESSION_ID })).rejects.toThrow('failed_precondition');
    await expect(play(master, { sessionId: 'none' })).rejects.toThrow('not_found');
    await master.pass(1_000);
    expect([await list(master), await runningSessions(master)]).toEqual([[], 0]);
  });

  it('[RP-41] ends with its replay, also while it starts', async () => {
    const master = await masterWithSession(CHAIN);
    const starting = play(master, { sessionId: SESSION_ID }).catch(() => undefined);
    while ((await list(master)).length === 0) await master.pass();
    await stop(master, (await list(master))[0]!.id);
    await starting;
    await master.pass(100);
    expect([await list(master), await runningSessions(master)]).toEqual([[], 0]);
  });

  it('[RP-40] needs a topic that it reads', async () => {
    const master = await masterWithSession(CHAIN);
    const started = play(master, { sessionId: SESSION_ID, topics: ['/out'] });
    await expect(started).rejects.toThrow('invalid_argument');
  });
});
