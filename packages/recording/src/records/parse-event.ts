import { hasMoreCharacters } from '@ubii/words';
import { eventSchemaOf, type ObjectSchema, type ValueSchema } from './event-schemas.ts';
import { RecordingError } from './recording-error.ts';
import type { EventKind, EventValue, RecordingEvent } from './recording-event.ts';

/** A value that is not as its schema says: where, and what is wrong, as the end of a sentence. */
interface Problem {
  readonly path: string;
  readonly text: string;
}

/**
 * Reads an event of a file, which may hold anything. Members that the schema does not name are left out.
 *
 * @param timeNs of its message
 * @throws RecordingError that says what is wrong and where [RC-55]
 */
export function parseEvent(kind: EventKind, timeNs: bigint, data: Uint8Array): RecordingEvent {
  let value: unknown;
  try {
    value = JSON.parse(new TextDecoder().decode(data));
  } catch (cause) {
    throw malformed(kind, timeNs, 'it cannot be parsed as JSON', cause);
  }
  const schema = eventSchemaOf(kind);
  const problem = findProblem(schema, value, '');
  if (problem !== undefined) {
    throw malformed(kind, timeNs, `${problem.path || 'it'} ${problem.text}`);
  }
  return { kind, timeNs, value: known(schema, value) } as RecordingEvent;
}

/** Returns whether a value from outside is the value of an event. */
export function isEventValue<K extends EventKind>(kind: K, value: unknown): value is EventValue<K> {
  return findProblem(eventSchemaOf(kind), value, '') === undefined;
}

function findProblem(schema: ValueSchema, value: unknown, path: string): Problem | undefined {
  switch (schema.type) {
    case 'string':
      if (typeof value !== 'string') return { path, text: `is ${wordOf(value)}, and not a text` };
      if (schema.maxLength === undefined || !hasMoreCharacters(value, schema.maxLength)) break;
      return { path, text: `has more than ${schema.maxLength} characters` };
    case 'number':
      return numberProblem(schema, value, path);
    case 'boolean':
      if (typeof value === 'boolean') break;
      return { path, text: `is ${wordOf(value)}, and neither true nor false` };
    case 'array':
      if (!Array.isArray(value)) return { path, text: `is ${wordOf(value)}, and not a list` };
      return firstOf(value, (each, index) => findProblem(schema.items, each, `${path}[${index}]`));
    case 'object':
      return objectProblem(schema, value, path);
  }
  return undefined;
}

function numberProblem(
  { minimum = -Infinity, maximum = Infinity }: Extract<ValueSchema, { type: 'number' }>,
  value: unknown,
  path: string,
): Problem | undefined {
  if (typeof value !== 'number') return { path, text: `is ${wordOf(value)}, and not a number` };
  if (Number.isFinite(value) && value >= minimum && value <= maximum) return undefined;
  return { path, text: `is ${value}, which is out of range` };
}

function objectProblem(
  { properties, required }: ObjectSchema,
  value: unknown,
  path: string,
): Problem | undefined {
  if (!isObject(value)) return { path, text: `is ${wordOf(value)}, and not an object` };
  return firstOf(Object.entries(properties), ([name, schema]) => {
    const inner = path === '' ? name : `${path}.${name}`;
    if (Object.hasOwn(value, name)) return findProblem(schema, value[name], inner);
    return required.includes(name) ? { path: inner, text: 'is missing' } : undefined;
  });
}

function firstOf<T>(
  list: readonly T[],
  find: (each: T, index: number) => Problem | undefined,
): Problem | undefined {
  for (const [index, each] of list.entries()) {
    const problem = find(each, index);
    if (problem !== undefined) return problem;
  }
  return undefined;
}

/** A copy of a value that is as its schema says. */
function known(schema: ValueSchema, value: unknown): unknown {
  if (schema.type === 'array') {
    return (value as readonly unknown[]).map((each) => known(schema.items, each));
  }
  if (schema.type !== 'object') return value;
  const members = value as Readonly<Record<string, unknown>>;
  return Object.fromEntries(
    Object.entries(schema.properties)
      .filter(([name]) => Object.hasOwn(members, name))
      .map(([name, inner]) => [name, known(inner, members[name])]),
  );
}

function isObject(value: unknown): value is Readonly<Record<string, unknown>> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function wordOf(value: unknown): string {
  if (value === null) return 'null';
  if (Array.isArray(value)) return 'a list';
  if (typeof value === 'object') return 'an object';
  if (typeof value === 'boolean') return String(value);
  return typeof value === 'string' ? 'a text' : 'a number';
}

function malformed(kind: EventKind, timeNs: bigint, what: string, cause?: unknown): RecordingError {
  const time = new Date(Number(timeNs / 1_000_000n)).toISOString();
  return new RecordingError(`The ${kind} event of ${time} is malformed: ${what}.`, { cause });
}
