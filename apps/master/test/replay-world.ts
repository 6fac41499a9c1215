import {
  AccessRole,
  decode,
  encode,
  encodeRecord,
  isMasterTopic,
  toJson,
  type Init,
  type Replay,
  type ReplayChangeRequest,
  type ReplayStartRequest,
  type Session,
} from '@ubii/proto';
import type { RecordedRecord, RecordingEvent } from '@ubii/recording';
import { recorded, recordedDevice, SAMPLE_START_NS } from '@ubii/recording/testing';
import { MemoryFolder, MemoryRecording } from '../src/testing/memory-folder.ts';
import { TestMaster, type TestClient, type TestMasterOptions } from '../src/testing/index.ts';
import { createGrant, join } from './access-world.ts';

/** Id of the recording. */
export const RECORDING = 'lesson';
const SERVICES = '/services/ubii/';

/** A recorded number. @param atMs since the start of the recording */
export function at(topic: string, atMs: number, value = atMs, clientId = 'ada'): RecordedRecord {
  const logTimeNs = SAMPLE_START_NS + BigInt(Math.round(atMs * 1e6));
  const timestampMs = Number(logTimeNs / 1_000_000n);
  const record = encodeRecord({ topic, format: 'double', value, timestampMs, clientId });
  return { topic, clientId, record, logTimeNs, publishTimeNs: logTimeNs };
}

/** `/a` every 100 ms for a second, with the time as its value; `/b` at 50 ms. */
export const RECORDS: readonly RecordedRecord[] = [
  at('/a', 0),
  at('/b', 50),
  ...Array.from({ length: 10 }, (_, index) => at('/a', 100 * (index + 1))),
];

/** The registration of a device when the recording began. */
export function deviceEvent(...device: Parameters<typeof recordedDevice>): RecordingEvent {
  return { kind: 'device', timeNs: SAMPLE_START_NS, value: recordedDevice(...device) };
}

/** Id of the recorded session. */
export const SESSION_ID = 'recorded-session';

/** A session that ran when the recording began. */
export function sessionEvent(session: Init<Session>): RecordingEvent {
  const message = decode('ubii.sessions.Session', encode('ubii.sessions.Session', session));
  const value = { id: SESSION_ID, name: message.name, state: 'running' };
  const json = JSON.stringify(toJson('ubii.sessions.Session', message));
  return { kind: 'session', timeNs: SAMPLE_START_NS, value: { ...value, session: json } };
}

/** A folder with one recording. */
export async function folderWith(
  records: readonly RecordedRecord[] = RECORDS,
  events: readonly RecordingEvent[] = [],
): Promise<MemoryFolder> {
  const folder = new MemoryFolder();
  const { bytes } = await recorded(records, events);
  folder.files.set(RECORDING, new MemoryRecording(bytes));
  return folder;
}

/** A master that has the recording. */
export async function masterWith(
  records?: readonly RecordedRecord[],
  options: TestMasterOptions = {},
  events?: readonly RecordingEvent[],
): Promise<TestMaster> {
  return new TestMaster({ recordings: await folderWith(records, events), ...options });
}

/** A participant that made the recording, which replaces the one of a master that has not read it yet. */
export async function makerOfRecording(
  master: TestMaster,
  records = RECORDS,
  events: readonly RecordingEvent[] = [],
): Promise<TestClient> {
  const { grant, token } = await createGrant(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
  const selection = JSON.stringify({ makerId: grant!.id });
  const { bytes } = await recorded(records, events, { selection });
  master.recordings.files.set(RECORDING, new MemoryRecording(bytes));
  return join(master, token, 'maker');
}

/** Starts a replay. @throws Error with code and message when the master refuses */
export async function play(
  caller: Pick<TestMaster, 'call'> | Pick<TestClient, 'call'>,
  request: Init<ReplayStartRequest> = {},
): Promise<Replay> {
  const replayStartRequest = { recordingId: RECORDING, ...request };
  const { replay, error } = await caller.call({
    topic: `${SERVICES}replay_start`,
    replayStartRequest,
  });
  if (replay === undefined) throw new Error(`${error?.code}: ${error?.message}`);
  return replay;
}

/** Changes a replay. @throws Error with code and message when the master refuses */
export async function change(
  caller: Pick<TestMaster, 'call'> | Pick<TestClient, 'call'>,
  request: Init<ReplayChangeRequest>,
): Promise<Replay> {
  const { replay, error } = await caller.call({
    topic: `${SERVICES}replay_change`,
    replayChangeRequest: request,
  });
  if (replay === undefined) throw new Error(`${error?.code}: ${error?.message}`);
  return replay;
}

/** Stops a replay. Returns the code of the error, if there is one. */
export async function stop(
  caller: Pick<TestMaster, 'call'> | Pick<TestClient, 'call'>,
  id: string,
): Promise<string | undefined> {
  const request = { topic: `${SERVICES}replay_stop`, replayRequest: { id } };
  return (await caller.call(request)).error?.code;
}

/** All replays. */
export async function list(master: TestMaster): Promise<Replay[]> {
  return (await master.call({ topic: `${SERVICES}replay_list` })).replayList!.elements;
}

/** A client that gets all topics. */
export async function listener(master: TestMaster): Promise<TestClient> {
  const client = await master.extension('listener');
  await client.subscribe({ subscribeTopicRegexp: ['.*'] });
  client.takeRecords();
  return client;
}

/** Topics and values of clients that it got since it was asked last. */
export function heard(client: TestClient): [topic: string, value: unknown][] {
  return client.takeValues().filter(([topic]) => !isMasterTopic(topic));
}

/** What a replay may hold: topics and clients. */
export async function ledger(master: TestMaster) {
  const { stringList } = await master.call({ topic: '/services/topic_list' });
  return {
    topics: stringList!.elements.filter((topic) => !isMasterTopic(topic)),
    clients: await clientList(master),
  };
}

/** Names and tags of all clients. */
export async function clientList(master: TestMaster) {
  const { clientList: reply } = await master.call({ topic: '/services/client/get_list' });
  return reply!.elements.map(({ name, tags }) => ({ name, tags }));
}
