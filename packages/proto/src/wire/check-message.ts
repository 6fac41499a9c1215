import {
  FIXED32,
  FIXED64,
  LOW_FIELDS,
  MESSAGE,
  STRING,
  VARINT,
  type FieldCheck,
  type MessageCheck,
} from './check-table.ts';
import type { Cursor } from './cursor.ts';
import { MalformedError } from './malformed-error.ts';
import { checkUtf8 } from './utf8.ts';

/** The schema's knowledge of a field, if it came with a wire type it may have. */
export function fieldOf(message: MessageCheck, tag: number): FieldCheck | undefined {
  const number = tag >>> 3;
  const field = number < LOW_FIELDS ? message.low[number] : message.high.get(number);
  if (field === undefined) return undefined;
  const wireType = tag & 7;
  return wireType === field.wireType || (wireType === 2 && field.isPackable) ? field : undefined;
}

/**
 * Checks the structure of a message from the cursor to its end: lengths, wire types, UTF-8, nested
 * messages. Unknown fields pass. Recurses along the schema, which does not contain itself. [TD-12]
 *
 * @throws MalformedError that says where the structure breaks
 */
export function checkMessage(cursor: Cursor, message: MessageCheck): void {
  while (cursor.pos < cursor.end) {
    const tag = cursor.readTag();
    const field = fieldOf(message, tag);
    if (field === undefined) cursor.skipField(tag);
    else checkField(cursor, field, tag & 7);
  }
}

/** Checks the value of a field and steps over it. */
export function checkField(cursor: Cursor, field: FieldCheck, wireType: number): void {
  switch (wireType) {
    case 0:
      return cursor.skipVarint();
    case 1:
      return cursor.skipBytes(8);
    case 5:
      return cursor.skipBytes(4);
  }
  const length = cursor.readLength();
  const end = cursor.pos + length;
  if (field.check === MESSAGE) {
    const outer = cursor.end;
    cursor.end = end;
    checkMessage(cursor, field.message!);
    cursor.end = outer;
  } else if (field.check === STRING) {
    checkUtf8(cursor.bytes, cursor.pos, end);
    cursor.pos = end;
  } else if (field.check === VARINT) {
    const outer = cursor.end;
    cursor.end = end;
    while (cursor.pos < end) cursor.skipVarint();
    cursor.end = outer;
  } else {
    const size = field.check === FIXED64 ? 8 : field.check === FIXED32 ? 4 : 1;
    if (length % size !== 0) {
      throw new MalformedError(
        `${length} bytes at ${cursor.pos} are no list of ${size}-byte numbers`,
      );
    }
    cursor.pos = end;
  }
}
