import { createMemoryIdentity, createClient } from '@ubii/client-web/node';
import type { UbiiClient } from '@ubii/client-web/node';
import { temporaryFolder } from '@ubii/program/testing';
import { RecordingState, type Init, type Recording, type RecordingSelection } from '@ubii/proto';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { startMaster, startNode } from './programs.ts';

// Each test starts several programs, which takes long on a busy machine.
vi.setConfig({ testTimeout: 90_000 });
const SOON = { timeout: 60_000 };

async function joinAs(url: string, name: string): Promise<UbiiClient> {
  const client = createClient({ url, name, identity: createMemoryIdentity() });
  onTestFinished(() => client.close());
  await client.connect();
  return client;
}

interface Place {
  readonly url: string;
  readonly folder: string;
  readonly identity: string;
}

/** A node that records into a folder. */
async function recorderAt({ url, folder, identity }: Place) {
  const program = startNode([
    ...['--master', url, '--name', 'kitchen', '--record-dir', folder, '--identity', identity],
    ...['--print-endpoints', 'json'],
  ]);
  const { id } = await program.ready<{ id: string }>();
  return { program, id };
}

async function startPlace(): Promise<Place & { ada: UbiiClient }> {
  const { url } = await startMaster();
  const base = temporaryFolder();
  const ada = await joinAs(url, 'Ada');
  return { url, folder: join(base, 'recordings'), identity: join(base, 'identity.json'), ada };
}

function start(
  ada: UbiiClient,
  nodeId: string,
  selection: Init<RecordingSelection>,
): Promise<Recording> {
  return ada.call('recordingStart', { clientId: ada.id, name: 'Lesson', nodeId, selection });
}

const find = async (ada: UbiiClient, id: string): Promise<Recording | undefined> =>
  (await ada.call('recordingList')).elements.find((one) => one.id === id);

/** Topics and records of the file at the master. */
async function contentOf(ada: UbiiClient, url: string, id: string) {
  const { topics } = await ada.call('recordingGet', { id });
  expect((await fetch(`${url}/recordings/${id}.mcap`)).status).toBe(200);
  return topics.map(({ topic, clientName, recordCount }) => [topic, clientName, recordCount]);
}

const files = (folder: string): string[] =>
  readdirSync(folder, { recursive: true })
    .map(String)
    .filter((name) => name.endsWith('.mcap'));

describe('a node that records for the master', () => {
  it('[RC-60] [RC-61] [RC-63] starts, marks and stops by services, and brings the file to the master', async () => {
    const place = await startPlace();
    const { ada, url, folder } = place;
    const { id: nodeId } = await recorderAt(place);
    const { elements: nodes } = await ada.call('nodeList');
    expect(nodes.find(({ clientId }) => clientId === nodeId)?.node).toMatchObject({
      records: true,
    });

    const { id, nodeName } = await start(ada, nodeId, { patterns: ['/lab/**'] });
    expect(nodeName).toBe('kitchen');
    ada.publish('/lab/x', 'double', 1, { immediate: true });
    ada.publish('/other', 'double', 1, { immediate: true });
    ada.publish('/lab/recording/marker', 'string', 'By a topic', { immediate: true });
    // It counts while it runs, and everybody can mark it.
    await expect.poll(async () => (await find(ada, id))?.recordCount, SOON).toBe(2);
    await ada.call('recordingMark', { recordingId: id, clientId: ada.id, text: 'By a service' });
    const marks = async (): Promise<string[]> =>
      (await ada.call('recordingGet', { id })).markers.map(({ text }) => text).sort();
    await expect.poll(marks, SOON).toEqual(['By a service', 'By a topic']);

    await ada.call('recordingStop', { id });
    await expect
      .poll(async () => (await find(ada, id))?.state, SOON)
      .toBe(RecordingState.RECORDING_STATE_COMPLETE);
    expect(await find(ada, id)).toMatchObject({ name: 'Lesson', author: 'Ada', nodeId: '' });
    expect(await contentOf(ada, url, id)).toEqual([
      ['/lab/x', 'Ada', 1],
      ['/lab/recording/marker', 'Ada', 1],
    ]);
    expect(await marks()).toEqual(['By a service', 'By a topic']);
    await expect.poll(() => files(folder), SOON).toEqual([]);
  });

  it('[RC-61] records what the master finds for clients, also what comes later', async () => {
    const place = await startPlace();
    const { ada, url } = place;
    const { id: nodeId } = await recorderAt(place);
    const bob = await joinAs(url, 'Bob');
    bob.publish('/bob/before', 'double', 1, { immediate: true });
    await expect
      .poll(async () => (await ada.call('topicList')).elements, SOON)
      .toContain('/bob/before');
    const { id } = await start(ada, nodeId, { clients: ['Bob'] });
    ada.publish('/ada', 'double', 1, { immediate: true });
    bob.publish('/bob/after', 'double', 2, { immediate: true });
    await expect.poll(async () => (await find(ada, id))?.recordCount, SOON).toBe(2);
    await ada.call('recordingStop', { id });
    await expect.poll(async () => (await find(ada, id))?.nodeId, SOON).toBe('');
    const topics = (await contentOf(ada, url, id)).map(([topic]) => topic);
    expect(topics.sort()).toEqual(['/bob/after', '/bob/before']);
  });

  it('[RC-64] is shown as away when it is killed, and brings what it has when it returns', async () => {
    const place = await startPlace();
    const { ada, url } = place;
    const { program, id: nodeId } = await recorderAt(place);
    const { id } = await start(ada, nodeId, {});
    ada.publish('/lab/x', 'double', 1, { immediate: true });
    await expect.poll(async () => (await find(ada, id))?.recordCount, SOON).toBe(1);
    // A chunk is on the disk: what came a second before the end stays.
    const written = async (): Promise<number> => (await find(ada, id))?.sizeBytes ?? 0;
    const first = await written();
    await expect.poll(written, SOON).toBeGreaterThan(first);
    await program.kill();
    await expect.poll(async () => (await find(ada, id))?.nodeIsAway, SOON).toBe(true);
    await expect(ada.call('recordingStop', { id })).rejects.toThrow('is not connected');

    await recorderAt(place);
    await expect
      .poll(async () => (await find(ada, id))?.state, SOON)
      .toBe(RecordingState.RECORDING_STATE_REPAIRED);
    expect(await contentOf(ada, url, id)).toEqual([['/lab/x', 'Ada', 1]]);
  });

  it('says why it does not record for a master', async () => {
    const { ada } = await startPlace();
    await expect(start(ada, ada.id!, {})).rejects.toThrow('does not record');
  });
});
