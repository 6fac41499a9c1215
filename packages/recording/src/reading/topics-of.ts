import type { Channel } from '@mcap/core';
import type { FileIndex } from '../mcap/file-index.ts';
import type { EventKind } from '../records/recording-event.ts';
import { RECORD_SCHEMA_NAME } from '../records/event-schemas.ts';
import type { ForeignChannel } from '../records/recorded-record.ts';
import type { RecordedTopic } from '../records/recording-summary.ts';
import { eventKindOf } from './recorded-events.ts';

/** The channels of a file. */
export interface FileChannels {
  /** Channels of records. */
  readonly records: ReadonlyMap<number, Channel>;
  /** Channels of events. */
  readonly events: ReadonlyMap<number, EventKind>;
  /** Of those of `records` that hold messages of other programs, by id. */
  readonly foreign: ReadonlyMap<number, ForeignChannel>;
  /** Of the channels of records, in the order of the file. */
  readonly topics: readonly RecordedTopic[];
}

/** Separates channels of records from channels of events. */
export function channelsOf(index: FileIndex): FileChannels {
  const records = new Map<number, Channel>();
  const events = new Map<number, EventKind>();
  const foreign = new Map<number, ForeignChannel>();
  const topics: RecordedTopic[] = [];
  for (const channel of index.channels.values()) {
    const schema = index.schemas.get(channel.schemaId);
    const schemaName = schema?.name ?? '';
    const kind = eventKindOf(channel, schemaName);
    if (kind !== undefined) events.set(channel.id, kind);
    else {
      records.set(channel.id, channel);
      const topic = topicOf(channel, schemaName, index);
      topics.push(topic);
      const { messageEncoding, metadata } = channel;
      if (topic.isRaw) foreign.set(channel.id, { schema, messageEncoding, metadata });
    }
  }
  return { records, events, foreign, topics };
}

function topicOf(channel: Channel, schemaName: string, index: FileIndex): RecordedTopic {
  const { topic, metadata, messageEncoding } = channel;
  return {
    topic,
    clientId: metadata.get('clientId') ?? '',
    clientName: metadata.get('clientName') ?? '',
    format: metadata.get('format') ?? '',
    records: Number(index.messages.get(channel.id) ?? 0n),
    isRaw: schemaName !== RECORD_SCHEMA_NAME || messageEncoding !== 'protobuf',
    schemaName,
    messageEncoding,
  };
}
