import type { PlayedSession } from '../reading/recording-messages.ts';
import { formatLength } from '../timeline/recording-time.ts';

/** The state of a session at the playhead: `running`, `starts at 0:12`, `ended at 0:30`. */
export function presenceWords({ presence, state, sinceMs }: PlayedSession): string {
  return presence === 'present' ? state : `${presence} at ${formatLength(sinceMs)}`;
}
