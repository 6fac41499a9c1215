import type { JsonValue } from '@ubii/proto';
import { randomUuid } from '../connection/random-uuid.ts';

/** What stands for something new in each record that is sent. */
export const VARIABLES = [
  { name: 'uuid', sentence: 'a new id' },
  { name: 'timestamp', sentence: 'now, milliseconds since 1970' },
  { name: 'counter', sentence: 'records sent before this one' },
  { name: 'random', sentence: 'a number from 0 to 1' },
] as const;

export type VariableName = (typeof VARIABLES)[number]['name'];

/** Where the values come from. */
export type VariableSource = Readonly<Record<VariableName, () => string>>;

const VARIABLE = /\{\{\s*(uuid|timestamp|counter|random)\s*\}\}/g;

export function variableSource(counter: () => number): VariableSource {
  return {
    uuid: randomUuid,
    timestamp: () => String(Date.now()),
    counter: () => String(counter()),
    random: () => String(Math.random()),
  };
}

/** The value with every `{{variable}}` in its texts filled in. */
export function fillIn(json: JsonValue, source: VariableSource): JsonValue {
  if (typeof json === 'string') {
    if (!json.includes('{{')) return json;
    return json.replace(VARIABLE, (_all, name: VariableName) => source[name]());
  }
  if (Array.isArray(json)) return json.map((element) => fillIn(element, source));
  if (typeof json !== 'object' || json === null) return json;
  return Object.fromEntries(
    Object.entries(json).map(([key, member]) => [key, fillIn(member as JsonValue, source)]),
  );
}
