import type { Serializer } from '@vueuse/core';
import { parse, safeParse, type GenericSchema, type InferOutput } from 'valibot';

/**
 * Parses JSON that a page stored or published, possibly of another version.
 * @param text `null` when nothing is stored
 * @param maxChars longer texts are invalid
 * @returns `undefined` for a text that is not JSON or does not match the schema; never throws
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

/** The same for a parsed value. */
export function storedValue<S extends GenericSchema>(
  schema: S,
  json: unknown,
): InferOutput<S> | undefined {
  const { success, output } = safeParse(schema, json, { abortEarly: true });
  return success ? output : undefined;
}

/**
 * Serializer for `useLocalStorage` and similar functions, with a schema.
 * @param empty JSON from which the schema creates the initial value
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
