import type { Share } from '../shares/accounts.ts';
import type { ClientAccess } from './caller.ts';

/** Whose share a client that came in like this uses [AC-82]. */
export function shareOf({ role, grant }: ClientAccess): Share {
  return { shareClass: role === 'none' ? 'player' : role, invitation: grant };
}
