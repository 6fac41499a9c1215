import {
  AccessRole,
  decodeRecord,
  RecordingKind,
  unpackFlightRecords,
  type Init,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { joinAs } from './access-world.ts';
import { contentOf, SERVICES, start, stop } from './recording-world.ts';

const { ACCESS_ROLE_ADMIN, ACCESS_ROLE_PARTICIPANT, ACCESS_ROLE_PLAYER, ACCESS_ROLE_VIEWER } =
  AccessRole;
const FLIGHT = { isOn: true, minutes: 5, maxBytes: 1_000_000, withImages: true };

describe('the flight recorder', () => {
  it('[RC-30] [RC-32] [RC-33] keeps the last minutes with clients, and goes on', async () => {
    const master = new TestMaster({ flightRecorder: FLIGHT });
    const ada = await master.legacy('ada');
    ada.publish('/x', 'double', 1);
    ada.publish('/y', 'double', 2);
    ada.publish(`/${ada.id}/page_state`, 'string', '{"visible":true}'); // [RC-12]
    await master.pass(1_000);
    const keep = { topic: `${SERVICES}flight_recorder_keep`, flightRecorderKeepRequest: {} };
    const { recording } = await master.call(keep);
    expect(recording).toMatchObject({ recordCount: 2, topicCount: 2 });
    expect(recording!.kind).toBe(RecordingKind.RECORDING_KIND_FLIGHT_RECORDER);
    const { summary } = await contentOf(master, recording!.id);
    expect(summary.clients).toMatchObject([{ name: 'ada' }]);
    ada.publish('/x', 'double', 3);
    expect((await master.call(keep)).recording).toMatchObject({ recordCount: 3 });
    const { flightRecorder } = await master.call({ topic: `${SERVICES}flight_recorder_get` });
    expect(flightRecorder).toMatchObject({ ...FLIGHT, recordCount: 3, topicCount: 2 });
  });

  it('[RC-33] forgets topics that were deleted before the kept time', async () => {
    const master = new TestMaster({ flightRecorder: { ...FLIGHT, minutes: 1, maxBytes: 100_000 } });
    const ada = await master.legacy('ada');
    const bob = await master.legacy('bob');
    ada.publish('/gone', 'double', 1);
    bob.publish('/stays', 'double', 2);
    await master.pass(100);
    await ada.call({ topic: '/services/client/deregistration', client: { id: ada.id } });
    for (let second = 0; second < 200; second++) {
      for (let i = 0; i < 20; i++) bob.publish('/pose', 'double', i);
      await master.pass(1_000);
    }
    const keep = { topic: `${SERVICES}flight_recorder_keep`, flightRecorderKeepRequest: {} };
    const { recording } = await master.call(keep);
    const { summary } = await contentOf(master, recording!.id);
    expect(summary.topics.map(({ topic }) => topic).sort()).toEqual(['/pose', '/stays']);
  });

  it('[RC-36] sends what it holds of topics to those that may receive all of them', async () => {
    const master = new TestMaster({ flightRecorder: FLIGHT });
    const ada = await master.legacy('ada');
    const read = async (topics: string[], sinceMs = 0) => {
      const request = { flightRecordsRequest: { topics, sinceMs } };
      return master.call({ topic: `${SERVICES}flight_recorder_records`, ...request });
    };
    const valuesOf = async (topics: string[], sinceMs?: number) => {
      const { flightRecords } = await read(topics, sinceMs);
      const found = [...unpackFlightRecords(flightRecords!)];
      return found.map(({ record }) => decodeRecord(record).value);
    };
    ada.publish('/x', 'double', 1);
    ada.publish('/y', 'double', 2);
    await master.pass(1_000);
    const nowMs = master.clock.nowMs();
    ada.publish('/x', 'double', 3);
    expect(await valuesOf(['/x', '/x', '/nothing'])).toEqual([1, 3]);
    expect(await valuesOf(['/x', '/y'], nowMs)).toEqual([3]);
    expect((await read(Array.from({ length: 65 }, () => '/x'))).error!.message).toContain('65');
    const reads = await Promise.all([read(['/x']), read(['/x']), read(['/x'])]);
    expect(reads.map(({ error }) => error?.code)).toEqual([
      ...[undefined, undefined, 'resource_exhausted'],
    ]);
    const settings = { flightRecorderSettings: { isOn: false } };
    await master.call({ topic: `${SERVICES}flight_recorder_set`, ...settings });
    expect(await valuesOf(['/x'])).toEqual([]);
  });

  it('[RC-31] leaves out images when they are not wanted', async () => {
    const master = new TestMaster({ flightRecorder: { ...FLIGHT, withImages: false } });
    const ada = await master.legacy('ada');
    ada.publish('/camera', 'image2D', {
      width: 1,
      height: 1,
      dataFormat: 0,
      data: Uint8Array.of(1),
    });
    ada.publish('/pose', 'double', 1);
    const { flightRecorder } = await master.call({ topic: `${SERVICES}flight_recorder_get` });
    expect(flightRecorder).toMatchObject({ recordCount: 1, topicCount: 1 });
  });

  it('[RC-31] is turned off and on by admins, within limits', async () => {
    const master = new TestMaster({ flightRecorder: FLIGHT });
    const ada = await master.legacy('ada');
    const set = (flightRecorderSettings: Init<typeof FLIGHT>) =>
      master.call({ topic: `${SERVICES}flight_recorder_set`, flightRecorderSettings });
    ada.publish('/x', 'double', 1);
    expect((await set({ isOn: false })).flightRecorder).toMatchObject({
      isOn: false,
      minutes: 5,
      recordCount: 0,
    });
    ada.publish('/x', 'double', 2);
    const keep = { topic: `${SERVICES}flight_recorder_keep`, flightRecorderKeepRequest: {} };
    expect((await master.call(keep)).error!.code).toBe('failed_precondition');
    expect((await set({ isOn: true, minutes: 2 })).flightRecorder).toMatchObject({
      isOn: true,
      minutes: 2,
      maxBytes: FLIGHT.maxBytes,
      recordCount: 0,
    });
    ada.publish('/x', 'double', 3);
    expect((await master.call(keep)).recording).toMatchObject({ recordCount: 1 });
    expect((await set({ isOn: true, minutes: 61 })).error!.code).toBe('resource_exhausted');
    expect((await set({ isOn: true, minutes: -1 })).error!.code).toBe('invalid_argument');
  });
});

describe('topics of markers', () => {
  it('[RC-24] mark what is recorded, whatever is selected, some a second', async () => {
    const master = new TestMaster();
    const robot = await master.legacy('robot');
    const id = await start(master, { topics: ['/elsewhere'] });
    const topic = '/study/recording/marker';
    robot.publish(topic, 'string', ' Grasped ');
    robot.publish(topic, 'string', '  ');
    robot.publish(topic, 'double', 1);
    robot.publish('/study/recording/markers', 'string', 'not one');
    await master.pass(1_000);
    for (let index = 0; index < 20; index++) robot.publish(topic, 'string', `Slip ${index}`);
    const { markerCount, topicCount } = await stop(master, id);
    expect({ markerCount, topicCount }).toEqual({ markerCount: 11, topicCount: 0 });
    const { summary } = await contentOf(master, id);
    expect(summary.markers[0]).toMatchObject({
      text: 'Grasped',
      author: 'robot',
      authorId: robot.id,
      kind: 'topic',
    });
  });
});

describe('rights on recordings', () => {
  it('[RC-20] [RC-21] let players mark what runs, and change only their own markers', async () => {
    const master = new TestMaster();
    const ada = await joinAs(master, ACCESS_ROLE_PLAYER);
    const bob = await joinAs(master, ACCESS_ROLE_PLAYER);
    const mark = (client: TestClient, recordingMarker: Init<object>) =>
      client.call({
        topic: `${SERVICES}recording_mark`,
        recordingMarker: { clientId: client.id, ...recordingMarker },
      });
    expect((await mark(ada, { text: 'x' })).error!.code).toBe('failed_precondition');
    const id = await start(master);
    const { recordingMarker } = await mark(ada, { text: 'Look here' });
    expect(recordingMarker).toMatchObject({
      text: 'Look here',
      author: 'phone',
      clientId: ada.id,
      timeMs: master.clock.nowMs(),
    });
    const change = { ...recordingMarker, text: 'Mine' };
    expect((await mark(bob, change)).error!.code).toBe('permission_denied');
    expect((await mark(ada, change)).error).toBeUndefined();
    await stop(master, id);
    expect((await mark(ada, { ...change, recordingId: id })).error!.code).toBe('permission_denied');
    const recordingRequest = { id };
    const { recording } = await master.call({
      topic: `${SERVICES}recording_get`,
      recordingRequest,
    });
    expect(recording!.markers).toMatchObject([{ text: 'Mine', author: 'phone' }]);
  });

  it('[RC-5] let participants delete what their invitation recorded, and admins all', async () => {
    const master = new TestMaster();
    const ada = await joinAs(master, ACCESS_ROLE_PARTICIPANT);
    const bob = await joinAs(master, ACCESS_ROLE_PARTICIPANT);
    const admin = await joinAs(master, ACCESS_ROLE_ADMIN);
    const startAs = async (client: TestClient): Promise<string> => {
      const recordingStartRequest = { clientId: client.id, name: 'Mine' };
      const topic = `${SERVICES}recording_start`;
      return (await client.call({ topic, recordingStartRequest })).recording!.id;
    };
    const remove = (client: TestClient, id: string) =>
      client.call({ topic: `${SERVICES}recording_delete`, recordingRequest: { id } });
    const first = await startAs(ada);
    expect((await remove(bob, first)).error!.code).toBe('permission_denied');
    expect((await remove(ada, first)).error).toBeUndefined();
    expect((await remove(admin, await startAs(bob))).error).toBeUndefined();
    expect(master.recordings.files.size).toBe(0);
  });

  it('[RC-31] let viewers look at the flight recorder, and change nothing', async () => {
    const master = new TestMaster();
    const viewer = await joinAs(master, ACCESS_ROLE_VIEWER);
    const looked = await viewer.call({ topic: `${SERVICES}flight_recorder_get` });
    expect(looked.flightRecorder).toMatchObject({ isOn: false });
    const topic = `${SERVICES}recording_start`;
    const refused = await viewer.call({ topic, recordingStartRequest: {} });
    expect(refused.error!.code).toBe('permission_denied');
  });

  it('[EX-90] leave entries in the audit log', async () => {
    const master = new TestMaster();
    await stop(master, await start(master));
    const { auditLog } = await master.call({
      topic: `${SERVICES}audit_log`,
      auditLogRequest: { service: 'recording' },
    });
    expect(auditLog!.entries.map(({ service }) => service)).toEqual([
      `${SERVICES}recording_stop`,
      `${SERVICES}recording_start`,
    ]);
  });
});
