import type { EncodedRecord, UbiiClient } from '@ubii/client-web/node';
import { encodeRecord, INFO_TOPICS } from '@ubii/proto';
import { RecordingReader, RecordingWriter } from '@ubii/recording';
import { MemoryFile, SAMPLE_HEADER } from '@ubii/recording/testing';
import { expect, it, vi } from 'vitest';
import { ClientRecorder } from './client-recorder.ts';

type Receive = (record: Partial<EncodedRecord>) => void;
type Wanted = string | { readonly glob: string };

/** A client whose requests have these answers, and which receives what the test publishes. */
function aClient(answers: Readonly<Record<string, readonly object[]>>) {
  const receivers = new Map<string, Receive>();
  const client = {
    call: (service: string) => Promise.resolve({ elements: answers[service] ?? [] }),
    masterTime: { nowMs: () => 1_750_000_000_000 },
    subscribeEncoded: (wanted: Wanted, { onRecord }: { onRecord: Receive }) => {
      const name = typeof wanted === 'string' ? wanted : wanted.glob;
      receivers.set(name, onRecord);
      return () => receivers.delete(name);
    },
  } as unknown as UbiiClient;
  return { client, receivers };
}

it('records clients, devices and sessions as they are, and those that come later', async () => {
  const { client, receivers } = aClient({
    clientGetList: [{ id: 'ada-id', name: 'Ada', tags: [], state: 0 }],
    deviceGetList: [{ id: 'd1', name: 'Glove', clientId: 'ada-id', tags: [], components: [] }],
    sessionRuntimeGetList: [{ id: 's1', name: 'Lesson' }],
  });
  const file = new MemoryFile();
  const writer = await RecordingWriter.create(file, SAMPLE_HEADER);
  const recorder = new ClientRecorder(client, writer, {
    patterns: ['/**'],
    isChosen: () => true,
    withImages: true,
    onProgress: () => undefined,
    maxMs: Infinity,
    maxBytes: Infinity,
  });
  const stop = new AbortController();
  const ended = recorder.run(stop.signal);
  await vi.waitFor(() => expect(receivers.has(INFO_TOPICS.newDevice)).toBe(true));
  receivers.get('/**')!({
    topic: '/a',
    publisherId: 'ada-id',
    bytes: encodeRecord({ topic: '/a', format: 'double', value: 1 }),
  });
  const later = { id: 'd2', name: 'Late', clientId: 'ada-id', tags: [], components: [] };
  const topic = INFO_TOPICS.newDevice;
  receivers.get(topic)!({ topic, bytes: encodeRecord({ topic, format: 'device', value: later }) });
  stop.abort();
  expect(await ended).toBe('Stopped');
  expect(receivers.size).toBe(0);
  await writer.end();
  const reader = await RecordingReader.open(file);
  expect(reader.summary).toMatchObject({ records: 1, topics: [{ clientName: 'Ada' }] });
  const devices = await reader.devices();
  expect(devices.map(({ value }) => value.name)).toEqual(['Glove', 'Late']);
  const sessions = await reader.sessions();
  expect(sessions.map(({ value }) => value.name)).toEqual(['Lesson']);
});
