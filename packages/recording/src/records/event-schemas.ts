import { DEFAULT_TEXT_LIMITS } from '@ubii/proto';

import type { EventKind } from './recording-event.ts';

/** Name of the MCAP schema of our records. */
export const RECORD_SCHEMA_NAME = 'ubii.topicData.TopicDataRecord';

/** A part of JSON Schema: what events need. */
export type ValueSchema =
  | { readonly type: 'string'; readonly maxLength?: number }
  | { readonly type: 'number'; readonly minimum?: number; readonly maximum?: number }
  | { readonly type: 'boolean' }
  | { readonly type: 'array'; readonly items: ValueSchema }
  | ObjectSchema;

/** An object with these members, and no others. */
export interface ObjectSchema {
  readonly type: 'object';
  readonly properties: Readonly<Record<string, ValueSchema>>;
  readonly required: readonly string[];
}

const TEXT = { type: 'string' } as const;
const ID = { type: 'string', maxLength: DEFAULT_TEXT_LIMITS.idCharacters } as const;
const NUMBER = { type: 'number' } as const;
/** The latest time that a file can have: nanoseconds of 64 bits, in milliseconds. */
export const MAX_TIME_MS = 2 ** 64 / 1e6 - 1;
const TIME = { type: 'number', minimum: 0, maximum: MAX_TIME_MS } as const;
const COUNT = { type: 'number', minimum: 0, maximum: Number.MAX_SAFE_INTEGER } as const;
const TEXTS = { type: 'array', items: TEXT } as const;
const COMPONENT = object({
  id: ID,
  name: TEXT,
  topic: TEXT,
  format: TEXT,
  direction: TEXT,
  tags: TEXTS,
});

const SCHEMAS: Readonly<Record<EventKind, ObjectSchema>> = {
  marker: object(
    {
      id: ID,
      timeMs: TIME,
      text: TEXT,
      author: TEXT,
      authorId: ID,
      kind: TEXT,
      isRemoved: { type: 'boolean' },
    },
    ['isRemoved'],
  ),
  clock: object({ clientId: ID, offsetMs: NUMBER, errorMs: NUMBER, driftPpm: NUMBER }),
  session: object({ id: ID, name: TEXT, state: TEXT, session: TEXT }),
  client: object({ id: ID, name: TEXT, tags: TEXTS, state: TEXT }),
  device: object({
    id: ID,
    clientId: ID,
    name: TEXT,
    tags: TEXTS,
    state: TEXT,
    components: { type: 'array', items: COMPONENT },
  }),
  gap: object({ topic: TEXT, fromMs: TIME, untilMs: TIME, records: COUNT, reason: TEXT }, [
    'topic',
  ]),
};

/** The schema that values of a kind of events have. */
export function eventSchemaOf(kind: EventKind): ObjectSchema {
  return SCHEMAS[kind];
}

/** The JSON Schema of a kind of events, as text. */
export function eventSchema(kind: EventKind): string {
  return JSON.stringify({ title: kind, ...SCHEMAS[kind] });
}

function object(
  properties: Readonly<Record<string, ValueSchema>>,
  optional: readonly string[] = [],
): ObjectSchema {
  const required = Object.keys(properties).filter((name) => !optional.includes(name));
  return { type: 'object', properties, required };
}
