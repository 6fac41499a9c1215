import { AuditEntryWay, type ServiceRequest } from '@ubii/proto';
import type { Caller } from '../access/caller.ts';
import { wireRole } from '../access/roles.ts';
import { wireAddressKind } from '../monitoring/client-report.ts';
import type { Core } from '../areas/core.ts';
import { oneLine } from '../texts/one-line.ts';
import type { Service } from './define-service.ts';

/**
 * Looks up what an audited request is about before it is done: what is removed has no name afterwards.
 * @returns a function that writes down who asked, and how it ended (code of the error; empty when it was
 * done); undefined when this service or this caller is not audited [EX-90]
 */
export function openAudit(
  core: Core,
  service: Service | undefined,
  request: ServiceRequest,
  caller: Caller,
): ((error: string) => void) | undefined {
  if (service?.audited !== true) return undefined;
  // Those who have not joined can do nothing, and would fill the log with trying.
  if (caller.kind === 'stranger' || caller.kind === 'joining') return undefined;
  const { clients, audit, limits } = core;
  const object = oneLine(service.auditObjectOf(core, request), limits.reasonCharacters);
  return (error) => {
    // Only callers that need no credential may name their client. [AC-22]
    const id = caller.kind === 'client' ? caller.clientId : service.subjectOf(request);
    const client = clients.get(id);
    const grant = caller.kind === 'client' ? caller.grant : undefined;
    audit.add({
      service: request.topic,
      object,
      error,
      clientId: caller.kind === 'client' ? id : (client?.id ?? ''),
      clientName: client?.spec.name ?? '',
      role: wireRole(caller.role),
      way: wayOf(caller),
      grantId: grant?.id ?? '',
      grantLabel: grant?.label ?? '',
      addressKind: wireAddressKind(caller.kind === 'local' ? 'loopback' : client?.peer.addressKind),
    });
  };
}

function wayOf({ kind }: Caller): AuditEntryWay {
  if (kind === 'local') return AuditEntryWay.LOCAL;
  return kind === 'network' ? AuditEntryWay.NETWORK : AuditEntryWay.GRANT;
}
