import type { Study, StudyNote, StudyParticipant, StudyRun } from '@ubii/proto';
import { counted } from '@ubii/words';
import { sizeText } from '../../recordings/list/recording-words.ts';
import { formatMoment } from '../../ui/readouts/format-clock.ts';

/** Whether and when a participant consented in a run. */
export function consentWords(
  { consent }: Pick<StudyRun, 'consent'>,
  { consentVersion }: Pick<Study, 'consentVersion'>,
): string {
  if (consent === undefined) return 'No consent recorded.';
  const version = consent.version === consentVersion ? '' : ` to version ${consent.version}`;
  return `Consented${version} on ${formatMoment(consent.timeMs, 'minute')}.`;
}

/** When in a run a note was written, and by whom. */
export const noteSource = ({ block, author }: Pick<StudyNote, 'block' | 'author'>): string =>
  [block > 0 ? `block ${block}` : '', author].filter(Boolean).join(', ');

/** What a deletion takes away, one sentence. */
export function deletionSentence(
  { code, recordingIds, sizeBytes }: Pick<StudyParticipant, 'code' | 'recordingIds' | 'sizeBytes'>,
  runs: readonly Pick<StudyRun, 'notes' | 'consent'>[],
  studyName: string,
): string {
  const notes = runs.reduce((sum, run) => sum + run.notes.length, 0);
  const files = `${counted(recordingIds.length, 'recording')} (${sizeText(sizeBytes)})`;
  const isConsented = runs.some(({ consent }) => consent !== undefined);
  return (
    `${counted(runs.length, 'run')}${isConsented ? ' with consent' : ''}, ${counted(notes, 'note')} and ${files} ` +
    `of ${code} in ${studyName} are deleted from the master, and what the flight recorder holds. This cannot be undone.`
  );
}
