import { Reader } from '../binary/reader.ts';
import { skipField } from '../binary/skip-field.ts';
import { DecodeError } from '../decode-error.ts';
import { fieldOf } from './check-message.ts';
import {
  BYTES,
  FIXED32,
  FIXED64,
  MESSAGE,
  messageCheck,
  STRING,
  type MessageCheck,
} from './check-table.ts';

/** Result of a scan of an encoded `ServiceRequest`. */
export interface RequestScan {
  /** Of several the last; empty when there is none. */
  readonly topic: string;
  /** Never less than the values decoding makes. */
  readonly values: number;
  /** Position at which there were more values than allowed; undefined: nowhere. */
  readonly excessAt: number | undefined;
}

const REQUEST_TYPE = 'ubii.services.ServiceRequest';
const REQUEST = messageCheck(REQUEST_TYPE);
const TOPIC = REQUEST.low.find((field) => field?.number === 1)!;

/**
 * Finds the topic of an encoded `ServiceRequest` and counts its values: fields, elements and messages
 * within each other. Costs by value, not by byte, and ends at the limit. [SV-43]
 *
 * @throws DecodeError when its structure is broken
 */
export function scanServiceRequest(bytes: Uint8Array, maxValues: number): RequestScan {
  const reader = new Reader(bytes);
  let topic = '';
  const counter = new Counter(maxValues);
  try {
    while (reader.pos < reader.end && counter.hasRoom) {
      const tag = reader.tag();
      if (tag >>> 3 === TOPIC.number && (tag & 7) === TOPIC.wireType) {
        topic = reader.string();
        counter.values++;
      } else counter.countField(reader, REQUEST, tag);
    }
  } catch (cause) {
    throw DecodeError.wrap(REQUEST_TYPE, bytes.byteLength, cause);
  }
  const { values } = counter;
  return { topic, values, excessAt: counter.hasRoom ? undefined : reader.pos };
}

class Counter {
  values = 1;
  readonly #maxValues: number;

  constructor(maxValues: number) {
    this.#maxValues = maxValues;
  }

  get hasRoom(): boolean {
    return this.values <= this.#maxValues;
  }

  countField(reader: Reader, message: MessageCheck, tag: number): void {
    this.values++;
    const field = fieldOf(message, tag);
    if (field === undefined || (tag & 7) !== 2) return skipField(reader, tag);
    switch (field.check) {
      case MESSAGE: {
        const outerEnd = reader.enter();
        while (reader.pos < reader.end && this.hasRoom) {
          this.countField(reader, field.message!, reader.tag());
        }
        reader.end = outerEnd;
        return;
      }
      case STRING:
      case BYTES:
        return reader.skip(reader.length());
      default: {
        const length = reader.length();
        const size = field.check === FIXED64 ? 8 : field.check === FIXED32 ? 4 : 1;
        this.values += Math.ceil(length / size);
        reader.skip(length);
      }
    }
  }
}
