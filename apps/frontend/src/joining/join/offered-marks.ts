import type { JoinCheck, Mark } from '@ubii/proto';
import { isSameMark } from '../../marks/mark-words.ts';
import type { OfferedMarks } from './join-state.ts';

/** Marks in the reply to a check of a token. */
export function offeredMarks({
  freeMark,
  takenMarks,
}: Pick<JoinCheck, 'freeMark' | 'takenMarks'>): OfferedMarks {
  return {
    free: freeMark,
    taken: takenMarks.flatMap(({ name, mark }) => (mark === undefined ? [] : { name, mark })),
  };
}

/** For masters that give no marks. */
const ANY: Mark = { shape: 1, colour: 1, chosen: false };

/** The mark that is proposed: the one that the person chose before, else one that is free. */
export function proposedMark(kept: Mark | undefined, { free, taken }: OfferedMarks): Mark {
  const isFree = kept !== undefined && !taken.some(({ mark }) => isSameMark(mark, kept));
  if (kept !== undefined && (kept.chosen || isFree)) return kept;
  return free ?? ANY;
}
