import { accessOf } from '../access/caller.ts';
import { fileMakerOf, requireFilesOf } from '../access/file-maker.ts';
import { PARTICIPANTS, READERS } from '../access/roles.ts';
import type { Core } from '../areas/core.ts';
import { nameOfCaller } from './by-caller.ts';
import { definer, success } from './define-service.ts';
import type { ServiceCall } from './service-call.ts';

type Context = Pick<Core, 'replays' | 'recordings' | 'clients'>;
const define = definer<keyof Context>();

/** Services that play recordings into live topics. */
export const REPLAY_SERVICES = [
  // [RP-1]
  define('replayStart', {
    roles: PARTICIPANTS,
    subject: ({ clientId }) => clientId,
    auditObject: (_core, { recordingId }) => recordingId,
    async handle(core, request, { caller }) {
      // Playing a recording is reading it. [RC-66]
      requireFilesOf(await core.recordings.makerOf(request.recordingId), caller, 'recordings');
      const expiresMs = caller.kind === 'client' ? caller.expiresMs : Number.POSITIVE_INFINITY;
      return core.replays.start(request, {
        author: nameOfCaller(core, request.clientId),
        makerId: fileMakerOf(caller),
        access: accessOf(caller, expiresMs),
      });
    },
  }),
  // [RP-5] [RP-6]
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

/** @throws ServiceError when it is of others, and the caller no admin [RP-6] */
function requireOwn({ replays }: Context, id: string, { caller }: ServiceCall): void {
  requireFilesOf(replays.require(id).parts.makerId, caller, 'replays');
}
