import { ServiceError, type Session, type SessionProblem } from '@ubii/proto';
import { computed, shallowRef, watch, type ComputedRef, type Ref } from 'vue';
import { tryRequest, type RequestError } from '../../../../connection/useAttempt.ts';
import {
  problemsOnLines,
  readSessionText,
  type TextProblem,
} from '../../../../sessions/text/session-text.ts';

/** A text that is to become a session: what is wrong with it, and the try to make one of it. */
export interface TextCheck {
  /** What this page finds while one types, and what the master found in the last try. */
  readonly problems: ComputedRef<readonly TextProblem[]>;
  readonly isTrying: Readonly<Ref<boolean>>;
  /**
   * Reads the text and hands the session on.
   * @returns what `use` gave, `undefined` when something is wrong
   */
  submit<T>(use: (session: Session) => Promise<T>): Promise<T | undefined>;
}

const isProblems = (value: unknown): value is readonly SessionProblem[] =>
  Array.isArray(value) && value.length > 0;

export function useTextCheck(text: Readonly<Ref<string>>): TextCheck {
  /** The master's word on a text, until it is changed. */
  const refusal = shallowRef<readonly TextProblem[]>([]);
  watch(text, () => (refusal.value = []));
  const isTrying = shallowRef(false);

  const found = computed(() => {
    if (text.value.trim() === '') return [];
    return readSessionText(text.value).problems;
  });

  function refused(cause: RequestError): readonly TextProblem[] {
    const problems = cause instanceof ServiceError ? cause.details['problems'] : undefined;
    if (isProblems(problems)) return problemsOnLines(text.value, problems);
    return [{ isError: true, message: cause.message, line: undefined, path: '' }];
  }

  return {
    problems: computed(() => [...refusal.value, ...found.value]),
    isTrying,
    async submit(use) {
      const read = readSessionText(text.value);
      if (read.kind === 'broken') {
        // Shown while one types, unless there is nothing
        if (text.value.trim() === '') refusal.value = read.problems;
        return undefined;
      }
      isTrying.value = true;
      try {
        return await tryRequest(
          () => use(read.session),
          (cause) => (refusal.value = refused(cause)),
        );
      } finally {
        isTrying.value = false;
      }
    },
  };
}
