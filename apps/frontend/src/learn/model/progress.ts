import * as v from 'valibot';
import { storedAs } from '../../json/read-stored.ts';
import { validMembers } from '../../json/schemas.ts';

/** Progress in a lesson. */
export interface LessonProgress {
  readonly reached: number;
  readonly isDone: boolean;
}

/** By lesson id. */
export type Progress = Readonly<Record<string, LessonProgress>>;

export const PROGRESS_KEY = 'ubii.learn.progress';

/** Storage of the progress; invalid entries are dropped. */
export const storedProgress = storedAs<v.GenericSchema<unknown, Progress>>(
  validMembers(v.object({ reached: v.pipe(v.number(), v.integer()), isDone: v.boolean() })),
  {},
);

/** Returns the progress with one lesson updated. */
export function withLesson(progress: Progress, id: string, entry: LessonProgress): Progress {
  return { ...progress, [id]: { reached: entry.reached, isDone: entry.isDone } };
}
