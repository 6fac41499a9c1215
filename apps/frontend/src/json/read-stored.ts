import type { Serializer } from '@vueuse/core';
import { parse, safeParse, type GenericSchema, type InferOutput } from 'valibot';

/**
 * Reads JSON that a page stored or published, perhaps one of another version.
 * @param text `null` where nothing is stored
 * @param maxChars longer texts are none of ours
 * @returns `undefined` for a text that is no JSON or does not fit the schema; never throws
 */
export function readStored<S extends GenericSchema>(
  schema: S,
  text: string | null,
  maxChars = Infinity,
): InferOutput<S> | undefined {
  if (text === null || text.length > maxChars) return undefined;
  try {
    return storedValue(schema, JSON.parse(text));
  } catch {
    return undefined;
  }
}

/** As `readStored`, of a value that is parsed already. */
export function storedValue<S extends GenericSchema>(
  schema: S,
  json: unknown,
): InferOutput<S> | undefined {
  const { success, output } = safeParse(schema, json, { abortEarly: true });
  return success ? output : undefined;
}

/**
 * How `useLocalStorage` and its like read and write a value of a schema.
 * @param empty JSON of which the schema makes the value to begin with
 */
export function storedAs<S extends GenericSchema>(
  schema: S,
  empty: object,
): Serializer<InferOutput<S>> {
  return {
    read: (text) => readStored(schema, text) ?? parse(schema, empty),
    write: (value) => JSON.stringify(value),
  };
}
