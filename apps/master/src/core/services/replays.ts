import { accessOf, makerOf } from '../access/caller.ts';
import { roleRefusal } from '../access/join-refusals.ts';
import { PARTICIPANTS, READERS } from '../access/roles.ts';
import type { Core } from '../areas/core.ts';
import { nameOfCaller } from './by-caller.ts';
import { definer, success } from './define-service.ts';
import type { ServiceCall } from './service-call.ts';

type Parts = Pick<Core, 'replays' | 'clients'>;
const define = definer<keyof Parts>();

/** Services that play recordings into live topics. */
export const REPLAY_SERVICES = [
  // [RP-1]
  define('replayStart', {
    roles: PARTICIPANTS,
    subject: ({ clientId }) => clientId,
    auditObject: (_core, { recordingId }) => recordingId,
    handle(core, request, { caller }) {
      const expiresMs = caller.kind === 'client' ? caller.expiresMs : Number.POSITIVE_INFINITY;
      return core.replays.start(request, {
        author: nameOfCaller(core, request.clientId),
        makerId: makerOf(caller),
        access: accessOf(caller, expiresMs),
      });
    },
  }),
  // Of others, only an admin's: see `requireOwn`. [RP-5] [RP-6]
  define('replayChange', {
    roles: PARTICIPANTS,
    handle(core, request, call) {
      requireOwn(core, request.id, call);
      return core.replays.change(request);
    },
  }),
  define('replayStop', {
    roles: PARTICIPANTS,
    auditObject: (_core, { id }) => id,
    handle(core, { id }, call) {
      requireOwn(core, id, call);
      core.replays.stop(id);
      return success('The replay is stopped.');
    },
  }),
  // [RP-7]
  define('replayList', {
    roles: READERS,
    handle: ({ replays }) => ({ elements: replays.list() }),
  }),
];

/** @throws ServiceError when a participant has not started it [RP-6] */
function requireOwn({ replays }: Parts, id: string, { caller }: ServiceCall): void {
  if (caller.role === 'admin' || replays.require(id).parts.makerId === makerOf(caller)) return;
  throw roleRefusal(
    `Only an admin may control replays of others. This device joined as ${caller.role}.`,
  );
}
