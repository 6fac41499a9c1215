import { AuditEntryWay, ServiceError, type ServiceRequest } from '@ubii/proto';
import { oneLine } from '@ubii/words';
import type { Caller } from '../access/caller.ts';
import { wireRole } from '../access/roles.ts';
import { wireAddressKind } from '../monitoring/client-report.ts';
import type { CalledMaster } from '../ports/caller-facts.ts';
import type { Core } from '../areas/core.ts';
import type { Service } from './define-service.ts';
import type { ServiceCall } from './service-call.ts';

/** What an entry is about. */
interface AuditedAction {
  /** Topic of the service, or what else was called. */
  readonly service: string;
  /** A name or id of what is changed. */
  readonly object: string;
  /** Client that the request names. Only callers that need no credential may do so. [AC-22] */
  readonly subject?: string;
  /** The master that was called. Default: this one. */
  readonly calledMaster?: CalledMaster | undefined;
}

/** Writes how an action ended: the code of its error, empty when it was done. */
export type WriteAudit = (error: string) => void;

/** Like `openAudit`, for a request. Returns undefined when its service is not audited. [EX-90] */
export function openAuditOf(
  core: Core,
  service: Service | undefined,
  request: ServiceRequest,
  { caller, facts }: Pick<ServiceCall, 'caller' | 'facts'>,
): WriteAudit | undefined {
  if (service?.audited !== true) return undefined;
  const object = service.auditObjectOf(core, request);
  return openAudit(core, caller, {
    service: request.topic,
    object,
    subject: service.subjectOf(request),
    calledMaster: facts.calledMaster,
  });
}

/**
 * Keeps what an action is about before it is done: what is removed has no name afterwards. Returns a function that adds the
 * entry, or undefined when this caller is not audited. [EX-90]
 */
export function openAudit(
  core: Core,
  caller: Caller,
  { service, object, subject = '', calledMaster }: AuditedAction,
): WriteAudit | undefined {
  // Those who have not joined can do nothing, and would fill the log with trying.
  if (caller.kind === 'stranger' || caller.kind === 'joining') return undefined;
  const { clients, audit, limits } = core;
  const line = oneLine(object, limits.reasonCharacters);
  const isOfThisMachine = caller.kind === 'local' && calledMaster === undefined;
  return (error) => {
    const id = caller.kind === 'client' ? caller.clientId : subject;
    const client = clients.get(id);
    const grant = caller.kind === 'client' ? caller.grant : undefined;
    audit.add({
      service,
      object: line,
      error,
      clientId: caller.kind === 'client' ? id : (client?.id ?? ''),
      clientName: client?.spec.name ?? '',
      role: wireRole(caller.role),
      way: wayOf(caller, calledMaster),
      grantId: grant?.id ?? '',
      grantLabel: grant?.label ?? '',
      addressKind: wireAddressKind(isOfThisMachine ? 'loopback' : client?.peer.addressKind),
      masterName: calledMaster?.name ?? '',
    });
  };
}

/** Does what is audited, and writes how it ended. */
export async function writeResult<T>(
  write: WriteAudit | undefined,
  work: () => Promise<T>,
): Promise<T> {
  try {
    const result = await work();
    write?.('');
    return result;
  } catch (error) {
    write?.(ServiceError.from(error).code);
    throw error;
  }
}

function wayOf({ kind }: Caller, calledMaster: CalledMaster | undefined): AuditEntryWay {
  if (kind === 'client') return AuditEntryWay.GRANT;
  if (calledMaster !== undefined) return AuditEntryWay.CLUSTER;
  if (kind === 'local') return AuditEntryWay.LOCAL;
  return kind === 'network' ? AuditEntryWay.NETWORK : AuditEntryWay.GRANT;
}
