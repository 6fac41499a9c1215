import { ServiceError, type Recording } from '@ubii/proto';
import { makerOf } from '../access/caller.ts';
import { roleRefusal } from '../access/join-refusals.ts';
import { ADMINS, PARTICIPANTS, PUBLISHERS, READERS } from '../access/roles.ts';
import type { RecordingPage } from '@ubii/recording/recorder';
import type { Core } from '../areas/core.ts';
import type { RecordingWish } from '../recordings/recordings.ts';
import { EVERYTHING } from '../recordings/selection.ts';
import { nameOfCaller } from './by-caller.ts';
import { definer, success } from './define-service.ts';
import type { ServiceCall } from './service-call.ts';

type Parts = Pick<Core, 'recordings' | 'clients'>;
const define = definer<keyof Parts>();

/** Services on recordings. What was published by others is for participants and admins; marking is for all that publish. */
export const RECORDING_SERVICES = [
  // [RC-3]
  define('recordingList', {
    roles: READERS,
    async handle({ recordings }, _request, call) {
      const list = await recordings.list();
      const elements = list.elements.filter((recording) => mayKnow(call, recording));
      return { ...list, elements };
    },
  }),
  // [RC-3]
  define('recordingGet', {
    roles: READERS,
    async handle({ recordings }, { id, ...page }, call) {
      const { recording } = await recordings.get(id, requirePage(page));
      if (mayKnow(call, recording)) return recording;
      throw new ServiceError(
        'permission_denied',
        'The recording is part of a study. Only participants and admins of the master can open it.',
      );
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
    handle: ({ recordings }, { id }) => recordings.stop(id),
  }),
  // [RC-6]
  define('recordingChange', {
    roles: PARTICIPANTS,
    // Without the name, which has the code of a participant in a study. [ST-52]
    auditObject: (_core, { id }) => id,
    handle: ({ recordings }, { id, name, notes }) => recordings.change(id, name, notes),
  }),
  // Of others, only an admin's: see `requireOwn`. [RC-5]
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
    handle: ({ recordings }, { id }) => recordings.fetch(id),
  }),
  // [RC-20] [RC-21]
  define('recordingMark', {
    roles: PUBLISHERS,
    subject: ({ clientId }) => clientId,
    handle(core, marker, { caller }) {
      const mayChangeAll = PARTICIPANTS.some((role) => role === caller.role);
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

function wishOf(core: Parts, { clientId, name, notes }: Wish, call: ServiceCall): RecordingWish {
  return { name, notes, author: nameOfCaller(core, clientId), makerId: makerOf(call.caller) };
}

/** [RC-54] @throws ServiceError when a page begins before the first element */
function requirePage({ topicsFrom, markersFrom }: RecordingPage): RecordingPage {
  if (topicsFrom >= 0 && markersFrom >= 0) return { topicsFrom, markersFrom };
  throw new ServiceError(
    'invalid_argument',
    'A page begins at 0 or later. Set `topics_from` and `markers_from` to 0 for the first page.',
  );
}

/** @throws ServiceError when a participant has not made it [RC-5] */
async function requireOwn(
  { recordings }: Parts,
  id: string,
  { caller }: ServiceCall,
): Promise<void> {
  if (caller.role === 'admin') return;
  const { makerId } = await recordings.get(id);
  if (makerId === makerOf(caller)) return;
  throw roleRefusal(
    `Only an admin may delete recordings of others. This device joined as ${caller.role}.`,
  );
}

/** Recordings of studies are for those who may read studies. [ST-54] */
function mayKnow({ caller }: ServiceCall, { study }: Recording): boolean {
  return study === undefined || caller.role === 'admin' || caller.role === 'participant';
}
