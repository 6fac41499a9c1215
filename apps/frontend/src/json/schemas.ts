import { DecodeError, fromJson, type JsonObject, type MessageType } from '@ubii/proto';
import * as v from 'valibot';
import { storedValue } from './read-stored.ts';

/** JSON has no NaN, but 1e999 is infinite. */
export const finite = v.pipe(v.number(), v.finite());

export const textUpTo = (maxChars: number) => v.pipe(v.string(), v.maxLength(maxChars));

/** A text; empty where there is none. */
export const textOrNone = v.fallback(v.string(), '');

/** The beginning of a text; empty where there is none. */
export const textCutAt = (maxChars: number) =>
  v.fallback(
    v.pipe(
      v.string(),
      v.transform((text) => text.slice(0, maxChars)),
    ),
    '',
  );

/** True only when it says so. */
export const flag = v.fallback(v.boolean(), false);

/** Undefined where it is missing or does not fit. */
export const maybe = <S extends v.GenericSchema>(schema: S) =>
  v.fallback(v.optional(schema), undefined);

/** An object of whatever members. */
export const jsonObject = v.custom<JsonObject>(
  (json) => typeof json === 'object' && json !== null && !Array.isArray(json),
  'should be an object',
);

/** A message of the protocol, as the codec reads it. */
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

/** The elements of a list that fit, at most `max` of them. */
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

/** The members of an object whose values fit. */
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
