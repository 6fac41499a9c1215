import type { ChunkIndex } from '@mcap/core';

/** Most bytes of one read, unless a single chunk is larger. */
export const MAX_READ_BYTES = 4 * 1024 * 1024;

/** Which chunks are read together. */
interface NeighbourLimits {
  /** Most bytes of a group, from its first byte to its last. A single chunk may be larger. */
  readonly maxBytes: number;
  /** Most bytes between two chunks of a group, such as message indexes. */
  readonly maxGapBytes: number;
}

/** Bytes of a file. */
export interface ByteSpan {
  readonly from: bigint;
  readonly until: bigint;
}

export const endOf = ({ chunkStartOffset, chunkLength }: ChunkIndex): bigint =>
  chunkStartOffset + chunkLength;

/** From the first byte of some chunks to their last. */
export function spanOf(chunks: readonly ChunkIndex[]): ByteSpan {
  let { chunkStartOffset: from } = chunks[0]!;
  let until = endOf(chunks[0]!);
  for (const chunk of chunks) {
    if (chunk.chunkStartOffset < from) from = chunk.chunkStartOffset;
    if (endOf(chunk) > until) until = endOf(chunk);
  }
  return { from, until };
}

/** How many chunks, from a place in their order on, are close enough in the file for one read. At least one. */
function countNeighbours(
  chunks: readonly ChunkIndex[],
  start: number,
  { maxBytes, maxGapBytes }: NeighbourLimits,
): number {
  let { from, until } = spanOf([chunks[start]!]);
  let count = 1;
  for (; start + count < chunks.length; count++) {
    const chunk = chunks[start + count]!;
    const end = endOf(chunk);
    const gap = chunk.chunkStartOffset >= until ? chunk.chunkStartOffset - until : from - end;
    if (gap > maxGapBytes) break;
    const next = {
      from: chunk.chunkStartOffset < from ? chunk.chunkStartOffset : from,
      until: end > until ? end : until,
    };
    if (next.until - next.from > maxBytes) break;
    ({ from, until } = next);
  }
  return count;
}

/** Divides chunks into groups that are read at once, in their order. */
export function neighbours(
  chunks: readonly ChunkIndex[],
  limits: NeighbourLimits,
): (readonly ChunkIndex[])[] {
  const groups: (readonly ChunkIndex[])[] = [];
  for (let start = 0; start < chunks.length;) {
    const end = start + countNeighbours(chunks, start, limits);
    groups.push(chunks.slice(start, end));
    start = end;
  }
  return groups;
}

/** Bytes of the second read. Each later one has up to twice as many: a reader that stops soon has read little. */
const SECOND_READ_BYTES = 512 * 1024;
/** Message indexes of a full chunk of small records, and chunks of events, are shorter. */
const MAX_GAP_BYTES = 512 * 1024;

interface Window extends ByteSpan {
  readonly bytes: Promise<Uint8Array>;
}

/** What reads ahead. */
export interface ChunkAheadOptions {
  /** In the order in which they are asked for. */
  readonly chunks: readonly ChunkIndex[];
  /** The chunk need not be read. */
  isKnown(chunk: ChunkIndex): boolean;
  read(span: ByteSpan): Promise<Uint8Array>;
}

/** Reads chunks one after the other: neighbours in the file with one read, and the next ones while these are used. */
export class ChunkAhead {
  readonly #options: ChunkAheadOptions;
  /** Place of the first chunk that no window has. */
  #planned = 0;
  #maxBytes = 1;
  #windows: Window[] = [];

  constructor(options: ChunkAheadOptions) {
    this.#options = options;
  }

  /** Returns the record of a chunk, as a copy. */
  async recordOf(chunk: ChunkIndex): Promise<Uint8Array> {
    const window = this.#windowOf(chunk);
    const from = Number(chunk.chunkStartOffset - window.from);
    const bytes = await window.bytes;
    return bytes.slice(from, from + Number(chunk.chunkLength));
  }

  #windowOf(chunk: ChunkIndex): Window {
    const holds = ({ from, until }: Window): boolean =>
      chunk.chunkStartOffset >= from && endOf(chunk) <= until;
    while (!this.#windows.some(holds)) {
      const next = this.#openNext();
      // It was known when the windows were planned, and is no longer.
      if (next === undefined) return this.#open([chunk]);
    }
    // Windows before are not asked for again.
    this.#windows.splice(0, this.#windows.findIndex(holds));
    const isSteady = this.#maxBytes > SECOND_READ_BYTES;
    if (isSteady && this.#windows.length === 1) this.#openNext();
    return this.#windows.find(holds)!;
  }

  #openNext(): Window | undefined {
    const { chunks, isKnown } = this.#options;
    while (this.#planned < chunks.length && isKnown(chunks[this.#planned]!)) this.#planned++;
    if (this.#planned >= chunks.length) return undefined;
    const limits = { maxBytes: this.#maxBytes, maxGapBytes: MAX_GAP_BYTES };
    const end = this.#planned + countNeighbours(chunks, this.#planned, limits);
    const window = this.#open(chunks.slice(this.#planned, end), chunks[end]);
    this.#planned = end;
    this.#maxBytes = Math.min(Math.max(2 * this.#maxBytes, SECOND_READ_BYTES), MAX_READ_BYTES);
    this.#windows.push(window);
    return window;
  }

  /** @param next read after these: what is between is taken along */
  #open(chunks: readonly ChunkIndex[], next?: ChunkIndex): Window {
    const span = spanOf(chunks);
    const gap = next === undefined ? 0n : next.chunkStartOffset - span.until;
    const until = gap > 0n && gap <= MAX_GAP_BYTES ? span.until + gap : span.until;
    const bytes = this.#options.read({ from: span.from, until });
    // A window that was read ahead may fail before it is asked for.
    bytes.catch(() => undefined);
    return { from: span.from, until, bytes };
  }
}
