import type { StoredMessage } from '../mcap/chunk-content.ts';
import type { ChannelChunks } from './channel-chunks.ts';
import type { Snapshot, StoredFile } from './stored-file.ts';

/**
 * Finds the last message of each channel at a moment. Reads the last snapshot before, and of the chunks after it, or of
 * all where the snapshot has no value, those that the index names: usually one for each channel.
 */
export async function findLatest(
  file: StoredFile,
  channelChunks: ChannelChunks,
  channelIds: Iterable<number>,
  timeNs: bigint,
): Promise<Map<number, StoredMessage>> {
  const snapshot = await file.snapshotBefore(timeNs);
  const candidates = [...channelIds].map((channelId) => {
    const { chunks, latestEnds } = channelChunks.of(channelId);
    const last = lastStartedBy(chunks, timeNs);
    return { channelId, chunks, latestEnds, last, offset: chunks[last]?.chunkStartOffset ?? 0n };
  });
  // Channels whose value is in the same chunk follow each other: it is loaded once, however many chunks are needed.
  candidates.sort((a, b) => Number(a.offset - b.offset));
  const latest = new Map<number, StoredMessage>();
  for (const candidate of candidates) {
    const message = await latestOf(file, candidate, snapshot, timeNs);
    if (message !== undefined) latest.set(candidate.channelId, message);
  }
  return latest;
}

type Candidate = ReturnType<ChannelChunks['of']> & {
  readonly channelId: number;
  /** Place in `chunks` of the last one that had begun. */
  readonly last: number;
};

async function latestOf(
  file: StoredFile,
  { channelId, chunks, latestEnds, last }: Candidate,
  snapshot: Snapshot | undefined,
  timeNs: bigint,
): Promise<StoredMessage | undefined> {
  const known = snapshot?.messages.get(channelId);
  const after = snapshot !== undefined && known !== undefined ? snapshot.offset : 0n;
  let best = known;
  let bestOffset = after;
  for (let i = last; i >= 0; i--) {
    if (best !== undefined && latestEnds[i]! < best.logTimeNs) break;
    const offset = chunks[i]!.chunkStartOffset;
    if (offset < after) continue;
    const found = (await file.messagesOf(chunks[i]!)).latestAt(channelId, timeNs);
    if (found === undefined) continue;
    // Of the same time, the one that was written later.
    const isNewer = best === undefined || found.logTimeNs > best.logTimeNs;
    if (isNewer || (found.logTimeNs === best?.logTimeNs && offset > bestOffset)) {
      best = found;
      bestOffset = offset;
    }
  }
  return best;
}

/** Place of the last chunk that begins at a moment or before it; -1 when there is none. */
function lastStartedBy(
  chunks: readonly { readonly messageStartTime: bigint }[],
  timeNs: bigint,
): number {
  let low = 0;
  let high = chunks.length;
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (chunks[middle]!.messageStartTime <= timeNs) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}
