import type { Study, StudyRun } from '@ubii/proto';
import { counted } from '@ubii/words';

/** Studies whose name has all words of a search. */
export function findStudies(all: readonly Study[], search: string): readonly Study[] {
  const words = search.toLowerCase().split(/\s+/).filter(Boolean);
  return all.filter(({ name }) => words.every((word) => name.toLowerCase().includes(word)));
}

/** How many took part: `6 participants, 8 runs`. */
export const takenPart = ({
  participantCount,
  runCount,
}: Pick<Study, 'participantCount' | 'runCount'>): string =>
  runCount === 0
    ? 'No runs yet'
    : `${counted(participantCount, 'participant')}, ${counted(runCount, 'run')}`;

/** Start of the newest run of each study, by id of the study. @param runs the newest first */
export function lastRuns(runs: readonly StudyRun[]): ReadonlyMap<string, number> {
  const last = new Map<string, number>();
  for (const { studyId, startedMs } of runs) if (!last.has(studyId)) last.set(studyId, startedMs);
  return last;
}

/** What the page of a study says that is not in the list. [ST-5] */
export function unknownSentence(isNoAdmin: boolean): string {
  const sentence = 'No study with this address. It may have been deleted.';
  return isNoAdmin ? `${sentence} Studies of others are shown to admins only.` : sentence;
}
