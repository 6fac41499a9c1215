import { withoutPayload, withPayload } from './define-service.ts';

/** Services about who may join, and as what. [AC-10] to [AC-16] */
export const ACCESS_SERVICES = {
  joinCheck: withPayload(
    '/services/ubii/join_check',
    'joinCheckRequest',
    'joinCheck',
    'Returns the role and page of a join token or code, or the rights of the caller.',
  ),
  accessGrantCreate: withPayload(
    '/services/ubii/access_grant_create',
    'accessGrantCreateRequest',
    'accessGrantCreated',
    'Creates an invitation and returns its token and its code, once.',
  ),
  accessGrantList: withoutPayload(
    '/services/ubii/access_grant_list',
    'accessGrantList',
    'Lists the invitations, with the number of joins of each.',
  ),
  accessGrantRevoke: withPayload(
    '/services/ubii/access_grant_revoke',
    'accessGrantRevokeRequest',
    'accessGrant',
    'Revokes an invitation, and disconnects all clients that joined with it.',
  ),
  auditLog: withPayload(
    '/services/ubii/audit_log',
    'auditLogRequest',
    'auditLog',
    'Returns the audit log: actions of admins and participants, newest first.',
  ),
} as const;
