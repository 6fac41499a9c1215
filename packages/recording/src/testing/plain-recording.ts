import { encodeRecord } from '@ubii/proto';
import { McapWriter } from '@mcap/core';
import { EVENT_TOPICS, type EventKind } from '../records/recording-event.ts';
import { PROFILE } from '../records/recording-header.ts';
import { RECORD_SCHEMA_NAME } from '../records/event-schemas.ts';
import { MemoryFile } from './memory-file.ts';
import { SAMPLE_START_NS } from './sample-records.ts';

const EVENTS: Readonly<Record<EventKind, unknown>> = {
  marker: { id: 'm', timeMs: 0, text: 'go', author: 'Jo', authorId: 'jo', kind: 'key' },
  clock: { clientId: 'ada', offsetMs: 1, errorMs: 2, driftPpm: 3 },
  session: { id: 's', name: 'S', state: 'running', session: '{"name":"S"}' },
  client: { id: 'ada', name: 'Ada', tags: ['phone'], state: 'active' },
  device: { id: 'd', clientId: 'ada', name: 'D', tags: [], state: 'registered', components: [] },
  gap: { fromMs: 1, untilMs: 2, records: 3, reason: 'busy' },
};

/**
 * A small recording without compression: some records of two topics, and an event of each kind. Tests that change its
 * bytes need not unpack anything.
 */
export async function plainRecording(): Promise<Uint8Array<ArrayBuffer>> {
  const file = new MemoryFile();
  const writer = new McapWriter({ writable: file, chunkSize: 1024 });
  await writer.start({ profile: PROFILE, library: 'test' });
  const header = { name: 'plain', kind: 'recording', masterName: '', version: '1', notes: 'n' };
  const metadata = new Map(Object.entries({ ...header, selection: '{"topics":["/a"]}' }));
  await writer.addMetadata({ name: PROFILE, metadata });
  let sequence = 0;
  const add = async (channelId: number, atMs: number, data: Uint8Array): Promise<void> => {
    const time = SAMPLE_START_NS + BigInt(atMs) * 1_000_000n;
    const times = { logTime: time, publishTime: time };
    await writer.addMessage({ channelId, sequence: sequence++, ...times, data });
  };
  const addChannel = async (name: string, topic: string, encoding: 'json' | 'protobuf') => {
    const schemaId = await writer.registerSchema({ name, encoding: '', data: new Uint8Array() });
    const about = new Map([['clientId', 'ada']]);
    return writer.registerChannel({ schemaId, topic, messageEncoding: encoding, metadata: about });
  };
  for (const [kind, value] of Object.entries(EVENTS)) {
    const topic = EVENT_TOPICS[kind as EventKind];
    const channel = await addChannel(`ubii.recording.${kind}`, topic, 'json');
    await add(channel, 5, new TextEncoder().encode(JSON.stringify(value)));
  }
  for (const topic of ['/a', '/b']) {
    const channel = await addChannel(RECORD_SCHEMA_NAME, topic, 'protobuf');
    for (let index = 0; index < 8; index++) {
      await add(channel, index * 10, encodeRecord({ topic, format: 'double', value: index }));
    }
  }
  await writer.end();
  return file.bytes;
}
