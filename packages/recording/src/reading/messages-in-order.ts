import type { ChunkIndex } from '@mcap/core';
import { byTime, type StoredMessage } from '../mcap/chunk-content.ts';
import type { StoredFile } from './stored-file.ts';

/** A span of log times, both ends inclusive. */
export interface TimeSpan {
  readonly fromNs: bigint;
  readonly untilNs: bigint;
}

/**
 * Reads the messages of some channels by log time, chunk after chunk; chunks whose times overlap are read together.
 *
 * @param chunks by their first time
 */
export async function* messagesInOrder(
  file: StoredFile,
  chunks: readonly ChunkIndex[],
  channelIds: ReadonlySet<number>,
  span: TimeSpan,
  { isReverse = false, isOnce = false }: { isReverse?: boolean; isOnce?: boolean },
): AsyncGenerator<StoredMessage> {
  const { fromNs, untilNs } = span;
  const groups = overlappingGroups(chunks, span);
  if (isReverse) groups.reverse();
  const messagesOf = file.inOrder(groups.flat(), isOnce);
  for (const group of groups) {
    const parts = [];
    for (const chunk of group) parts.push((await messagesOf(chunk)).all);
    const messages = parts.length === 1 ? parts[0]! : parts.flat().sort(byTime);
    const length = messages.length;
    for (let i = 0; i < length; i++) {
      const message = messages[isReverse ? length - 1 - i : i]!;
      const { channelId, logTimeNs } = message;
      if (logTimeNs >= fromNs && logTimeNs <= untilNs && channelIds.has(channelId)) yield message;
    }
  }
}

/**
 * Chunks in the span: those of one group overlap in time and are in the order of the file, which messages of the same
 * time keep. Those of different groups do not overlap.
 */
function overlappingGroups(chunks: readonly ChunkIndex[], span: TimeSpan): ChunkIndex[][] {
  const groups: ChunkIndex[][] = [];
  let end = -1n;
  for (const chunk of chunks) {
    if (chunk.messageStartTime > span.untilNs || chunk.messageEndTime < span.fromNs) continue;
    const group = groups.at(-1);
    // Chunks that only touch stay apart when they are in the order of the file.
    const touches =
      chunk.messageStartTime === end && group?.some((other) => isBefore(chunk, other));
    if (group !== undefined && (chunk.messageStartTime < end || touches)) group.push(chunk);
    else groups.push([chunk]);
    if (chunk.messageEndTime > end) end = chunk.messageEndTime;
  }
  for (const group of groups) group.sort((a, b) => (isBefore(a, b) ? -1 : 1));
  return groups;
}

function isBefore(a: ChunkIndex, b: ChunkIndex): boolean {
  return a.chunkStartOffset < b.chunkStartOffset;
}
