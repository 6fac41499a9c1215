import { tryOnScopeDispose } from '@vueuse/core';
import { computed, shallowRef, type ComputedRef } from 'vue';

/** The viewers of data and their intervals. Data without viewers is not requested. */
export interface Interest {
  /** The shortest interval of all viewers, milliseconds; `undefined` without viewers. */
  readonly intervalMs: ComputedRef<number | undefined>;
  /** Registers a viewer with an interval until the calling component or scope ends. */
  express(intervalMs: number): void;
}

export function createInterest(): Interest {
  const wishes = shallowRef<readonly { readonly intervalMs: number }[]>([]);
  return {
    intervalMs: computed(() =>
      wishes.value.length === 0
        ? undefined
        : Math.min(...wishes.value.map(({ intervalMs }) => intervalMs)),
    ),
    express(intervalMs) {
      const wish = { intervalMs };
      wishes.value = [...wishes.value, wish];
      tryOnScopeDispose(() => {
        wishes.value = wishes.value.filter((other) => other !== wish);
      });
    },
  };
}
