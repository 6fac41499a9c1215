import { ServiceError, type Init, type ServiceReply, type ServiceRequest } from '@ubii/proto';
import type { Core } from '../areas/core.ts';
import type { CallerFacts } from '../ports/caller-facts.ts';
import { quote } from '../texts/quote.ts';
import type { CallTarget, Service } from './define-service.ts';

type Context = Pick<Core, 'masters' | 'clients' | 'sessionTable' | 'foreignSessions'> &
  Pick<Core, 'sessionLibrary'>;

/**
 * Has a call answered by the master that its client or session is at. [CU-28]
 *
 * @returns undefined: it is to be answered here
 * @throws ServiceError when that master is lost
 */
export function forward(
  core: Context,
  service: Service,
  request: ServiceRequest,
  facts: CallerFacts,
): Promise<Init<ServiceReply>> | undefined {
  if (core.masters === undefined) return undefined;
  const masterId = masterOf(core, service.targetOf(request));
  return masterId === undefined ? undefined : core.masters.call(masterId, request, facts);
}

/** Another master carried the call here, but its client or session has gone elsewhere meanwhile. @throws ServiceError */
export function requireHere(core: Context, service: Service, request: ServiceRequest): void {
  if (masterOf(core, service.targetOf(request)) === undefined) return;
  throw new ServiceError(
    'unavailable',
    'What the request is about has gone to another master. Send the request again.',
  );
}

function masterOf(core: Context, { clientId, session, moduleId }: CallTarget): string | undefined {
  if (clientId !== undefined && clientId !== '') return masterOfClient(core, clientId);
  if (session !== undefined) return masterOfSession(core, session);
  if (moduleId === undefined || core.sessionTable.findModule(moduleId)) return undefined;
  return core.foreignSessions.masterOfModule(moduleId);
}

function masterOfClient({ clients }: Context, id: string): string | undefined {
  const home = clients.get(id)?.home;
  if (home?.isLost !== true) return home?.masterId;
  throw new ServiceError(
    'not_found', // [CU-21]
    `The master of the client ${quote(id)} is lost. Register again, at this master or another one.`,
  );
}

/** A stored session has the id under which it is opened. */
function masterOfSession(
  { sessionTable, foreignSessions, sessionLibrary }: Context,
  { id, name }: { readonly id: string; readonly name: string },
): string | undefined {
  const openedId = id === '' && name !== '' ? (sessionLibrary.get(name)?.id ?? '') : id;
  return sessionTable.get(openedId) ? undefined : foreignSessions.masterOf(openedId);
}
