import type { LessonFacts } from './facts.ts';
import type { Lesson, Measurement } from './lesson.ts';

/** The user's progress in a lesson. */
export interface LessonRun {
  readonly step: number;
  /** The farthest step that was opened. */
  readonly reached: number;
  /** Passed checks of this step, with their measured values. */
  readonly passed: ReadonlyMap<string, string>;
  /** True when all steps are completed. */
  readonly isDone: boolean;
}

export type LessonEvent =
  | { readonly kind: 'observe'; readonly found: ReadonlyMap<string, Measurement> }
  | { readonly kind: 'next' }
  /** Resets the step. */
  | { readonly kind: 'reset' }
  /** Opens a step that was reached before. */
  | { readonly kind: 'open'; readonly step: number }
  /** Restarts the lesson. */
  | { readonly kind: 'restart' };

const NOTHING: ReadonlyMap<string, string> = new Map();

export function startLesson(
  lesson: Lesson,
  kept?: { readonly reached: number; readonly isDone: boolean },
): LessonRun {
  const last = lesson.steps.length - 1;
  const reached = Math.min(last, Math.max(0, Math.trunc(kept?.reached ?? 0)));
  const isDone = kept?.isDone === true;
  return { step: isDone ? 0 : reached, reached, passed: NOTHING, isDone };
}

/** Measures all checks of the step, by id. */
export function measureStep(
  lesson: Lesson,
  step: number,
  facts: LessonFacts,
): ReadonlyMap<string, Measurement> {
  const checks = lesson.steps[step]?.checks ?? [];
  return new Map(checks.map((check) => [check.id, check.measure(facts)]));
}

/** Whether all checks of the step have passed. */
export function hasPassed(lesson: Lesson, { step, passed }: LessonRun): boolean {
  return (lesson.steps[step]?.checks ?? []).every(({ id }) => passed.has(id));
}

/** Transition function of a run. Events that are not allowed change nothing. */
export function nextRun(lesson: Lesson, run: LessonRun, event: LessonEvent): LessonRun {
  switch (event.kind) {
    case 'observe': {
      // Passed checks stay passed: some checks of a step cannot hold at the same time.
      const fresh = [...event.found].filter(([id, { passed }]) => passed && !run.passed.has(id));
      if (fresh.length === 0) return run;
      const passed = new Map(run.passed);
      for (const [id, { value }] of fresh) passed.set(id, value);
      return { ...run, passed };
    }
    case 'next': {
      if (!hasPassed(lesson, run)) return run;
      const isLast = run.step === lesson.steps.length - 1;
      if (isLast) return { ...run, isDone: true };
      const step = run.step + 1;
      return { ...run, step, reached: Math.max(run.reached, step), passed: NOTHING };
    }
    case 'reset':
      return { ...run, passed: NOTHING };
    case 'open':
      return event.step < 0 || event.step > run.reached || event.step === run.step
        ? run
        : { ...run, step: event.step, passed: NOTHING };
    case 'restart':
      return { step: 0, reached: 0, passed: NOTHING, isDone: false };
  }
}
