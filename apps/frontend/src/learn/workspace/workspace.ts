import type { CallFact, SessionFact, TryFact } from '../model/facts.ts';
import type { Answer } from '../model/lesson.ts';

/** What only the workspace knows. */
export interface WorkspaceFacts {
  readonly session?: SessionFact | undefined;
  readonly tried?: TryFact | undefined;
  readonly calls?: readonly CallFact[];
}

/** What every workspace exposes to the lesson beside it. */
export interface LessonWorkspace {
  read(): WorkspaceFacts;
  /** Does what the step asks for. @returns what takes it back; undefined where nothing was changed */
  answer(answer: Answer): Promise<(() => void) | undefined>;
  /** Back to how the step begins. */
  reset(step: number): Promise<void>;
}
