import { DeviceFinder } from '../studies/device-finder.ts';
import { OwnValues } from '../studies/own-values.ts';
import { Participants } from '../studies/participants.ts';
import { RateMeter } from '../studies/rate-meter.ts';
import { Studies } from '../studies/studies.ts';
import { StudyBlocks } from '../studies/study-blocks.ts';
import { StudyChecks } from '../studies/study-checks.ts';
import { StudyNews } from '../studies/study-news.ts';
import { StudyRuns } from '../studies/study-runs.ts';
import { StudyStore } from '../studies/study-store.ts';
import { Turns } from '../studies/turns.ts';
import type { ClientArea } from './clients.ts';
import type { Foundation } from './foundation.ts';
import type { NodeArea } from './nodes.ts';
import type { RecordingArea } from './recordings.ts';
import type { SessionArea } from './sessions.ts';
import { nameOf, type MasterPorts } from './settings.ts';
import type { TopicArea } from './topics.ts';

/** Studies, their runs and participants. */
export type StudyArea = ReturnType<typeof createStudies>;

export type StudyAreaContext = Pick<MasterPorts, 'clock' | 'ids' | 'log' | 'studyStorage'> &
  Pick<Foundation, 'settings' | 'limitWatch' | 'onClose'> &
  Pick<TopicArea, 'topics' | 'publisher'> &
  Pick<ClientArea, 'clients' | 'devices'> &
  Pick<NodeArea, 'nodes'> &
  Pick<SessionArea, 'sessions'> &
  Pick<RecordingArea, 'recordings'>;

export function createStudies(context: StudyAreaContext) {
  const { clock, log, topics, nodes, settings, limitWatch: limits, onClose } = context;
  const rates = new RateMeter(clock, topics);
  const masterName = nameOf(settings);
  const finder = new DeviceFinder({ ...context, masterId: nodes.masterId, masterName, rates });
  const store = new StudyStore({ storage: context.studyStorage, limits, log });
  const checks = new StudyChecks({ clock, limits, rates, finder });
  const ownValues = new OwnValues({ store, topics, clock });
  const news = new StudyNews({ ...context, store, checks });
  const blocks = new StudyBlocks({
    ...context,
    limits,
    store,
    checks,
    ownValues,
    onTimeUp(runId, recordingId) {
      studyRuns.endBlock(runId, recordingId).catch((error: unknown) => {
        log.warn('a block of a study could not be ended', { runId, reason: String(error) });
      });
    },
  });
  const shared = { ...context, limits, store, checks, blocks, news, turns: new Turns() };
  const studyRuns = new StudyRuns(shared);
  onClose.add(() => {
    news.close();
    blocks.close();
  });
  return { studies: new Studies(shared), studyRuns, participants: new Participants(shared) };
}
