import { DATA_FORMATS, dataFormatOfField, decodeRecord } from '@ubii/proto';
import type { EncodedRecord } from '../../ports/topic-port.ts';

/**
 * Whether a record tells something else than the one before it, so that it does not replace it: every
 * event does, and a `bool` that changed. Of other formats the newest value is all that matters. [PM-25]
 */
export function isOtherEvent(before: EncodedRecord, next: EncodedRecord): boolean {
  const format = dataFormatOfField(next.valueField);
  if (format === undefined || before.valueField !== next.valueField) return false;
  if (format !== 'bool') return DATA_FORMATS[format].isEvent;
  return decodeRecord(before.bytes).value !== decodeRecord(next.bytes).value;
}
