import { DecodeError, fromJson, type JsonObject, type MessageType } from '@ubii/proto';
import * as v from 'valibot';
import { storedValue } from './read-stored.ts';

/** JSON has no NaN, but 1e999 is infinite. */
export const finite = v.pipe(v.number(), v.finite());

export const textUpTo = (maxChars: number) => v.pipe(v.string(), v.maxLength(maxChars));

/** A text; empty when missing or invalid. */
export const textOrNone = v.fallback(v.string(), '');

/** A text cut to a length; empty when missing or invalid. */
export const textCutAt = (maxChars: number) =>
  v.fallback(
    v.pipe(
      v.string(),
      v.transform((text) => text.slice(0, maxChars)),
    ),
    '',
  );

/** A boolean; false when missing or invalid. */
export const flag = v.fallback(v.boolean(), false);

/** Undefined when missing or invalid. */
export const maybe = <S extends v.GenericSchema>(schema: S) =>
  v.fallback(v.optional(schema), undefined);

/** Any object. */
export const jsonObject = v.custom<JsonObject>(
  (json) => typeof json === 'object' && json !== null && !Array.isArray(json),
  'should be an object',
);

/** A message of the protocol in JSON form. */
export const message = <const T extends MessageType>(type: T) =>
  v.pipe(
    v.unknown(),
    v.rawTransform(({ dataset, addIssue, NEVER }) => {
      try {
        return fromJson(type, dataset.value);
      } catch (cause) {
        if (!(cause instanceof DecodeError)) throw cause;
        addIssue({
          message: `is damaged: ${cause.message.slice(cause.message.indexOf(': ') + 2)}`,
        });
        return NEVER;
      }
    }),
  );

/** A list; drops invalid elements, and elements above `max`. */
export const validElements = <S extends v.GenericSchema>(element: S, max = Infinity) =>
  v.pipe(
    v.array(v.unknown()),
    v.transform((list) =>
      list
        .map((one) => storedValue(element, one))
        .filter((one) => one !== undefined)
        .slice(0, max),
    ),
  );

/** An object; drops invalid members. */
export const validMembers = <S extends v.GenericSchema>(member: S) =>
  v.pipe(
    v.record(v.string(), v.unknown()),
    v.transform((members): Readonly<Record<string, v.InferOutput<S>>> => {
      const kept = Object.entries(members).flatMap(([name, value]) => {
        const read = storedValue(member, value);
        return read === undefined ? [] : [[name, read] as const];
      });
      return Object.fromEntries(kept);
    }),
  );
