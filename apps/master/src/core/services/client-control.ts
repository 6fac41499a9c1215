import { ServiceError, StatusEventKind } from '@ubii/proto';
import { roleRefusal } from '../access/join-refusals.ts';
import type { Client } from '../clients/client.ts';
import { readClientReport } from '../monitoring/client-report.ts';
import { throttleClient, unthrottleClient } from '../clients/throttling.ts';
import type { Core } from '../parts/core.ts';
import { oneLine } from '../texts/one-line.ts';
import { byCaller, nameOfCaller } from './by-caller.ts';
import type { ServiceCall, ServiceHandler } from './handler.ts';
import { requireElements } from './list-limits.ts';

/** The slowest throttle: a record in ten seconds [EX-31]. */
const MIN_RECORDS_PER_SECOND = 0.1;

/** `/services/ubii/client_report` [EX-25] */
export const reportClients: ServiceHandler = (core, request) => {
  const wanted = request.clientReportRequest!;
  requireElements(core, wanted.clientIds);
  return { clientReport: readClientReport(core, wanted) };
};

/** `/services/ubii/client_rename` [EX-29] */
export const renameClient: ServiceHandler = (core, request, call) => {
  const { clientId, targetId, name } = request.clientRenameRequest!;
  const client = core.clients.require(targetId, 'client_rename_request.target_id');
  requireTarget(call, client, 'rename');
  const { nameCharacters } = core.limits;
  if (name === '' || name !== oneLine(name, nameCharacters)) {
    throw new ServiceError(
      'invalid_argument',
      `A name has 1 to ${nameCharacters} characters on one line, without spaces around it.`,
    );
  }
  if (name !== client.spec.name) {
    const text = `${client.label} was renamed to ${name}${by(core, clientId)}`;
    core.clients.rename(client, name);
    core.events.add(StatusEventKind.CLIENT_RENAMED, text, client.id);
  }
  return { client: client.toMessage() };
};

/** `/services/ubii/client_disconnect` [EX-30] */
export const disconnectClient: ServiceHandler = (core, request, call) => {
  const { clientId, targetId, reason } = request.clientDisconnectRequest!;
  const client = core.clients.require(targetId, 'client_disconnect_request.target_id');
  requireTarget(call, client, 'disconnect');
  const told = byCaller(core, clientId, reason);
  const { label } = client;
  core.clients.dismiss(client, told);
  core.events.add(
    StatusEventKind.CLIENT_DISCONNECTED,
    `${label} was disconnected ${told}`,
    targetId,
  );
  return { success: { title: 'Success', message: `${label} is disconnected.` } };
};

/** `/services/ubii/client_throttle` [EX-31] */
export const controlThrottle: ServiceHandler = (core, request) => {
  const { clientId, targetId, recordsPerSecond, reason } = request.clientThrottleRequest!;
  const client = core.clients.require(targetId, 'client_throttle_request.target_id');
  const byName = nameOfCaller(core, clientId);
  if (recordsPerSecond === 0) {
    unthrottleClient(core, client, byName);
    return { success: { title: 'Success', message: `${client.label} is no longer throttled.` } };
  }
  if (!(recordsPerSecond >= MIN_RECORDS_PER_SECOND && Number.isFinite(recordsPerSecond))) {
    throw new ServiceError(
      'invalid_argument',
      `The member records_per_second is ${recordsPerSecond}, but a throttle is ${MIN_RECORDS_PER_SECOND} or more records per second, or 0 to lift it.`,
    );
  }
  throttleClient(core, client, {
    recordsPerSecond,
    byPolicy: false,
    byName,
    reason,
  });
  const message = `${client.label} is throttled to ${recordsPerSecond} records per second.`;
  return { success: { title: 'Success', message } };
};

/** Of others, this is an admin's [AC-21]. */
function requireTarget({ caller }: ServiceCall, client: Client, what: string): void {
  if (caller.role === 'admin') return;
  if (caller.kind === 'client' && caller.clientId === client.id) return;
  throw roleRefusal(
    `Only an admin may ${what} another client. This device joined as ${caller.role}.`,
  );
}

function by(core: Core, clientId: string): string {
  const name = nameOfCaller(core, clientId);
  return name === '' ? '' : ` by ${name}`;
}
