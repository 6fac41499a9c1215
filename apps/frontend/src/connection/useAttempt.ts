import { ConnectionError } from '@ubii/client-web';
import { ServiceError } from '@ubii/proto';
import { computed, shallowReactive, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

/** Error of a request that the user can do something about. Every other error is one of the program. */
export type RequestError = ServiceError | ConnectionError;

export function isRequestError(cause: unknown): cause is RequestError {
  return cause instanceof ServiceError || cause instanceof ConnectionError;
}

/**
 * Sends requests to the master.
 *
 * @param onError called with the reason why the master refused, or is not reachable
 * @returns undefined after such an error
 * @throws every other error
 */
export async function tryRequest<T>(
  work: () => Promise<T>,
  onError: (error: RequestError) => void = () => undefined,
): Promise<T | undefined> {
  try {
    return await work();
  } catch (cause) {
    if (!isRequestError(cause)) throw cause;
    onError(cause);
    return undefined;
  }
}

/** Returns the sentence of an error; `undefined` for a lost connection, which the shell shows. */
export function refusalSentence(error: Error): string | undefined {
  return error instanceof ConnectionError ? undefined : error.message;
}

export interface AttemptOptions {
  /** Returns the sentence for an error; `undefined` leaves `problem` as it is. Default: the message of the error. */
  readonly sentenceOf?: (error: Error) => string | undefined;
  /** True for work that also loads code: its other errors are problems, too. Default: they are thrown. */
  readonly catchesAll?: boolean;
  /** True for requests that repeat: `problem` stays until one succeeds. Default: until the next request. */
  readonly keepsProblem?: boolean;
}

/** Requests to the master that may be refused. */
export interface Attempt {
  /** Why the last request failed, one sentence. */
  readonly problem: ShallowRef<string | undefined>;
  readonly isBusy: ComputedRef<boolean>;
  /** @returns undefined when the master refused or is not reachable */
  attempt<T>(work: () => Promise<T>): Promise<T | undefined>;
}

export function useAttempt(options: AttemptOptions = {}): Attempt {
  const {
    sentenceOf = ({ message }) => message,
    catchesAll = false,
    keepsProblem = false,
  } = options;
  const problem = shallowRef<string>();
  const pending = shallowRef(0);

  async function attempt<T>(work: () => Promise<T>): Promise<T | undefined> {
    if (!keepsProblem) problem.value = undefined;
    pending.value += 1;
    try {
      const result = await work();
      if (keepsProblem) problem.value = undefined;
      return result;
    } catch (cause) {
      if (!isRequestError(cause) && !(catchesAll && cause instanceof Error)) throw cause;
      problem.value = sentenceOf(cause) ?? problem.value;
      return undefined;
    } finally {
      pending.value -= 1;
    }
  }

  return { problem, isBusy: computed(() => pending.value > 0), attempt };
}

/** Requests about many things, such as the sessions of a list. */
export interface AttemptByKey {
  /** Why the last request about a thing failed, by its key. */
  readonly problems: ComputedRef<ReadonlyMap<string, string>>;
  /** Keys of things with a pending request. */
  readonly busy: ComputedRef<ReadonlySet<string>>;
  /** @returns undefined when the master refused or is not reachable */
  attempt<T>(key: string, work: () => Promise<T>): Promise<T | undefined>;
  /** Removes the problem of a thing. */
  dismiss(key: string): void;
}

export function useAttemptByKey(): AttemptByKey {
  const byKey = shallowReactive(new Map<string, Attempt>());

  function attemptOf(key: string): Attempt {
    const known = byKey.get(key) ?? useAttempt();
    byKey.set(key, known);
    return known;
  }

  return {
    problems: computed(() => {
      const problems = new Map<string, string>();
      for (const [key, { problem }] of byKey) {
        if (problem.value !== undefined) problems.set(key, problem.value);
      }
      return problems;
    }),
    busy: computed(
      () => new Set([...byKey].filter(([, { isBusy }]) => isBusy.value).map(([key]) => key)),
    ),
    attempt: (key, work) => attemptOf(key).attempt(work),
    dismiss(key) {
      const known = byKey.get(key);
      if (known) known.problem.value = undefined;
    },
  };
}
