import { ServiceError } from '@ubii/proto';
import { fileMakerOf, mayUseFilesOf, requireFilesOf } from '../access/file-maker.ts';
import { ADMINS, PARTICIPANTS, PUBLISHERS, READERS } from '../access/roles.ts';
import type { RecordingPage } from '@ubii/recording/recorder';
import type { Core } from '../areas/core.ts';
import type { RecordingWish } from '../recordings/recordings.ts';
import { EVERYTHING } from '../recordings/selection.ts';
import { nameOfCaller } from './by-caller.ts';
import { definer, success } from './define-service.ts';
import type { ServiceCall } from './service-call.ts';

type Context = Pick<Core, 'recordings' | 'clients'>;
const define = definer<keyof Context>();

/** Services on recordings. Each is its maker's and admins' [RC-66]; marking what runs is for all that publish. */
export const RECORDING_SERVICES = [
  // [RC-3]
  define('recordingList', {
    roles: PARTICIPANTS,
    handle: ({ recordings }, _request, { caller }) =>
      recordings.list((makerId) => mayUseFilesOf(makerId, caller)),
  }),
  // [RC-3]
  define('recordingGet', {
    roles: PARTICIPANTS,
    async handle(core, { id, ...page }, call) {
      await requireOwn(core, id, call);
      return (await core.recordings.get(id, requirePage(page))).recording;
    },
  }),
  // [RC-4]
  define('recordingStart', {
    roles: PARTICIPANTS,
    subject: ({ clientId }) => clientId,
    auditObject: (_core, { name }) => name,
    handle(core, { selection = EVERYTHING, budget, nodeId, ...wish }, call) {
      return core.recordings.start(wishOf(core, wish, call), { selection, budget, nodeId });
    },
  }),
  // [RC-5]
  define('recordingStop', {
    roles: PARTICIPANTS,
    auditObject: (_core, { id }) => id,
    async handle(core, { id }, call) {
      await requireOwn(core, id, call);
      return core.recordings.stop(id);
    },
  }),
  // [RC-6]
  define('recordingChange', {
    roles: PARTICIPANTS,
    // Without the name, which has the code of a participant in a study. [ST-52]
    auditObject: (_core, { id }) => id,
    async handle(core, { id, name, notes }, call) {
      await requireOwn(core, id, call);
      return core.recordings.change(id, name, notes);
    },
  }),
  // [RC-5]
  define('recordingDelete', {
    roles: PARTICIPANTS,
    auditObject: (_core, { id }) => id,
    async handle(core, { id }, call) {
      await requireOwn(core, id, call);
      await core.recordings.delete(id);
      return success('The recording is deleted.');
    },
  }),
  // [RC-63]
  define('recordingUpload', {
    roles: PARTICIPANTS,
    auditObject: (_core, { id }) => id,
    async handle(core, { id }, call) {
      await requireOwn(core, id, call);
      return core.recordings.fetch(id);
    },
  }),
  // [RC-20] [RC-21]
  define('recordingMark', {
    roles: PUBLISHERS,
    subject: ({ clientId }) => clientId,
    async handle(core, marker, { caller }) {
      const { recordingId } = marker;
      const mayChangeAll =
        caller.role === 'admin' ||
        (recordingId !== '' && mayUseFilesOf(await core.recordings.makerOf(recordingId), caller));
      return core.recordings.mark(marker, nameOfCaller(core, marker.clientId), mayChangeAll);
    },
  }),
  // [RC-15]
  define('recordingEstimate', {
    roles: READERS,
    handle: ({ recordings }, selection) => recordings.estimate(selection),
  }),
  // [RC-30]
  define('flightRecorderGet', { roles: READERS, handle: ({ recordings }) => recordings.flight() }),
  // [RC-31]
  define('flightRecorderSet', {
    roles: ADMINS,
    auditObject: (_core, { isOn, minutes }) => (isOn ? `on, ${minutes} min` : 'off'),
    handle: ({ recordings }, settings) => recordings.setFlight(settings),
  }),
  // [RC-36]
  define('flightRecorderRecords', {
    // Those that may receive all topics.
    roles: READERS,
    subject: ({ clientId }) => clientId,
    handle: ({ recordings }, { clientId, ...search }) => recordings.findInFlight(clientId, search),
  }),
  // [RC-32]
  define('flightRecorderKeep', {
    roles: PARTICIPANTS,
    subject: ({ clientId }) => clientId,
    auditObject: (_core, { name }) => name,
    handle: (core, wish, call) => core.recordings.keep(wishOf(core, wish, call)),
  }),
];

interface Wish {
  readonly clientId: string;
  readonly name: string;
  readonly notes: string;
}

function wishOf(core: Context, { clientId, name, notes }: Wish, call: ServiceCall): RecordingWish {
  return { name, notes, author: nameOfCaller(core, clientId), makerId: fileMakerOf(call.caller) };
}

/** [RC-54] @throws ServiceError when a page begins before the first element */
function requirePage({ topicsFrom, markersFrom }: RecordingPage): RecordingPage {
  if (topicsFrom >= 0 && markersFrom >= 0) return { topicsFrom, markersFrom };
  throw new ServiceError(
    'invalid_argument',
    'A page begins at 0 or later. Set `topics_from` and `markers_from` to 0 for the first page.',
  );
}

/** @throws ServiceError when it is of others, and the caller no admin [RC-66] */
async function requireOwn(
  { recordings }: Context,
  id: string,
  { caller }: ServiceCall,
): Promise<void> {
  if (caller.role !== 'admin') {
    requireFilesOf(await recordings.makerOf(id), caller, 'recordings');
  }
}
