import type { Channel, ChunkIndex } from '@mcap/core';

import type { StoredMessage } from '../mcap/chunk-content.ts';
import { parseEvent } from '../records/parse-event.ts';
import { RecordingError, RecordingLimitError } from '../records/recording-error.ts';
import {
  EVENT_TOPICS,
  type EventKind,
  type Marker,
  type RecordingEvent,
} from '../records/recording-event.ts';
import { READING_LIMITS } from '../storage/reading-limits.ts';
import type { ChannelChunks } from './channel-chunks.ts';
import type { StoredFile } from './stored-file.ts';

/** Reads at the same time: events are in many small chunks. Large chunks are read one after the other. */
const PARALLEL = 16;
const PARALLEL_BYTES = 8n * 1024n * 1024n;

/** Events of a file that were left out, because they are not what they should be. [RC-55] */
export interface MalformedEvents {
  readonly count: number;
  /** What is wrong with the first one, and where: a sentence. */
  readonly first: string;
}

/** Events of a file. */
export interface EventsOfFile {
  /** In the order in which they were written. */
  readonly events: readonly RecordingEvent[];
  /** Undefined when there are none. */
  readonly malformed: MalformedEvents | undefined;
}

/** The kind of events that a channel holds; undefined for records. */
export function eventKindOf(channel: Channel, schemaName: string): EventKind | undefined {
  if (!schemaName.startsWith('ubii.recording.')) return undefined;
  const kinds = Object.keys(EVENT_TOPICS) as EventKind[];
  return kinds.find((kind) => EVENT_TOPICS[kind] === channel.topic);
}

/**
 * Reads all events of some channels.
 *
 * @throws RecordingError when a chunk of events is broken, or there are too many events for the memory [RC-43]
 */
export async function readEvents(
  file: StoredFile,
  channelChunks: ChannelChunks,
  kinds: ReadonlyMap<number, EventKind>,
  maxEvents: number = READING_LIMITS.events,
): Promise<EventsOfFile> {
  if (kinds.size === 0) return { events: [], malformed: undefined };
  const groups = file.groupsOf(channelChunks.ofAny(new Set(kinds.keys())));
  const messages: StoredMessage[] = [];
  let bytes = 0;
  for (let i = 0; i < groups.length;) {
    const together = countTogether(groups, i);
    const loaded = await Promise.all(
      groups.slice(i, i + together).map((group) => file.messagesOfAll(group)),
    );
    i += together;
    for (const message of loaded.flat().flatMap(({ all }) => all)) {
      if (!kinds.has(message.channelId)) continue;
      bytes += message.data.length;
      expectFew(messages.length + 1, bytes, maxEvents);
      // A copy, so that the chunk can be released.
      messages.push({ ...message, data: message.data.slice() });
    }
  }
  messages.sort((a, b) => a.sequence - b.sequence);
  return parseEvents(messages, kinds);
}

/** How many groups, from a place on, are read at the same time. At least one. */
function countTogether(groups: readonly (readonly ChunkIndex[])[], start: number): number {
  let count = 0;
  let bytes = 0n;
  for (const group of groups.slice(start, start + PARALLEL)) {
    for (const { uncompressedSize } of group) bytes += uncompressedSize;
    if (count > 0 && bytes > PARALLEL_BYTES) break;
    count++;
  }
  return count;
}

function expectFew(events: number, bytes: number, maxEvents: number): void {
  const { eventBytes } = READING_LIMITS;
  if (events <= maxEvents && bytes <= eventBytes) return;
  throw new RecordingLimitError(
    `The file has too many events, such as markers. At most ${maxEvents} with ${eventBytes} bytes are read.`,
  );
}

/** The markers among events, by time; without those that were removed. */
export function markersOf(events: readonly RecordingEvent[]): Marker[] {
  const all = events.filter((event) => event.kind === 'marker').map(({ value }) => value);
  return [...new Map(all.map((marker) => [marker.id, marker])).values()]
    .filter(({ isRemoved }) => isRemoved !== true)
    .sort((a, b) => a.timeMs - b.timeMs);
}

function parseEvents(
  messages: readonly StoredMessage[],
  kinds: ReadonlyMap<number, EventKind>,
): EventsOfFile {
  const events: RecordingEvent[] = [];
  let malformed: MalformedEvents | undefined;
  for (const { channelId, data, logTimeNs } of messages) {
    try {
      events.push(parseEvent(kinds.get(channelId)!, logTimeNs, data));
    } catch (error) {
      if (!(error instanceof RecordingError)) throw error;
      malformed = { first: error.message, ...malformed, count: (malformed?.count ?? 0) + 1 };
    }
  }
  return { events, malformed };
}

/** A recording lasts at least until its last marker, which may be after the last record. */
export function withMarkers(
  { startNs, endNs }: { readonly startNs: bigint; readonly endNs: bigint },
  markers: readonly Marker[],
): { readonly startNs: bigint; readonly endNs: bigint } {
  const times = markers
    .filter(({ timeMs }) => Number.isFinite(timeMs))
    .map(({ timeMs }) => BigInt(Math.round(timeMs * 1000)) * 1000n);
  const last = times.at(-1);
  if (last === undefined) return { startNs, endNs };
  return { startNs: startNs === 0n ? times[0]! : startNs, endNs: last > endNs ? last : endNs };
}
