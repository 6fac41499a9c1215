import { RECORD_SCHEMA } from '@ubii/proto/record-schema';
import { McapRecordBuilder, type Channel, type Attachment, type Message } from '@mcap/core';

import { SNAPSHOT_NAME, SNAPSHOT_TYPE, type FileIndex } from '../mcap/file-index.ts';
import { RECORD_SCHEMA_NAME, eventSchema } from '../records/event-schemas.ts';
import {
  describeRecord,
  type ForeignChannel,
  type RecordedRecord,
} from '../records/recorded-record.ts';
import { EVENT_TOPICS, type EventKind } from '../records/recording-event.ts';
import type { RecordedTopic } from '../records/recording-summary.ts';

/** Ids of channels have 16 bits; those of events come first. */
const MAX_CHANNELS = 65_535;
/** Channels that are kept free for events. */
const EVENT_CHANNELS = Object.keys(EVENT_TOPICS).length;

/** Channels with this id have no schema. */
const NO_SCHEMA = 0;

/** A topic and publisher of a file that is being written. */
export type WrittenTopic = Pick<
  RecordedTopic,
  'topic' | 'clientId' | 'clientName' | 'format' | 'records'
>;

/** The channels of a file: one for each topic and publisher, and one for each kind of events. */
export class Channels {
  readonly #file: FileIndex;
  readonly #records = new Map<string, Map<string, Channel>>();
  readonly #foreign = new Map<ForeignChannel, Channel>();
  readonly #foreignSchemas = new Map<ForeignChannel['schema'], number>([[undefined, NO_SCHEMA]]);
  readonly #events = new Map<EventKind, Channel>();
  readonly #clientNames = new Map<string, string>();
  #recordSchemaId: number | undefined;

  /** @param file gets channels and schemas; those of events that it has are used again */
  constructor(file: FileIndex) {
    this.#file = file;
    for (const [kind, topic] of Object.entries(EVENT_TOPICS)) {
      for (const channel of file.channels.values()) {
        if (channel.topic === topic) this.#events.set(kind as EventKind, channel);
      }
    }
  }

  /** Channels of records. */
  get recordChannels(): number {
    let count = this.#foreign.size;
    for (const byClient of this.#records.values()) count += byClient.size;
    return count;
  }

  /** Statistics of each topic and publisher so far. */
  get recordTopics(): WrittenTopic[] {
    return [...this.#records.values()].flatMap((byClient) =>
      [...byClient.values()].map(({ id, topic, metadata }) => ({
        topic,
        clientId: metadata.get('clientId') ?? '',
        clientName: metadata.get('clientName') ?? '',
        format: metadata.get('format') ?? '',
        records: Number(this.#file.messages.get(id) ?? 0n),
      })),
    );
  }

  /** Names the channels that a client publishes on from now on. */
  nameClient(id: string, name: string): void {
    this.#clientNames.set(id, name);
  }

  /** The channel of a record; undefined when the file can have no further ones. */
  ofRecord({ topic, clientId, record, foreign }: RecordedRecord): Channel | undefined {
    if (foreign !== undefined) return this.#ofForeign(topic, foreign);
    let byClient = this.#records.get(topic);
    if (byClient === undefined) this.#records.set(topic, (byClient = new Map<string, Channel>()));
    const known = byClient.get(clientId);
    if (known !== undefined) return known;
    if (this.#isFull) return undefined;
    this.#recordSchemaId ??= this.#addSchema(RECORD_SCHEMA_NAME, 'protobuf', recordSchemaBytes());
    const channel = this.#addChannel(topic, this.#recordSchemaId, 'protobuf', {
      clientId,
      clientName: this.#clientNames.get(clientId) ?? '',
      format: describeRecord(record).format ?? '',
    });
    byClient.set(clientId, channel);
    return channel;
  }

  get #isFull(): boolean {
    return this.#file.channels.size >= MAX_CHANNELS - EVENT_CHANNELS;
  }

  /** A channel as another program described it. */
  #ofForeign(topic: string, foreign: ForeignChannel): Channel | undefined {
    const known = this.#foreign.get(foreign);
    if (known !== undefined || this.#isFull) return known;
    const { schema, messageEncoding, metadata } = foreign;
    let schemaId = this.#foreignSchemas.get(schema);
    if (schemaId === undefined) {
      const { name, encoding, data } = schema!;
      schemaId = this.#addSchema(name, encoding, data);
      this.#foreignSchemas.set(schema, schemaId);
    }
    const members = Object.fromEntries(metadata);
    const channel = this.#addChannel(topic, schemaId, messageEncoding, members);
    this.#foreign.set(foreign, channel);
    return channel;
  }

  /** The channel of a kind of events. */
  ofEvent(kind: EventKind): Channel {
    const known = this.#events.get(kind);
    if (known !== undefined) return known;
    const schema = new TextEncoder().encode(eventSchema(kind));
    const schemaId = this.#addSchema(`ubii.recording.${kind}`, 'jsonschema', schema);
    const channel = this.#addChannel(EVENT_TOPICS[kind], schemaId, 'json', {});
    this.#events.set(kind, channel);
    return channel;
  }

  #addSchema(name: string, encoding: string, data: Uint8Array): number {
    const id = nextId(this.#file.schemas, 1);
    this.#file.schemas.set(id, { id, name, encoding, data });
    return id;
  }

  #addChannel(
    topic: string,
    schemaId: number,
    messageEncoding: string,
    metadata: Readonly<Record<string, string>>,
  ): Channel {
    const id = nextId(this.#file.channels, 0);
    const channel = {
      id,
      schemaId,
      topic,
      messageEncoding,
      metadata: new Map(Object.entries(metadata)),
    };
    this.#file.channels.set(id, channel);
    return channel;
  }
}

/** The lowest id that comes after `first` ones and is free; files of our own have no holes. */
function nextId(used: ReadonlyMap<number, unknown>, first: number): number {
  let id = first + used.size;
  while (used.has(id)) id++;
  return id;
}

function recordSchemaBytes(): Uint8Array {
  return Uint8Array.from(atob(RECORD_SCHEMA), (character) => character.charCodeAt(0));
}

/** Larger records are found in their chunks. */
const MAX_RECORD_BYTES = 16 * 1024;
/** A file has a snapshot for each so many bytes: that much is read, at most, to seek. */
const BYTES_BETWEEN = 4 * 1024 * 1024;
/** Snapshots take up to a 16th of a file. */
const SHARE = 16;

type LastValue = { -readonly [K in keyof Message]: Message[K] };

/**
 * The last value of each channel, written as a snapshot now and then: seeking reads one and the few chunks that follow it,
 * and not the chunk that each value was written in. A snapshot is a row of MCAP message records.
 */
export class LastValues {
  readonly #latest = new Map<number, LastValue>();
  #endNs = 0n;
  #nextAt = BigInt(BYTES_BETWEEN);

  /** Remembers a copy of a message, unless a later one of its channel is known. */
  add(message: Message): void {
    if (message.logTime > this.#endNs) this.#endNs = message.logTime;
    const known = this.#latest.get(message.channelId);
    if (known !== undefined && known.logTime > message.logTime) return;
    if (message.data.length > MAX_RECORD_BYTES) {
      this.#latest.delete(message.channelId);
    } else if (known?.data.length === message.data.length) {
      known.data.set(message.data);
      known.logTime = message.logTime;
      known.publishTime = message.publishTime;
      known.sequence = message.sequence;
    } else this.#latest.set(message.channelId, { ...message, data: message.data.slice() });
  }

  /** A snapshot, when one is due. @param position bytes of the file so far */
  snapshotAt(position: bigint): Attachment | undefined {
    if (position < this.#nextAt) return undefined;
    const builder = new McapRecordBuilder();
    for (const message of this.#latest.values()) builder.writeMessage(message);
    const data = builder.buffer;
    this.#nextAt = position + BigInt(Math.max(BYTES_BETWEEN, SHARE * data.length));
    const times = { logTime: this.#endNs, createTime: this.#endNs };
    return { name: SNAPSHOT_NAME, mediaType: SNAPSHOT_TYPE, ...times, data };
  }
}
