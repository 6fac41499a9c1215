import { clientsPage } from './clients-page.ts';
import { CLUSTER } from './cluster.ts';
import { connecting, idleConnections } from './connections.ts';
import { CORES } from './cores.ts';
import { detection } from './detection.ts';
import { FAN_OUTS } from './fan-out.ts';
import { firstPublish, laterPublish } from './first-publish.ts';
import { graphEditor, graphEditorOpen } from './graph-editor.ts';
import { hostileBodies } from './hostile-bodies.ts';
import { markers } from './markers.ts';
import { masterTime } from './master-time.ts';
import { MODULE_CALLS, MODULE_CALLS_IN_BROWSER } from './module-call.ts';
import { LOCKSTEPS } from './lockstep.ts';
import { modules100 } from './modules-100.ts';
import { pacedPictures } from './paced-pictures.ts';
import { party } from './party.ts';
import { partyScreen } from './party-screen.ts';
import { PEER_WORKLOADS } from './peers.ts';
import { partyTraffic } from './party-traffic.ts';
import { recording } from './recording.ts';
import { recordingSeek, recordingWrite } from './recording-files.ts';
import { recordingTimeline } from './recording-timeline.ts';
import { roundTrip } from './round-trip.ts';
import { SEEING } from './seeing.ts';
import { topicsPage } from './topics-page.ts';
import { trigger } from './trigger.ts';
import { turns } from './turns.ts';
import { zeromq } from './zeromq.ts';
import type { Workload } from '../measuring/workload.ts';

/** Every workload, in the order of the report. Goals: see the README. */
export const WORKLOADS: readonly Workload[] = [
  roundTrip,
  ...FAN_OUTS,
  pacedPictures,
  ...PEER_WORKLOADS,
  zeromq,
  ...CLUSTER,
  ...CORES,
  connecting,
  idleConnections,
  firstPublish,
  laterPublish,
  ...MODULE_CALLS,
  ...MODULE_CALLS_IN_BROWSER,
  detection,
  ...SEEING,
  markers,
  trigger,
  ...LOCKSTEPS,
  modules100,
  party,
  partyTraffic,
  turns,
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
