import type { MasterProcess } from '@ubii/harness';
import { AccessRole, type AccessGrantCreateRequest, type AccessGrantCreated } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';

/** An invitation, made as by the host. */
export async function makeGrant(
  master: MasterProcess,
  changes: Partial<AccessGrantCreateRequest> = {},
): Promise<AccessGrantCreated & { readonly id: string }> {
  const { accessGrantCreated, error } = await callService(master.endpoints, {
    topic: '/services/ubii/access_grant_create',
    accessGrantCreateRequest: {
      role: AccessRole.ACCESS_ROLE_PARTICIPANT,
      target: '/topics',
      ...changes,
    },
  });
  if (accessGrantCreated?.grant === undefined) throw new Error(error?.title ?? 'no grant');
  return { ...accessGrantCreated, id: accessGrantCreated.grant.id };
}

export async function revokeGrant(master: MasterProcess, grantId: string): Promise<void> {
  const { error } = await callService(master.endpoints, {
    topic: '/services/ubii/access_grant_revoke',
    accessGrantRevokeRequest: { grantId, reason: 'the story wants it' },
  });
  if (error !== undefined) throw new Error(error.title);
}
