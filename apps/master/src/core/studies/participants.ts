import {
  RecordingKind,
  ServiceError,
  StudyRunState,
  type Recording,
  type StudyDeletion,
  type StudyOtherRecording,
  type StudyParticipant,
  type StudyParticipantList,
  type StudyParticipantRequest,
  type StudyRun,
} from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { Recordings } from '../recordings/recordings.ts';
import { isSameCode } from './labels.ts';
import type { StudyBlocks } from './study-blocks.ts';
import type { StudyNews } from './study-news.ts';
import type { StudyStore } from './study-store.ts';
import type { Turns } from './turns.ts';

/** What participants are found in. */
export interface ParticipantsContext {
  readonly clock: Clock;
  readonly recordings: Recordings;
  readonly store: StudyStore;
  readonly blocks: StudyBlocks;
  readonly news: StudyNews;
  readonly turns: Turns;
}

/** First and last moment, milliseconds since the Unix epoch. */
type Span = readonly [fromMs: number, untilMs: number];

/** Named in the report of a deletion. [ST-53] */
const MAX_OTHERS = 100;

/** Participants of studies, with all that is kept of them. [ST-50] [ST-51] */
export class Participants {
  readonly #context: ParticipantsContext;

  constructor(context: ParticipantsContext) {
    this.#context = context;
  }

  /** @param isWanted whether studies and recordings of this maker are listed [ST-5] */
  async list(
    request: StudyParticipantRequest,
    isWanted: (makerId: string) => boolean,
  ): Promise<StudyParticipantList> {
    const { store } = this.#context;
    const found = await this.#find(request, isWanted);
    const runs = found.runs.filter(({ studyId }) => isWanted(store.makerOf(studyId)));
    const participants = new Map<string, StudyParticipant>();
    const participantOf = (studyId: string, code: string): StudyParticipant => {
      const key = `${studyId} ${code.toLowerCase()}`;
      const known = participants.get(key);
      if (known !== undefined) return known;
      const added = { studyId, code, number: 0, runIds: [], recordingIds: [], sizeBytes: 0 };
      participants.set(key, { ...added, lastMs: 0 });
      return participants.get(key)!;
    };
    for (const { studyId, participantCode, participantNumber, id, startedMs } of runs) {
      const participant = participantOf(studyId, participantCode);
      participant.number = participantNumber;
      participant.runIds.push(id);
      participant.lastMs = Math.max(participant.lastMs, startedMs);
    }
    for (const { study, id, sizeBytes } of found.recordings) {
      const participant = participantOf(study!.studyId, study!.participantCode);
      participant.recordingIds.push(id);
      participant.sizeBytes += sizeBytes;
    }
    const elements = [...participants.values()].sort(
      (a, b) => a.studyId.localeCompare(b.studyId) || a.code.localeCompare(b.code, 'en'),
    );
    return { elements };
  }

  /** [ST-51] */
  delete(request: StudyParticipantRequest): Promise<StudyDeletion> {
    const { store, blocks, recordings: files, news, turns } = this.#context;
    if (request.participantCode === '') {
      throw new ServiceError(
        'invalid_argument',
        'The request names no participant. Set `participant_code`.',
      );
    }
    return turns.run(async () => {
      const { runs, recordings, others } = await this.#find(request);
      if (runs.length === 0 && recordings.length === 0) {
        throw new ServiceError('not_found', 'There is no participant with this code.');
      }
      for (const run of runs) blocks.abandon(run);
      // Runs last: as long as one is left, the participant is listed, and can be deleted again.
      for (const { id } of recordings) await files.delete(id);
      await files.emptyFlight();
      for (const { id } of runs) await store.deleteRun(id);
      news.announce();
      const spans = [...runs.map((run) => this.#spanOf(run)), ...recordings.map(spanOfRecording)];
      return {
        ...this.#deletionOf(runs, recordings),
        otherRecordings: madeDuring(spans, others),
      };
    });
  }

  /** When a run was; of one that the master left when it exited, until its last recording. */
  #spanOf({ state, startedMs, endedMs, blocks }: StudyRun): Span {
    if (endedMs > 0) return [startedMs, endedMs];
    if (state === StudyRunState.STUDY_RUN_STATE_OPEN)
      return [startedMs, this.#context.clock.nowMs()];
    const takes = blocks.flatMap((block) => block.takes);
    return [
      startedMs,
      Math.max(startedMs, ...takes.flatMap((take) => [take.startedMs, take.endedMs])),
    ];
  }

  #deletionOf(
    runs: readonly StudyRun[],
    recordings: readonly Recording[],
  ): Omit<StudyDeletion, 'otherRecordings'> {
    const studies = new Set([
      ...runs.map(({ studyId }) => studyId),
      ...recordings.map(({ study }) => study!.studyId),
    ]);
    const names = new Map(recordings.map(({ study }) => [study!.studyId, study!.studyName]));
    return {
      recordingNames: recordings.map(({ name }) => name),
      sizeBytes: recordings.reduce((sum, { sizeBytes }) => sum + sizeBytes, 0),
      runCount: runs.length,
      noteCount: runs.reduce((sum, { notes }) => sum + notes.length, 0),
      studyNames: [...studies].map(
        (id) => this.#context.store.find(id)?.name ?? names.get(id) ?? id,
      ),
    };
  }

  /** What there is of participants, the newest first. */
  async #find(
    { studyId, participantCode }: StudyParticipantRequest,
    isWanted?: (makerId: string) => boolean,
  ) {
    const { store, recordings } = this.#context;
    const isMeant = (study: string, code: string): boolean =>
      (studyId === '' || study === studyId) &&
      (participantCode === '' || isSameCode(code, participantCode));
    const { elements } = await recordings.list(isWanted);
    const isOf = ({ study }: Recording): boolean =>
      study !== undefined && isMeant(study.studyId, study.participantCode);
    return {
      runs: store.runs().filter((run) => isMeant(run.studyId, run.participantCode)),
      recordings: elements.filter(isOf),
      others: elements.filter((recording) => !isOf(recording)),
    };
  }
}

/** Recordings that may have data of a participant, of those that were made in one of the spans. [ST-53] */
function madeDuring(
  spans: readonly Span[],
  recordings: readonly Recording[],
): StudyOtherRecording[] {
  return recordings
    .filter((recording) => {
      const [from, until] = spanOfRecording(recording);
      // What a comparison records comes from a recording.
      if (recording.kind === RecordingKind.RECORDING_KIND_COMPARISON) return false;
      return spans.some(([start, end]) => from <= end && until >= start);
    })
    .slice(0, MAX_OTHERS)
    .map(({ id, name }) => ({ id, name }));
}

const spanOfRecording = ({ startedMs, durationMs }: Recording): Span => [
  startedMs,
  startedMs + durationMs,
];
