/** A publisher on a topic, with the retained value before the oldest record. */
export interface Channel {
  readonly number: number;
  readonly topic: string;
  /** Id of the client that publishes; empty for the master. */
  readonly clientId: string;
  /** Entries of it that are held. */
  held: number;
  /** Its last record that left, of those that leave now; where it begins in memory, and its bytes. */
  leavingOffset: number;
  leavingLength: number;
  leavingMs: number;
  isLeaving: boolean;
  /** Nothing of it is held any more; its number may be of another one. */
  isGone: boolean;
}

/** A channel in messages between threads. */
export type NamedChannel = Pick<Channel, 'number' | 'topic' | 'clientId'>;

/** A publisher on a topic; remembers the channel. */
export interface ChannelSource {
  readonly topic: string;
  readonly clientId: string;
  channel: Channel | undefined;
}

/** Channels that have entries or a standing value, by number. */
export class Channels {
  readonly #byTopic = new Map<string, Map<string, Channel>>();
  readonly #byNumber: (Channel | undefined)[] = [];
  readonly #free: number[] = [];
  /** Channels that were taken since they were told last. */
  #untold = new Set<Channel>();

  get topicCount(): number {
    return this.#byTopic.size;
  }

  get(number: number): Channel {
    return this.#byNumber[number]!;
  }

  hasTopic(topic: string): boolean {
    return this.#byTopic.has(topic);
  }

  ofTopic(topic: string): Iterable<Channel> {
    return this.#byTopic.get(topic)?.values() ?? [];
  }

  ofTopics(topics: readonly string[]): NamedChannel[] {
    return topics.flatMap((topic) => [...this.ofTopic(topic)].map(nameOf));
  }

  /** The channel of a source that gets a record. */
  take(source: ChannelSource): Channel {
    const known = source.channel;
    if (known?.isGone === false) return known;
    return (source.channel = this.#find(source));
  }

  /** Ends a channel of which nothing is held. */
  drop(channel: Channel): void {
    const { topic, clientId, number } = channel;
    channel.isGone = true;
    const byClient = this.#byTopic.get(topic)!;
    byClient.delete(clientId);
    if (byClient.size === 0) this.#byTopic.delete(topic);
    this.#byNumber[number] = undefined;
    this.#free.push(number);
    this.#untold.delete(channel);
  }

  /** Channels that were taken since the last call: a number may be of another one than before. */
  takeUntold(): NamedChannel[] {
    if (this.#untold.size === 0) return [];
    const named = [...this.#untold].map(nameOf);
    this.#untold = new Set();
    return named;
  }

  /** All channels. */
  list(): NamedChannel[] {
    return this.#byNumber.filter((channel) => channel !== undefined).map(nameOf);
  }

  #find({ topic, clientId }: ChannelSource): Channel {
    let byClient = this.#byTopic.get(topic);
    if (byClient === undefined) this.#byTopic.set(topic, (byClient = new Map<string, Channel>()));
    let channel = byClient.get(clientId);
    if (channel === undefined) {
      const number = this.#free.pop() ?? this.#byNumber.length;
      channel = {
        number,
        topic,
        clientId,
        held: 0,
        isGone: false,
        leavingOffset: 0,
        leavingLength: 0,
        leavingMs: 0,
        isLeaving: false,
      };
      byClient.set(clientId, channel);
      this.#byNumber[number] = channel;
      this.#untold.add(channel);
    }
    return channel;
  }
}

function nameOf({ number, topic, clientId }: Channel): NamedChannel {
  return { number, topic, clientId };
}

/** Larger values are not kept once they left the window. */
const MAX_RECORD_BYTES = 16 * 1024;

/** A value that stands when the window begins. */
interface StandingValue {
  readonly timeMs: number;
  readonly record: Uint8Array<ArrayBuffer>;
}

/** The last value of each topic and publisher that left the window: what stands when the window begins. [RC-33] */
export class StandingValues {
  readonly #values = new Map<Channel, StandingValue>();
  #bytes = 0;

  get bytes(): number {
    return this.#bytes;
  }

  has(channel: Channel): boolean {
    return this.#values.has(channel);
  }

  /** Keeps a copy in place of an earlier value. @param record of any memory */
  set(channel: Channel, timeMs: number, record: Uint8Array): void {
    this.delete(channel);
    if (record.length > MAX_RECORD_BYTES) return;
    this.#values.set(channel, { timeMs, record: record.slice() });
    this.#bytes += bytesOf(channel, record.length);
  }

  delete(channel: Channel): void {
    const known = this.#values.get(channel);
    if (known === undefined) return;
    this.#values.delete(channel);
    this.#bytes -= bytesOf(channel, known.record.length);
  }

  /** Forgets the values that were kept first. @returns their channels */
  *limitTo(bytes: number): Generator<Channel> {
    for (const channel of this.#values.keys()) {
      if (this.#bytes <= bytes) return;
      this.delete(channel);
      yield channel;
    }
  }

  [Symbol.iterator](): IterableIterator<[Channel, StandingValue]> {
    return this.#values.entries();
  }
}

/** With what map and objects take, about. */
function bytesOf({ topic }: Channel, recordBytes: number): number {
  return 256 + topic.length * 2 + recordBytes;
}
