import {
  ServiceError,
  type Recording,
  type StudyDeletion,
  type StudyParticipant,
  type StudyParticipantList,
  type StudyParticipantRequest,
  type StudyRun,
} from '@ubii/proto';
import type { Recordings } from '../recordings/recordings.ts';
import { isSameCode } from './labels.ts';
import type { StudyBlocks } from './study-blocks.ts';
import type { StudyNews } from './study-news.ts';
import type { StudyStore } from './study-store.ts';
import type { Turns } from './turns.ts';

/** What participants are found in. */
export interface ParticipantsContext {
  readonly recordings: Recordings;
  readonly store: StudyStore;
  readonly blocks: StudyBlocks;
  readonly news: StudyNews;
  readonly turns: Turns;
}

/** Participants of studies, with all that is kept of them. [ST-50] [ST-51] */
export class Participants {
  readonly #context: ParticipantsContext;

  constructor(context: ParticipantsContext) {
    this.#context = context;
  }

  async list(request: StudyParticipantRequest): Promise<StudyParticipantList> {
    const found = await this.#find(request);
    const participants = new Map<string, StudyParticipant>();
    const participantOf = (studyId: string, code: string): StudyParticipant => {
      const key = `${studyId} ${code.toLowerCase()}`;
      const known = participants.get(key);
      if (known !== undefined) return known;
      const added = { studyId, code, number: 0, runIds: [], recordingIds: [], sizeBytes: 0 };
      participants.set(key, { ...added, lastMs: 0 });
      return participants.get(key)!;
    };
    for (const { studyId, participantCode, participantNumber, id, startedMs } of found.runs) {
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
      const { runs, recordings } = await this.#find(request);
      if (runs.length === 0 && recordings.length === 0) {
        throw new ServiceError('not_found', 'There is no participant with this code.');
      }
      for (const run of runs) blocks.abandon(run);
      // Runs last: as long as one is left, the participant is listed, and can be deleted again.
      for (const { id } of recordings) await files.delete(id);
      for (const { id } of runs) await store.deleteRun(id);
      news.tell();
      return this.#deletionOf(runs, recordings);
    });
  }

  #deletionOf(runs: readonly StudyRun[], recordings: readonly Recording[]): StudyDeletion {
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
  async #find({ studyId, participantCode }: StudyParticipantRequest) {
    const { store, recordings } = this.#context;
    const isMeant = (study: string, code: string): boolean =>
      (studyId === '' || study === studyId) &&
      (participantCode === '' || isSameCode(code, participantCode));
    const { elements } = await recordings.list();
    return {
      runs: store.runs().filter((run) => isMeant(run.studyId, run.participantCode)),
      recordings: elements.filter(
        ({ study }) => study !== undefined && isMeant(study.studyId, study.participantCode),
      ),
    };
  }
}
