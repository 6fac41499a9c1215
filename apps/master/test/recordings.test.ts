import {
  decode,
  encode,
  RecordingState,
  RECORDING_STATUS_TOPIC,
  type Init,
  type RecordingSelection,
  type RecordingStatus,
  type ServiceRequest,
} from '@ubii/proto';
import { RecordingReader } from '@ubii/recording';
import { describe, expect, it } from 'vitest';
import { LOCAL_CALLER } from '../src/index.ts';
import { MemoryFolder, TestMaster, type TestClient } from '../src/testing/index.ts';
import { readRecording } from '../src/testing/read-recording.ts';
import { contentOf, SERVICES, start, stop } from './recording-world.ts';

async function topicsOf(master: TestMaster, id: string): Promise<string[]> {
  await stop(master, id);
  const { values } = await contentOf(master, id);
  return [...new Set(values.map(([topic]) => topic))].sort();
}

describe('a recording', () => {
  it('[RC-12] of everything leaves out what pages tell each other, unless it is named', async () => {
    const master = new TestMaster();
    const ada = await master.legacy('ada');
    const record = async (selection: Init<RecordingSelection>): Promise<string[]> => {
      const id = await start(master, selection);
      ada.publish(`/${ada.id}/page_state`, 'string', '{"visible":true}');
      ada.publish(`/${ada.id}/graph_editor/presence`, 'string', '{"session":""}');
      ada.publish(`/${ada.id}/preflight`, 'string', '{"address":"http://10.0.0.7"}');
      ada.publish('/lab/page_state', 'double', 1);
      return topicsOf(master, id);
    };
    expect(await record({})).toEqual(['/lab/page_state']);
    expect(await record({ patterns: ['/*/page_state'] })).toHaveLength(2);
    expect(await record({ clients: ['ada'] })).toHaveLength(4);
  });

  it('[RC-1] [RC-4] [RC-5] holds all that was published from its start to its stop', async () => {
    const master = new TestMaster();
    const ada = await master.legacy('ada');
    const id = await start(master);
    ada.publish('/lab/x', 'double', 2);
    ada.publish('/lab/name', 'string', 'Lab');
    const stopped = await stop(master, id);
    ada.publish('/lab/after', 'double', 3);
    expect(stopped).toMatchObject({ id, name: 'Lesson', recordCount: 2, lostCount: 0 });
    expect(stopped.state).toBe(RecordingState.RECORDING_STATE_COMPLETE);
    const { summary, values } = await contentOf(master, id);
    expect(values).toEqual([
      ['/lab/x', 2],
      ['/lab/name', 'Lab'],
    ]);
    expect(summary.topics).toMatchObject([
      { topic: '/lab/x', clientId: ada.id, clientName: 'ada', format: 'double' },
      { topic: '/lab/name', clientId: ada.id, format: 'string' },
    ]);
  });

  it('[RC-9] begins with the values that topics have, as far as they are selected and no events', async () => {
    const master = new TestMaster();
    const ada = await master.legacy('ada');
    ada.publish('/lab/flag', 'bool', false);
    ada.publish('/lab/flag', 'bool', true);
    ada.publish('/lab/pressed', 'keyEvent', { type: 0, key: 'a' });
    ada.publish('/lab/camera', 'image2D', {
      width: 1,
      height: 1,
      dataFormat: 0,
      data: Uint8Array.of(1),
    });
    ada.publish('/other', 'double', 1);
    await master.pass(5_000);
    const startedMs = master.clock.nowMs();
    const id = await start(master, { patterns: ['/lab/**'], withoutImages: true });
    ada.publish('/lab/x', 'double', 2);
    expect(await stop(master, id)).toMatchObject({ recordCount: 2, lostCount: 0 });
    const { values, summary } = await contentOf(master, id);
    expect(values).toEqual([
      ['/lab/flag', true],
      ['/lab/x', 2],
    ]);
    expect(summary.topics[0]).toMatchObject({ topic: '/lab/flag', clientName: 'ada' });
    const reader = await RecordingReader.open(await master.recordings.open(id));
    expect(reader.summary.startNs).toBe(BigInt(startedMs) * 1_000_000n);
  });

  it('[RC-12] tells of clients and sessions with their code, and not of topics of the master', async () => {
    const master = new TestMaster();
    await master.legacy('early');
    const id = await start(master);
    await master.legacy('late');
    const session = {
      name: 'Lights',
      processingModules: [{ name: 'm', onProcessingStringified: '() => ({ secret: 42 })' }],
    };
    await master.call({ topic: '/services/session/runtime/add', session });
    await stop(master, id);
    const file = await master.recordings.open(id);
    const { summary, values } = await readRecording(file);
    expect(values).toEqual([]);
    expect(summary.clients.map(({ name }) => name).sort()).toEqual(['early', 'late']);
    const sessions = await sessionsOf(master, id);
    expect(sessions).toMatchObject([{ name: 'Lights', state: 'created' }]);
    expect(sessions[0]!.session).toContain('secret: 42');
  });

  it('[RC-12] tells of devices with their components: those that are there, come, change and leave', async () => {
    const master = new TestMaster();
    const ada = await master.legacy('ada');
    const register = (id: string, name: string) =>
      ada.call({
        topic: '/services/device/registration',
        device: {
          id,
          name,
          tags: ['phone'],
          clientId: ada.id,
          components: [
            { name: 'tilt', topic: '/tilt', messageFormat: 'vector3', tags: ['sensor'] },
          ],
        },
      });
    await register('early', 'first');
    const id = await start(master);
    await register('late', 'second');
    await register('late', 'renamed');
    await ada.call({
      topic: '/services/device/deregistration',
      device: { id: 'early', clientId: ada.id },
    });
    await stop(master, id);
    const reader = await RecordingReader.open(await master.recordings.open(id));
    const devices = (await reader.devices()).map(({ value }) => value);
    expect(devices.map((device) => [device.id, device.name, device.state])).toEqual([
      ['early', 'first', 'registered'],
      ['late', 'second', 'registered'],
      ['late', 'renamed', 'registered'],
      ['early', 'first', 'deregistered'],
    ]);
    expect(devices[0]).toMatchObject({
      clientId: ada.id,
      tags: ['phone'],
      components: [
        {
          name: 'tilt',
          topic: '/tilt',
          format: 'vector3',
          tags: ['sensor'],
          direction: 'publisher',
        },
      ],
    });
  });

  it('[RC-10] [RC-13] holds what any member of its selection names, and nothing excluded', async () => {
    const master = new TestMaster();
    const ada = await master.legacy('ada');
    const bob = await master.legacy('bob');
    const phone = { name: 'phone', tags: ['sensor'], clientId: ada.id };
    const component = { topic: '/phone/touch', messageFormat: 'double' };
    await ada.call({
      topic: '/services/device/registration',
      device: { ...phone, components: [component] },
    });
    const publishAll = (): void => {
      for (const topic of ['/lab/x', '/lab/y/z', '/phone/touch', '/other']) {
        ada.publish(topic, 'double', 1);
      }
      bob.publish('/bob/x', 'double', 1);
    };
    const recorded = async (selection: Init<RecordingSelection>): Promise<string[]> => {
      const id = await start(master, selection);
      publishAll();
      return topicsOf(master, id);
    };
    expect(await recorded({ topics: ['/other'] })).toEqual(['/other']);
    expect(await recorded({ patterns: ['/lab/*'] })).toEqual(['/lab/x']);
    expect(await recorded({ clients: ['bob'] })).toEqual(['/bob/x']);
    expect(await recorded({ clients: [bob.id], topics: ['/lab/x'] })).toEqual(['/bob/x', '/lab/x']);
    expect(await recorded({ devices: ['sensor'] })).toEqual(['/phone/touch']);
    const excludedPatterns = ['/lab/**', '/phone/*'];
    expect(await recorded({ excludedPatterns })).toEqual(['/bob/x', '/other']);
  });

  it('[RC-13] leaves out images', async () => {
    const master = new TestMaster();
    const ada = await master.legacy('ada');
    const id = await start(master, { withoutImages: true });
    ada.publish('/camera', 'image2D', {
      width: 1,
      height: 1,
      dataFormat: 0,
      data: Uint8Array.of(1),
    });
    ada.publish('/x', 'double', 1);
    expect(await topicsOf(master, id)).toEqual(['/x']);
  });

  it('[RC-10] [RC-11] holds topics of a session, and of devices and clients that come later', async () => {
    const master = new TestMaster();
    const bySession = await start(master, { sessions: ['Lights'] });
    const byDevice = await start(master, { devices: ['phone'] });
    const byName = await start(master, { clients: ['Eve'] });
    const ada = await master.legacy('ada');
    for (const topic of ['/in', '/phone/touch']) ada.publish(topic, 'double', 1);
    await master.pass(100);
    const module = { id: 'm1', name: 'm', onProcessingStringified: '() => ({})' };
    const inputs = [{ internalName: 'x', messageFormat: 'double' }];
    const inputMappings = [{ inputName: 'x', topic: '/in' }];
    await master.call({
      topic: '/services/session/runtime/add',
      session: {
        name: 'Lights',
        processingModules: [{ ...module, inputs }],
        ioMappings: [{ processingModuleId: 'm1', inputMappings }],
      },
    });
    const components = [{ topic: '/phone/touch', messageFormat: 'double' }];
    await ada.call({
      topic: '/services/device/registration',
      device: { name: 'phone', clientId: ada.id, components },
    });
    const eve = await master.legacy('Eve');
    for (const topic of ['/in', '/phone/touch', '/other']) ada.publish(topic, 'double', 2);
    eve.publish('/eve', 'double', 2);
    expect(await topicsOf(master, bySession)).toEqual(['/in']);
    expect(await topicsOf(master, byDevice)).toEqual(['/phone/touch']);
    expect(await topicsOf(master, byName)).toEqual(['/eve']);
  });

  it('[RC-14] holds the clocks that clients report', async () => {
    const master = new TestMaster();
    const ada = await master.extension('ada');
    const id = await start(master);
    ada.sendText('PING 1 12.5 0.5 30');
    ada.publish('/x', 'double', 1);
    await master.pass(2_000);
    await stop(master, id);
    const clocks = await clocksOf(master, id);
    expect(clocks.map(({ value }) => value)).toContainEqual({
      clientId: ada.id,
      offsetMs: -12.5,
      errorMs: 0.5,
      driftPpm: 30,
    });
  });

  it('[RC-7] is closed when the master ends, and listed by the next run', async () => {
    const recordings = new MemoryFolder();
    const master = new TestMaster({ recordings });
    const ada = await master.legacy('ada');
    const id = await start(master);
    ada.publish('/x', 'double', 1);
    await master.master.close();
    const next = new TestMaster({ recordings });
    const { recordingList } = await next.call({ topic: `${SERVICES}recording_list` });
    expect(recordingList!.elements).toMatchObject([{ id, name: 'Lesson', recordCount: 1 }]);
    expect(recordingList!.elements[0]!.state).toBe(RecordingState.RECORDING_STATE_COMPLETE);
  });

  it('[RC-8] is announced while it runs', async () => {
    const master = new TestMaster();
    const page = await master.extension('page');
    await page.subscribe({ subscribeTopics: [RECORDING_STATUS_TOPIC] });
    const id = await start(master);
    page.publish('/x', 'double', 1);
    await master.pass(2_000);
    const statuses = takeStatuses(page);
    expect(statuses[0]!.running).toMatchObject([{ id, name: 'Lesson' }]);
    expect(statuses.at(-1)!.running).toMatchObject([{ recordCount: 1 }]);
    await stop(master, id);
    await master.pass();
    const last = takeStatuses(page).at(-1)!;
    expect(last.running).toEqual([]);
    expect(last.listRevision).toBeGreaterThan(statuses[0]!.listRevision);
  });

  it('[RC-15] is estimated before it starts', async () => {
    const master = new TestMaster();
    const ada = await master.legacy('ada');
    ada.publish('/x', 'double', 0);
    const request = decodedRequest({
      topic: `${SERVICES}recording_estimate`,
      recordingSelection: { patterns: ['/x'] },
    });
    const reply = master.master.handleServiceRequest(request, LOCAL_CALLER);
    await master.pass();
    for (let i = 0; i < 50; i++) ada.publish('/x', 'double', i);
    ada.publish('/y', 'double', 0);
    await master.pass(1_000);
    const { recordingEstimate, error } = (await reply).reply;
    expect(error).toBeUndefined();
    expect(recordingEstimate!.topics).toMatchObject([{ topic: '/x', dataFormat: 'double' }]);
    expect(recordingEstimate!.recordsPerSecond).toBeCloseTo(50, 0);
  });

  it('[RC-19] has a gap where the recorder could not follow, and the master goes on', async () => {
    const master = new TestMaster({ limits: { recorderQueueBytes: 100 } });
    const ada = await master.legacy('ada');
    const bob = await master.legacy('bob');
    await bob.subscribe({ subscribeTopics: ['/x'] });
    const id = await start(master);
    // The recorder has no turn in between, and there is room for one.
    for (const value of [1, 2, 3]) ada.publish('/x', 'double', value);
    expect(bob.takeValues()).toHaveLength(3);
    await master.pass(100);
    ada.publish('/x', 'double', 4);
    const { recordCount, lostCount } = await stop(master, id);
    expect({ recordCount, lostCount }).toEqual({ recordCount: 2, lostCount: 2 });
    expect((await contentOf(master, id)).values.map(([, value]) => value)).toEqual([3, 4]);
  });

  it('[RC-4] is refused beyond the limits', async () => {
    const master = new TestMaster({ limits: { runningRecordings: 1 } });
    await start(master);
    await expect(start(master)).rejects.toThrow('runningRecordings');
    const full = new TestMaster({ limits: { recordings: 1 } });
    await stop(full, await start(full));
    await expect(start(full)).rejects.toThrow('limit recordings');
    const large = new TestMaster({ limits: { recordingsBytes: 10 } });
    await stop(large, await start(large));
    await expect(start(large)).rejects.toThrow('recordingsBytes');
  });
});

function decodedRequest(init: Init<ServiceRequest>): ServiceRequest {
  return decode('ubii.services.ServiceRequest', encode('ubii.services.ServiceRequest', init));
}

async function sessionsOf(master: TestMaster, id: string) {
  const reader = await openReader(master, id);
  return [...(await reader.sessionsAt(2n ** 62n)).values()];
}

async function clocksOf(master: TestMaster, id: string) {
  return (await openReader(master, id)).clocks();
}

async function openReader(master: TestMaster, id: string): Promise<RecordingReader> {
  return RecordingReader.open(await master.recordings.open(id));
}

function takeStatuses(client: TestClient): RecordingStatus[] {
  return client
    .takeRecords()
    .flatMap(({ format, value }) => (format === 'recordingStatus' ? [value] : []));
}
