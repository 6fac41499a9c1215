import type { Share } from '../shares/accounts.ts';
import type { ClientAccess } from './caller.ts';

/** Returns the share that a client with this access uses [AC-82]. */
export function shareOf({ role, grant }: ClientAccess): Share {
  return { shareClass: role === 'none' ? 'player' : role, invitation: grant };
}
