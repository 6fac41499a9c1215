import { decodeRecord, FAREWELL_TOPIC } from '@ubii/proto';
import type { Publication } from './publication.ts';

/** Whether the record says that the client which publishes it is gone, and nobody else [AC-24]. */
export function isOwnFarewell({ client, topic, frame, start, end }: Publication): boolean {
  if (topic !== FAREWELL_TOPIC || client === undefined) return false;
  const { format, value } = decodeRecord(frame.subarray(start, end));
  return format === 'string' && value === client.id;
}
