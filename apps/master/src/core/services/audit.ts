import { AuditEntryWay, serviceByTopic, type ServiceRequest } from '@ubii/proto';
import type { Caller } from '../access/caller.ts';
import { wireRole } from '../access/roles.ts';
import { SERVICE_RIGHTS } from '../access/service-rights.ts';
import { wireAddressKind } from '../monitoring/client-report.ts';
import type { Core } from '../parts/core.ts';
import { oneLine } from '../texts/one-line.ts';
import { callerId } from './clients.ts';
import type { ServiceHandler } from './handler.ts';

/** `/services/ubii/audit_log` [EX-93] */
export const readAuditLog: ServiceHandler = ({ audit }, request) => ({
  auditLog: audit.read(request.auditLogRequest!),
});

/** What a request is about, to be written down when it is known how it ended. */
export type AuditSubject = string | undefined;

/**
 * What an audited request is about, looked up before it is done: what is removed has no name afterwards.
 * @returns undefined when this service or this caller is not audited [EX-90]
 */
export function auditSubject(core: Core, request: ServiceRequest, caller: Caller): AuditSubject {
  const name = serviceByTopic(request.topic);
  if (name === undefined || !SERVICE_RIGHTS[name].audited) return undefined;
  // Those who have not joined can do nothing, and would fill the log with trying.
  if (caller.kind === 'stranger' || caller.kind === 'joining') return undefined;
  return oneLine(objectOf(core, request), core.limits.reasonCharacters);
}

/** Writes down who did it, and how it ended. @param error code of the error; empty when it was done */
export function writeAudit(
  core: Core,
  request: ServiceRequest,
  caller: Caller,
  object: string,
  error: string,
): void {
  // Only callers that need no credential may name their client. [AC-22]
  const id = caller.kind === 'client' ? caller.clientId : callerId(request);
  const client = core.clients.get(id);
  const grant = caller.kind === 'client' ? caller.grant : undefined;
  core.audit.add({
    service: request.topic,
    object,
    error,
    clientId: caller.kind === 'client' ? caller.clientId : (client?.id ?? ''),
    clientName: client?.spec.name ?? '',
    role: wireRole(caller.role),
    way: wayOf(caller),
    grantId: grant?.id ?? '',
    grantLabel: grant?.label ?? '',
    addressKind: wireAddressKind(caller.kind === 'local' ? 'loopback' : client?.peer.addressKind),
  });
}

/** What it is done to, for people. */
function objectOf(core: Core, request: ServiceRequest): string {
  const { session, sessionList, processingModule, processingModuleList } = request;
  const { clientRenameRequest, clientDisconnectRequest, clientThrottleRequest } = request;
  const { accessGrantCreateRequest, accessGrantRevokeRequest } = request;
  if (request.assetSetRequest !== undefined) return request.assetSetRequest.name;
  if (session !== undefined) return nameOfSession(core, session);
  if (sessionList !== undefined) return listed(sessionList.elements.map(({ name }) => name));
  if (processingModule !== undefined) return processingModule.name || processingModule.id;
  if (processingModuleList !== undefined) {
    return listed(processingModuleList.elements.map(({ name }) => name));
  }
  if (clientRenameRequest !== undefined) {
    const { targetId, name } = clientRenameRequest;
    return `${nameOfClient(core, targetId)} → ${name}`;
  }
  if (clientDisconnectRequest !== undefined) {
    return nameOfClient(core, clientDisconnectRequest.targetId);
  }
  if (clientThrottleRequest !== undefined) {
    const { targetId, recordsPerSecond } = clientThrottleRequest;
    const to = recordsPerSecond === 0 ? 'no limit' : `${recordsPerSecond} records/s`;
    return `${nameOfClient(core, targetId)} → ${to}`;
  }
  if (accessGrantCreateRequest !== undefined) return accessGrantCreateRequest.label;
  if (accessGrantRevokeRequest !== undefined) {
    const { grantId } = accessGrantRevokeRequest;
    return core.access.grants.get(grantId)?.label || grantId;
  }
  return '';
}

function nameOfSession(
  { processing }: Core,
  { id, name }: { readonly id: string; readonly name: string },
): string {
  const known = processing.sessions.list().find((session) => session.id === id);
  return known?.description.name || name || id;
}

function nameOfClient({ clients }: Core, id: string): string {
  return clients.get(id)?.label ?? id;
}

function listed(names: readonly string[]): string {
  const shown = names.slice(0, 5).map((name) => name.slice(0, 40));
  return names.length > shown.length ? `${shown.join(', ')}, …` : shown.join(', ');
}

function wayOf({ kind }: Caller): AuditEntryWay {
  if (kind === 'local') return AuditEntryWay.LOCAL;
  return kind === 'network' ? AuditEntryWay.NETWORK : AuditEntryWay.GRANT;
}
