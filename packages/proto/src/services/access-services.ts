import { withoutPayload, withPayload } from './define-service.ts';

/** Services about who may join, and as what. [AC-10] to [AC-16] */
export const ACCESS_SERVICES = {
  joinCheck: withPayload(
    '/services/ubii/join_check',
    'joinCheckRequest',
    'joinCheck',
    'Says what a join token or code is good for, or what the caller may do.',
  ),
  accessGrantCreate: withPayload(
    '/services/ubii/access_grant_create',
    'accessGrantCreateRequest',
    'accessGrantCreated',
    'Makes leave to join, and shows its token and its code once.',
  ),
  accessGrantList: withoutPayload(
    '/services/ubii/access_grant_list',
    'accessGrantList',
    'Lists the leaves to join, with how many have joined.',
  ),
  accessGrantRevoke: withPayload(
    '/services/ubii/access_grant_revoke',
    'accessGrantRevokeRequest',
    'accessGrant',
    'Takes leave to join back, and disconnects all who have joined with it.',
  ),
  auditLog: withPayload(
    '/services/ubii/audit_log',
    'auditLogRequest',
    'auditLog',
    'Returns what admins and participants did, the newest first.',
  ),
} as const;
