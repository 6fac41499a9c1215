import type { ChunkIndex } from '@mcap/core';

/** Most bytes of one read, unless a single chunk is larger. */
export const MAX_READ_BYTES = 4 * 1024 * 1024;

/** Which chunks are read together. */
export interface NeighbourLimits {
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
export function countNeighbours(
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
