import { Replays } from '../replays/replays.ts';
import type { AccessArea } from './access.ts';
import type { ClientArea } from './clients.ts';
import type { Foundation } from './foundation.ts';
import type { LibraryArea } from './library.ts';
import type { RecordingArea } from './recordings.ts';
import type { SessionArea } from './sessions.ts';
import type { MasterPorts } from './settings.ts';
import type { TopicArea } from './topics.ts';

/** Recordings that are played into live topics. */
export type ReplayArea = ReturnType<typeof createReplays>;

export type ReplayAreaContext = Pick<MasterPorts, 'clock' | 'ids' | 'patterns' | 'replayFiles'> &
  Pick<Foundation, 'limits' | 'limitWatch' | 'counters' | 'onClose'> &
  Pick<TopicArea, 'accounts' | 'topics' | 'kept' | 'tap' | 'replayed' | 'publisher'> &
  Pick<TopicArea, 'subscriptions' | 'recordedSources'> &
  Pick<ClientArea, 'clients' | 'devices' | 'info'> &
  Pick<LibraryArea, 'modules'> &
  Pick<SessionArea, 'sessions'> &
  Pick<AccessArea, 'sockets'> &
  Pick<RecordingArea, 'recordings'>;

export function createReplays(context: ReplayAreaContext) {
  const replays = new Replays(context);
  context.onClose.add(() => replays.close());
  return { replays };
}
