import type { ServiceError } from '@ubii/proto';
import type { Grant, GrantId } from './grant.ts';
import type { Role } from './roles.ts';

/**
 * A caller after its transport and token were checked: `local`: on this computer without a token [AC-2]; `network`:
 * admitted without a token [AC-4]; `client`: a joined client with its credential [AC-13]; `joining`: with a token or
 * code, to register; `stranger`: all others.
 */
export type Caller =
  | { readonly kind: 'local'; readonly role: 'admin' | 'participant' }
  | { readonly kind: 'network'; readonly role: 'participant' }
  | {
      readonly kind: 'client';
      readonly role: Role;
      readonly clientId: string;
      readonly grant: Grant;
      /** The client that joined first, with whose credential further ones did [AC-23]; else itself. */
      readonly holderId: string;
      /** End of the credential, epoch milliseconds. */
      readonly expiresMs: number;
    }
  | { readonly kind: 'joining'; readonly role: 'none'; readonly grant: Grant }
  | {
      readonly kind: 'stranger';
      readonly role: 'none';
      /** Why it is not admitted. */
      readonly refusal: ServiceError;
    };

/** Access of a client, stored with it. [AC-20] */
export interface ClientAccess {
  readonly kind: 'local' | 'network' | 'grant';
  readonly role: Role;
  /** Its invitation; undefined for all but `grant`. */
  readonly grant: Grant | undefined;
  /** The client that joined first, with whose credential this one did [AC-23]; undefined for itself. */
  readonly holderId: string | undefined;
  /** End of its newest credential, epoch milliseconds. */
  readonly expiresMs: number;
}

/** Access of a client that needed no token, on a trusted computer. [AC-40] */
export const TRUSTED_ACCESS: ClientAccess = withoutGrant('local', 'admin');
const LOCAL_ACCESS = withoutGrant('local', 'participant');
const NETWORK_ACCESS = withoutGrant('network', 'participant');

/**
 * Returns the rights of a client that this caller registers.
 * @param expiresMs end of the credential it is given, epoch milliseconds
 * @throws ServiceError when it is a stranger
 */
export function accessOf(caller: Caller, expiresMs: number): ClientAccess {
  switch (caller.kind) {
    case 'local':
      return caller.role === 'admin' ? TRUSTED_ACCESS : LOCAL_ACCESS;
    case 'network':
      return NETWORK_ACCESS;
    case 'client':
    case 'joining': {
      const { grant } = caller;
      const holderId = caller.kind === 'client' ? caller.holderId : undefined;
      return { kind: 'grant', role: grant.role, grant, holderId, expiresMs };
    }
    case 'stranger':
      throw caller.refusal;
  }
}

/** Grant with which a caller creates objects; undefined for callers that need none [AC-90]. */
export function grantOf(caller: Caller): GrantId | undefined {
  return caller.kind === 'client' && !caller.grant.hereOnly ? caller.grant.id : undefined;
}

/** The same for a client. */
export function grantOfAccess({ grant }: ClientAccess): GrantId | undefined {
  return grant === undefined || grant.hereOnly ? undefined : grant.id;
}

function withoutGrant(kind: 'local' | 'network', role: Role): ClientAccess {
  return { kind, role, grant: undefined, holderId: undefined, expiresMs: Number.POSITIVE_INFINITY };
}
