import type { Core } from '../areas/core.ts';

type Context = Pick<Core, 'clients'>;

/** The name of the client that asks, for people; empty when none does. */
export function nameOfCaller({ clients }: Context, clientId: string): string {
  return clients.get(clientId)?.label ?? '';
}

/** Text with the caller and its reason, for the affected user: `by Ada: the event is over`. */
export function byCaller(core: Context, clientId: string, reason: string): string {
  return `by ${nameOfCaller(core, clientId) || 'an admin'}${reason === '' ? '' : `: ${reason}`}`;
}
