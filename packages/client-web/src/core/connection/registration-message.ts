import type { Client, Init, ServiceRequestOf } from '@ubii/proto';
import { clientRole } from './join.ts';
import { LIBRARY_NAME } from './library-name.ts';
import type { ClientProfile, Membership } from './membership.ts';
import type { Identity } from './identity.ts';

/** What a client says when it registers; with its id when it was there before. */
export function registrationOf(
  profile: ClientProfile,
  identity: Identity | undefined,
  sentMs: number,
): Init<ServiceRequestOf<'clientRegistration'>> {
  const { name, description, tags, node, processingModules, isDedicatedNode, mark } = profile;
  const resumeToken = identity?.resumeToken;
  return {
    name,
    ...(description === '' ? {} : { description }),
    ...(tags.length === 0 ? {} : { tags: [...tags] }),
    ...(processingModules.length === 0 ? {} : { processingModules: [...processingModules] }),
    ...(isDedicatedNode ? { isDedicatedProcessingNode: true } : {}),
    // An id without a token proves nothing, and an original master refuses the id of a client it still has.
    ...(resumeToken === undefined ? {} : { id: identity!.clientId }),
    extension: {
      recordLists: true, // [EX-2]
      library: LIBRARY_NAME, // [EX-25]
      sentMs, // [EX-51]
      ...(resumeToken === undefined ? {} : { resumeToken }), // [EX-3]
      ...(node === undefined ? {} : { node }), // [PM-60]
      ...(mark === undefined ? {} : { mark }), // [EX-100]
    },
  };
}

/** What the master answered. */
export function membershipOf({ id, extension }: Client, serial: number): Membership {
  return {
    identity: {
      clientId: id,
      resumeToken: extension?.resumeToken || undefined,
      ...(extension?.credential ? { credential: extension.credential } : {}), // [AC-13]
    },
    isExtended: extension !== undefined, // [EX-1]
    tellsTime: extension?.tellsTime ?? false,
    masterVersion: extension?.masterVersion || undefined,
    masters: extension?.masters ?? [], // [CU-26]
    isInCluster: (extension?.masterId ?? '') !== '', // [CU-80]
    role: clientRole(extension?.role ?? 0),
    serial,
  };
}
