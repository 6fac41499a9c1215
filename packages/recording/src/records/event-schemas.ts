import type { EventKind } from './recording-event.ts';

const TEXT = { type: 'string' };
const NUMBER = { type: 'number' };
const TEXTS = { type: 'array', items: TEXT };
const COMPONENT = {
  type: 'object',
  properties: { id: TEXT, name: TEXT, topic: TEXT, format: TEXT, direction: TEXT, tags: TEXTS },
};

const PROPERTIES: Readonly<Record<EventKind, object>> = {
  marker: {
    id: TEXT,
    timeMs: NUMBER,
    text: TEXT,
    author: TEXT,
    authorId: TEXT,
    kind: TEXT,
    isRemoved: { type: 'boolean' },
  },
  clock: { clientId: TEXT, offsetMs: NUMBER, errorMs: NUMBER, driftPpm: NUMBER },
  session: { id: TEXT, name: TEXT, state: TEXT, session: TEXT },
  client: { id: TEXT, name: TEXT, tags: TEXTS, state: TEXT },
  device: {
    id: TEXT,
    clientId: TEXT,
    name: TEXT,
    tags: TEXTS,
    state: TEXT,
    components: { type: 'array', items: COMPONENT },
  },
  gap: { topic: TEXT, fromMs: NUMBER, untilMs: NUMBER, records: NUMBER, reason: TEXT },
};

/** The JSON Schema of a kind of events, as text. */
export function eventSchema(kind: EventKind): string {
  return JSON.stringify({ title: kind, type: 'object', properties: PROPERTIES[kind] });
}
