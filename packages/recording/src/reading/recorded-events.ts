import type { Channel } from '@mcap/core';
import type { StoredMessage } from '../mcap/chunk-content.ts';
import { EVENT_TOPICS, type EventKind, type RecordingEvent } from '../records/recording-event.ts';
import type { ChannelChunks } from './channel-chunks.ts';
import type { StoredFile } from './stored-file.ts';

/** Chunks that are loaded at the same time: events are in many small ones. */
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
  const chunks = channelChunks.ofAny(new Set(kinds.keys()));
  const messages: StoredMessage[] = [];
  for (let i = 0; i < chunks.length; i += PARALLEL) {
    const loaded = await Promise.all(
      chunks.slice(i, i + PARALLEL).map((chunk) => file.messagesOf(chunk)),
    );
    for (const { all } of loaded) {
      for (const message of all) if (kinds.has(message.channelId)) messages.push(message);
    }
  }
  messages.sort((a, b) => a.sequence - b.sequence);
  return messages.flatMap((message) => parseEvent(kinds.get(message.channelId)!, message) ?? []);
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
