import * as v from 'valibot';
import { storedAs } from '../../json/read-stored.ts';
import { validMembers } from '../../json/schemas.ts';

/** How far one lesson has come. */
export interface LessonProgress {
  readonly reached: number;
  readonly isDone: boolean;
}

/** By the id of the lesson. */
export type Progress = Readonly<Record<string, LessonProgress>>;

export const PROGRESS_KEY = 'ubii.learn.progress';

/** What a browser keeps; entries that cannot be read count as nothing. */
export const storedProgress = storedAs<v.GenericSchema<unknown, Progress>>(
  validMembers(v.object({ reached: v.pipe(v.number(), v.integer()), isDone: v.boolean() })),
  {},
);

/** The progress with one lesson as it is now. */
export function withLesson(progress: Progress, id: string, entry: LessonProgress): Progress {
  return { ...progress, [id]: { reached: entry.reached, isDone: entry.isDone } };
}
