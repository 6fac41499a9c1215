import type { Reader } from '../binary/reader.ts';
import { skipField } from '../binary/skip-field.ts';
import { checkUtf8 } from '../binary/utf8.ts';
import {
  BYTES,
  FIXED32,
  FIXED64,
  LOW_FIELDS,
  MESSAGE,
  STRING,
  VARINT,
  type FieldCheck,
  type MessageCheck,
} from './check-table.ts';

/** The schema's knowledge of a field, if it came with a wire type it may have. */
export function fieldOf(message: MessageCheck, tag: number): FieldCheck | undefined {
  const number = tag >>> 3;
  const field = number < LOW_FIELDS ? message.low[number] : message.high.get(number);
  if (field === undefined) return undefined;
  const wireType = tag & 7;
  return wireType === field.wireType || (wireType === 2 && field.isPackable) ? field : undefined;
}

/**
 * Checks the structure of a message from the reader's position to its end: lengths, wire types,
 * UTF-8, nested messages. Unknown fields pass. Recurses along the schema, which does not contain
 * itself. [TD-12]
 *
 * @throws MalformedError that says where the structure breaks
 */
export function checkMessage(reader: Reader, message: MessageCheck): void {
  while (reader.pos < reader.end) {
    const tag = reader.tag();
    const field = fieldOf(message, tag);
    if (field === undefined) skipField(reader, tag);
    else checkField(reader, field, tag & 7);
  }
}

/** Checks the value of a field and steps over it. */
export function checkField(reader: Reader, field: FieldCheck, wireType: number): void {
  switch (wireType) {
    case 0:
      return reader.skipVarint();
    case 1:
      return reader.skip(8);
    case 5:
      return reader.skip(4);
  }
  switch (field.check) {
    case MESSAGE: {
      const outerEnd = reader.enter();
      checkMessage(reader, field.message!);
      reader.end = outerEnd;
      return;
    }
    case STRING: {
      const length = reader.length();
      checkUtf8(reader.input, reader.pos, reader.pos + length);
      return reader.skip(length);
    }
    case BYTES:
      return reader.skip(reader.length());
    case VARINT: {
      const outerEnd = reader.enter();
      while (reader.pos < reader.end) reader.skipVarint();
      reader.end = outerEnd;
      return;
    }
    case FIXED64:
      reader.skipFixedList(8);
      return;
    case FIXED32:
      reader.skipFixedList(4);
  }
}
