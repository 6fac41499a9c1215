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

export type RecordingDependencies = Pick<
  MasterPorts,
  'clock' | 'ids' | 'log' | 'patterns' | 'recorder' | 'personalData' | 'cluster'
> &
  Pick<Foundation, 'settings' | 'limits' | 'limitWatch' | 'onClose'> &
  Pick<TopicArea, 'topics' | 'tap' | 'publisher' | 'subscriptions' | 'accounts'> &
  Pick<ClientArea, 'clients' | 'devices'> &
  Pick<SessionArea, 'sessions' | 'reports'>;

export function createRecordings(dependencies: RecordingDependencies) {
  const { settings, limitWatch: limits, sessions, onClose } = dependencies;
  const interest = dependencies.cluster === undefined ? undefined : recordingInterest(dependencies);
  const collector = new RecordCollector({ ...dependencies, interest });
  const personalLabels = new PersonalLabels({
    ...dependencies,
    limits,
    store: dependencies.personalData,
  });
  const parts = { ...dependencies, limits, collector, sessions: () => sessions.list() };
  const atNodes = new NodeRecordings(parts);
  dependencies.reports.onMessage.add((client, { recorderAnswer, recorderReport }) => {
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
  dependencies.topics.onEnd.add((entry) => collector.handleEnd(entry));
  onClose.add(() => {
    atNodes.close();
    collector.close();
  });
  return { recordings, personalLabels };
}
