import { computed, inject, provide, type ComputedRef, type InjectionKey } from 'vue';
import { capitalised } from '@ubii/words';

/** What is wrong at each path of a message: `must be a number, got "a"`. */
export type FormProblems = ReadonlyMap<string, string>;

const PROBLEMS: InjectionKey<ComputedRef<FormProblems>> = Symbol('form problems');

/** Ends a text with a full stop, unless it ends as a sentence already. */
export const asSentence = (text: string): string => (/[.?]$/.test(text) ? text : `${text}.`);

export function provideFormProblems(problems: ComputedRef<FormProblems>): void {
  provide(PROBLEMS, problems);
}

/** What is wrong at a path, as a sentence; undefined when it is fine. */
export function useFormProblem(path: () => string): ComputedRef<string | undefined> {
  const problems = inject(
    PROBLEMS,
    computed(() => new Map()),
  );
  return computed(() => {
    const found = problems.value.get(path());
    return found && asSentence(capitalised(found));
  });
}
