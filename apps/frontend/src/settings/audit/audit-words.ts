import { AccessRole, AuditEntryWay, type AuditEntry } from '@ubii/proto';
import { unnamedClient } from '../../connection/display-names.ts';

/** Descriptions of actions, by the end of the service topic: as done, and as tried. */
const DEEDS: Readonly<Record<string, readonly [done: string, tried: string]>> = {
  'session/runtime/add': ['created the session', 'create the session'],
  'session/runtime/start': ['started the session', 'start the session'],
  'session/runtime/stop': ['stopped the session', 'stop the session'],
  'session/runtime/update': ['changed the session', 'change the session'],
  'session/runtime/remove': ['deleted the session', 'delete the session'],
  'session/database/save': ['saved the session', 'save the session'],
  'session/database/delete': ['deleted the stored session', 'delete the stored session'],
  'ubii/session_pause': ['paused the session', 'pause the session'],
  'ubii/session_resume': ['resumed the session', 'resume the session'],
  'processing_module/database/save': ['saved the module', 'save the module'],
  'processing_module/database/delete': ['deleted the module', 'delete the module'],
  'ubii/client_rename': ['renamed', 'rename'],
  'ubii/client_disconnect': ['disconnected', 'disconnect'],
  'ubii/client_throttle': ['throttled', 'throttle'],
  'ubii/asset_set_download': ['started the download of the model', 'download the model'],
  'ubii/asset_set_cancel': [
    'cancelled the download of the model',
    'cancel the download of the model',
  ],
  'ubii/lan_open': ['turned on the local network', 'turn on the local network'],
  'ubii/access_grant_create': ['created the invitation', 'create the invitation'],
  'ubii/access_grant_revoke': ['revoked the invitation', 'revoke the invitation'],
};

const ROLES: Readonly<Record<number, string>> = {
  [AccessRole.ACCESS_ROLE_ADMIN]: 'admin',
  [AccessRole.ACCESS_ROLE_PARTICIPANT]: 'participant',
  [AccessRole.ACCESS_ROLE_PLAYER]: 'player',
  [AccessRole.ACCESS_ROLE_VIEWER]: 'viewer',
};

/** Filters for actions, by a part of the service names. */
export const AREAS = [
  { value: 'all', text: 'everything' },
  { value: 'session', text: 'sessions' },
  { value: 'processing_module', text: 'modules' },
  { value: 'ubii/client', text: 'clients' },
  { value: 'access_grant', text: 'invitations' },
] as const;

export type Area = (typeof AREAS)[number]['value'];

/**
 * Returns the actor: a name, or the kind of access.
 * @param client the client, if known: its display name is used while its own name is unchanged
 */
export function whoOf(
  { clientName, clientId, way, masterName }: AuditEntry,
  client?: { readonly ownName: string | undefined; readonly displayName: string | undefined },
): string {
  if (client?.displayName !== undefined && client.ownName === clientName) return client.displayName;
  if (clientName !== '') return clientName;
  if (clientId !== '') return unnamedClient(clientId);
  if (way === AuditEntryWay.CLUSTER) return `A program that called the master ${masterName}`;
  if (way === AuditEntryWay.LOCAL) return 'A program on the computer of the master';
  return way === AuditEntryWay.NETWORK ? 'A program in an admitted network' : 'A client';
}

/** `started the session Lights`, or `tried to start` it; the service name if there is no description. */
export function deedOf({ service, object, error }: AuditEntry): string {
  const name = service.replace('/services/', '');
  const [done, tried] = DEEDS[name] ?? [`called ${name}`, `call ${name}`];
  return [error === '' ? done : `tried to ${tried}`, object].filter(Boolean).join(' ');
}

/** `participant, invitation Class 7b, through the master Foyer`. */
export function standingOf({ role, grantId, grantLabel, masterName }: AuditEntry): string {
  const invitation = grantId === '' ? undefined : `invitation ${grantLabel || grantId.slice(0, 8)}`;
  const master = masterName === '' ? undefined : `through the master ${masterName}`;
  return [ROLES[role], invitation, master].filter(Boolean).join(', ');
}
