import {
  fromJson,
  RecordingKind,
  RecordingState,
  type JsonObject,
  type Recording,
  type RecordingSelection,
  type RecordingStudy,
  type RecordingTopic,
  type TextLimits,
} from '@ubii/proto';
import { shortened } from '@ubii/words';
import type { RecordingHeader } from '../records/recording-header.ts';
import type { RecordedTopic, RecordingSummary } from '../records/recording-summary.ts';
import type { RecordingJob } from './recorder.ts';
import { msOf } from '../records/recorded-record.ts';

/** What the master keeps in the header of a file, besides what every reader knows. */
export interface FileFacts {
  readonly name: string;
  readonly notes: string;
  readonly kind: RecordingKind;
  readonly masterName: string;
  readonly version: string;
  readonly author: string;
  readonly makerId: string;
  readonly startedMs: number;
  readonly state: RecordingState;
  readonly problem: string;
  readonly selection: RecordingSelection | undefined;
  /** Of a comparison: id of the recording that was replayed; else empty [RP-41]. */
  readonly replayedRecordingId: string;
  /** Labels of personal data as JSON; empty when there are none. [PD-6] */
  readonly personalData: string;
  /** [ST-24] */
  readonly study: RecordingStudy | undefined;
}

const KINDS: { readonly [K in RecordingKind]?: RecordingHeader['kind'] } = {
  [RecordingKind.RECORDING_KIND_RECORDING]: 'recording',
  [RecordingKind.RECORDING_KIND_FLIGHT_RECORDER]: 'flight-recorder',
  [RecordingKind.RECORDING_KIND_IMPORT]: 'import',
  [RecordingKind.RECORDING_KIND_COMPARISON]: 'comparison',
};

/** What a file may say of itself: it is not being recorded any more, and is not at a node. */
const ENDED = [
  RecordingState.RECORDING_STATE_COMPLETE,
  RecordingState.RECORDING_STATE_REPAIRED,
  RecordingState.RECORDING_STATE_FAILED,
];

/** Of a recording of which no page of topics and markers was asked for. [RC-54] */
export const WITHOUT_PAGE = {
  topics: [],
  markers: [],
  topicsFrom: 0,
  topicsTotal: 0,
  markersFrom: 0,
} satisfies Partial<Recording>;

/** Of recordings that no node has. [RC-60] */
export const AT_MASTER = { nodeId: '', nodeName: '', nodeIsAway: false, uploadedBytes: 0 } as const;

/** What the file of a new recording begins with. */
export function factsOf(
  job: RecordingJob,
  kind: RecordingKind,
  startedMs: number,
  selection?: RecordingSelection,
): FileFacts {
  const state = RecordingState.RECORDING_STATE_COMPLETE;
  const { name, notes, author, makerId, masterName, version, personalData, study } = job;
  const { replayedRecordingId = '' } = job;
  const texts = { name, notes, author, makerId, masterName, version, personalData };
  return { ...texts, kind, startedMs, state, problem: '', selection, replayedRecordingId, study };
}

/** The header for a file. The member `selection` of it is JSON with all that has no member of its own. */
export function formatHeader(facts: FileFacts): RecordingHeader {
  const { name, notes, kind, masterName, version, selection, personalData, ...rest } = facts;
  return {
    name,
    notes,
    masterName,
    version,
    kind: KINDS[kind] ?? 'recording',
    selection: JSON.stringify({ ...selection, ...rest }),
    ...(personalData !== '' && { personalData }),
  };
}

/** What a file says of itself; of files of other programs, little. */
export function parseFacts(summary: RecordingSummary): FileFacts {
  const { name, notes, masterName, version, kind, personalData = '' } = summary;
  const { author, makerId, startedMs, state, problem, replayedRecordingId, study, ...selection } =
    parseObject(summary.selection);
  const kinds = Object.entries(KINDS).find(([, word]) => word === kind);
  return {
    name,
    notes,
    masterName,
    version,
    personalData,
    kind: summary.isForeign
      ? RecordingKind.RECORDING_KIND_IMPORT
      : (Number(kinds?.[0] ?? 0) as RecordingKind),
    author: textOf(author),
    makerId: textOf(makerId),
    startedMs: typeof startedMs === 'number' && Number.isFinite(startedMs) ? startedMs : 0,
    state: ENDED.find((each) => each === state) ?? RecordingState.RECORDING_STATE_COMPLETE,
    problem: textOf(problem),
    selection: selectionOf(selection),
    replayedRecordingId: textOf(replayedRecordingId),
    study: studyOf(study),
  };
}

/** A finished recording, as services describe it, without topics and markers. */
export function describeFile(
  id: string,
  facts: FileFacts,
  summary: RecordingSummary,
  sizeBytes: number,
): Recording {
  const startMs = summary.startNs === 0n ? facts.startedMs : msOf(summary.startNs);
  return {
    id,
    name: facts.name === '' ? id : facts.name,
    kind: facts.kind,
    state: facts.state,
    startedMs: startMs,
    durationMs: Math.max(0, msOf(summary.endNs - summary.startNs)),
    sizeBytes,
    recordCount: summary.records,
    lostCount: summary.gaps.reduce((sum, { records }) => sum + records, 0),
    topicCount: new Set(summary.topics.map(({ topic }) => topic)).size,
    markerCount: summary.markers.length,
    problem: facts.problem,
    notes: facts.notes,
    author: facts.author,
    selection: facts.selection,
    study: facts.study,
    budget: undefined,
    ...WITHOUT_PAGE,
    replayedRecordingId: facts.replayedRecordingId,
    ...AT_MASTER,
  };
}

function parseObject(json: string): Record<string, unknown> {
  try {
    const value: unknown = JSON.parse(json);
    return typeof value === 'object' && value !== null ? { ...value } : {};
  } catch {
    return {};
  }
}

function textOf(value: unknown): string {
  return typeof value === 'string' ? value : '';
}

function studyOf(value: unknown): RecordingStudy | undefined {
  if (typeof value !== 'object' || value === null) return undefined;
  try {
    return fromJson('ubii.extension.RecordingStudy', value as JsonObject);
  } catch {
    return undefined;
  }
}

function selectionOf(value: Readonly<Record<string, unknown>>): RecordingSelection {
  const texts = (name: keyof RecordingSelection): string[] => {
    const list = value[name];
    return Array.isArray(list) ? list.filter((each) => typeof each === 'string') : [];
  };
  return {
    topics: texts('topics'),
    patterns: texts('patterns'),
    clients: texts('clients'),
    devices: texts('devices'),
    sessions: texts('sessions'),
    excludedPatterns: texts('excludedPatterns'),
    withoutImages: value['withoutImages'] === true,
  };
}

/** What messages tell of a topic of a file. */
export type DescribedTopic = Pick<
  RecordedTopic,
  'topic' | 'clientId' | 'clientName' | 'format' | 'records'
>;

/** A topic of a file, as messages have it. [RC-54] */
export function describeTopic(
  { topic, clientId, clientName, format, records }: DescribedTopic,
  { topicBytes, idCharacters, nameCharacters, identifierCharacters }: TextLimits,
): RecordingTopic {
  return {
    topic: shortened(topic, topicBytes),
    clientId: shortened(clientId, idCharacters),
    clientName: shortened(clientName, nameCharacters),
    dataFormat: shortened(format, identifierCharacters),
    recordCount: records,
  };
}
