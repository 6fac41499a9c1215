import { ServiceError, StatusEventKind } from '@ubii/proto';
import { oneLine } from '@ubii/words';
import { roleRefusal } from '../access/join-refusals.ts';
import { ADMINS, PARTICIPANTS } from '../access/roles.ts';
import type { Client } from '../clients/client.ts';
import { throttleClient, unthrottleClient } from '../clients/throttling.ts';
import type { Core } from '../areas/core.ts';
import { byCaller, nameOfCaller } from './by-caller.ts';
import { definer, success } from './define-service.ts';
import type { ServiceCall } from './service-call.ts';

type Context = Pick<Core, 'clients' | 'limits' | 'events' | 'clock'>;
const define = definer<keyof Context>();

/** The slowest throttle: a record in ten seconds [EX-31]. */
const MIN_RECORDS_PER_SECOND = 0.1;

/** Services that change other clients. */
export const CLIENT_CONTROL_SERVICES = [
  // Of others, only an admin's: see `requireTarget`. [EX-29]
  define('clientRename', {
    roles: PARTICIPANTS,
    subject: ({ clientId }) => clientId,
    target: ({ targetId }) => ({ clientId: targetId }),
    auditObject: (core, { targetId, name }) => `${nameOf(core, targetId)} → ${name}`,
    handle(core, payload, call) {
      const { clientId, targetId, name } = payload;
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
      return client.toMessage();
    },
  }),
  // [EX-30]
  define('clientDisconnect', {
    roles: PARTICIPANTS,
    subject: ({ clientId }) => clientId,
    target: ({ targetId }) => ({ clientId: targetId }),
    auditObject: (core, { targetId }) => nameOf(core, targetId),
    handle(core, payload, call) {
      const { clientId, targetId, reason } = payload;
      const client = core.clients.require(targetId, 'client_disconnect_request.target_id');
      requireTarget(call, client, 'disconnect');
      const told = byCaller(core, clientId, reason);
      const { label } = client;
      core.clients.dismiss(client, { reason: 'disconnected', explanation: told });
      core.events.add(
        StatusEventKind.CLIENT_DISCONNECTED,
        `${label} was disconnected ${told}`,
        targetId,
      );
      return success(`${label} is disconnected.`);
    },
  }),
  // Not for participants: a throttled one would lift its throttle. [EX-31]
  define('clientThrottle', {
    roles: ADMINS,
    subject: ({ clientId }) => clientId,
    target: ({ targetId }) => ({ clientId: targetId }),
    auditObject(core, { targetId, recordsPerSecond }) {
      const to = recordsPerSecond === 0 ? 'no limit' : `${recordsPerSecond} records/s`;
      return `${nameOf(core, targetId)} → ${to}`;
    },
    handle(core, payload) {
      const { clientId, targetId, recordsPerSecond, reason } = payload;
      const client = core.clients.require(targetId, 'client_throttle_request.target_id');
      const byName = nameOfCaller(core, clientId);
      if (recordsPerSecond === 0) {
        unthrottleClient(core, client, byName);
        return success(`${client.label} is no longer throttled.`);
      }
      if (!(recordsPerSecond >= MIN_RECORDS_PER_SECOND && Number.isFinite(recordsPerSecond))) {
        throw new ServiceError(
          'invalid_argument',
          `The member records_per_second is ${recordsPerSecond}, but a throttle is ${MIN_RECORDS_PER_SECOND} or more records per second, or 0 to lift it.`,
        );
      }
      throttleClient(core, client, { recordsPerSecond, byPolicy: false, byName, reason });
      return success(`${client.label} is throttled to ${recordsPerSecond} records per second.`);
    },
  }),
];

/** Of others, this is an admin's [AC-21]. */
function requireTarget({ caller }: ServiceCall, client: Client, what: string): void {
  if (caller.role === 'admin') return;
  if (caller.kind === 'client' && caller.clientId === client.id) return;
  throw roleRefusal(
    `Only an admin may ${what} another client. This device joined as ${caller.role}.`,
  );
}

function by(core: Context, clientId: string): string {
  const name = nameOfCaller(core, clientId);
  return name === '' ? '' : ` by ${name}`;
}

function nameOf({ clients }: Context, id: string): string {
  return clients.get(id)?.label ?? id;
}
