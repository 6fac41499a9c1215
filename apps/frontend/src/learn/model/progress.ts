/** How far one lesson has come. */
export interface LessonProgress {
  readonly reached: number;
  readonly isDone: boolean;
}

/** By the id of the lesson. */
export type Progress = Readonly<Record<string, LessonProgress>>;

export const PROGRESS_KEY = 'ubii.learn.progress';

/** Reads what a browser kept; what cannot be read counts as nothing. */
export function parseProgress(text: string | null): Progress {
  if (text === null) return {};
  try {
    const parsed = JSON.parse(text) as unknown;
    if (typeof parsed !== 'object' || parsed === null) return {};
    return Object.fromEntries(Object.entries(parsed).filter(([, entry]) => isProgress(entry)));
  } catch {
    return {};
  }
}

function isProgress(value: unknown): value is LessonProgress {
  const entry = value as Partial<LessonProgress> | null;
  return (
    typeof entry === 'object' &&
    entry !== null &&
    Number.isInteger(entry.reached) &&
    typeof entry.isDone === 'boolean'
  );
}

/** The progress with one lesson as it is now. */
export function withLesson(progress: Progress, id: string, entry: LessonProgress): Progress {
  return { ...progress, [id]: { reached: entry.reached, isDone: entry.isDone } };
}
