import { PersonalLabels } from '../personal-data/personal-labels.ts';
import { DEFAULT_FLIGHT_RECORDER } from '../recordings/flight-settings.ts';
import { NodeRecordings } from '../recordings/node-recordings.ts';
import { recordingInterest } from '../recordings/recording-interest.ts';
import { RecordCollector } from '../recordings/record-collector.ts';
import { Recordings } from '../recordings/recordings.ts';
import type { ClientArea } from './clients.ts';
import type { Foundation } from './foundation.ts';
import type { SessionArea } from './sessions.ts';
import { nameOf, type MasterPorts } from './settings.ts';
import type { TopicArea } from './topics.ts';

/** Recordings of topics, and the flight recorder. */
export type RecordingArea = ReturnType<typeof createRecordings>;

export type RecordingAreaContext = Pick<
  MasterPorts,
  'clock' | 'ids' | 'log' | 'patterns' | 'recorder' | 'personalData' | 'cluster'
> &
  Pick<Foundation, 'settings' | 'limits' | 'limitWatch' | 'onClose'> &
  Pick<TopicArea, 'topics' | 'tap' | 'publisher' | 'subscriptions' | 'accounts'> &
  Pick<ClientArea, 'clients' | 'devices'> &
  Pick<SessionArea, 'sessions' | 'reports'>;

export function createRecordings(context: RecordingAreaContext) {
  const { settings, limitWatch: limits, sessions, onClose } = context;
  const interest = context.cluster === undefined ? undefined : recordingInterest(context);
  const collector = new RecordCollector({ ...context, interest });
  const personalLabels = new PersonalLabels({
    ...context,
    limits,
    store: context.personalData,
  });
  const parts = { ...context, limits, collector, sessions: () => sessions.list() };
  const atNodes = new NodeRecordings(parts);
  context.reports.onMessage.add((client, { recorderAnswer, recorderReport }) => {
    if (recorderAnswer !== undefined) atNodes.handleAnswer(client, recorderAnswer);
    if (recorderReport !== undefined) atNodes.handleReport(client, recorderReport);
  });
  const recordings = new Recordings({
    ...parts,
    atNodes,
    personalLabels,
    flight: { ...DEFAULT_FLIGHT_RECORDER, ...settings.flightRecorder },
    masterName: nameOf(settings),
    version: settings.version,
  });
  context.topics.onEnd.add((entry) => collector.handleEnd(entry));
  onClose.add(() => {
    atNodes.close();
    collector.close();
  });
  return { recordings, personalLabels };
}
