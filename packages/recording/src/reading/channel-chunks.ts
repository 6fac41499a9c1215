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
