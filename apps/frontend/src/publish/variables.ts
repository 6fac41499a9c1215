import type { JsonValue } from '@ubii/proto';
import { randomUuid } from '../connection/random-uuid.ts';

/** Placeholders that get a new value in each published record. */
export const VARIABLES = [
  { name: 'uuid', sentence: 'a random UUID' },
  { name: 'timestamp', sentence: 'current time, milliseconds since 1970' },
  { name: 'counter', sentence: 'number of records published before' },
  { name: 'random', sentence: 'random number from 0 to 1' },
] as const;

export type VariableName = (typeof VARIABLES)[number]['name'];

/** Returns the value of each variable. */
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

/** Replaces every `{{variable}}` in the texts of a value. */
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

/** Returns the unknown names in `{{…}}`, which are published unchanged. */
export function unknownVariables(text: string): string[] {
  const known: ReadonlySet<string> = new Set(VARIABLES.map(({ name }) => name));
  const named = Array.from(text.matchAll(/\{\{\s*(\w{1,40})\s*\}\}/g), ([, name]) => name!);
  return [...new Set(named)].filter((name) => !known.has(name));
}
