import { computed, inject, provide, type ComputedRef, type InjectionKey } from 'vue';
import { capitalised } from '@ubii/words';

/** Problems of a message by path: `must be a number, got "a"`. */
export type FormProblems = ReadonlyMap<string, string>;

const PROBLEMS: InjectionKey<ComputedRef<FormProblems>> = Symbol('form problems');

/** Appends a full stop, unless the text ends a sentence already. */
export const asSentence = (text: string): string => (/[.?]$/.test(text) ? text : `${text}.`);

export function provideFormProblems(problems: ComputedRef<FormProblems>): void {
  provide(PROBLEMS, problems);
}

/** Returns the problem at a path as a sentence; undefined without one. */
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
