import { Reader } from './binary/reader.ts';
import { writeMessage } from './binary/write-message.ts';
import { DecodeError } from './decode-error.ts';
import { MESSAGES } from './descriptor.ts';
import { GENERATED_CODECS } from './generated/codec.ts';
import type { MessageTypes } from './generated/messages.ts';
import type { Init } from './init.ts';
import { tableCodec, type CodecOf } from './table-codec.ts';

/** Full name of a message of the schema, for example `ubii.services.ServiceRequest`. */
export type MessageType = keyof MessageTypes;

/** True for the full name of a message of the schema. */
export function isMessageType(text: string): text is MessageType {
  return MESSAGES.has(text);
}

/**
 * Encodes a message. Members given as 0, false or empty text are written too, as the original
 * platform does, except `ProcessingModule.language: 0`, which existing nodes cannot bear.
 *
 * Numbers and truth values are converted as JavaScript does; `DATA_FORMATS[...].validate` checks.
 * The result has memory of its own, which may be transferred to a worker.
 *
 * @throws TypeError when text, bytes or a message is expected and something else given
 */
export function encode<T extends MessageType>(type: T, message: Init<MessageTypes[T]>): Uint8Array {
  return writeMessage<Init<MessageTypes[T]>>(codecOf(type).encode, message);
}

/**
 * Decodes a message into a plain object: scalars and enums are always there, lists always arrays,
 * absent messages `undefined`, at most one member of a oneof is set. Unknown fields are skipped,
 * unknown enum numbers kept.
 *
 * @param bytes borrowed: `bytes` members of the result (pictures) are views of it, not copies
 * @throws DecodeError when the bytes are not this message
 */
export function decode<T extends MessageType>(type: T, bytes: Uint8Array): MessageTypes[T] {
  try {
    return codecOf(type).decode(new Reader(bytes));
  } catch (cause) {
    throw DecodeError.wrap(type, bytes.byteLength, cause);
  }
}

/** Generated functions for the values of topics, the schema table for all other messages. */
export function codecOf<T extends MessageType>(type: T): CodecOf<T> {
  const generated: { readonly [K in MessageType]?: CodecOf<K> } = GENERATED_CODECS;
  return generated[type] ?? tableCodec(type);
}
