import type { ChunkIndex } from '@mcap/core';

/** Chunks by their first time. */
interface ChunkList {
  readonly chunks: readonly ChunkIndex[];
  /** The latest end of each chunk and of those before it in the list. */
  readonly latestEnds: readonly bigint[];
}

/** Says which chunks may have messages of a channel, without reading them. */
export class ChannelChunks {
  readonly #byChannel = new Map<number, ChunkList>();
  readonly #all: ChunkList;
  /** Other programs may leave message indexes out: then each chunk may have any channel. */
  readonly #isIndexed: boolean;

  constructor(chunks: readonly ChunkIndex[]) {
    const sorted = [...chunks].sort(byStart);
    const lists = new Map<number, ChunkIndex[]>();
    for (const chunk of sorted) {
      for (const channelId of chunk.messageIndexOffsets.keys()) {
        const list = lists.get(channelId);
        if (list === undefined) lists.set(channelId, [chunk]);
        else list.push(chunk);
      }
    }
    for (const [channelId, list] of lists) this.#byChannel.set(channelId, toList(list));
    this.#all = toList(sorted);
    this.#isIndexed = sorted.every(({ messageIndexOffsets }) => messageIndexOffsets.size > 0);
  }

  of(channelId: number): ChunkList {
    return this.#isIndexed ? (this.#byChannel.get(channelId) ?? EMPTY) : this.#all;
  }

  /** Chunks that may have messages of some channels, by their first time. */
  ofAny(channelIds: ReadonlySet<number>): readonly ChunkIndex[] {
    if (!this.#isIndexed) return this.#all.chunks;
    return this.#all.chunks.filter(({ messageIndexOffsets }) => {
      for (const channelId of messageIndexOffsets.keys()) {
        if (channelIds.has(channelId)) return true;
      }
      return false;
    });
  }
}

const EMPTY: ChunkList = { chunks: [], latestEnds: [] };

function toList(chunks: readonly ChunkIndex[]): ChunkList {
  let latest = 0n;
  const latestEnds = chunks.map(({ messageEndTime }) => {
    if (messageEndTime > latest) latest = messageEndTime;
    return latest;
  });
  return { chunks, latestEnds };
}

/** By first time; chunks of the same time stay in the order of the file. */
function byStart(a: ChunkIndex, b: ChunkIndex): number {
  if (a.messageStartTime === b.messageStartTime) return 0;
  return a.messageStartTime < b.messageStartTime ? -1 : 1;
}

/** Opcode, length, channel and length of the list of a message index record; then 16 bytes for each message. */
const INDEX_HEAD_BYTES = 15n;
const INDEX_ENTRY_BYTES = 16n;

/** Messages of each channel in a chunk, computed from the places of its message indexes; empty without indexes. */
function countsOf(chunk: ChunkIndex): Map<number, number> {
  const { chunkStartOffset, chunkLength, messageIndexLength, messageIndexOffsets } = chunk;
  const places = [...messageIndexOffsets];
  // Usually they are in order, and a long recording has a million.
  if (places.some(([, offset], i) => i > 0 && offset < places[i - 1]![1]))
    places.sort(([, a], [, b]) => (a < b ? -1 : 1));
  const end = chunkStartOffset + chunkLength + messageIndexLength;
  return new Map(
    places.map(([channelId, offset], i) => {
      const next = places[i + 1]?.[1] ?? end;
      const count = (next - offset - INDEX_HEAD_BYTES) / INDEX_ENTRY_BYTES;
      return [channelId, count > 0n ? Number(count) : 0];
    }),
  );
}

/** How much there is over the length of a recording, in parts of equal length. */
interface ChannelActivity {
  /** Messages, or bytes in files whose chunks have no message indexes. */
  readonly all: Float32Array;
  /** Messages of each channel. */
  readonly byChannel: ReadonlyMap<number, Float32Array>;
}

/** Counts messages of channels over time from the index alone: those of a chunk are spread evenly over it. */
export function activityOf(
  chunks: readonly ChunkIndex[],
  channelIds: Iterable<number>,
  span: { readonly startNs: bigint; readonly endNs: bigint },
  parts: number,
): ChannelActivity {
  const builderOf = (): ActivityBuilder => new ActivityBuilder(span.startNs, span.endNs, parts);
  const all = builderOf();
  const each = new Map(Array.from(channelIds, (id) => [id, builderOf()]));
  for (const chunk of chunks) {
    const { messageStartTime: from, messageEndTime: until, uncompressedSize } = chunk;
    const counts = countsOf(chunk);
    if (counts.size === 0) all.add(from, until, Number(uncompressedSize));
    for (const [channelId, count] of counts) {
      const one = each.get(channelId);
      one?.add(from, until, count);
      if (one !== undefined) all.add(from, until, count);
    }
  }
  return {
    all: all.activity,
    byChannel: new Map(Array.from(each, ([id, { activity }]) => [id, activity])),
  };
}

class ActivityBuilder {
  readonly #startNs: bigint;
  readonly #lengthNs: number;
  readonly activity: Float32Array;

  constructor(startNs: bigint, endNs: bigint, parts: number) {
    this.#startNs = startNs;
    // The last message lies at the very end.
    this.#lengthNs = Math.max(1, Number(endNs - startNs)) * 1.000001;
    this.activity = new Float32Array(parts);
  }

  /** Adds a number, spread evenly over a span. */
  add(fromNs: bigint, untilNs: bigint, amount: number): void {
    const parts = this.activity.length;
    const at = (timeNs: bigint): number =>
      Math.min(Math.max(0, (Number(timeNs - this.#startNs) / this.#lengthNs) * parts), parts);
    const [from, until] = [at(fromNs), at(untilNs)];
    const length = until - from;
    for (let part = Math.floor(from); part < parts && part <= until; part++) {
      const covered = Math.min(until, part + 1) - Math.max(from, part);
      const share = length > 0 ? covered / length : 1;
      this.activity[part]! += amount * share;
      if (length <= 0) return;
    }
  }
}
