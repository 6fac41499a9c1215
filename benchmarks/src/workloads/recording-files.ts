import { McapWriter } from '@mcap/core';
import { encodeRecord } from '@ubii/proto';
import { RecordingReader, type RecordedRecord } from '@ubii/recording';
import { MemoryFile, recorded, SAMPLE_HEADER, SAMPLE_START_NS } from '@ubii/recording/testing';
import type { Callee } from '../calls/call-series.ts';
import { measureCalls, warmUp } from '../calls/measure-calls.ts';
import type { Subject, Workload } from '../measuring/workload.ts';

const TOPICS = 200;
const RECORDS_PER_CALL = 10_000;
/** Records that make a file of about 100 MB. */
const RECORDS_OF_FILE = 400_000;
const SEEK_LIMIT_US = 200_000;

/** Poses on 200 topics, as devices publish them: 50 000 records/s. */
function poses(count: number): RecordedRecord[] {
  return Array.from({ length: count }, (_, i) => {
    const topic = `/0a1b2c3d-4e5f-6789/device-${i % TOPICS}/pose`;
    const position = { x: Math.sin(i / 100), y: Math.random() / 100, z: Math.cos(i / 77) };
    const record = encodeRecord({ topic, format: 'pose3D', value: { position } });
    const logTimeNs = SAMPLE_START_NS + BigInt(i) * 20_000n;
    return { topic, clientId: 'ada', record, logTimeNs, publishTimeNs: logTimeNs };
  });
}

/** Writing beside the writer of the MCAP library, which does not compress and makes no snapshots. */
export const recordingWrite: Workload = {
  name: 'recording-write',
  group: 'recording-files',
  title: `${RECORDS_PER_CALL} records of ${TOPICS} topics to a recording in memory`,
  figures: [
    { key: 'p50Us', label: 'p50', unit: 'µs', isHigherBetter: false, goals: { recording: 1.5 } },
  ],
  reference: '@mcap/core',
  placement: 'one-core',
  roundShare: 1 / 3,
  open: async () => {
    const records = poses(RECORDS_PER_CALL);
    return [
      await subject(
        '@mcap/core',
        writing(() => writeByLibrary(records)),
      ),
      await subject(
        'recording',
        writing(() => recorded(records)),
      ),
    ];
  },
};

/** The last value of every topic at random moments, beside reading one chunk at each: the least there is to read. */
export const recordingSeek: Workload = {
  name: 'recording-seek',
  group: 'recording-files',
  title: `The last value of ${TOPICS} topics at a random moment of a recording`,
  figures: [
    {
      key: 'p50Us',
      label: 'p50',
      unit: 'µs',
      isHigherBetter: false,
      goals: {},
    },
    {
      key: 'p99Us',
      label: 'p99',
      unit: 'µs',
      isHigherBetter: false,
      goals: {},
      bounds: { 'all topics': SEEK_LIMIT_US },
    },
  ],
  reference: 'one topic',
  placement: 'one-core',
  roundShare: 1 / 3,
  open: async () => {
    const file = await recorded(poses(RECORDS_OF_FILE));
    const [one] = (await RecordingReader.open(file)).summary.topics;
    return [
      await subject('one topic', await seeking(file, [one!.topic])),
      await subject('all topics', await seeking(file, undefined)),
    ];
  },
};

function writing(write: () => Promise<MemoryFile>): Callee<undefined, MemoryFile> {
  return {
    sequence: 0,
    prepare: () => undefined,
    call: write,
    isRight: (file) => file.position() > 0n,
  };
}

async function writeByLibrary(records: readonly RecordedRecord[]): Promise<MemoryFile> {
  const file = new MemoryFile();
  const writer = new McapWriter({ writable: file });
  await writer.start({ profile: SAMPLE_HEADER.kind, library: '' });
  const channels = new Map<string, number>();
  for (const [sequence, { topic, record, logTimeNs, publishTimeNs }] of records.entries()) {
    let channelId = channels.get(topic);
    if (channelId === undefined) {
      const channel = { topic, schemaId: 0, messageEncoding: 'protobuf', metadata: new Map() };
      channelId = await writer.registerChannel(channel);
      channels.set(topic, channelId);
    }
    const times = { logTime: logTimeNs, publishTime: publishTimeNs };
    await writer.addMessage({ channelId, sequence, data: record, ...times });
  }
  await writer.end();
  return file;
}

async function seeking(
  file: MemoryFile,
  topics: readonly string[] | undefined,
): Promise<Callee<bigint, number>> {
  const reader = await RecordingReader.open(file);
  const { startNs, endNs } = reader.summary;
  const wanted = topics?.length ?? TOPICS;
  // All topics have a value from the first moments on.
  const fromNs = startNs + 1_000_000_000n;
  return {
    sequence: 0,
    prepare: () => fromNs + BigInt(Math.floor(Math.random() * Number(endNs - fromNs))),
    call: async (timeNs) => (await reader.latestAt(timeNs, topics)).size,
    isRight: (values) => values === wanted,
  };
}

async function subject<P, A>(name: string, callee: Callee<P, A>): Promise<Subject> {
  await warmUp(callee);
  return { name, pids: [], measure: (options) => measureCalls(callee, options) };
}
