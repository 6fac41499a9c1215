import type { CallFact, SessionFact, TryFact } from '../model/facts.ts';
import type { Answer } from '../model/lesson.ts';

/** Facts that only the workspace knows. */
export interface WorkspaceFacts {
  readonly session?: SessionFact | undefined;
  readonly tried?: TryFact | undefined;
  readonly calls?: readonly CallFact[];
}

/** Interface of every workspace to the lesson beside it. */
export interface LessonWorkspace {
  read(): WorkspaceFacts;
  /** Performs the answer of a step. @returns a function that reverts it; undefined if nothing changed */
  answer(answer: Answer): Promise<(() => void) | undefined>;
  /** Resets the workspace to the start of a step. */
  reset(step: number): Promise<void>;
}
