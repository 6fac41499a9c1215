import type { Core } from '../core.ts';
import { oneLine } from '../one-line.ts';

/** Characters of a client's name [EX-29]. */
export const MAX_NAME_LENGTH = 100;
/** Characters of the reason somebody gives. */
export const MAX_REASON_LENGTH = 200;

/** The name of the client that asks, for people; empty when none does. */
export function nameOfCaller({ clients }: Core, clientId: string): string {
  return oneLine(clients.get(clientId)?.label ?? '', MAX_NAME_LENGTH);
}

/** Who asked for something and why, for the person it affects: `by Ada: the event is over`. */
export function byCaller(core: Core, clientId: string, reason: string): string {
  const why = oneLine(reason, MAX_REASON_LENGTH);
  return `by ${nameOfCaller(core, clientId) || 'somebody'}${why === '' ? '' : `: ${why}`}`;
}
