import { RecordingKind, RecordingState, type Recording } from '@ubii/proto';
import {
  AT_MASTER,
  elementsFrom,
  WITHOUT_PAGE,
  type RecordingJob,
  type RecordingPage,
} from '@ubii/recording/recorder';
import type { Client } from '../clients/client.ts';

/** Ids of recordings, which are names of files as well. */
const ID = /^[\da-zA-Z-]{1,64}$/;

/** What the master knows itself of a recording of a node. */
interface Known {
  readonly author: string;
  readonly recording: Pick<Recording, 'study' | 'selection' | 'budget' | 'replayedRecordingId'>;
}

export function isRecordingId(id: string): boolean {
  return ID.test(id);
}

/** A recording of a node as the master describes it: numbers and texts of the node, and what only the master decides. [RC-62] */
export function reportedRecording(told: Recording, known: Known, client: Client): Recording {
  const isRunning = told.state === RecordingState.RECORDING_STATE_RECORDING;
  const { study, selection, budget, replayedRecordingId } = known.recording;
  return {
    ...told,
    study,
    selection,
    budget,
    replayedRecordingId,
    author: known.author,
    state: isRunning ? told.state : RecordingState.RECORDING_STATE_AT_NODE,
    nodeId: client.id,
    nodeName: client.label,
    nodeIsAway: false,
    ...WITHOUT_PAGE,
  };
}

/** A page of topics and markers as a node tells it. A node that knows no pages sends all, from 0 on. [RC-54] */
export function reportedPage(
  { topics, topicsFrom, topicsTotal, markers, markersFrom }: Recording,
  page: RecordingPage,
): Pick<Recording, 'topics' | 'topicsFrom' | 'topicsTotal' | 'markers' | 'markersFrom'> {
  const from = (wanted: number, told: number): number => Math.max(0, wanted - Math.max(0, told));
  return {
    topics: elementsFrom(topics, from(page.topicsFrom, topicsFrom), (topic) => topic),
    topicsFrom: page.topicsFrom,
    topicsTotal: Math.max(topicsTotal, topicsFrom + topics.length),
    markers: elementsFrom(markers, from(page.markersFrom, markersFrom), (marker) => marker),
    markersFrom: page.markersFrom,
  };
}

/** A recording that a node is asked to start. */
export function newRecording(job: RecordingJob, nowMs: number): Recording {
  const { id, name, notes, author, study, replayedRecordingId = '' } = job;
  return {
    id,
    name,
    notes,
    author,
    study,
    replayedRecordingId,
    kind: RecordingKind.RECORDING_KIND_RECORDING,
    // Until the node says that it records.
    state: RecordingState.RECORDING_STATE_UNSPECIFIED,
    startedMs: nowMs,
    durationMs: 0,
    sizeBytes: 0,
    recordCount: 0,
    lostCount: 0,
    topicCount: 0,
    markerCount: 0,
    problem: '',
    selection: undefined,
    budget: undefined,
    ...WITHOUT_PAGE,
    ...AT_MASTER,
  };
}
