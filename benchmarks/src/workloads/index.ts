import { clientsPage } from './clients-page.ts';
import { CLUSTER } from './cluster.ts';
import { connecting, idleConnections } from './connections.ts';
import { CORES } from './cores.ts';
import { detection } from './detection.ts';
import { fanOut, fanOutPictures } from './fan-out.ts';
import { firstPublish } from './first-publish.ts';
import { graphEditor, graphEditorOpen } from './graph-editor.ts';
import { hostileBodies } from './hostile-bodies.ts';
import { markers } from './markers.ts';
import { masterTime } from './master-time.ts';
import { MODULE_CALLS } from './module-call.ts';
import { MODULE_CALLS_IN_BROWSER } from './module-call-browser.ts';
import { LOCKSTEPS } from './lockstep.ts';
import { modules100 } from './modules-100.ts';
import { party } from './party.ts';
import { partyScreen } from './party-screen.ts';
import { recording } from './recording.ts';
import { recordingSeek, recordingWrite } from './recording-files.ts';
import { recordingTimeline } from './recording-timeline.ts';
import { roundTrip } from './round-trip.ts';
import { SEEING } from './seeing.ts';
import { topicsPage } from './topics-page.ts';
import { trigger } from './trigger.ts';
import { zeromq } from './zeromq.ts';
import type { Workload } from '../measuring/workload.ts';

/** Every workload, in the order of the report. Goals: see the README. */
export const WORKLOADS: readonly Workload[] = [
  roundTrip,
  fanOut(64, { 'ubii-extension': 0.85, 'ubii-legacy': 0.7 }),
  fanOut(1, { 'ubii-extension': 0.95, 'ubii-legacy': 0.95 }),
  fanOutPictures,
  zeromq,
  ...CLUSTER,
  ...CORES,
  connecting,
  idleConnections,
  firstPublish,
  ...MODULE_CALLS,
  ...MODULE_CALLS_IN_BROWSER,
  detection,
  ...SEEING,
  markers,
  trigger,
  ...LOCKSTEPS,
  modules100,
  party,
  partyScreen,
  masterTime,
  hostileBodies,
  recording,
  recordingWrite,
  recordingSeek,
  recordingTimeline,
  graphEditor,
  topicsPage,
  clientsPage,
  graphEditorOpen,
];
