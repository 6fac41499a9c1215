import { computed, inject, provide, type ComputedRef, type InjectionKey } from 'vue';

/** What is wrong at each path of a message: `must be a number, got "a"`. */
export type FormProblems = ReadonlyMap<string, string>;

const PROBLEMS: InjectionKey<ComputedRef<FormProblems>> = Symbol('form problems');

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
    return found && `${found[0]!.toUpperCase()}${found.slice(1)}${found.endsWith('.') ? '' : '.'}`;
  });
}
