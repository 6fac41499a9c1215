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
  isReverse: boolean,
): AsyncGenerator<StoredMessage> {
  const { fromNs, untilNs } = span;
  const groups = overlappingGroups(chunks, span);
  if (isReverse) groups.reverse();
  for (const group of groups) {
    const parts = [];
    for (const chunk of group) parts.push((await file.messagesOf(chunk)).all);
    const messages = parts.length === 1 ? parts[0]! : parts.flat().sort(byTime);
    const length = messages.length;
    for (let i = 0; i < length; i++) {
      const message = messages[isReverse ? length - 1 - i : i]!;
      const { channelId, logTimeNs } = message;
      if (logTimeNs >= fromNs && logTimeNs <= untilNs && channelIds.has(channelId)) yield message;
    }
  }
}

/** Chunks in the span: those of one group overlap in time, those of different groups do not. */
function overlappingGroups(chunks: readonly ChunkIndex[], span: TimeSpan): ChunkIndex[][] {
  const groups: ChunkIndex[][] = [];
  let end = -1n;
  for (const chunk of chunks) {
    if (chunk.messageStartTime > span.untilNs || chunk.messageEndTime < span.fromNs) continue;
    // Chunks that only touch stay apart: at the same time, the first of the file comes first.
    if (groups.length > 0 && chunk.messageStartTime < end) groups.at(-1)!.push(chunk);
    else groups.push([chunk]);
    if (chunk.messageEndTime > end) end = chunk.messageEndTime;
  }
  return groups;
}
