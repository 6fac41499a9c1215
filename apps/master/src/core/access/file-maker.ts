import { roleRefusal } from './join-refusals.ts';
import type { Caller } from './caller.ts';
import type { Grant } from './grant.ts';

/** Makers that joined with no invitation and are no admins. */
const LOCAL = 'local';
const NETWORK = 'network';

/**
 * Returns the maker of what a caller records or saves: its invitation; with the invitation of a terminal, which all share
 * who type its code, the client that joined with the code. Empty for the operator's. [RC-66]
 */
export function fileMakerOf(caller: Caller): string {
  switch (caller.kind) {
    case 'client':
      return makerOfGrant(caller.grant, caller.holderId);
    case 'local':
      return caller.role === 'admin' ? '' : LOCAL;
    case 'network':
      return NETWORK;
    case 'joining':
    case 'stranger':
      return '';
  }
}

/** Whether a caller may read and change what this maker made. [RC-66] */
export function mayUseFilesOf(makerId: string, caller: Caller): boolean {
  if (caller.role === 'admin') return true;
  return caller.role !== 'none' && makerId !== '' && makerId === fileMakerOf(caller);
}

/** @param what such as "recordings" @throws ServiceError when the caller may not use it [RC-66] */
export function requireFilesOf(makerId: string, caller: Caller, what: string): void {
  if (mayUseFilesOf(makerId, caller)) return;
  throw roleRefusal(
    `Only an admin may use ${what} of others. This device joined as ${caller.role}.`,
  );
}

function makerOfGrant({ id, isTerminal, hereOnly }: Grant, holderId: string): string {
  if (hereOnly) return '';
  return isTerminal ? `${id}/${holderId}` : id;
}
