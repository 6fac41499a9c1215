import {
  RecordingKind,
  RecordingState,
  ReplayState,
  type Init,
  type ProcessingModule,
  type Session,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';
import { contentOf, SERVICES, start, stop as stopRecording } from './recording-world.ts';
import { at, folderWith, list, play, SESSION_ID, sessionEvent, stop } from './replay-world.ts';
import { doubler, doubling, TOPICS } from './sessions/session-world.ts';

const RECORDED = [at('/in', 0, 1), at('/out', 5, 2), at('/in', 100, 5), at('/out', 105, 10)];

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

async function masterWithSession(session: Init<Session>, library: Init<ProcessingModule>[] = []) {
  const master = new TestMaster({
    recordings: await folderWith(RECORDED, [sessionEvent(session)]),
  });
  for (const module of library) await save(master, module);
  return master;
}

async function save(master: TestMaster, processingModule: Init<ProcessingModule>) {
  const { error } = await master.call({ topic: TOPICS.saveModule, processingModule });
  if (error !== undefined) throw new Error(error.message);
}

/** Records a session whose module is in the library, then saves another version of the module and runs the session again. */
async function runAgainWith(changed: Init<ProcessingModule>) {
  const master = new TestMaster();
  const ada = await master.extension('ada');
  await save(master, times(1));
  const mappings = doubling('/in', '/out');
  const { session } = await master.call({
    topic: TOPICS.start,
    session: { ...mappings, processingModules: [{ name: 'doubler' }] },
  });
  await master.pass();
  const recordingId = await start(master);
  for (const value of [1, 5]) {
    ada.publish('/in', 'double', value);
    await master.pass(50);
  }
  await stopRecording(master, recordingId);
  await save(master, changed);
  const rerun = await play(master, { recordingId, sessionId: session!.id });
  await master.pass(1_000);
  const outputs = async (id: string, topic: string) =>
    (await contentOf(master, id)).values.filter(([name]) => name === topic).map(([, v]) => v);
  const { comparisonRecordingId, outputPrefix, recordedModules } = rerun.session!;
  return {
    recorded: await outputs(recordingId, '/out'),
    today: await outputs(comparisonRecordingId, `${outputPrefix}/out`),
    recordedModules,
    problem: (await list(master))[0]!.problem,
  };
}

async function runningSessions(master: TestMaster): Promise<number> {
  return (await master.call({ topic: TOPICS.list })).sessionList!.elements.length;
}

describe('a recorded session', () => {
  it('[RP-40] [RP-41] runs again with the modules of today, beside its recorded outputs', async () => {
    const master = await masterWithSession(CHAIN, [times(10)]);
    const { id, session } = await play(master, { sessionId: SESSION_ID });
    expect(session).toMatchObject({
      sessionId: SESSION_ID,
      recordedModules: ['copier'],
      inputPrefix: `/replays/${id}/in`,
      outputPrefix: `/replays/${id}/out`,
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

  it('[RP-40] runs a module as it was saved after the recording', async () => {
    const { recorded, today, recordedModules, problem } = await runAgainWith(times(2));
    expect([recorded, today]).toEqual([
      [1, 5],
      [2, 10],
    ]);
    expect([recordedModules, problem]).toEqual([[], '']);
  });

  it.each([
    ['fail', 'inputs.missing.double', 'A run of the module "doubler" failed: '],
    ['return no value of the format', '{ outputs: { out: 2 } }', 'write { double: value }'],
  ])('[RP-40] names modules whose runs %s', async (_, result, reason) => {
    const onProcessingStringified = `(deltaTime, inputs) => (${result})`;
    const { recorded, today, problem } = await runAgainWith({
      ...doubler,
      onProcessingStringified,
    });
    expect([recorded, today]).toEqual([[1, 5], []]);
    expect(problem).toContain('"doubler"');
    expect(problem).toContain(reason);
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
