import type { ChunkIndex } from '@mcap/core';
import { timesOf } from '../mcap/file-index.ts';
import { readMetadata } from '../mcap/stored-part.ts';
import { expectMcap, indexBytesOf, readIndex } from '../mcap/open-file.ts';
import { RecordingError } from '../records/recording-error.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import type { Marker } from '../records/recording-event.ts';
import { headerFromMetadata, PROFILE, type RecordingHeader } from '../records/recording-header.ts';
import type { RecordedTopic } from '../records/recording-summary.ts';
import type { RecordingSource } from '../storage/recording-storage.ts';
import { ChannelChunks, activityOf } from './channel-chunks.ts';
import { markersOf, readEvents, withMarkers } from './recorded-events.ts';
import { StoredFile } from './stored-file.ts';
import { channelsOf, type FileChannels } from './topics-of.ts';

/** Longest index that is read: of about three hours with 100 topics. */
const MAX_INDEX_BYTES = 8 * 1024 * 1024;
/** Chunks with markers that are read. */
const MAX_MARKER_CHUNKS = 32;

/** A topic and how much of it there is over time. */
export interface TopicOutline extends RecordedTopic {
  readonly activity: Float32Array;
}

/** The content of the index of a recording: how much was recorded when. */
export interface RecordingOutline {
  readonly header: RecordingHeader;
  /** As in the summary: nanoseconds since the Unix epoch, 0 without records. */
  readonly startNs: bigint;
  readonly endNs: bigint;
  /** Records over time, or bytes in files whose chunks have no message indexes. */
  readonly activity: Float32Array;
  /** In the order of the file, one for each publisher. */
  readonly topics: readonly TopicOutline[];
  /** By time; the first ones of a recording with many. */
  readonly markers: readonly Marker[];
}

/** Reads the outline of a recording with a few small reads: the index, the header and the first markers. */
export class OutlineReader {
  readonly #source: RecordingSource;
  readonly #file: StoredFile;
  readonly #channels: FileChannels;
  readonly #chunks: ChannelChunks;

  private constructor(source: RecordingSource, file: StoredFile) {
    this.#source = source;
    this.#file = file;
    this.#channels = channelsOf(file.index);
    this.#chunks = new ChannelChunks(file.index.chunks);
  }

  /** @throws RecordingError when the source is no MCAP file, has no index or too long a one */
  static async open(source: RecordingSource): Promise<OutlineReader> {
    await expectMcap(source);
    if ((await indexBytesOf(source)) > MAX_INDEX_BYTES) {
      throw new RecordingError('The recording is too long for a preview.');
    }
    const whole = await readIndex(source);
    if (whole === undefined) throw new RecordingError('The end of the file is missing.');
    return new OutlineReader(source, new StoredFile(source, whole.index));
  }

  /** @param parts of equal length into which the recording is divided */
  async outline(parts: number): Promise<RecordingOutline> {
    const { index } = this.#file;
    const header = headerFromMetadata(await readMetadata(this.#source, index, PROFILE));
    const markers = await this.#markers();
    const times = timesOf(this.#recordChunks());
    const { startNs, endNs } = withMarkers(times, markers);
    const { records, topics } = this.#channels;
    const span = { startNs, endNs };
    const { all, byChannel } = activityOf(this.#recordChunks(), records.keys(), span, parts);
    const activities = [...byChannel.values()];
    return {
      header,
      startNs,
      endNs,
      markers,
      activity: all,
      topics: topics.map((topic, i) => ({ ...topic, activity: activities[i]! })),
    };
  }

  /** Finds a record of a topic near a moment, with one read; undefined when that takes more than so many bytes. */
  async recordNear(
    topic: string,
    timeNs: bigint,
    maxBytes: number,
  ): Promise<RecordedRecord | undefined> {
    const channels = [...this.#channels.records.values()].filter((one) => one.topic === topic);
    const ids = new Set(channels.map(({ id }) => id));
    const chunk = nearest(this.#chunks.ofAny(ids), timeNs);
    if (chunk === undefined || chunk.chunkLength > maxBytes) return undefined;
    const { all } = await this.#file.messagesOf(chunk);
    const some = all.filter(({ channelId }) => ids.has(channelId));
    const message = some.find(({ logTimeNs }) => logTimeNs >= timeNs) ?? some.at(-1);
    if (message === undefined) return undefined;
    const { channelId, data: record, logTimeNs, publishTimeNs } = message;
    const clientId = this.#channels.records.get(channelId)?.metadata.get('clientId') ?? '';
    return { topic, clientId, record, logTimeNs, publishTimeNs };
  }

  #recordChunks(): readonly ChunkIndex[] {
    return this.#chunks.ofAny(new Set(this.#channels.records.keys()));
  }

  async #markers(): Promise<Marker[]> {
    const kinds = [...this.#channels.events].filter(([, kind]) => kind === 'marker');
    const ids = new Set(kinds.map(([id]) => id));
    const chunks = this.#chunks
      .ofAny(ids)
      .filter(({ messageIndexOffsets }) => messageIndexOffsets.size > 0);
    const first = new ChannelChunks(chunks.slice(0, MAX_MARKER_CHUNKS));
    return markersOf((await readEvents(this.#file, first, new Map(kinds))).events);
  }
}

/** The chunk whose middle is nearest to a moment. */
function nearest(chunks: readonly ChunkIndex[], timeNs: bigint): ChunkIndex | undefined {
  const distance = ({ messageStartTime, messageEndTime }: ChunkIndex): number =>
    Math.abs(Number(messageStartTime + messageEndTime - 2n * timeNs));
  let best = chunks[0];
  for (const chunk of chunks) {
    if (best !== undefined && distance(chunk) < distance(best)) best = chunk;
  }
  return best;
}
