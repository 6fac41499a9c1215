import { DEFAULT_TEXT_LIMITS, RecordingKind, RecordingState } from '@ubii/proto';
import { RecordingWriter, type RecordingEvent } from '@ubii/recording';
import { recordHere, type RecordingJob } from '@ubii/recording/recorder';
import { SAMPLE_HEADER, SAMPLE_START_NS, sampleRecord } from '@ubii/recording/testing';
import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { runningJob } from '../../testing/acceptance/index.ts';
import { MemoryFolder, MemoryRecording } from '../../testing/memory-folder.ts';

const LIMITS = {
  ...DEFAULT_TEXT_LIMITS,
  recordingsBytes: 1e9,
  markersPerRecording: 3_000,
  recorderQueueBytes: 1e6,
};
const STUDY = {
  studyId: 's',
  studyName: 'Reach',
  runId: 'r',
  participantCode: 'P01',
  visit: '1',
  condition: 'A',
  block: 1,
  runNumber: 1,
};
const SELECTION = { topics: ['/x'], patterns: [], clients: [], devices: [], sessions: [] };
const LONG = 'x'.repeat(100_000);
/** Reply of `recording_get` at most. [RC-54] */
const MAX_REPLY_BYTES = 1024 * 1024;

interface Content {
  readonly header?: Partial<typeof SAMPLE_HEADER>;
  readonly facts?: object;
  readonly topics?: readonly string[];
  readonly events?: readonly RecordingEvent[];
}

/** A file that says what it wants. */
async function fileOf({ header, facts = {}, topics = ['/x'], events = [] }: Content) {
  const file = new MemoryRecording();
  const selection = JSON.stringify(facts);
  const writer = await RecordingWriter.create(file, { ...SAMPLE_HEADER, selection, ...header });
  for (const event of events) writer.addEvent(event);
  for (const topic of topics) await writer.addRecord(sampleRecord(topic, 1));
  await writer.end();
  return file;
}

function markerOf(id: string, text = 'Go', more: object = {}): RecordingEvent {
  const marker = { id, timeMs: 1.75e12, text, author: 'Ada', authorId: 'ada', kind: 'key' };
  return { kind: 'marker', timeNs: SAMPLE_START_NS, value: { ...marker, ...more } };
}

function openEngine() {
  const folder = new MemoryFolder();
  const recorder = recordHere({ folder, clock: new FakeClock(), limits: LIMITS });
  const upload = async (content: Content, more: Partial<RecordingJob> = {}) => {
    folder.uploads.set('up', await fileOf(content));
    return recorder.adopt({ ...runningJob('up'), name: '', ...more });
  };
  return { folder, recorder, upload };
}

describe('texts in files', () => {
  const HEADER = { name: LONG, notes: LONG, masterName: LONG, version: LONG };
  const FACTS = {
    author: LONG,
    makerId: LONG,
    problem: LONG,
    replayedRecordingId: LONG,
    study: STUDY,
    ...SELECTION,
  };

  it('[RC-54] cuts those of an upload, and says so', async () => {
    const { upload, recorder } = openEngine();
    const taken = await upload({ header: HEADER });
    expect(taken).toMatchObject({
      name: `${'x'.repeat(99)}…`,
      notes: `${'x'.repeat(4_095)}…`,
      problem: 'Too long in the file, and cut: name, notes.',
    });
    expect(await recorder.list()).toMatchObject({ recordings: [taken] });
  });

  it('[RC-54] cuts those of files that were in the folder', async () => {
    const { folder, recorder } = openEngine();
    const study = { ...STUDY, participantCode: LONG };
    folder.files.set('a', await fileOf({ header: HEADER, facts: { ...FACTS, study } }));
    const [listed] = (await recorder.list()).recordings;
    expect(listed!.author).toBe(`${'x'.repeat(99)}…`);
    expect(listed!.study!.participantCode).toBe(`${'x'.repeat(99)}…`);
    expect(listed!.problem).toHaveLength(500);
    expect(listed!.replayedRecordingId).toBe('');
    expect(JSON.stringify(listed).length).toBeLessThan(6_000);
    expect((await recorder.get('a')).makerId).toBe('');
  });

  it.each([
    ['texts', { ...SELECTION, topics: Array<string>(257).fill('/x') }],
    ['characters', { ...SELECTION, patterns: [LONG] }],
  ])('[RC-54] leaves out a selection with too many %s', async (_, facts) => {
    const { folder, recorder } = openEngine();
    folder.files.set('a', await fileOf({ facts }));
    const { selection, problem } = (await recorder.list()).recordings[0]!;
    expect(selection).toBeUndefined();
    expect(problem).toBe('What was selected is too long in the file, and left out.');
  });

  it('[RC-3] lists recordings without long selections', async () => {
    const { folder, recorder } = openEngine();
    const topics = Array.from({ length: 256 }, (_, index) => `/topic/of/some/length/${index}`);
    folder.files.set('a', await fileOf({ facts: { ...SELECTION, topics } }));
    expect((await recorder.list()).recordings).toMatchObject([{ selection: undefined }]);
    const page = { topicsFrom: 0, markersFrom: 0 };
    expect((await recorder.get('a', page)).recording).toMatchObject({ selection: { topics } });
  });

  it('keeps the labels of personal data when a recording is renamed', async () => {
    const { folder, recorder } = openEngine();
    const header = { ...SAMPLE_HEADER, personalData: '{"labels":[]}' };
    folder.files.set('a', await fileOf({ header }));
    await recorder.change('a', { name: 'New', notes: '' });
    const text = new TextDecoder().decode(folder.files.get('a')!.bytes);
    expect(text.split('{"labels":[]}')).toHaveLength(3);
  });
});

describe('pages', () => {
  it('[RC-54] have 1000 topics and markers, and lead through all', async () => {
    const { folder, recorder } = openEngine();
    const topics = Array.from({ length: 1_500 }, (_, index) => `/x/${index}`);
    const events = Array.from({ length: 2_100 }, (_, index) => markerOf(`m${index}`));
    folder.files.set('a', await fileOf({ topics, events }));
    const pageOf = async (topicsFrom: number, markersFrom: number) =>
      (await recorder.get('a', { topicsFrom, markersFrom })).recording;
    const first = await pageOf(0, 0);
    expect([first.topics.length, first.markers.length]).toEqual([1_000, 1_000]);
    expect([first.topicsTotal, first.markerCount]).toEqual([1_500, 2_100]);
    const last = await pageOf(1_000, 2_000);
    expect([last.topics.length, last.markers.length]).toEqual([500, 100]);
    expect([last.topicsFrom, last.markersFrom]).toEqual([1_000, 2_000]);
    expect(last.topics[0]).toMatchObject({ topic: '/x/1000' });
    expect(last.markers[0]).toMatchObject({ id: 'm2000' });
    expect(await pageOf(9_999, 9_999)).toMatchObject({ topics: [], markers: [] });
    expect((await recorder.get('a')).recording).toMatchObject({ topics: [], markers: [] });
  });

  it('[RC-54] are at most 1 MiB, whatever a file says', async () => {
    const { folder, recorder } = openEngine();
    const topics = Array.from({ length: 1_000 }, (_, index) => `/${index}/${'ä'.repeat(2_000)}`);
    const events = Array.from({ length: 1_000 }, (_, index) =>
      markerOf(`${'i'.repeat(250)}${index}`, '\u0001'.repeat(2_000), { author: 'y'.repeat(300) }),
    );
    folder.files.set('a', await fileOf({ topics, events, facts: SELECTION }));
    const { recording } = await recorder.get('a', { topicsFrom: 0, markersFrom: 0 });
    expect(recording.topics[0]!.topic).toHaveLength(1_024);
    expect(recording.markers[0]!.text).toHaveLength(500);
    expect(recording.markers[0]!.author).toHaveLength(100);
    const bytes = new TextEncoder().encode(JSON.stringify(recording)).length;
    expect(bytes).toBeLessThan(MAX_REPLY_BYTES);
    expect(recording.topics.length).toBeGreaterThan(50);
  });
});

describe('malformed events', () => {
  it('[RC-55] refuse an upload, of which nothing stays', async () => {
    const { upload, folder, recorder } = openEngine();
    await expect(upload({ events: [markerOf('a', {} as string)] })).rejects.toMatchObject({
      code: 'invalid_argument',
      message: expect.stringContaining('text is an object') as string,
    });
    expect(folder.files.size).toBe(0);
    expect((await recorder.list()).recordings).toEqual([]);
  });

  it('[RC-55] are left out of files that were in the folder, which say so', async () => {
    const { folder, recorder } = openEngine();
    const events = [markerOf('a', null as never), markerOf('b'), markerOf('c', 5 as never)];
    folder.files.set('a', await fileOf({ events }));
    expect((await recorder.list()).recordings).toMatchObject([
      {
        markerCount: 1,
        problem: expect.stringContaining('2 malformed events are left out. The marker') as string,
      },
    ]);
    const { markers } = (await recorder.get('a', { topicsFrom: 0, markersFrom: 0 })).recording;
    expect(markers).toMatchObject([{ id: 'b' }]);
  });

  it('[RC-56] answers failed_precondition for a file that cannot be read any more', async () => {
    const { folder, recorder } = openEngine();
    folder.files.set('a', await fileOf({}));
    await recorder.list();
    folder.files.set('a', new MemoryRecording(new TextEncoder().encode('Not a recording.')));
    const page = { topicsFrom: 0, markersFrom: 0 };
    const refused = { code: 'failed_precondition' };
    await expect(recorder.get('a', page)).rejects.toMatchObject(refused);
    await expect(recorder.change('a', { name: 'b', notes: '' })).rejects.toMatchObject(refused);
  });
});

describe('a recording that is gone', () => {
  const mark = {
    marker: {
      recordingId: 'a',
      id: 'm',
      timeMs: 1,
      text: '',
      author: '',
      clientId: '',
      isRemoved: false,
    },
    mayChangeAll: true,
  };
  const gone = { code: 'not_found', message: 'No recording has the id "a".' };
  const open = async () => {
    const parts = openEngine();
    parts.folder.files.set('a', await fileOf({}));
    await parts.recorder.list();
    return parts;
  };

  it('[RC-56] is not found, when it was deleted', async () => {
    const { recorder } = await open();
    await recorder.delete('a');
    await expect(recorder.change('a', { name: 'b', notes: '' })).rejects.toMatchObject(gone);
    await expect(recorder.mark(mark)).rejects.toMatchObject(gone);
  });

  it('[RC-56] is not found, when it is deleted while changes wait', async () => {
    const { recorder } = await open();
    const outcomes = Promise.allSettled([
      recorder.change('a', { name: 'b', notes: '' }),
      recorder.mark(mark),
      recorder.delete('a'),
      recorder.mark(mark),
    ]);
    for (const outcome of await outcomes) {
      if (outcome.status === 'rejected') expect(outcome.reason).toMatchObject(gone);
    }
    expect((await outcomes).at(-1)).toMatchObject({ status: 'rejected' });
    expect((await recorder.list()).recordings).toEqual([]);
  });

  it('[RC-56] is not found, and leaves the list, when another program deleted its file', async () => {
    const { recorder, folder } = await open();
    folder.files.delete('a');
    await expect(recorder.get('a')).rejects.toMatchObject(gone);
    await expect(recorder.mark(mark)).rejects.toMatchObject(gone);
    expect((await recorder.list()).recordings).toEqual([]);
  });
});

describe('claims of files', () => {
  const CLAIMS = {
    author: 'Eve',
    makerId: 'grant-of-others',
    replayedRecordingId: 'other',
    study: STUDY,
    state: RecordingState.RECORDING_STATE_RECORDING,
    problem: 'Call 0900.',
  };
  const HEADER = { kind: 'comparison' } as never;

  it('[RC-41] do not make an upload part of a study, a comparison, or that of others', async () => {
    const { upload, recorder } = openEngine();
    expect(await upload({ header: HEADER, facts: CLAIMS })).toMatchObject({
      author: 'Ada',
      study: undefined,
      replayedRecordingId: '',
      problem: '',
      kind: RecordingKind.RECORDING_KIND_IMPORT,
      state: RecordingState.RECORDING_STATE_COMPLETE,
    });
    expect((await recorder.get('up')).makerId).toBe('grant');
  });

  it('[RC-41] keep the part of a study where an admin brings it back', async () => {
    const { upload } = openEngine();
    expect(await upload({ facts: CLAIMS }, { keepsStudy: true })).toMatchObject({ study: STUDY });
  });

  it('[RC-63] do not make a recording of a node what the master did not order', async () => {
    const { upload } = openEngine();
    expect(await upload({ header: HEADER, facts: CLAIMS }, { isOfNode: true })).toMatchObject({
      author: 'Ada',
      study: undefined,
      replayedRecordingId: '',
      kind: RecordingKind.RECORDING_KIND_RECORDING,
    });
  });

  it('[RC-2] do not make a file one that is being recorded', async () => {
    const { folder, recorder } = openEngine();
    folder.files.set('a', await fileOf({ facts: CLAIMS }));
    const state = RecordingState.RECORDING_STATE_COMPLETE;
    expect((await recorder.list()).recordings).toMatchObject([{ state }]);
  });
});
