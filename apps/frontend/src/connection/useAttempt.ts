import { ConnectionError } from '@ubii/client-web';
import { ServiceError } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';

/** Requests to the master that may be refused. */
export interface Attempts {
  /** Why the last request failed, one sentence. */
  readonly problem: ShallowRef<string | undefined>;
  readonly isBusy: Readonly<ShallowRef<boolean>>;
  /** @returns undefined when the master refused or is not reachable */
  attempt<T>(work: () => Promise<T>): Promise<T | undefined>;
}

export function useAttempt(): Attempts {
  const problem = shallowRef<string>();
  const isBusy = shallowRef(false);
  return {
    problem,
    isBusy,
    async attempt(work) {
      problem.value = undefined;
      isBusy.value = true;
      try {
        return await work();
      } catch (cause) {
        if (!(cause instanceof ServiceError || cause instanceof ConnectionError)) throw cause;
        problem.value = cause.message;
        return undefined;
      } finally {
        isBusy.value = false;
      }
    },
  };
}
