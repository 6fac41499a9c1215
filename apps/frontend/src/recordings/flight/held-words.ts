import type { FlightRecorder } from '@ubii/proto';
import { counted } from '@ubii/words';
import { formatLength } from '../timeline/recording-time.ts';

const MINUTE_MS = 60_000;

/** How much the flight recorder holds: `5 minutes`, `2:30 minutes`, `38 seconds`. */
export function heldWords({ heldMs, minutes, recordCount }: FlightRecorder): string {
  if (heldMs >= minutes * MINUTE_MS * 0.98 || recordCount === 0) return counted(minutes, 'minute');
  return heldMs >= MINUTE_MS
    ? `${formatLength(heldMs)} minutes`
    : counted(Math.max(1, Math.round(heldMs / 1000)), 'second');
}
