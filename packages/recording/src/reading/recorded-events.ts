import type { Channel } from '@mcap/core';
import type { StoredMessage } from '../mcap/chunk-content.ts';
import {
  EVENT_TOPICS,
  type EventKind,
  type Marker,
  type RecordingEvent,
} from '../records/recording-event.ts';
import type { ChannelChunks } from './channel-chunks.ts';
import type { StoredFile } from './stored-file.ts';

/** Reads at the same time: events are in many small chunks. */
const PARALLEL = 16;

/** The kind of events that a channel holds; undefined for records. */
export function eventKindOf(channel: Channel, schemaName: string): EventKind | undefined {
  if (!schemaName.startsWith('ubii.recording.')) return undefined;
  const kinds = Object.keys(EVENT_TOPICS) as EventKind[];
  return kinds.find((kind) => EVENT_TOPICS[kind] === channel.topic);
}

/** Reads all events of some channels, in the order in which they were written. Broken ones are left out. */
export async function readEvents(
  file: StoredFile,
  channelChunks: ChannelChunks,
  kinds: ReadonlyMap<number, EventKind>,
): Promise<RecordingEvent[]> {
  const groups = file.groupsOf(channelChunks.ofAny(new Set(kinds.keys())));
  const messages: StoredMessage[] = [];
  for (let i = 0; i < groups.length; i += PARALLEL) {
    const loaded = await Promise.all(
      groups.slice(i, i + PARALLEL).map((group) => file.messagesOfAll(group)),
    );
    for (const { all } of loaded.flat()) {
      for (const message of all) if (kinds.has(message.channelId)) messages.push(message);
    }
  }
  messages.sort((a, b) => a.sequence - b.sequence);
  return messages.flatMap((message) => parseEvent(kinds.get(message.channelId)!, message) ?? []);
}

/** The markers among events, by time; without those that were removed. */
export function markersOf(events: readonly RecordingEvent[]): Marker[] {
  const all = events.filter((event) => event.kind === 'marker').map(({ value }) => value);
  return [...new Map(all.map((marker) => [marker.id, marker])).values()]
    .filter(({ isRemoved }) => isRemoved !== true)
    .sort((a, b) => a.timeMs - b.timeMs);
}

function parseEvent(
  kind: EventKind,
  { data, logTimeNs }: StoredMessage,
): RecordingEvent | undefined {
  try {
    const value: unknown = JSON.parse(new TextDecoder().decode(data));
    return { kind, timeNs: logTimeNs, value } as RecordingEvent;
  } catch {
    return undefined;
  }
}
