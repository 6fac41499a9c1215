import { RECORD_SCHEMA } from '@ubii/proto/record-schema';
import type { Channel } from '@mcap/core';
import type { FileIndex } from '../mcap/file-index.ts';
import { RECORD_SCHEMA_NAME } from '../records/record-schema-name.ts';
import { describeRecord } from '../records/describe-record.ts';
import { eventSchema } from '../records/event-schemas.ts';
import type { ForeignChannel, RecordedRecord } from '../records/recorded-record.ts';
import type { RecordedTopic } from '../records/recording-summary.ts';
import { EVENT_TOPICS, type EventKind } from '../records/recording-event.ts';

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

  /** What was written of each topic and publisher so far. */
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
