import { decodeRecord, FAREWELL_TOPIC } from '@ubii/proto';
import type { Publication } from './publication.ts';

/** True when the record says only that its publisher has left [AC-24]. */
export function isOwnFarewell({ client, topic, frame, start, end }: Publication): boolean {
  if (topic !== FAREWELL_TOPIC || client === undefined) return false;
  const { format, value } = decodeRecord(frame.subarray(start, end));
  return format === 'string' && value === client.id;
}
