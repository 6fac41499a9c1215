import { readText } from '../binary/read-text.ts';
import { Reader } from '../binary/reader.ts';
import { skipField } from '../binary/skip-field.ts';
import type { TextCache } from '../binary/text-cache.ts';
import { DecodeError } from '../decode-error.ts';
import { messageCheck } from './check-table.ts';
import { fieldOf } from './check-message.ts';
import {
  CLIENT_ID_TAG,
  EXPIRY_MS_TAG,
  KEEP_SECONDS_TAG,
  RECORD_EXTENSION_TAG,
  TOPIC_TAG,
} from './tags.ts';

/** Members of an encoded record besides its value. */
export interface RecordHead {
  /** Empty when it has none. */
  readonly topic: string;
  /** Number of the value member, 0 when there is none. */
  readonly valueField: number;
  /** Client id of the publisher, as stated by the publisher; empty when it stated none. */
  readonly clientId: string;
  /** How long the value outlives its publisher, seconds. [TD-43] */
  readonly keepSeconds: number;
  /** How long the value stands while no newer record comes, milliseconds; 0: as long as any. [TD-47] */
  readonly expiryMs: number;
}

type LifeOfValue = Pick<RecordHead, 'keepSeconds' | 'expiryMs'>;

const NO_LIFE: LifeOfValue = { keepSeconds: 0, expiryMs: 0 };
const RECORD = messageCheck('ubii.topicData.TopicDataRecord');

/**
 * Reads what an encoded record says beside its value, which is stepped over.
 *
 * @param record a record that was checked before
 * @param texts remembers topics and ids, for callers that read many records
 * @throws DecodeError when the outer structure is broken
 */
export function readRecordHead(record: Uint8Array, texts?: TextCache): RecordHead {
  const reader = new Reader(record);
  let topic = '';
  let valueField = 0;
  let clientId = '';
  let life = NO_LIFE;
  try {
    while (reader.pos < reader.end) {
      const tag = reader.tag();
      if (tag === TOPIC_TAG) topic = readText(reader, texts);
      else if (tag === CLIENT_ID_TAG) clientId = readText(reader, texts);
      else if (tag === RECORD_EXTENSION_TAG) life = readLife(reader, life);
      else {
        const field = fieldOf(RECORD, tag);
        if (field?.isOneofMember === true) valueField = field.number;
        skipField(reader, tag);
      }
    }
  } catch (cause) {
    throw DecodeError.wrap(RECORD.name, record.length, cause);
  }
  // A spread would cost more than all of the above.
  const { keepSeconds, expiryMs } = life;
  return { topic, valueField, clientId, keepSeconds, expiryMs };
}

/** @param before what an earlier occurrence of the member said, which this one is merged into */
function readLife(reader: Reader, before: LifeOfValue): LifeOfValue {
  let { keepSeconds, expiryMs } = before;
  const outerEnd = reader.enter();
  while (reader.pos < reader.end) {
    const tag = reader.tag();
    if (tag === KEEP_SECONDS_TAG) keepSeconds = reader.int32();
    else if (tag === EXPIRY_MS_TAG) expiryMs = reader.int32();
    else skipField(reader, tag);
  }
  reader.end = outerEnd;
  return { keepSeconds, expiryMs };
}
